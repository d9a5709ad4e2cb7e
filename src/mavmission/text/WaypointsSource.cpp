#include "WaypointsSource.h"

#include <Arduino.h>

namespace mavmission {
using namespace detail;

namespace {
constexpr int kEnd = -1;
constexpr int kUnreadable = -2;
}  // namespace

WaypointsSource::WaypointsSource(Stream& stream, SeekFunction seek, void* context)
    : stream_(stream), seek_(seek), context_(context) {
  begin();
}

void WaypointsSource::begin() {
  state_ = State::Reading;
  isBegun_ = false;
  text_.begin();
}

bool WaypointsSource::goTo(uint32_t position) {
  position_ = position;
  return seek_(context_, position);
}

int WaypointsSource::next() {
  const int byte = stream_.read();
  if (byte >= 0) {
    ++position_;
    return byte;
  }
  // A file that has bytes available but does not give them has not ended: the card has failed.
  return stream_.available() > 0 ? kUnreadable : kEnd;
}

WaypointsSource::State WaypointsSource::update() {
  if (state_ != State::Reading) return state_;
  if (!isBegun_) {
    isBegun_ = true;
    if (!goTo(0)) {
      text_.fail(TextError::Unreadable);
      return state_ = State::Bad;
    }
  }
  for (uint8_t left = kBytesPerUpdate; left != 0; --left) {
    if (text_.isAtLineStart()) lineStart_ = position_;
    const int byte = next();
    const bool wasInField = text_.isInField();
    WaypointsText::Step step;
    bool isOver = false;
    if (byte == kUnreadable) {
      step = text_.fail(TextError::Unreadable);
    } else if (byte == kEnd) {
      step = text_.end();
      isOver = step == WaypointsText::Step::More;
    } else {
      step = text_.take(static_cast<char>(byte));
    }
    if (step == WaypointsText::Step::Item && text_.count() == 1) first_ = Mark{lineStart_, text_.firstNumber()};
    if (step == WaypointsText::Step::Bad) return state_ = State::Bad;
    if (isOver) {
      count_ = text_.count();
      size_ = position_;
      last_.number = 0;  // no item was read yet, or line 0 was: it is soon found again
      return state_ = State::Good;
    }
    if (wasInField && !text_.isInField()) break;  // one number is enough work for one call
  }
  return state_;
}

ItemSource WaypointsSource::source() {
  // Without a plan: one item that is refused, since uploading an empty plan would clear the plan aboard.
  return ItemSource{readItem, this, state_ == State::Good ? count_ : 1u};
}

bool WaypointsSource::readItem(void* source, uint16_t index, MissionItem& item) {
  WaypointsSource& from = *static_cast<WaypointsSource*>(source);
  if (from.state_ != State::Good || index >= from.count_) return false;
  const uint16_t number = index + from.text_.firstNumber();
  const uint16_t last = from.last_.number;
  const bool isNext = last != 0 && last + 1u == number && from.text_.error() == TextError::None;
  if (!isNext && !from.find(number)) return false;
  if (from.readLine() != WaypointsText::Step::Item) return false;
  from.last_ = Mark{from.lineStart_, number};
  item = from.text_.item();
  return true;
}

// Reads up to the next item.
WaypointsText::Step WaypointsSource::readLine() {
  for (;;) {
    if (text_.isAtLineStart()) lineStart_ = position_;
    const int byte = next();
    WaypointsText::Step step;
    if (byte >= 0) {
      step = text_.take(static_cast<char>(byte));
    } else {
      step = byte == kEnd ? text_.end() : WaypointsText::Step::More;
      // The text was longer when it was counted.
      if (step == WaypointsText::Step::More) step = text_.fail(TextError::Unreadable);
    }
    if (step != WaypointsText::Step::More) return step;
  }
}

// Goes to the line with this number, by halving the part of the text that may contain it. The numbers rise from line to
// line, as was checked before.
bool WaypointsSource::find(uint16_t number) {
  Mark low = first_;
  uint32_t end = size_;
  if (last_.number != 0 && text_.error() == TextError::None) {
    if (last_.number <= number) {
      low = last_;
    } else {
      end = last_.position;
    }
  }
  bool isReadable = true;
  while (low.number != number && isReadable) {
    const uint32_t middle = low.position + (end - low.position) / 2;
    Mark found = low;
    // From one byte earlier: a line that begins in the middle is recognised by the end of the line before it.
    isReadable = middle > low.position && goTo(middle - 1) && readMark(found);
    if (!isReadable) break;
    if (found.number == 0 || found.number > number || found.position >= end) {
      end = middle;
    } else {
      low = found;
    }
  }
  text_.beginAt(low.number);
  if (isReadable && goTo(low.position)) return true;
  text_.fail(TextError::Unreadable);
  return false;
}

// The first line with an item that begins after the present position; number 0: there is none.
bool WaypointsSource::readMark(Mark& mark) {
  mark.number = 0;
  bool isPassedOver = true;  // the rest of the line is not needed
  for (;;) {
    const int byte = next();
    if (byte == kUnreadable) return false;
    const bool isDigit = byte >= '0' && byte <= '9';
    if (mark.number != 0 && !isDigit) return true;
    if (byte == kEnd) return true;
    if (byte == '\n' || byte == '\r') {
      isPassedOver = false;
      mark.position = position_;
      continue;
    }
    if (isPassedOver) continue;
    if (isDigit) {
      mark.number = static_cast<uint16_t>(mark.number * 10 + (byte - '0'));
    } else if (byte == '#') {
      isPassedOver = true;
    }
  }
}

}  // namespace mavmission
