// What is known about a command in a plan: what an autopilot keeps of it, and whether it has a place.
#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../PlanType.h"
#include "Personality.h"

namespace mavmission {
namespace detail {

// `vehicleType`: HEARTBEAT.type.
Keeper keeperOf(Firmware firmware, uint8_t vehicleType, PlanType type);

// Flags of a command.
enum CommandTrait : uint8_t {
  kHasNoPlace = 1,       // the command has no place: it is sent with Frame::Mission
  kIsNotTaken = 2,       // this autopilot does not take the command in a plan
  kPlaceIsOptional = 4,  // without a place ArduPilot takes off or lands where it is; PX4 needs a place
  kAsItsFrameSays = 8,   // the item's frame tells whether it has a place; so for every command without a row
};

// The flags of a MAV_CMD for any autopilot, an or of CommandTrait: they tell whether the command has a place.
uint8_t traitsOf(uint16_t command);

}  // namespace detail
}  // namespace mavmission
