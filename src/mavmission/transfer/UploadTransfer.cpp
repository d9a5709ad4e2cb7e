#include "UploadTransfer.h"

namespace mavmission {
namespace detail {

void UploadTransfer::begin(uint16_t count, Firmware firmware, uint8_t leftovers) {
  *this = UploadTransfer();  // all zero: state Counting, no item requested yet
  behind_ = count;
  item_ = 0xFFFF;  // the one before item 0
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
  if (item > most_ || item >= behind_ || item < first_) return Status::Transferring;
  // An autopilot does not go back in a transfer: a request for an item before the one that it has requested is late. If
  // it comes still, the autopilot has begun again.
  if (item + 1u < asked_ && since(progressMs_, nowMs) < kLateRequestMs) return Status::Transferring;
  // The request that is heard decides, also where it goes back to an item that was taken for received.
  asked_ = item + 1;
  if (item == item_) {
    const uint16_t agoMs = since(sentMs_, nowMs);
    if (send_ == Send::Nothing && agoMs < pace.sameRequestMs()) return Status::Transferring;
    pace.noteRepeat(agoMs);
    repeated_ = true;
    send_ = Send::Item;
    return Status::Transferring;
  }
  if (item != nextItem()) {
    pace.noteSlower();
    repeated_ = true;
  } else if (!isAgain_) {
    pace.learn(startedMs_, nowMs, tries_);
  }
  if (state_ == State::Counting) state_ = State::Sending;
  moveTo(item, nowMs);
  return Status::Transferring;
}

// From now on this is the item that is sent, and sent again, until the autopilot is heard to have it.
void UploadTransfer::moveTo(uint16_t item, uint16_t nowMs) {
  isAgain_ = item < most_;
  if (!isAgain_) most_ = item + 1;
  item_ = item;
  progressMs_ = nowMs;
  tries_ = 0;
  isUnasked_ = false;
  send_ = Send::Item;
}

// PX4 may ignore our COUNT and continue an earlier, longer transfer of ours from which it had not received an item yet.
// Such a transfer is cancelled, and ours begins again.
void UploadTransfer::endOlder() {
  if (!has(firmware_, kGoesOnWithOlder) || !mayBeAnswered() || freed_) return;
  freed_ = true;
  state_ = State::Counting;
  send_ = Send::Cancel;
  asked_ = first_;
  item_ = first_ - 1;
  most_ = first_;
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
      // A server whose ways are not known may be idle behind the last item, with our plan or without it: that is read
      // back. Before, it has given the upload up at an item that came twice (Betaflight).
      if (has(firmware_, kMayBeOld)) return state_ == State::Confirming ? Status::Unconfirmed : Status::TimedOut;
      // ArduPilot answers so to every item but the one that it waits for, and continues. It has waited for the current
      // one; so if this answers a repeat of that, and no item before, the current item is there, and the next request
      // was lost. (That is not certain for the last item but one while an earlier transfer may be answered: a newer
      // ArduPilot answers so to every item until it has sent that transfer's acceptance.)
      if (state_ == State::Sending && has(firmware_, kRefusesTakenItems) && tries_ > 1 && send_ == Send::Nothing &&
          !(mayBeAnswered() && item_ + 2u == behind_) && pace.isBehind(since(startedMs_, nowMs))) {
        moveTo(nextItem(), nowMs);
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
        // and PX4 gives up by itself, 5 s after it has heard something, before all tries are used up. On a line that
        // loses that is so behind a reset, too, and each repeat of COUNT from before the cancelling has its error.
        const uint8_t ours = pace.isLossy() ? kBusy | kAnswers : kBusy;
        const uint8_t mayBeOurs = leftovers_ & ours;
        if (freed_) return mayBeOurs == 0 || tries_ >= kBusyTries ? status : Status::Transferring;
        freed_ = true;
        tries_ = 0;
        send_ = Send::Cancel;
        return Status::Transferring;
      }
      // So late it answers nothing earlier, but an item of this transfer, which the autopilot has given up.
      if (state_ == State::Sending && isUnasked_ && since(progressMs_, nowMs) >= kLateErrorMs) return Status::TimedOut;
      // On a line that loses, many repeats in an earlier transfer may be answered with an error each.
      // (The last item is read back in any case.)
      if (mayBeAnswered() && pace.isLossy() && (state_ != State::Confirming || !isUnasked_)) {
        if (state_ == State::Counting) break;
        return Status::Transferring;
      }
      // PX4 answers our second COUNT with an error, "busy", and continues.
      if (state_ == State::Counting) return status;
      if (!has(firmware_, kSaysErrorWhenBusy) || !recounted_) {
        // An idle autopilot answers our repeated item with an error, and with nothing else afterwards. For the last
        // item this error says nothing about the plan (PX4 answers with ACCEPTED again); for an earlier item it means
        // that the autopilot has given up, or was restarted.
        if (isUnasked_ && state_ == State::Sending) return Status::TimedOut;
        if (isUnasked_ && !has(firmware_, kRepeatsAcceptance)) return Status::Unconfirmed;
        // An idle autopilot answers so to an item that arrives after the end of the transfer, as an item that was sent
        // twice may. Any other error is a refusal of the item.
        if (state_ != State::Confirming || !repeated_) return status;
      }
      suspicion_ = status;
      return Status::Transferring;

    default: return status;
  }
  if (!mayBeAnswered()) return status;
  suspicion_ = status;
  return Status::Transferring;
}

Status UploadTransfer::onTime(uint16_t nowMs, Pace& pace) {
  if (send_ != Send::Nothing) return Status::Transferring;  // the line is not free yet
  const uint16_t stillMs = since(progressMs_, nowMs);
  const bool isCounting = state_ == State::Counting;
  if (state_ == State::Confirming) {
    if (stillMs >= kConfirmingMs) return Status::Unconfirmed;
  } else if (stillMs >= (isCounting ? kCountingMs : kPassiveMs)) {
    return suspicion_ != Status::Transferring ? suspicion_ : isCounting ? Status::NoAnswer : Status::TimedOut;
  }
  if (state_ == State::Sending && !pace.isLossy()) return Status::Transferring;
  // In a server whose ways are not known each repeat may begin the timeout anew after which it asks again (MAVSDK): so
  // every few repeats there is room for that.
  const bool isRoom = has(firmware_, kMayBeOld) && (tries_ & 7) == 0;
  if (isRoom && since(sentMs_, nowMs) < kRoomMs) return Status::Transferring;
  // While an autopilot may still be busy with an earlier transfer of ours, it needs the longer time.
  if (since(sentMs_, nowMs) < (isCounting && freed_ ? kRepeatMs : pace.waitMs(kRepeatMs))) return Status::Transferring;
  if (isCounting) {
    send_ = freed_ ? Send::Cancel : Send::Count;
    return Status::Transferring;
  }
  // The current item, although it was not requested again.
  repeated_ = true;
  isUnasked_ = true;
  send_ = Send::Item;
  return Status::Transferring;
}

void UploadTransfer::sent(uint16_t nowMs) {
  if (send_ == Send::Cancel) {
    send_ = Send::Count;
    return;
  }
  if (send_ == Send::Count) {
    if (tries_ != 0 || freed_) recounted_ = true;
    if (tries_ == 0) progressMs_ = nowMs;
  } else if (state_ != State::Confirming && item_ + 1u == behind_) {
    state_ = State::Confirming;
    suspicion_ = Status::Transferring;
  }
  if (tries_ == 0) startedMs_ = nowMs;
  const uint8_t tries = tries_ + 1;
  if (tries != 0) tries_ = tries;
  sentMs_ = nowMs;
  send_ = Send::Nothing;
}

}  // namespace detail
}  // namespace mavmission
