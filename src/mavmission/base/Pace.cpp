#include "Pace.h"

namespace mavmission {
namespace detail {

void Pace::learn(uint16_t roundTripMs, bool isSure) {
  if (roundTripMs < roundTripMs_) {
    roundTripMs_ = (roundTripMs_ + roundTripMs) / 2;
  } else if (isSure) {
    // (Of what was sent more than once it is not known which was answered, and an autopilot that asks again by itself
    // makes it look longer.)
    roundTripMs_ = roundTripMs;
  }
}

uint16_t Pace::againMs() const {
  const bool lossy = isLossy();
  const uint16_t waitMs = lossy ? 2 * roundTripMs_ : 4 * roundTripMs_;
  const uint16_t leastMs = lossy ? 4 * busyMs_ : kPatienceMs;
  return waitMs > leastMs ? waitMs : leastMs;
}

}  // namespace detail
}  // namespace mavmission
