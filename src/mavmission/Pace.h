// How quickly the line answers, and whether it loses: when to send again what has had no answer.
#pragma once

#include <stdint.h>

#include "Config.h"

namespace mavmission {

// A repeat takes a quarter of the line at the most: it comes not before four round trips, and a round trip is an item
// and a request, or a request and an item, on the line.
class Pace {
 public:
  static constexpr uint8_t kLossyS = 10;       // a line that has lost something is taken for one that loses [s]
  static constexpr uint8_t kFirstMs = 40;      // a round trip before one was heard
  static constexpr uint16_t kPatienceMs = 250;  // the least wait on a line that has lost nothing

  // Something was damaged or lost on the line.
  void noteLoss() { lossyS_ = kLossyS; }
  void onSecond() {
    if (lossyS_ != 0) --lossyS_;
  }
  bool isLossy() const { return lossyS_ != 0; }

  // An answer has come so long after the last sending of what it answers. `isSure`: it was the only one.
  MAVMISSION_APART void learn(uint16_t roundTripMs, bool isSure);

  // What the line took for the last frame [ms].
  uint8_t& lineMs() { return lineMs_; }

  // How long to wait for an answer to what may be sent again.
  MAVMISSION_APART uint16_t againMs() const;
  // The same for what is sent again on a line that loses only, and otherwise after so long.
  uint16_t againMs(uint16_t otherwiseMs) const { return isLossy() ? againMs() : otherwiseMs; }

 private:
  static constexpr uint16_t kMostMs = 4000;

  uint16_t knownMs() const { return roundTripMs_ != 0 ? roundTripMs_ : kFirstMs; }

  uint16_t roundTripMs_;  // 0 before one was heard
  uint8_t lossyS_;
  uint8_t lineMs_;
};

}  // namespace mavmission
