// What an autopilot keeps of the fields of an item: one row for each command, in flash.
#pragma once

#include <stdint.h>

#include "../item/MissionItem.h"
#include "Commands.h"

namespace mavmission {
namespace detail {

namespace keeping {

// What becomes of a field. Some numbers have several names, since their meaning depends on the field: param1 to param4,
// x and y, or z.
enum Kind : uint8_t {
  K = 0,          // kept as it is
  D = 1,          // dropped, because the autopilot does not use the field: reads back as 0
  Yaw360 = 2,     // param4: a heading from -180 to 360 degrees, turned into 0 to 360 through radians. NaN: as you fly
  Later = 2,      // param1: dropped by PX4 to 1.17, kept and used from 1.18 on
  Rounded = 2,    // x, y: rounded to the 24 bits of a float; the autopilot does not use them
  Height = 2,     // z: ArduPilot keeps whole centimetres
  NoYaw = 3,      // param4: a heading that is not kept. NaN: as you fly
  NoHold = 3,     // param1: a time to hold that is dropped, so that only 0 means the same
  Sign = 4,       // -1 for a negative number, else 1
  MountMode = 4,  // z: always reads back as 2
  Three = 4,      // param1, in a table of its own: iNav takes a region of interest with a place alone
  Special = 5,    // param1: turns, the radius of a fence, the mode of a region of interest; param3: the radius of turns
  Zero = 5,       // param2, param4: dropped although another number than 0 would change the flight
  Centimetres = 6,  // 0 to 655.35, kept in whole hundredths, as an altitude is
  U1 = 7,           // 0 and 1; this and all kinds below keep whole numbers only
  U8 = 8,
  I8 = 9,
  U16 = 10,
  I16 = 11,
  Radius = 12,  // -65535 to 65535
  To180 = 13,   // -180 to 180
  To90 = 14,    // -90 to 90
  To360 = 15,   // -180 to 360; in a table of its own 0 to 359
};

}  // namespace keeping

// The Kinds of param1 to param4, x, y and z, four bits each, beginning with the lowest; the highest four bits are the
// command's flags (CommandTrait).
struct Rules {
  union {
    uint32_t bits;
    uint8_t bytes[4];  // the lowest bits first, as in a MAVLink message
  };

  bool has(CommandTrait trait) const { return (bytes[3] & trait << 4) != 0; }
  // True if param4 may be NaN, which means "as you fly".
  bool hasYaw() const { return isYaw(bytes[1] >> 4); }
  // The same of param4's Kind.
  static bool isYaw(uint8_t kind) { return kind >= keeping::Yaw360 && kind <= keeping::Sign; }
};

// The rules by which this keeper keeps the fields of an item. They depend on the item's command and frame.
Rules rulesOf(const MissionItem& item, Keeper keeper);

// The parameters of a command (1 to 4, or 7 for z), one bit each, that may be NaN beside a yaw: it means unset, PX4
// keeps it so, and MAVLink gives it a meaning.
MAVMISSION_APART uint8_t unsetOf(uint16_t command);

}  // namespace detail
}  // namespace mavmission
