// Whether the line loses bytes or frames, how quickly it answers, and so when to repeat what has not been answered.
#pragma once

#include <stdint.h>

#include "Config.h"
#include "RetryRules.h"

namespace mavmission {
namespace detail {

class Pace : public PaceRules {
 public:
  // Something was damaged or lost on the line.
  void noteLoss() { lossyS_ = kLossyS; }
  void onSecond() {
    busyMs_ /= 2;
    if (lossyS_ != 0) --lossyS_;
  }
  bool isLossy() const { return lossyS_ != 0; }
  uint16_t roundTripMs() const { return roundTripMs_; }
  // Answers come before anything is repeated that might do harm.
  bool isNear() const { return roundTripMs_ < kLeastMs; }

  // An answer has come `roundTripMs` after the first sending of its question. `isSure`: the question was sent only
  // once. If it was sent more than once, it is not known which sending was answered: the round trip takes no longer
  // than that.
  void learn(uint16_t roundTripMs, bool isSure);
  // The same for an answer that comes now to a question that was sent first at `startedMs`, and `tries` times.
  MAVMISSION_APART void learn(uint16_t startedMs, uint16_t nowMs, uint8_t tries);
  // An answer has come that took at least so long.
  void learnAtLeast(uint16_t ms) {
    if (ms > roundTripMs_) roundTripMs_ = ms < kMostMs ? ms : kMostMs;
  }
  // An answer came later than any that was measured.
  void noteSlower() {
    if (roundTripMs_ < kMostMs) roundTripMs_ *= 2;
  }
  // True if `ms` after something new was sent an answer is no longer one to what was sent before that.
  bool isBehind(uint16_t ms) const { return ms >= roundTripMs_ + kLeastMs; }
  // A request that comes again sooner than that after its answer was sent before the answer arrived.
  uint16_t sameRequestMs() const;
  // A request came again `afterMs` after our last answer to it: the answer, or the next request, was lost. A quicker
  // repeat says nothing: the next request may still be under way on a slow or full line.
  void noteRepeat(uint16_t afterMs) {
    if (afterMs >= kRepeatedMs && afterMs >= roundTripMs_ + roundTripMs_ / 2) noteLoss();
  }
  // The line has been busy with a frame for `ms`. The longest time is kept, and halved each second.
  void noteBusy(uint8_t ms) {
    if (ms > busyMs_) busyMs_ = ms;
  }

  // The frames are shorter from now on: what was noted of longer ones no longer counts.
  void noteShorterFrames() { busyMs_ = 0; }

  // From a message to its repeat. On a line that loses nothing it is `ruleMs`, which the protocol or the autopilots
  // demand, or more where answers are slower than that. On a lossy link it is the time after which an answer
  // should have come, or on a line that answers late a quarter of it: what is lost is then there all the same, since
  // several are on their way. Repeats take a fifth of the line, and with the zeros before them a quarter at the most.
  // `isHarmless`, of what does no harm when it comes twice: on a lossy link that answers quickly it is three quarters
  // of a round trip, but no less than a kHaste-th of the time above. At most two copies are under way: so they do not
  // pile up before a radio that is slower than our port.
  MAVMISSION_APART uint16_t waitMs(uint16_t ruleMs, bool isHarmless = false) const;

 private:
  uint16_t roundTripMs_;  // no less than it takes; 0: nothing was measured yet
  uint8_t busyMs_;
  uint8_t lossyS_;
};

}  // namespace detail
}  // namespace mavmission
