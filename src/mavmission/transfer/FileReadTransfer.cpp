#include "FileReadTransfer.h"

#include "../base/Clock.h"

namespace mavmission {
namespace detail {

void FileReadTransfer::begin(bool takesAnyOrder) {
  mostHoles_ = takesAnyOrder ? kHoles : 0;
  end_ = 0;
  taken_ = 0;
  holeCount_ = 0;
  isBurstWorthIt_ = true;
  state_ = State::Opening;
  ask(Send::Open);
}

void FileReadTransfer::ask(Send what) {
  send_ = what;
  request_ = what;
  tries_ = 0;
}

void FileReadTransfer::askNext() {
  if (taken_ == count_) return close(Status::Downloaded);
  const bool isBurst = isBurstWorthIt_ && holeCount_ == 0 && count_ - end_ > 1;
  ask(isBurst ? Send::Burst : Send::Item);
  burstFirst_ = end_;
  burstGot_ = 0;
}

void FileReadTransfer::learn(uint16_t nowMs, Pace& pace) const { pace.learn(startedMs_, nowMs, tries_); }

void FileReadTransfer::onOpened(uint16_t nowMs, Pace& pace) {
  if (state_ != State::Opening || tries_ == 0) return;
  learn(nowMs, pace);
  state_ = State::Heading;
  ask(Send::Header);
}

bool FileReadTransfer::onCount(uint16_t count, uint16_t nowMs, Pace& pace) {
  if (state_ != State::Heading || tries_ == 0) return false;
  learn(nowMs, pace);
  count_ = count;
  state_ = State::Reading;
  askNext();
  return true;
}

bool FileReadTransfer::wants(uint16_t item) const {
  if (state_ != State::Reading || item >= count_) return false;
  if (item == end_) return true;
  if (item > end_) return holeCount_ < mostHoles_;
  for (uint8_t i = 0; i < holeCount_; ++i) {
    const Hole& hole = holes_[i];
    // In the middle of a hole it would make two of one.
    if (item == hole.from || item == hole.end - 1) return true;
  }
  return false;
}

void FileReadTransfer::fill(uint8_t index, uint16_t item) {
  Hole& hole = holes_[index];
  if (item == hole.from) {
    ++hole.from;
  } else {
    --hole.end;
  }
  if (hole.from != hole.end) return;
  --holeCount_;
  for (; index < holeCount_; ++index) holes_[index] = holes_[index + 1];
}

void FileReadTransfer::onItem(uint16_t item, uint16_t nowMs, Pace& pace) {
  const bool isAskedFor = request_ == Send::Item && item == itemToAsk();
  if (isAskedFor && tries_ != 0) learn(nowMs, pace);
  sentMs_ = nowMs;  // the answer to what was asked for comes after the rest of a burst
  ++taken_;
  if (item >= end_) {
    if (item != end_) holes_[holeCount_++] = Hole{end_, item};
    end_ = item + 1;
  } else {
    uint8_t hole = 0;
    while (item < holes_[hole].from || item >= holes_[hole].end) ++hole;
    fill(hole, item);
  }
  if (isAskedFor || taken_ == count_) return askNext();
  if (request_ != Send::Burst) return;
  ++burstGot_;
  tries_ = 1;
}

void FileReadTransfer::onUnused(uint16_t nowMs) {
  sentMs_ = nowMs;
  ++burstGot_;
}

void FileReadTransfer::judgeBurst() {
  const uint16_t due = count_ - burstFirst_;
  isBurstWorthIt_ = burstGot_ >= due - due / kMostLost;
}

void FileReadTransfer::onBurstEnd() {
  if (state_ != State::Reading || request_ != Send::Burst || tries_ == 0) return;
  judgeBurst();
  askNext();
}

void FileReadTransfer::close(Status result) {
  state_ = State::Closing;
  result_ = result;
  ask(Send::Close);
}

Status FileReadTransfer::onTime(uint16_t nowMs, const Pace& pace) {
  if (send_ != Send::Nothing) {
    // The line is not free yet. What the closing of the file waits for too long is closed after the end.
    return state_ == State::Closing && since(sentMs_, nowMs) >= kWriteMs ? result_ : Status::Transferring;
  }
  const bool isOpening = state_ == State::Opening;
  uint16_t waitMs = pace.waitMs(isOpening ? kOpenMs : kPieceMs);
  // The autopilot sends a whole burst for each repeat, so none leaves before the first piece is late.
  const uint16_t pieceMs = pace.roundTripMs() + pace.roundTripMs() / 2;
  if (request_ == Send::Burst && waitMs < pieceMs) waitMs = pieceMs;
  if (since(sentMs_, nowMs) < waitMs) return Status::Transferring;
  if (state_ == State::Closing) return result_;
  const uint8_t most =
      isOpening ? (pace.isLossy() ? kLossyOpenTries : kOpenTries) : (pace.isLossy() ? kLossyTries : kPieceTries);
  if (tries_ >= most) return isOpening ? Status::NoAnswer : Status::TimedOut;
  send_ = request_;
  // What is left of a burst that has fallen silent is asked for like what has never come.
  if (request_ == Send::Burst && burstGot_ != 0) {
    judgeBurst();
    askNext();
  }
  return Status::Transferring;
}

void FileReadTransfer::sent(uint16_t nowMs) {
  if (tries_ == 0) startedMs_ = nowMs;
  ++tries_;
  sentMs_ = nowMs;
  send_ = Send::Nothing;
}

}  // namespace detail
}  // namespace mavmission
