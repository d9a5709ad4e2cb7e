// The square root of a whole number.
#pragma once

#include <stdint.h>

namespace mavmission {
namespace detail {

// Rounded down, bit by bit.
inline uint16_t rootOf(uint32_t square) {
  uint16_t root = 0;
  for (uint16_t bit = 0x8000; bit != 0; bit >>= 1) {
    const uint16_t more = root | bit;
    if (static_cast<uint32_t>(more) * more <= square) root = more;
  }
  return root;
}

}  // namespace detail
}  // namespace mavmission
