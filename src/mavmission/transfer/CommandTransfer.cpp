#include "CommandTransfer.h"

namespace mavmission {
namespace detail {

void CommandTransfer::next(bool repeats) {
  rest();
  state_ = static_cast<uint8_t>(State::Due);
  repeats_ = repeats ? 1 : 0;
  isGuarded_ = 0;
  if (isAsking_ != 0) isFresh_ = 0;  // it was about the request
  isAsking_ = 0;
}

void CommandTransfer::asked(uint16_t nowMs) {
  lookedMs_ = nowMs;
  isFresh_ = 0;
}

bool CommandTransfer::look(bool isOld, bool isBlind, uint16_t nowMs) {
  const bool isFirst = isOld_ == 0;
  isOld_ = isOld ? 1 : 0;
  if (isBlind) ordered_ = static_cast<uint8_t>(nowMs / kOrderTickMs - kUnderWayMs / kOrderTickMs);  // long ago
  if (!mayBeUnderWay(nowMs)) hasOrdered_ = 0;
  if (!isOld) return false;
  isFresh_ = isAsking_;
  return isFirst && isGuarded_ != 0;
}

void CommandTransfer::onHeartbeat(uint16_t nowMs) {
  if (isOld_ != 0) return;  // a newer one is asked for
  lookedMs_ = nowMs;
  isFresh_ = 1;
  isAsking_ = 0;
}

void CommandTransfer::wait(State state, uint16_t waitMs, uint16_t nowMs) {
  state_ = static_cast<uint8_t>(state);
  sentMs_ = nowMs;
  waitMs_ = waitMs;
}

void CommandTransfer::sent(uint16_t nowMs, uint16_t answerMs) {
  const uint8_t isLossy = answerMs < kAnswerMs ? 1 : 0;
  const bool isAcceptedAgain = tries_ != 0 && waitMs_ == kAcceptedMs && !isRestoring();
  tries_ += isAcceptedAgain ? kAcceptedTries : 1;
  if (isGuarded_ != 0) {
    // What a heartbeat shows sooner may be from before the order has arrived: it would be sent once too often.
    if (answerMs < kUnderWayMs) answerMs = kUnderWayMs;
    ordered_ = static_cast<uint8_t>(nowMs / kOrderTickMs);
    hasOrdered_ = 1;
    isFresh_ = 0;
  }
  if (isRestoring()) {
    isFresh_ = isLossy;
    return;
  }
  wait(State::Sent, repeats_ != 0 ? answerMs : kProgressMs, nowMs);
}

Status CommandTransfer::onTime(uint8_t asksOpen, uint16_t nowMs) {
  if (isAsking_ != 0 && asksOpen >= (isUrgent() ? kMostUrgentAsks : kMostAsks) && since(lookedMs_, nowMs) >= kAskMs) {
    isAsking_ = 0;
    tries_ = 0;
    return Status::NoAnswer;
  }
  // What has come of an order is asked for, also where its answer was lost: somebody may undo it before it would be
  // sent again.
  const bool isUnseen = isGuarded_ != 0 && isAsking_ == 0 && isFresh_ == 0 && state() == State::Sent;
  if (isUnseen && since(sentMs_, nowMs) >= kAskMs) askLater();
  if (isRestoring() && tries_ >= kRestoreTries) {
    tries_ = 0;
    return Status::NoAnswer;
  }
  if (isDue() || isUrgent() || since(sentMs_, nowMs) < waitMs_) return Status::Transferring;
  // The autopilot may have carried out the command, and only its answer may be lost: a command that must not happen
  // twice is not sent again.
  const bool isSilent = state() == State::Listening || (state() != State::Pausing && repeats_ == 0);
  const uint8_t most = waitMs_ < kAnswerMs && state() == State::Sent ? kLossyTries : kTries;
  if (!isSilent && tries_ < most) {
    state_ = static_cast<uint8_t>(State::Due);
    return Status::Transferring;
  }
  tries_ = 0;
  return isSilent ? Status::Unconfirmed : Status::NoAnswer;
}

}  // namespace detail
}  // namespace mavmission
