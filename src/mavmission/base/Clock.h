// Time. It is read once in each update() and passed down. An elapsed time is one unsigned subtraction, which is right
// across the wrap of millis() too.
#pragma once

#include <stdint.h>

namespace mavmission {
namespace detail {

// Milliseconds from `thenMs` to `nowMs`, both the low 16 bits of millis(). They suffice for 65 s, which is longer than
// every timeout of the protocol, and take half the RAM and code of 32 bits.
inline uint16_t since(uint16_t thenMs, uint16_t nowMs) { return static_cast<uint16_t>(nowMs - thenMs); }

}  // namespace detail
}  // namespace mavmission
