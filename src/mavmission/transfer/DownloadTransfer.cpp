#include "DownloadTransfer.h"

#include "../base/Clock.h"

namespace mavmission {
namespace detail {

void DownloadTransfer::begin(uint16_t nowMs, uint8_t anew) {
  sentMs_ = nowMs;
  count_ = 0;
  next_ = 0;
  state_ = State::Listing;
  isDue_ = true;
  tries_ = 0;
  anew_ = anew;
}

bool DownloadTransfer::beginAnew(uint16_t nowMs) {
  if (anew_ == kMostAnew) return false;
  begin(nowMs, anew_ + 1);
  return true;
}

bool DownloadTransfer::onCount(uint16_t count, uint16_t nowMs, Pace& pace) {
  // A second COUNT is the answer to a repeated REQUEST_LIST; the items are being requested already.
  if (!expectsAnswer(State::Listing)) return false;
  pace.learn(startedMs_, nowMs, tries_);
  count_ = count;
  tries_ = 0;
  state_ = State::Fetching;
  isDue_ = true;
  if (count == 0) close();
  return true;
}

bool DownloadTransfer::expectsItem(uint16_t item, uint16_t nowMs, Pace& pace) const {
  if (!expectsAnswer(State::Fetching)) return false;
  // The one before comes again, for which nothing was sent since the request that is open now: it took so long.
  if (item + 1u == next_) pace.learnAtLeast(since(startedMs_, nowMs));
  return item == next_;
}

void DownloadTransfer::onItem(uint16_t nowMs, Pace& pace) {
  pace.learn(startedMs_, nowMs, tries_);
  ++next_;
  tries_ = 0;
  isDue_ = true;
  if (next_ == count_) close();
}

void DownloadTransfer::askAgain() {
  tries_ = 0;
  isDue_ = true;
}

Status DownloadTransfer::onAck(uint8_t result) const {
  // ACCEPTED does not end a download: it answers something else. Neither does INVALID_SEQUENCE, which may be a late
  // answer to an upload before.
  const Status status = fromMissionResult(result);
  if (state_ == State::Closing || status == Status::Accepted || status == Status::InvalidSequence) {
    return Status::Transferring;
  }
  return status;
}

Status DownloadTransfer::onTime(uint16_t nowMs, const Pace& pace) {
  if (isDue_) return Status::Transferring;  // the line is not free yet
  uint8_t most = kItemTries;
  uint16_t waitMs = kItemMs;
  Status end = Status::TimedOut;
  if (state_ == State::Listing) {
    most = kListTries;
    waitMs = kListMs;
    end = Status::NoAnswer;
  }
  if (since(sentMs_, nowMs) < pace.waitMs(waitMs)) return Status::Transferring;
  if (tries_ >= (pace.isLossy() ? Pace::kLossyTries : most)) return end;
  isDue_ = true;
  return Status::Transferring;
}

bool DownloadTransfer::mustWait(uint16_t nowMs) const { return anew_ != 0 && since(sentMs_, nowMs) < kCopyMs; }

bool DownloadTransfer::sent(uint16_t nowMs) {
  if (tries_ == 0) startedMs_ = nowMs;
  ++tries_;
  sentMs_ = nowMs;
  isDue_ = false;
  return state_ == State::Closing;
}

}  // namespace detail
}  // namespace mavmission
