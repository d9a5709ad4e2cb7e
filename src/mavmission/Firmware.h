// The autopilots that the library knows.
#pragma once

#include <stdint.h>

namespace mavmission {

// The autopilot's software (HEARTBEAT.autopilot).
enum class Firmware : uint8_t {
  Unknown,    // nothing heard yet
  ArduPilot,  // MAV_AUTOPILOT_ARDUPILOTMEGA (3)
  Px4,        // MAV_AUTOPILOT_PX4 (12)
  Other,      // any other autopilot: the protocol as the guide describes it
};

}  // namespace mavmission
