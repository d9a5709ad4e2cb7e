#include "DownloadTransfer.h"

#include "../base/Clock.h"

namespace mavmission {
namespace detail {

void DownloadTransfer::begin(uint16_t nowMs, uint8_t anew) {
  sentMs_ = nowMs;
  left_ = 0;
  next_ = 0;
  state_ = State::Listing;
  pending_ = 0;
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
  left_ = count - next_;
  tries_ = 0;
  state_ = State::Fetching;
  pending_ = 0;
  if (count == 0) close();
  return true;
}

bool DownloadTransfer::expectsItem(uint16_t item, uint16_t nowMs, Pace& pace) const {
  if (!expectsAnswer(State::Fetching)) return false;
  // The one before comes again, for which nothing was sent since the request that is open now: it took so long.
  if (item + 1u == next_ && tries_ != 0) pace.learnAtLeast(since(startedMs_, nowMs));
  return item == next_;
}

void DownloadTransfer::onItem(uint16_t nowMs, Pace& pace) {
  if (tries_ != 0) pace.learn(startedMs_, nowMs, tries_);
  ++next_;
  tries_ = 0;
  pending_ = 0;
  if (--left_ == 0) close();
}

void DownloadTransfer::stayAhead(uint8_t others, uint16_t nowMs) {
  if (others == 0) return;
  pending_ = others;
  sentMs_ = nowMs;
}

void DownloadTransfer::askAgain() {
  tries_ = 0;
  pending_ = 0;
}

Status DownloadTransfer::onAck(uint8_t result) const {
  // What comes before anything is asked for is no answer. ACCEPTED does not end a download: it answers something else.
  // Neither does INVALID_SEQUENCE, which may be a late answer to an upload before.
  const Status status = fromMissionResult(result);
  if (state_ == State::Closing || !expectsAnswer(state_) || status == Status::Accepted ||
      status == Status::InvalidSequence) {
    return Status::Transferring;
  }
  return status;
}

Status DownloadTransfer::onTime(uint16_t nowMs, const Pace& pace, bool answersAny, bool mayBeAhead) {
  if (pending_ == 0) return Status::Transferring;  // the line is not free yet
  uint8_t most = kItemTries;
  uint16_t waitMs = kItemMs;
  Status end = Status::TimedOut;
  if (state_ == State::Listing) {
    most = kListTries;
    waitMs = kListMs;
    end = Status::NoAnswer;
  }
  const uint16_t ms = since(sentMs_, nowMs);
  // Several are asked for anew when none of the answers is under way any more.
  if (ms < pace.waitMs(waitMs, answersAny && tries_ < kHastyTries) ||
      (mayBeAhead && pending_ > 1 && !pace.isBehind(ms)))
    return Status::Transferring;
  if (tries_ >= (pace.isLossy() ? Pace::kLossyTries : most)) return end;
  pending_ = 0;
  if (mayBeAhead && tries_ == 0) {
    tries_ = 1;
    startedMs_ = sentMs_;
  }
  return Status::Transferring;
}

bool DownloadTransfer::mustWait(uint16_t nowMs) const { return anew_ != 0 && since(sentMs_, nowMs) < kCopyMs; }

bool DownloadTransfer::sent(uint16_t nowMs, bool asksAhead) {
  if (!asksAhead || pending_ == 0) {
    if (tries_ == 0) startedMs_ = nowMs;
    ++tries_;
  }
  ++pending_;
  sentMs_ = nowMs;
  return state_ == State::Closing;
}

}  // namespace detail
}  // namespace mavmission
