#include "ClearTransfer.h"

#include "../base/Clock.h"

namespace mavmission {
namespace detail {

void ClearTransfer::begin(PlanType type, bool isDoubtful) {
  const bool isAll = type == PlanType::All;
  last_ = isAll ? PlanType::Rally : type;
  isDoubtful_ = isDoubtful;
  begin(isAll ? PlanType::Mission : type);
}

void ClearTransfer::begin(PlanType type) {
  type_ = type;
  tries_ = 0;
  clears_ = 0;
  isAsking_ = false;
  state_ = State::Due;
}

bool ClearTransfer::onAccepted() {
  if (!isDoubtful_) return true;
  clears_ = tries_;
  tries_ = 0;
  isAsking_ = true;
  state_ = State::Due;
  return false;
}

bool ClearTransfer::onCount(bool isEmpty) {
  if (isEmpty) return true;
  tries_ = clears_;
  isAsking_ = false;
  state_ = State::Due;
  return false;
}

bool ClearTransfer::next() {
  if (type_ == last_) return false;
  begin(static_cast<PlanType>(static_cast<uint8_t>(type_) + 1));
  return true;
}

Status ClearTransfer::onTime(uint16_t nowMs, const Pace& pace) {
  if (state_ == State::Sent) {
    if (since(sentMs_, nowMs) < pace.waitMs(kAnswerMs)) return Status::Transferring;
    state_ = State::Due;
  }
  if (tries_ < (pace.isLossy() ? Pace::kLossyTries : kTries)) return Status::Transferring;
  return clears_ != 0 ? Status::Unconfirmed : Status::NoAnswer;
}

void ClearTransfer::sent(uint16_t nowMs) {
  state_ = State::Sent;
  ++tries_;
  sentMs_ = nowMs;
}

}  // namespace detail
}  // namespace mavmission
