// How quickly the line answers, and whether it loses: when to send again what has had no answer.
#pragma once

#include <stdint.h>

#include "../Config.h"

namespace mavmission {
namespace detail {

class Pace {
 public:
  static constexpr uint8_t kLossyS = 10;        // a line that has lost something is taken for one that loses [s]
  static constexpr uint8_t kFirstMs = 40;       // a round trip before one was heard
  static constexpr uint16_t kPatienceMs = 250;  // the least wait on a line that has lost nothing

  void begin() { roundTripMs_ = kFirstMs; }

  // Something was damaged or lost on the line.
  void noteLoss() { lossyS_ = kLossyS; }
  void onSecond() {
    busyMs_ /= 2;
    if (lossyS_ != 0) --lossyS_;
  }
  bool isLossy() const { return lossyS_ != 0; }

  // An answer has come so long after the last sending of what it answers. `isSure`: it was the only one.
  // (Of what was sent more than once it is not known which was answered, and an autopilot that asks again by itself
  // makes it look longer.)
  void learn(uint16_t roundTripMs, bool isSure) {
    if (isSure || roundTripMs < roundTripMs_) roundTripMs_ = roundTripMs;
  }
  // The line has been busy with a frame for so long. (The longest counts, and is forgotten in some seconds.)
  void noteBusy(uint16_t ms) {
    if (ms > busyMs_) busyMs_ = ms;
  }

  // How long to wait for an answer to what may be sent again. On a line that loses repeats take a fifth of it, and what
  // fills before others something of the rest: a quarter in all.
  MAVMISSION_APART uint16_t againMs() const;

 private:
  uint16_t roundTripMs_;
  uint16_t busyMs_;
  uint8_t lossyS_;
};

}  // namespace detail
}  // namespace mavmission
