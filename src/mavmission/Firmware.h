// The autopilots that the library knows.
#pragma once

#include <stdint.h>

namespace mavmission {

// Whose software flies (HEARTBEAT.autopilot).
enum class Firmware : uint8_t {
  Unknown,    // nothing heard yet
  ArduPilot,  // MAV_AUTOPILOT_ARDUPILOTMEGA (3)
  Px4,        // MAV_AUTOPILOT_PX4 (12)
  Other,      // any other autopilot: the protocol as the guide has it
};

}  // namespace mavmission
