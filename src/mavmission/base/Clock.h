// Time. It is read once in each update() and passed down; an elapsed time is one unsigned subtraction, right across the
// wrap of millis().
#pragma once

#include <stdint.h>

namespace mavmission {
namespace detail {

// Milliseconds from `thenMs` to `nowMs`, both the low 16 bits of millis(): right up to 65 s, which is longer than every
// wait of the protocol and half the RAM and code of 32 bits.
inline uint16_t since(uint16_t thenMs, uint16_t nowMs) { return static_cast<uint16_t>(nowMs - thenMs); }

}  // namespace detail
}  // namespace mavmission
