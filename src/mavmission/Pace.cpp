#include "Pace.h"

namespace mavmission {

void Pace::learn(uint16_t roundTripMs, bool isSure) {
  const uint16_t known = knownMs();
  // Halfway down to a shorter one. Up to a longer one at once if what was sent once was answered; of what was sent more
  // often it is not known which was, and an autopilot that asks again by itself makes it look longer.
  if (roundTripMs < known) {
    roundTripMs = (known + roundTripMs) / 2;
  } else if (!isSure && roundTripMs > known + known / 4) {
    roundTripMs = known + known / 4;
  }
  roundTripMs_ = roundTripMs < kMostMs ? roundTripMs : kMostMs;
}

uint16_t Pace::againMs() const {
  const uint16_t knownMs = this->knownMs();
  if (isLossy()) {
    const uint16_t quarterMs = 4 * lineMs_;
    return 2 * knownMs > quarterMs ? 2 * knownMs : quarterMs;
  }
  return 8 * knownMs > kPatienceMs ? 8 * knownMs : kPatienceMs;
}

}  // namespace mavmission
