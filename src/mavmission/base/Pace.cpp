#include "Pace.h"

namespace mavmission {
namespace detail {

uint16_t Pace::waitMs(uint16_t ruleMs) const {
  if (!isLossy()) return ruleMs;
  const uint16_t answeredMs = kRoundTrips * roundTripMs_;
  const uint16_t leastMs = kFrameTimes * busyMs_;
  return answeredMs > leastMs ? answeredMs : leastMs;
}

}  // namespace detail
}  // namespace mavmission
