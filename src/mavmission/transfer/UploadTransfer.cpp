#include "UploadTransfer.h"

namespace mavmission {
namespace detail {

void UploadTransfer::begin(uint16_t count, Firmware firmware, uint8_t leftovers) {
  *this = UploadTransfer();  // all zero: state Counting, no item requested yet
  end_ = count;
  item_ = 0xFFFF;  // the one before item 0
  send_ = Send::Count;
  suspicion_ = Status::Transferring;
  firmware_ = firmware;
  evidence_ = leftovers & (kFromOpen | kFromBusy | kFromBefore);
}

Status UploadTransfer::onRequest(uint16_t item, uint16_t nowMs, Pace& pace) {
  // Before our COUNT has been sent a request can only belong to an earlier transfer.
  if (state_ == State::Counting && tries_ == 0) return Status::Transferring;
  // A request that skips items, or lies beyond the plan, answers nothing that we sent: an autopilot requests an item
  // only when it has the one before.
  if (item >= end_ && state_ != State::Counting) endOther();
  if (item > sentEnd_ || item >= end_ || item < first_) return Status::Transferring;
  // An autopilot does not go back in a transfer: a request for an item before the one that it has requested is late. If
  // it comes still, the autopilot has begun again.
  if (item + 1u < requestedEnd_ && since(progressMs_, nowMs) < kLateRequestMs) return Status::Transferring;
  // The request that is heard decides, also where it goes back to an item that was taken for received.
  requestedEnd_ = item + 1;
  if (item == item_) {
    const uint16_t agoMs = since(sentMs_, nowMs);
    if (send_ == Send::Nothing && agoMs < pace.sameRequestMs()) return Status::Transferring;
    pace.noteRepeat(agoMs);
    note(kItemAgain);
    send_ = Send::Item;
    return Status::Transferring;
  }
  // The next one, or the one after that, which PX4 may have been sent.
  if (static_cast<uint16_t>(item - item_) > 2) {
    pace.noteSlower();
    note(kItemAgain);
  } else if (!isAgain_) {
    pace.learn(startedMs_, nowMs, tries_);
  }
  if (state_ == State::Counting) state_ = State::Sending;
  moveTo(item, nowMs);
  return Status::Transferring;
}

// From now on this is the item that is sent, and sent again, until the autopilot is heard to have it.
void UploadTransfer::moveTo(uint16_t item, uint16_t nowMs) {
  isAgain_ = item < sentEnd_;
  if (!isAgain_) sentEnd_ = item + 1;
  item_ = item;
  progressMs_ = nowMs;
  tries_ = 0;
  evidence_ &= static_cast<uint8_t>(~kUnasked);
  send_ = Send::Item;
}

// The autopilot receives another, longer plan: a COUNT of an earlier upload has arrived after ours, or PX4 has ignored
// ours and continues an upload from which it had not received an item yet. That one is ended, and ours begins again.
void UploadTransfer::endOther() {
  note(kBeyond);
  if (state_ == State::Confirming && first_ == 0 && !has(kFreed) && !detail::has(firmware_, kMayBeOld)) freeFirst();
}

void UploadTransfer::freeFirst() {
  note(kFreed);
  state_ = State::Counting;
  send_ = Send::Cancel;
  requestedEnd_ = 0;
  item_ = 0xFFFF;
  sentEnd_ = 0;
  tries_ = 0;
}

// The evidence when an answer comes.
struct UploadTransfer::Now {
  const UploadTransfer& transfer;
  const Pace& pace;
  uint16_t ms;

  MAVMISSION_INLINE bool has(UploadEvidence evidence) const {
    switch (evidence) {
      case kDoubted: return transfer.suspicion_ != Status::Transferring;
      case kOnLossy: return pace.isLossy();
      case kLongAfter: return since(transfer.progressMs_, ms) >= kLateErrorMs;
      case kIsTaken: return isTaken();
      case kTriesUsed: return transfer.tries_ >= kBusyTries;
      case kIsPart: return transfer.first_ != 0;
      default: return transfer.has(static_cast<uint8_t>(evidence));
    }
  }
  // ArduPilot has waited for the current item; so if this answers a repeat of that, and no item before, the item is
  // there, and the next request was lost. (That is not certain for the last item but one while an earlier transfer may
  // be answered: a newer ArduPilot answers so to every item until it has sent that transfer's acceptance.)
  bool isTaken() const {
    const bool isLastButOne = transfer.item_ + 2u == transfer.end_;
    return transfer.tries_ > 1 && transfer.send_ == Send::Nothing && !(isLastButOne && transfer.has(kFromOpen)) &&
           pace.isBehind(since(transfer.startedMs_, ms));
  }
};

Status UploadTransfer::onAck(uint8_t result, uint16_t nowMs, Pace& pace) {
  // An answer to something earlier: nothing of this upload has been sent yet.
  if (state_ == State::Counting && tries_ == 0) return Status::Transferring;
  Status status = fromMissionResult(result);
  if (status == Status::Accepted && state_ != State::Confirming && end_ != first_) status = Status::AcceptedEarly;
  switch (verdictOf(state_, status, firmware_, Now{*this, pace, nowMs})) {
    case Verdict::Ends: return status;
    case Verdict::GivenUp: return Status::TimedOut;
    case Verdict::Unproven: return Status::Unconfirmed;
    case Verdict::GoesOn: break;
    case Verdict::Doubted: suspicion_ = status; break;
    case Verdict::NextItem: moveTo(nextItem(), nowMs); break;
    case Verdict::FreeFirst: freeFirst(); break;
  }
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
  // While an autopilot may still be busy with an earlier transfer of ours, it needs the longer time.
  // (An item that ArduPilot or PX4 has already does no harm.)
  const bool mayBeOld = detail::has(firmware_, kMayBeOld);
  uint16_t waitMs =
      isCounting && has(kFreed) ? kRepeatMs : pace.waitMs(kRepeatMs, state_ == State::Sending && !mayBeOld);
  // In a server whose ways are not known each repeat may begin the timeout anew after which it asks again (MAVSDK): so
  // every few repeats there is room for that.
  if (mayBeOld && (tries_ & 7) == 0 && waitMs < kRoomMs) waitMs = kRoomMs;
  if (since(sentMs_, nowMs) < waitMs) return Status::Transferring;
  if (isCounting) {
    send_ = has(kFreed) ? Send::Cancel : Send::Count;
    return Status::Transferring;
  }
  // The current item, although it was not requested again.
  note(kItemAgain | kUnasked);
  send_ = Send::Item;
  // The autopilot may have that item, and its request for the next one was lost. Where it says nothing to an item that
  // it has, and answers come soon, it gets the two in turn after some copies, but the last of the plan not so.
  if (detail::has(firmware_, kIgnoresOtherItems) && tries_ >= kCopies && (tries_ & 1) == 0 && item_ + 2u < end_ &&
      pace.isNear()) {
    send_ = Send::NextItem;
    sentEnd_ = item_ + 2;
  }
  return Status::Transferring;
}

void UploadTransfer::sent(uint16_t nowMs) {
  if (send_ == Send::Cancel) {
    send_ = Send::Count;
    return;
  }
  if (send_ == Send::Count) {
    if (tries_ == 0) progressMs_ = nowMs;
  } else if (state_ != State::Confirming && item_ + 1u == end_) {
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
