// A .waypoints text, read by the library's own reader and told in pieces: for judge.cpp, and for the browser
// (tools/playing/hearing_wasm.cpp).
#pragma once

#include "mavmission/text/WaypointsText.h"

class TextReading {
 public:
  enum Event : uint8_t { kMore, kItem, kHome, kBad, kEnd };

  // Takes the next byte, or -1 at the text's end: to be called until it gives kBad or kEnd.
  Event take(int byte) {
    using mavmission::detail::WaypointsText;
    const WaypointsText::Step step = byte < 0 ? text_.end() : text_.take(static_cast<char>(byte));
    if (step == WaypointsText::Step::Bad) return kBad;
    if (step == WaypointsText::Step::Item) return kItem;
    if (!hasHome_ && text_.firstNumber() == 1) {
      hasHome_ = true;
      return kHome;
    }
    return byte < 0 ? kEnd : kMore;
  }

  // The line of the item that take() has given.
  unsigned itemLine() const { return text_.errorLine() - 1u; }
  const mavmission::detail::WaypointsText& text() const { return text_; }

 private:
  mavmission::detail::WaypointsText text_;
  bool hasHome_ = false;
};
