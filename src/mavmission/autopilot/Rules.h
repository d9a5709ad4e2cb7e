// What an autopilot makes of the fields of an item, command by command: one row each, in flash.
#pragma once

#include <stdint.h>

#include "../MissionItem.h"
#include "Commands.h"

namespace mavmission {
namespace detail {

namespace keeping {

// What becomes of a field. The number of a kind means another thing in param1 to param4 than in x and y, or in z.
enum Kind : uint8_t {
  K = 0,          // kept as it is
  D = 1,          // dropped, because nothing uses it: read as 0
  Yaw360 = 2,     // param4: a heading from -180 to 360 degrees, put into 0 to 360 by way of radians. NaN: as you fly
  Rounded = 2,    // x, y: cut to the 24 bits of a float; nothing uses it
  Height = 2,     // z: ArduPilot keeps whole centimetres of it
  NoYaw = 3,      // param4: a heading that is not kept. NaN: as you fly
  Sign = 4,       // -1 for what is negative, else 1
  MountMode = 4,  // z: read as 2, whatever it was
  Special = 5,    // param1: turns, the radius of a fence, the mode of a region of interest; param3: the radius of turns
  Centimetres = 6,  // from 0 to 655.35, as an altitude
  U1 = 7,           // whole numbers, from here on: 0 and 1
  U8 = 8,
  I8 = 9,
  U16 = 10,
  I16 = 11,
  Radius = 12,  // -65535 to 65535
  To180 = 13,   // -180 to 180
  To90 = 14,    // -90 to 90
  To360 = 15,   // -180 to 360
};

}  // namespace keeping

// The Kind of param1 to param4, x, y and z, four bits each from the lowest on, and then the flags of a command.
struct Rules {
  uint32_t bits;

  bool has(CommandTrait trait) const { return (static_cast<uint8_t>(bits >> 24) >> 4 & trait) != 0; }
  // param4 may be NaN: as you fly.
  bool hasYaw() const {
    const uint8_t kind = static_cast<uint8_t>(bits >> 8) >> 4;
    return kind >= keeping::Yaw360 && kind <= keeping::Sign;
  }
};

// What this keeper makes of the fields of such an item: its command and its frame count.
Rules rulesOf(const MissionItem& item, Keeper keeper);

}  // namespace detail
}  // namespace mavmission
