#include "Pace.h"

namespace mavmission {
namespace detail {

uint16_t Pace::waitMs(uint16_t ruleMs) const {
  const bool lossy = isLossy();
  const uint16_t answeredMs = (lossy ? kHurry : kPatience) * roundTripMs_;
  const uint16_t leastMs = lossy ? kFrameTimes * busyMs_ : ruleMs;
  return answeredMs > leastMs ? answeredMs : leastMs;
}

}  // namespace detail
}  // namespace mavmission
