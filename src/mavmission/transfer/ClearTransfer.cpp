#include "ClearTransfer.h"

#include "../base/Clock.h"

namespace mavmission {
namespace detail {

void ClearTransfer::begin(PlanType type) {
  const bool isAll = type == PlanType::All;
  last_ = isAll ? PlanType::Rally : type;
  next(isAll ? PlanType::Mission : type);
}

void ClearTransfer::next(PlanType type) {
  type_ = type;
  tries_ = 0;
  state_ = State::Due;
}

Status ClearTransfer::onAccepted() {
  if (type_ == last_) return Status::Cleared;
  next(static_cast<PlanType>(static_cast<uint8_t>(type_) + 1));
  return Status::Transferring;
}

Status ClearTransfer::onTime(uint16_t nowMs, const Pace& pace) {
  if (state_ == State::Due || since(sentMs_, nowMs) < pace.waitMs(kAnswerMs)) return Status::Transferring;
  if (tries_ >= (pace.isLossy() ? Pace::kLossyTries : kTries)) return Status::NoAnswer;
  state_ = State::Due;
  return Status::Transferring;
}

void ClearTransfer::sent(uint16_t nowMs) {
  state_ = State::Sent;
  ++tries_;
  sentMs_ = nowMs;
}

}  // namespace detail
}  // namespace mavmission
