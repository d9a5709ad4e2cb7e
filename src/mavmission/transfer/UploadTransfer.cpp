#include "UploadTransfer.h"

namespace mavmission {
namespace detail {

void UploadTransfer::begin(uint16_t count, Firmware firmware, uint8_t leftovers, uint16_t nowMs) {
  *this = UploadTransfer();  // all zero: Counting, nothing asked for
  progressMs_ = nowMs;
  behind_ = count;
  send_ = Send::Count;
  suspicion_ = Status::Transferring;
  firmware_ = firmware;
  leftovers_ = leftovers;
}

Status UploadTransfer::onRequest(uint16_t item, uint16_t nowMs, Pace& pace) {
  // Before our COUNT has left only an earlier transfer can be asking.
  if (state_ == State::Counting && tries_ == 0) return Status::Transferring;
  // A request that jumps ahead, or beyond the plan, is no answer to anything that we sent: an autopilot asks for an
  // item only when it has the one before. It moves nothing.
  if (item >= behind_ && state_ == State::Confirming) endOlder();
  if (item > asked_ || item >= behind_ || item < first_) return Status::Transferring;
  if (item == asked_) {
    pace.learn(since(sentMs_, nowMs), tries_ == 1);
    ++asked_;
    isOnly_ = true;
    isUnasked_ = false;
    progressMs_ = nowMs;
    state_ = State::Sending;
    tries_ = 0;
  } else if (item == item_ && send_ == Send::Nothing && since(sentMs_, nowMs) < kSameRequestMs) {
    return Status::Transferring;
  } else {
    repeated_ = true;
    if (item + 1u != asked_) isOnly_ = false;
  }
  item_ = item;
  send_ = Send::Item;
  return Status::Transferring;
}

// PX4 goes on with an earlier, longer transfer of ours that had come to no item yet, whatever our COUNT said.
void UploadTransfer::endOlder() {
  if (!has(firmware_, kGoesOnWithOlder) || !mayBeAnswered() || freed_) return;
  freed_ = true;
  state_ = State::Counting;
  send_ = Send::Cancel;
  asked_ = first_;
  tries_ = 0;
  repeated_ = false;
}

Status UploadTransfer::onAcceptance() {
  // PX4 accepts a repeated last item though it has just failed to store the plan.
  if (state_ == State::Confirming && isUnasked_ && suspicion_ != Status::Transferring) return Status::Unconfirmed;
  if (state_ == State::Confirming || behind_ == first_) return Status::Accepted;
  if (!mayBeAnswered()) return Status::AcceptedEarly;
  suspicion_ = Status::AcceptedEarly;
  return Status::Transferring;
}

Status UploadTransfer::onAck(uint8_t result, uint16_t nowMs, Pace& pace) {
  if (state_ == State::Counting && tries_ == 0)
    return Status::Transferring;  // of something earlier: nothing of ours has left
  const Status status = fromMissionResult(result);
  switch (status) {
    case Status::Accepted: return onAcceptance();

    case Status::InvalidSequence:
      if (state_ == State::Counting) break;
      // ArduPilot says so of each item that reaches it twice, and goes on. If nothing else was sent since it was asked
      // for, ArduPilot has it, and it is the next request that was lost. (Not so that for the last item, where an
      // acceptance may be an earlier transfer's: a newer ArduPilot says so of every item while that is on its way.)
      if (state_ == State::Sending && has(firmware_, kRefusesTakenItems) && isOnly_ && tries_ > 1 &&
          send_ == Send::Nothing && !(mayBeAnswered() && asked_ + 1u == behind_)) {
        onRequest(asked_, nowMs, pace);
      }
      return Status::Transferring;

    case Status::CancelledByAutopilot:
      // It may have given up our earlier transfer; this one has not begun for it yet.
      if (state_ == State::Counting) break;
      return status;

    case Status::Denied:
      // To a part that was announced more than once: it has been receiving it from the first time on, and asks for its
      // items; the answer may come behind the first request.
      if (state_ == State::Confirming || first_ == 0 || !recounted_) return status;
      suspicion_ = status;
      return Status::Transferring;

    case Status::Error:
      if (state_ == State::Counting && !has(firmware_, kErrorRefusesCount)) {
        // PX4 is busy. If that may be with what was ours, end it, and ask again: the cancelling may be lost as well,
        // and PX4 gives up by itself, 5 s after it has heard something, before all tries are used up.
        if (freed_) return (leftovers_ & kBusy) == 0 || tries_ >= kTries ? status : Status::Transferring;
        freed_ = true;
        tries_ = 0;
        send_ = Send::Cancel;
        return Status::Transferring;
      }
      // To our own repetition an idle autopilot says so, and will say nothing else. Behind the last item it tells
      // nothing of the plan (PX4 accepts it again); before that it has given up, or was restarted.
      if (isUnasked_ && !(has(firmware_, kSaysErrorWhenBusy) && recounted_)) {
        if (state_ == State::Sending) return Status::TimedOut;
        if (!has(firmware_, kRepeatsAcceptance)) return Status::Unconfirmed;
      }
      // An idle autopilot says so of an item that reaches it after the end, as one that was sent twice may; PX4 says
      // "busy" to our own second COUNT, and goes on. Otherwise it is what became of the item.
      if ((state_ == State::Confirming && repeated_) ||
          (state_ != State::Counting && has(firmware_, kSaysErrorWhenBusy) && recounted_)) {
        suspicion_ = status;
        return Status::Transferring;
      }
      return status;

    default: return status;
  }
  if (!mayBeAnswered()) return status;
  suspicion_ = status;
  return Status::Transferring;
}

Status UploadTransfer::onTime(uint16_t nowMs, Pace& pace) {
  if (send_ != Send::Nothing) return Status::Transferring;  // the line is not free yet
  // (Where PX4 may be busy with what was ours, it needs the time.)
  const bool isHurried = state_ == State::Sending || (pace.isLossy() && !freed_);
  const bool isOverdue = since(sentMs_, nowMs) >= (isHurried ? pace.againMs() : kAnswerMs);
  const uint16_t stillMs = since(progressMs_, nowMs);
  switch (state_) {
    case State::Counting:
      if (!isOverdue) break;
      if (isHurried ? stillMs >= kCountingMs : tries_ >= kTries)
        return suspicion_ != Status::Transferring ? suspicion_ : Status::NoAnswer;
      send_ = freed_ ? Send::Cancel : Send::Count;
      break;

    case State::Sending:
      if (stillMs >= kPassiveMs) return suspicion_ != Status::Transferring ? suspicion_ : Status::TimedOut;
      if (!isOverdue) break;
      pace.noteLoss();
      sendAgain();
      break;

    case State::Confirming:
      if (stillMs >= kConfirmingMs) return Status::Unconfirmed;
      if (!isOverdue) break;
      if (!isHurried && tries_ > kTries) return Status::Unconfirmed;
      sendAgain();
      break;
  }
  return Status::Transferring;
}

// What was asked for last.
void UploadTransfer::sendAgain() {
  repeated_ = true;
  isUnasked_ = true;
  item_ = asked_ - 1;
  send_ = Send::Item;
}

void UploadTransfer::sent(uint16_t nowMs) {
  if (send_ == Send::Cancel) {
    send_ = Send::Count;
    return;
  }
  if (send_ == Send::Count) {
    recounted_ = tries_ != 0 || freed_;
  } else {
    if (state_ != State::Confirming && item_ + 1u == behind_) {
      state_ = State::Confirming;
      suspicion_ = Status::Transferring;
    }
  }
  if (tries_ != 255) ++tries_;
  sentMs_ = nowMs;
  send_ = Send::Nothing;
}

}  // namespace detail
}  // namespace mavmission
