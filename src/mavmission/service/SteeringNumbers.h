// Numbers of metres and of places, as Steering looks at them.
#pragma once

#include <stdint.h>
#include <string.h>

#include "../base/FloatBits.h"

namespace mavmission {
namespace detail {

// A number of metres in centimetres; 0 if it does not fit.
inline int32_t centimetres(float metres) {
  int32_t bits;
  memcpy(&bits, &metres, sizeof(bits));
  return timesWhole(bits, 100);
}

inline bool isNear(int32_t a, int32_t b, int32_t within) {
  const int32_t apart = a - b;
  return apart <= within && apart >= -within;
}

// PX4's mode while it takes off, in the numbers of modeNumber(); it goes over to HOLD by itself.
constexpr uint16_t kPx4TakeOff = 4 | 2 << 8;

}  // namespace detail
}  // namespace mavmission
