// The HEARTBEAT that this component sends (MAVLink guide, Heartbeat Protocol).
#pragma once

#include <string.h>

#include "../base/MavlinkHeaders.h"

namespace mavmission {
namespace detail {

// Fills it in. `customMode`: 0, or a mark by which its sender knows it again on a line that is looped back.
inline void makeOwnHeartbeat(mavlink_heartbeat_t& heartbeat, uint32_t customMode = 0) {
  memset(&heartbeat, 0, sizeof heartbeat);
  heartbeat.custom_mode = customMode;
  heartbeat.type = MAV_TYPE_ONBOARD_CONTROLLER;
  heartbeat.autopilot = MAV_AUTOPILOT_INVALID;
  heartbeat.system_status = MAV_STATE_ACTIVE;
  heartbeat.mavlink_version = 3;  // the field's fixed value (MAVLink common messages, HEARTBEAT)
}

}  // namespace detail
}  // namespace mavmission
