#include "FileWriteTransfer.h"

#include "../base/Clock.h"

namespace mavmission {
namespace detail {

void FileWriteTransfer::begin(uint16_t count) {
  count_ = count;
  next_ = 0;
  written_ = 0;
  leaving_ = kSlots;
  isQuick_ = false;
  isLossy_ = false;
  slots_[1].phase = Phase::Idle;
  enter(State::Creating);
}

void FileWriteTransfer::enter(State state) {
  state_ = state;
  slots_[0].left = 0;
  makeDue(slots_[0]);
}

// A lossy link is given one item at a time: the shorter a frame, the likelier it arrives.
void FileWriteTransfer::makeDue(Slot& slot) {
  slot.phase = Phase::Due;
  slot.tries = 0;
  slot.request.count = isLossy_ && slot.left > 1 ? 1 : slot.left;
}

void FileWriteTransfer::fillSlots(const Pace& pace) {
  isLossy_ = pace.isLossy();
  // On a line that is full of telemetry two writes are slower than one: their answers wait for room.
  const uint8_t most = isQuick_ || isLossy_ ? kSlots : 1;
  uint8_t open = 0;
  for (const Slot& slot : slots_) open += slot.phase != Phase::Idle;
  for (Slot& slot : slots_) {
    if (slot.phase != Phase::Idle || next_ == count_ || open >= most) continue;
    ++open;
    const uint16_t rest = count_ - next_;
    slot.request.first = next_;
    slot.left = rest < kMostItems ? static_cast<uint8_t>(rest) : kMostItems;
    next_ += slot.left;
    makeDue(slot);
  }
  if (open == 0) enter(State::Heading);
}

uint8_t FileWriteTransfer::due() const {
  uint8_t slot = 0;
  while (slot < kSlots && slots_[slot].phase != Phase::Due) ++slot;
  return slot;
}

const FileWriteTransfer::Request& FileWriteTransfer::begun(uint16_t& lastSequence) {
  leaving_ = due();
  Slot& slot = slots_[leaving_];
  if (slot.tries == 0) slot.request.sequence = ++lastSequence;
  ++slot.tries;
  slot.phase = Phase::Sent;
  return slot.request;
}

void FileWriteTransfer::onLeft(uint16_t nowMs) {
  slots_[leaving_].sentMs = nowMs;
  leaving_ = kSlots;
}

uint8_t FileWriteTransfer::slotOf(uint16_t sequence) const {
  for (uint8_t i = 0; i < kSlots; ++i) {
    const Slot& slot = slots_[i];
    if (slot.phase != Phase::Idle && slot.tries != 0 && slot.request.sequence == sequence) return i;
  }
  return kSlots;
}

bool FileWriteTransfer::isOpen(uint16_t sequence) const { return slotOf(sequence) < kSlots; }

bool FileWriteTransfer::onAnswer(uint16_t sequence, uint16_t nowMs, Pace& pace) {
  const uint8_t index = slotOf(sequence);
  if (index == kSlots) return false;
  Slot& slot = slots_[index];
  const bool isBeingRepeated = leaving_ == index;
  const uint16_t roundTripMs = since(slot.sentMs, nowMs);
  if (!isBeingRepeated) {
    if (slot.tries == 1) pace.learn(roundTripMs, true);
    isQuick_ = slot.tries == 1 && roundTripMs <= kQuickMs;
  }
  slot.phase = Phase::Idle;
  switch (state_) {
    case State::Creating: state_ = State::Items; break;
    case State::Items: {
      const uint8_t count = slot.request.count;
      written_ += count;
      slot.left -= count;
      slot.request.first += count;
      isLossy_ = pace.isLossy();
      if (slot.left != 0) makeDue(slot);
      break;
    }
    case State::Heading: enter(State::Closing); return false;
    case State::Closing: return true;
  }
  fillSlots(pace);
  return false;
}

Status FileWriteTransfer::onTime(uint16_t nowMs, const Pace& pace) {
  const bool isCreating = state_ == State::Creating;
  const bool isLossy = pace.isLossy();
  const uint8_t most = isLossy ? (isCreating ? kLossyOpenTries : kLossyTries) : isCreating ? kOpenTries : kPieceTries;
  const uint16_t waitMs = pace.waitMs(isCreating ? kOpenMs : kWriteMs);
  for (uint8_t i = 0; i < kSlots; ++i) {
    Slot& slot = slots_[i];
    if (slot.phase != Phase::Sent || leaving_ == i || since(slot.sentMs, nowMs) < waitMs) continue;
    if (slot.tries >= most) {
      switch (state_) {
        case State::Creating: return Status::NoAnswer;
        case State::Items: return Status::TimedOut;
        default: return Status::Unconfirmed;
      }
    }
    slot.phase = Phase::Due;
    isLossy_ = isLossy;
    if (isLossy && slot.request.count > 1) makeDue(slot);  // another request, with a number of its own
  }
  return Status::Transferring;
}

}  // namespace detail
}  // namespace mavmission
