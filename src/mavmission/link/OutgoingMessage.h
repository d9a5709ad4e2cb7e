// A message that the sketch sends, of any dialect.
#pragma once

#include <stdint.h>

namespace mavmission {

// For MissionClient::sendMessage().
struct OutgoingMessage {
  uint32_t id;          // below 2^24
  uint8_t crcExtra;     // CRC_EXTRA of its definition
  uint8_t length;       // of the payload [bytes], up to 255, extensions included
  uint8_t lengthV1;     // of the payload in MAVLink 1 [bytes], without extensions; 0: not to be sent there
  const void* payload;  // in wire order: the fields sorted by size, little-endian
};

}  // namespace mavmission
