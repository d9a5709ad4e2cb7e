// The MAVLink messages that the library speaks, as the vendored headers lay them out. Included by .cpp files only: no
// public header names a MAVLink type, so that a sketch may use any other MAVLink library beside this one.
#pragma once

#include <stddef.h>

#include "../base/MavlinkHeaders.h"
#include "FrameParser.h"

namespace mavmission {
namespace detail {

// The messages, received ones first: name, type, and where target_system lies in the payload.
#define MAVMISSION_RECEIVED_MESSAGES(X)                                                                         \
  X(HEARTBEAT, mavlink_heartbeat_t, MessageKey::kNoTarget)                                                      \
  X(MISSION_REQUEST, mavlink_mission_request_t, offsetof(mavlink_mission_request_t, target_system))             \
  X(MISSION_REQUEST_INT, mavlink_mission_request_int_t, offsetof(mavlink_mission_request_int_t, target_system)) \
  X(MISSION_ACK, mavlink_mission_ack_t, offsetof(mavlink_mission_ack_t, target_system))                         \
  X(MISSION_COUNT, mavlink_mission_count_t, offsetof(mavlink_mission_count_t, target_system))                   \
  X(MISSION_ITEM_INT, mavlink_mission_item_int_t, offsetof(mavlink_mission_item_int_t, target_system))          \
  X(MISSION_ITEM, mavlink_mission_item_t, offsetof(mavlink_mission_item_t, target_system))                      \
  X(MISSION_CURRENT, mavlink_mission_current_t, MessageKey::kNoTarget)                                          \
  X(COMMAND_ACK, mavlink_command_ack_t, offsetof(mavlink_command_ack_t, target_system))
#define MAVMISSION_SENT_MESSAGES(X)                                                                                \
  X(MISSION_REQUEST_LIST, mavlink_mission_request_list_t, offsetof(mavlink_mission_request_list_t, target_system)) \
  X(MISSION_CLEAR_ALL, mavlink_mission_clear_all_t, offsetof(mavlink_mission_clear_all_t, target_system))          \
  X(MISSION_SET_CURRENT, mavlink_mission_set_current_t, offsetof(mavlink_mission_set_current_t, target_system))    \
  X(COMMAND_LONG, mavlink_command_long_t, offsetof(mavlink_command_long_t, target_system))                         \
  X(COMMAND_INT, mavlink_command_int_t, offsetof(mavlink_command_int_t, target_system))                            \
  X(MISSION_WRITE_PARTIAL_LIST, mavlink_mission_write_partial_list_t,                                              \
    offsetof(mavlink_mission_write_partial_list_t, target_system))

// The key of a message, from the vendored headers. `target`: where target_system lies in the payload.
#define MAVMISSION_MESSAGE_KEY(NAME, target)                                                                         \
  {MAVLINK_MSG_ID_##NAME, MAVLINK_MSG_ID_##NAME##_CRC, MAVLINK_MSG_ID_##NAME##_MIN_LEN, MAVLINK_MSG_ID_##NAME##_LEN, \
   target}
// The same for a message without one, or for a listener that takes it whomever it is for.
#define MAVMISSION_LISTENER_KEY(NAME) MAVMISSION_MESSAGE_KEY(NAME, MessageKey::kNoTarget)

// The places of their keys in kKeys. That of a received message is its id modulo 16, so that wantedKey() finds it at
// once; the sent ones take the places between, none of them its own. 14 is free.
constexpr uint8_t kKeyPlaces = 16;
enum class KeyIndex : uint8_t {
  MISSION_REQUEST_LIST = 1,
  MISSION_CLEAR_ALL = 2,
  MISSION_SET_CURRENT = 4,
  COMMAND_LONG = 5,
  COMMAND_INT = 6,
  MISSION_WRITE_PARTIAL_LIST = 11,
#define MAVMISSION_PLACE(NAME, type, target) NAME = MAVLINK_MSG_ID_##NAME % kKeyPlaces,
  MAVMISSION_RECEIVED_MESSAGES(MAVMISSION_PLACE)
#undef MAVMISSION_PLACE
};
extern const MessageKey kKeys[];

// The key of a message type.
template <typename T>
struct MessageOf;

#define MAVMISSION_MESSAGE(NAME, type, target)                                                \
  template <>                                                                                 \
  struct MessageOf<type> {                                                                    \
    static constexpr KeyIndex kKey = KeyIndex::NAME;                                          \
    static_assert(sizeof(type) == MAVLINK_MSG_ID_##NAME##_LEN,                                \
                  "the struct of a message must have the layout of its payload on the wire"); \
  };
MAVMISSION_RECEIVED_MESSAGES(MAVMISSION_MESSAGE)
MAVMISSION_SENT_MESSAGES(MAVMISSION_MESSAGE)
#undef MAVMISSION_MESSAGE

// The payload of a received frame as a message: fields that MAVLink 2 omitted, or a MAVLink 1 sender does not know, are
// 0.
template <typename T>
T messageFrom(const FrameParser& frame) {
  T message;
  frame.copyPayload(&message, sizeof(T));
  return message;
}

}  // namespace detail
}  // namespace mavmission
