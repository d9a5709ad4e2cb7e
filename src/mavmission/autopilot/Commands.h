// What is known of a command in a plan: who keeps it, and whether it has a place.
#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../Firmware.h"
#include "../PlanType.h"

namespace mavmission {
namespace detail {

// Who keeps a plan, and of which kind it is: an or of these. None of the first two: the protocol as the guide has it.
enum KeeperFlag : uint8_t {
  kByArduPilot = 1,
  kByPx4 = 2,
  kByPlane = 4,  // ArduPilot's Plane, which keeps some fields that its Copter drops
  kOfFence = 8,
  kOfRally = 16,
};
typedef uint8_t Keeper;

// `vehicleType`: HEARTBEAT.type.
Keeper keeperOf(Firmware firmware, uint8_t vehicleType, PlanType type);

// Flags of a command.
enum CommandTrait : uint8_t {
  kHasNoPlace = 1,       // goes out with Frame::Mission
  kIsNotTaken = 2,       // by this autopilot, in a plan
  kPlaceIsOptional = 4,  // ArduPilot takes off or lands where it is when there is no place; PX4 needs one
  kAsItsFrameSays = 8,   // has a place, or has none: of a command that is not in the table
};

// The flags of a MAV_CMD wherever it may be sent, an or of CommandTrait: whether it has a place.
uint8_t traitsOf(uint16_t command);

}  // namespace detail
}  // namespace mavmission
