#include "FitReasons.h"

namespace mavmission {
namespace detail {

uint32_t greatestBits(const FrameParser& frame, uint8_t first, uint8_t count) {
  constexpr uint32_t kInfinity = 0x7F800000;
  uint32_t greatest = 0;
  for (; count != 0; --count, first += sizeof(float)) {
    const uint32_t bits = frame.payloadLong(first);
    if (bits <= kInfinity && bits > greatest) greatest = bits;
  }
  return greatest;
}

}  // namespace detail
}  // namespace mavmission
