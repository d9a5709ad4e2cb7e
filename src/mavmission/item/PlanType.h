// The three kinds of plan that an autopilot holds (MAV_MISSION_TYPE, MAVLink common messages).
#pragma once

#include <stdint.h>

namespace mavmission {

// One kind, or all.
enum class PlanType : uint8_t {
  Mission = 0,  // the flight itself
  Fence = 1,    // the area that it must not leave, or not enter; needs MAVLink 2
  Rally = 2,    // places to land instead of at home; needs MAVLink 2
  All = 255,    // all three; only for clear()
};

}  // namespace mavmission
