// What a PlanConsole is doing, between two calls of update().
#pragma once

#include <stdint.h>

#include "../FlashText.h"
#include "../TextError.h"
#include "../text/DecimalText.h"

namespace mavmission {

class PlanConsole;

namespace detail {

// What PlanConsole keeps, all zero at the start; a base of it, so that it lies first, which is cheap to reach on AVR.
class PlanConsoleState {
 protected:
  // What the lines are that come.
  enum class Mode : uint8_t { Commands, Text, Ending, Refused };
  // What there is to print; the first that is due comes first.
  enum Task : uint8_t { kNothing, kSay, kError, kHelp, kList, kStatus, kProgress, kEnded, kStored };
  typedef void (*Offer)(PlanConsole& console);
  static constexpr uint8_t kOffers = 5;
  static const char kLineEnd[];  // in flash

  Mode mode_;
  TextError error_;         // why the text was refused
  bool isItemHeld_ : 1;     // text_ holds an item for which there is no room
  bool isLineBegun_ : 1;    // of the text, or of what is passed over
  bool isCommand_ : 1;      // the line is one
  bool wasReturn_ : 1;      // the last character was CR: an LF behind it is no further line
  bool isOperation_ : 1;    // the client does what the console began
  bool isDownload_ : 1;     // that is one
  bool isStart_ : 1;        // that is start()
  bool isPlanAwaited_ : 1;  // it is being committed or erased
  bool isStuck_ : 1;        // the port had no room
  bool isBlind_ : 1;        // it does not say when it has
  uint8_t length_;          // of the command so far
  uint8_t kept_;            // items in the room
  uint8_t oldest_;          // of them
  uint8_t ring_;
  uint16_t told_;  // items that were said to be stored
  uint16_t done_;  // the progress that was printed
  uint16_t due_;   // a bit for each Task
  Task task_;
  uint8_t step_;       // of it
  uint16_t item_;      // that is listed
  uint16_t stuckMs_;   // when the port first had no room
  FlashText said_;     // the text of kSay
  const char* flash_;  // what is being printed: this, in flash, if it is not null,
  const char* ram_;    // then this
  char command_[9];
  char piece_[kFloatText];
  Offer offers_[kOffers];  // null: not offered
  bool (*composeList_)(PlanConsole& console);
};

}  // namespace detail
}  // namespace mavmission
