// The secret that both ends of a signed link share (MAVLink guide, Message Signing).
#pragma once

#include <stdint.h>

#include "../base/Flash.h"

namespace mavmission {

// A key.
struct SigningKey {
  static constexpr uint8_t kLength = 32;  // [bytes]
  uint8_t bytes[kLength];                 // the key itself
};

// A key in flash: static const uint8_t secret[32] PROGMEM = {...}.
inline SigningKey keyInFlash(const uint8_t (&bytes)[SigningKey::kLength]) {
  SigningKey key;
  memcpy_P(key.bytes, bytes, sizeof key.bytes);
  return key;
}

// A key in RAM.
inline SigningKey keyInRam(const uint8_t (&bytes)[SigningKey::kLength]) {
  SigningKey key;
  memcpy(key.bytes, bytes, sizeof key.bytes);
  return key;
}

// The key that ground stations derive from a passphrase: its SHA-256. It takes 2 ms for every 64 characters. A null
// pointer stands for the empty passphrase.
SigningKey keyFromPassphrase(const char* passphrase);

}  // namespace mavmission
