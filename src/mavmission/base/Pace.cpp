#include "Pace.h"

namespace mavmission {
namespace detail {

void Pace::learn(uint16_t roundTripMs, bool isSure) {
  if (roundTripMs > kMostMs) roundTripMs = kMostMs;
  if (isSure && roundTripMs_ != 0 && roundTripMs > roundTripMs_)
    roundTripMs = roundTripMs_ + (roundTripMs - roundTripMs_) / 4;
  if (isSure || roundTripMs_ == 0 || roundTripMs < roundTripMs_) roundTripMs_ = roundTripMs;
}

uint16_t Pace::sameRequestMs() const { return roundTripMs_ > kSameRequestMs ? roundTripMs_ : kSameRequestMs; }

uint16_t Pace::waitMs(uint16_t ruleMs) const {
  uint16_t answeredMs = roundTripMs_ / kHurry;
  if (isLossy()) {
    if (answeredMs > kMostWaitMs) answeredMs = kMostWaitMs;
    const uint8_t leastMs = ruleMs < kQuickMs ? kLeastMs / 2 : kLeastMs;
    ruleMs = kFrameTimes * busyMs_;
    if (ruleMs < leastMs) ruleMs = leastMs;
  } else {
    answeredMs = roundTripMs_ * kPatience;
  }
  return answeredMs > ruleMs ? answeredMs : ruleMs;
}

}  // namespace detail
}  // namespace mavmission
