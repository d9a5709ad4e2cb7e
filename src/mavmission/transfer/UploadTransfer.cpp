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

Status UploadTransfer::onRequest(uint16_t item, uint16_t nowMs) {
  // Before our COUNT has left, or while it is to be sent again, only an earlier transfer can be asking.
  if (state_ == State::Counting && send_ != Send::Nothing) return Status::Transferring;
  // A request that jumps ahead, or beyond the plan, is no answer to anything that we sent: an autopilot asks for an
  // item only when it has the one before. It moves nothing.
  if (item >= behind_ && state_ == State::Confirming) endOlder();
  if (item > asked_ || item >= behind_ || item < first_) return Status::Transferring;
  if (item == asked_) {
    ++asked_;
    progressMs_ = nowMs;
    state_ = State::Sending;
    tries_ = 0;
  } else if (item == item_ && send_ == Send::Nothing && since(sentMs_, nowMs) < kSameRequestMs) {
    return Status::Transferring;
  } else {
    repeated_ = true;
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
  if (state_ == State::Confirming && tries_ != 0 && suspicion_ != Status::Transferring) return Status::Unconfirmed;
  if (state_ == State::Confirming || behind_ == first_) return Status::Accepted;
  if (!mayBeAnswered()) return Status::AcceptedEarly;
  suspicion_ = Status::AcceptedEarly;
  return Status::Transferring;
}

Status UploadTransfer::onAck(uint8_t result) {
  if (state_ == State::Counting && tries_ == 0)
    return Status::Transferring;  // of something earlier: nothing of ours has left
  const Status status = fromMissionResult(result);
  switch (status) {
    case Status::Accepted: return onAcceptance();

    case Status::InvalidSequence:
      // Noise while it moves: ArduPilot says so of each item that reaches it twice, and goes on.
      if (state_ != State::Counting) return Status::Transferring;
      break;

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
        if (freed_) return (leftovers_ & kBusy) == 0 || tries_ >= kCountTries ? status : Status::Transferring;
        freed_ = true;
        tries_ = 0;
        send_ = Send::Cancel;
        return Status::Transferring;
      }
      // To our own repetition ArduPilot says so when it is idle, and will say nothing else: it tells nothing of the
      // plan.
      if (state_ == State::Confirming && tries_ != 0 && !has(firmware_, kRepeatsAcceptance)) return Status::Unconfirmed;
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

Status UploadTransfer::onTime(uint16_t nowMs) {
  if (send_ != Send::Nothing) return Status::Transferring;  // the line is not free yet
  const bool overdue = since(sentMs_, nowMs) >= (state_ == State::Counting ? kCountMs : kLastItemMs);
  switch (state_) {
    case State::Counting:
      if (!overdue) break;
      if (tries_ >= kCountTries) return suspicion_ != Status::Transferring ? suspicion_ : Status::NoAnswer;
      send_ = freed_ ? Send::Cancel : Send::Count;
      break;

    case State::Sending:
      if (since(progressMs_, nowMs) < kPassiveMs) break;
      return suspicion_ != Status::Transferring ? suspicion_ : Status::TimedOut;

    case State::Confirming:
      if (since(progressMs_, nowMs) >= kConfirmingMs) return Status::Unconfirmed;
      if (!overdue) break;
      if (tries_ == kLastItemTries) return Status::Unconfirmed;
      ++tries_;
      repeated_ = true;
      item_ = behind_ - 1;
      send_ = Send::Item;
      break;
  }
  return Status::Transferring;
}

void UploadTransfer::sent(uint16_t nowMs) {
  switch (send_) {
    case Send::Count:
      recounted_ = tries_ != 0 || freed_;
      ++tries_;
      sentMs_ = nowMs;
      send_ = Send::Nothing;
      break;
    case Send::Cancel: send_ = Send::Count; break;
    case Send::Item:
      if (state_ != State::Confirming && item_ + 1u == behind_) {
        state_ = State::Confirming;
        suspicion_ = Status::Transferring;
      }
      sentMs_ = nowMs;
      send_ = Send::Nothing;
      break;
    case Send::Nothing: break;
  }
}

}  // namespace detail
}  // namespace mavmission
