// What is known about a command in a plan: what an autopilot keeps of it, and whether it has a place.
#pragma once

#include <stdint.h>

#include "../base/Config.h"
#include "../item/PlanType.h"
#include "Personality.h"

namespace mavmission {
namespace detail {

// `vehicleType`: HEARTBEAT.type.
Keeper keeperOf(Firmware firmware, uint8_t vehicleType, PlanType type);

// Flags of a command.
enum CommandTrait : uint8_t {
  kHasNoPlace = 1,       // the command has no place: it is sent with CoordinateFrame::Mission
  kIsNotTaken = 2,       // this autopilot does not take the command in a plan
  kPlaceIsOptional = 4,  // PX4: it gets the place of another item; ArduPilot: its altitude is not flown
  kAsItsFrameSays = 8,   // the item's frame tells whether it has a place; so for every command without a row
};

// The flags of a MAV_CMD for any autopilot, an or of CommandTrait: they tell whether the command has a place.
uint8_t traitsOf(uint16_t command);
// True if a command has neither a place nor parameters 5 and 6.
bool dropsPlace(uint16_t command);

}  // namespace detail
}  // namespace mavmission
