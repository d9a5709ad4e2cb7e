// The keys of a TelemetryListener: HEARTBEAT, COMMAND_ACK, and its message, all from the vendored headers.
#pragma once

#include "../base/Flash.h"
#include "../link/Messages.h"

#define MAVMISSION_TELEMETRY_KEYS(NAME)                                                                              \
  const MessageKey kListened[3] PROGMEM = {MAVMISSION_LISTENER_KEY(HEARTBEAT), MAVMISSION_LISTENER_KEY(COMMAND_ACK), \
                                           MAVMISSION_LISTENER_KEY(NAME)};                                           \
  static_assert(MAVLINK_MSG_ID_##NAME##_MIN_LEN <= MAVLINK_MSG_ID_##NAME##_LEN, "extensions follow the other fields")
