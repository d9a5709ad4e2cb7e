// The fields of a message that a class holds as bytes, since a public header names no MAVLink type.
#pragma once

#include <stdint.h>
#include <string.h>

#include "../base/MavlinkHeaders.h"

namespace mavmission {
namespace detail {

template <typename T>
void put(uint8_t* payload, uint8_t offset, T value) {
  memcpy(payload + offset, &value, sizeof(value));
}

#define MAVMISSION_OUTGOING(NAME, payload)                                                     \
  OutgoingMessage {                                                                            \
    MAVLINK_MSG_ID_##NAME, MAVLINK_MSG_ID_##NAME##_CRC, static_cast<uint8_t>(sizeof(payload)), \
        MAVLINK_MSG_ID_##NAME##_MIN_LEN, payload                                               \
  }

}  // namespace detail
}  // namespace mavmission
