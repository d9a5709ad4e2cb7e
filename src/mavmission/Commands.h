// What is known of a command in a plan, command by command, on both autopilots: one row each, in flash.
#pragma once

#include <stdint.h>

#include "Firmware.h"

namespace mavmission {

// Flags of a command; 0 for a command that is not in the table.
enum CommandTrait : uint8_t {
  kHasNoPlace = 1,         // goes out with Frame::Mission, the only one that both autopilots take for it
  kYawInParam4 = 2,        // param4 may be NaN: as you fly
  kPlaceIsOptional = 4,    // ArduPilot takes off or lands where it is when there is no place; PX4 needs one
  kNotFlownByArduPilot = 8,
  kNotFlownByPx4 = 16,
  kNoPlaceOnPx4 = 32,      // PX4 takes it only with Frame::Mission
};

// The traits of a MAV_CMD, an or of CommandTrait.
uint8_t traitsOf(uint16_t command);

}  // namespace mavmission
