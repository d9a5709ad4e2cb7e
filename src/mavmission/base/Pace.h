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
  // The line has been busy with a frame for `ms`. The longest time is kept, and halved each second.
  void noteBusy(uint16_t ms) {
    if (ms > busyMs_) busyMs_ = ms;
  }

  // From a message to its repeat: on a line that loses nothing `ruleMs`, which the protocol or the autopilots demand.
  // On a line that loses, the time after which an answer should have come; repeats then take a fifth of the line, and
  // with the zeros before them less than a quarter.
  MAVMISSION_APART uint16_t waitMs(uint16_t ruleMs) const;

 private:
  uint16_t roundTripMs_;
  uint16_t busyMs_;
  uint8_t lossyS_;
};

}  // namespace detail
}  // namespace mavmission
