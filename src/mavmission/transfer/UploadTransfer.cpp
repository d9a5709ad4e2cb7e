#include "UploadTransfer.h"

namespace mavmission {
namespace detail {

void UploadTransfer::begin(uint16_t count, Firmware firmware, uint8_t leftovers, uint16_t nowMs) {
  *this = UploadTransfer();  // all zero: state Counting, no item requested yet
  progressMs_ = nowMs;
  behind_ = count;
  send_ = Send::Count;
  suspicion_ = Status::Transferring;
  firmware_ = firmware;
  leftovers_ = leftovers;
}

Status UploadTransfer::onRequest(uint16_t item, uint16_t nowMs, Pace& pace) {
  // Before our COUNT has been sent a request can only belong to an earlier transfer.
  if (state_ == State::Counting && tries_ == 0) return Status::Transferring;
  // A request that skips items, or lies beyond the plan, answers nothing that we sent: an autopilot requests an item
  // only when it has the one before. Such a request is ignored.
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
  } else if (item == item_ && send_ == Send::Nothing &&
             since(sentMs_, nowMs) < (pace.isLossy() ? pace.waitMs(0) : kSameRequestMs)) {
    return Status::Transferring;
  } else {
    pace.noteRepeat(since(sentMs_, nowMs));
    repeated_ = true;
    if (item + 1u != asked_) isOnly_ = false;
  }
  item_ = item;
  send_ = Send::Item;
  return Status::Transferring;
}

// PX4 may ignore our COUNT and continue an earlier, longer transfer of ours from which it had not received an item yet.
// Such a transfer is cancelled, and ours begins again.
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
  // PX4 answers a repeated last item with ACCEPTED even when it has just failed to store the plan.
  if (state_ == State::Confirming && isUnasked_ && suspicion_ != Status::Transferring) return Status::Unconfirmed;
  if (state_ == State::Confirming || behind_ == first_) return Status::Accepted;
  if (!mayBeAnswered()) return Status::AcceptedEarly;
  suspicion_ = Status::AcceptedEarly;
  return Status::Transferring;
}

Status UploadTransfer::onAck(uint8_t result, uint16_t nowMs, Pace& pace) {
  if (state_ == State::Counting && tries_ == 0)
    return Status::Transferring;  // an answer to something earlier: nothing of this upload has been sent yet
  const Status status = fromMissionResult(result);
  switch (status) {
    case Status::Accepted: return onAcceptance();

    case Status::InvalidSequence:
      if (state_ == State::Counting) break;
      // ArduPilot answers so to every item that it receives twice, and continues. If no other item was sent since its
      // request, ArduPilot has this item, and the next request was lost. (That is not certain for the last item but one
      // while an earlier transfer may be answered: a newer ArduPilot answers so to every item until it has sent that
      // transfer's acceptance.)
      if (state_ == State::Sending && has(firmware_, kRefusesTakenItems) && isOnly_ && tries_ > 1 &&
          send_ == Send::Nothing && !(mayBeAnswered() && asked_ + 1u == behind_)) {
        onRequest(asked_, nowMs, pace);
      }
      return Status::Transferring;

    case Status::CancelledByAutopilot:
      // The autopilot may mean our earlier transfer, since it has not begun this one yet.
      if (state_ == State::Counting) break;
      return status;

    case Status::Denied:
      // When a part of a plan was announced more than once, the autopilot denies the repetition: it has been receiving
      // the part since the first announcement, and requests its items. The denial may come after the first request.
      if (state_ == State::Confirming || first_ == 0 || !recounted_) return status;
      suspicion_ = status;
      return Status::Transferring;

    case Status::Error:
      if (state_ == State::Counting && !has(firmware_, kErrorRefusesCount)) {
        // PX4 is busy. If that may be with what was ours, end it, and ask again: the cancelling may be lost as well,
        // and PX4 gives up by itself, 5 s after it has heard something, before all tries are used up.
        if (freed_) return (leftovers_ & kBusy) == 0 || tries_ >= kCountTries ? status : Status::Transferring;
        freed_ = true;
        tries_ = 0;
        send_ = Send::Cancel;
        return Status::Transferring;
      }
      // An idle autopilot answers our repeated item with an error, and with nothing else afterwards. For the last item
      // this error says nothing about the plan (PX4 answers with ACCEPTED again); for an earlier item it means that the
      // autopilot has given up, or was restarted.
      if (isUnasked_ && !(has(firmware_, kSaysErrorWhenBusy) && recounted_)) {
        if (state_ == State::Sending) return Status::TimedOut;
        if (!has(firmware_, kRepeatsAcceptance)) return Status::Unconfirmed;
      }
      // An idle autopilot answers with an error to an item that arrives after the end of the transfer, as an item that
      // was sent twice may. PX4 answers our second COUNT with an error, "busy", and continues. Any other error is a
      // refusal of the item.
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
  // While an autopilot may still be busy with an earlier transfer of ours, it needs the longer time.
  const bool isLossy = pace.isLossy() && !(state_ == State::Counting && freed_);
  const uint16_t waitMs = state_ == State::Counting ? kCountMs : kLastItemMs;
  const bool isOverdue = since(sentMs_, nowMs) >= (state_ == State::Counting && freed_ ? waitMs : pace.waitMs(waitMs));
  const uint16_t stillMs = since(progressMs_, nowMs);
  switch (state_) {
    case State::Counting:
      if (!isOverdue) break;
      if (isLossy ? stillMs >= kCountingMs : tries_ >= kCountTries)
        return suspicion_ != Status::Transferring ? suspicion_ : Status::NoAnswer;
      send_ = freed_ ? Send::Cancel : Send::Count;
      break;

    case State::Sending:
      if (stillMs >= kPassiveMs) return suspicion_ != Status::Transferring ? suspicion_ : Status::TimedOut;
      if (isLossy && isOverdue) sendAgain();
      break;

    case State::Confirming:
      if (stillMs >= kConfirmingMs) return Status::Unconfirmed;
      if (!isOverdue) break;
      if (!isLossy && tries_ > kLastItemTries) return Status::Unconfirmed;
      sendAgain();
      break;
  }
  return Status::Transferring;
}

// Sends the item of the newest request again, although it was not requested again.
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
