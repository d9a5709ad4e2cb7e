// The HEARTBEAT that this component sends (MAVLink guide, Heartbeat Protocol).
#pragma once

#include <string.h>

#include "../base/MavlinkHeaders.h"

namespace mavmission {
namespace detail {

inline void makeOwnHeartbeat(mavlink_heartbeat_t& heartbeat) {
  memset(&heartbeat, 0, sizeof heartbeat);
  heartbeat.type = MAV_TYPE_ONBOARD_CONTROLLER;
  heartbeat.autopilot = MAV_AUTOPILOT_INVALID;
  heartbeat.system_status = MAV_STATE_ACTIVE;
  heartbeat.mavlink_version = 3;  // the field's fixed value (MAVLink common messages, HEARTBEAT)
}

}  // namespace detail
}  // namespace mavmission
