#include "Pace.h"

namespace mavmission {
namespace detail {

uint16_t Pace::waitMs(uint16_t ruleMs) const {
  uint16_t answeredMs = kHurry * roundTripMs_;
  if (isLossy()) {
    ruleMs = kFrameTimes * busyMs_;
  } else {
    answeredMs *= kPatience / kHurry;
  }
  return answeredMs > ruleMs ? answeredMs : ruleMs;
}

}  // namespace detail
}  // namespace mavmission
