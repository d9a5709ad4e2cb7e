// What identifies a message and its layout.
#pragma once

#include <stdint.h>

namespace mavmission {

// What must be known of a message in order to send it or to keep it.
struct MessageKey {
  static constexpr uint8_t kNoTarget = 255;  // `target` of a message without one

  uint16_t id;       // of the message, below 65,536
  uint8_t crcExtra;  // of its definition
  uint8_t lengthV1;  // of the payload in MAVLink 1, exactly [bytes]
  uint8_t length;    // of the payload in MAVLink 2, before its trailing zeros are dropped [bytes]
  uint8_t target;    // where target_system lies in the payload, target_component behind it; kNoTarget if it has none
};

}  // namespace mavmission
