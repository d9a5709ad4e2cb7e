// The numbers that identify a message and its layout.
#pragma once

#include <stdint.h>

namespace mavmission {

// The numbers that are needed to send or to decode a message.
struct MessageKey {
  static constexpr uint8_t kNoTarget = 255;  // `target` of a message without one

  uint16_t id;       // of the message, below 65,536
  uint8_t crcExtra;  // of its definition
  uint8_t lengthV1;  // of the payload in MAVLink 1, exactly [bytes]
  uint8_t length;    // of the payload in MAVLink 2, before its trailing zeros are dropped [bytes]
  uint8_t target;    // offset of target_system in the payload, target_component following; or kNoTarget
};

}  // namespace mavmission
