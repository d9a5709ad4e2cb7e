#include "Pace.h"

#include "Clock.h"

namespace mavmission {
namespace detail {

void Pace::learn(uint16_t roundTripMs, bool isSure) {
  if (roundTripMs > kMostMs) roundTripMs = kMostMs;
  if (roundTripMs_ != 0 && roundTripMs > roundTripMs_) {
    if (!isSure) return;
    roundTripMs = roundTripMs_ + (roundTripMs - roundTripMs_) / 4;
  }
  roundTripMs_ = roundTripMs;
}

void Pace::learn(uint16_t startedMs, uint16_t nowMs, uint8_t tries) { learn(since(startedMs, nowMs), tries == 1); }

uint16_t Pace::sameRequestMs() const { return roundTripMs_ > kSameRequestMs ? roundTripMs_ : kSameRequestMs; }

uint16_t Pace::waitMs(uint16_t ruleMs, bool isHarmless) const {
  uint16_t answeredMs = roundTripMs_ * kPatience;
  if (isLossy()) {
    answeredMs = roundTripMs_ / kHurry;
    if (answeredMs > kMostWaitMs) answeredMs = kMostWaitMs;
    const uint8_t leastMs = ruleMs < kQuickMs ? kLeastMs / 2 : kLeastMs;
    ruleMs = kFrameTimes * busyMs_;
    if (ruleMs < leastMs) ruleMs = leastMs;
    if (isHarmless && roundTripMs_ < leastMs) {
      ruleMs /= kHaste;
      answeredMs = roundTripMs_ - roundTripMs_ / 4;
    }
  }
  return answeredMs > ruleMs ? answeredMs : ruleMs;
}

}  // namespace detail
}  // namespace mavmission
