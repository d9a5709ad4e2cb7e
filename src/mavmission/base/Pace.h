// Whether the line loses bytes or frames, how quickly it answers, and so when to repeat what has not been answered.
#pragma once

#include <stdint.h>

#include "../Config.h"
#include "RetryRules.h"

namespace mavmission {
namespace detail {

class Pace : public PaceRules {
 public:
  void begin() { roundTripMs_ = kFirstMs; }

  // Something was damaged or lost on the line.
  void noteLoss() { lossyS_ = kLossyS; }
  void onSecond() {
    busyMs_ /= 2;
    if (lossyS_ != 0) --lossyS_;
  }
  bool isLossy() const { return lossyS_ != 0; }

  // An answer has come `roundTripMs` after the last sending of its question. `isSure`: the question was sent only once.
  // If it was sent more than once, it is not known which sending was answered; and an autopilot that repeats its own
  // request makes the time look longer.
  void learn(uint16_t roundTripMs, bool isSure) {
    if (isSure || roundTripMs < roundTripMs_) roundTripMs_ = roundTripMs;
  }
  // A request came again `afterMs` after our last answer to it: the answer, or the next request, was lost. A quicker
  // repeat says nothing: the next request may still be under way on a slow or full line.
  void noteRepeat(uint16_t afterMs) {
    if (afterMs >= waitMs(kRepeatedMs)) noteLoss();
  }
  // The line has been busy with a frame for `ms`. The longest time is kept, and halved each second.
  void noteBusy(uint8_t ms) {
    if (ms > busyMs_) busyMs_ = ms;
  }

  // From a message to its repeat. On a line that loses nothing it is `ruleMs`, which the protocol or the autopilots
  // demand, or more where answers are slower than that. On a line that loses it is the time after which an answer
  // should have come; repeats then take a fifth of the line, and with the zeros before them a quarter at the most.
  MAVMISSION_APART uint16_t waitMs(uint16_t ruleMs) const;

 private:
  uint16_t roundTripMs_;
  uint8_t busyMs_;
  uint8_t lossyS_;
};

}  // namespace detail
}  // namespace mavmission
