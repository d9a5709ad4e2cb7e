// The state of a PlanConsole between two calls of update().
#pragma once

#include <stdint.h>

#include "../base/FlashText.h"
#include "../base/StreamRoom.h"
#include "../base/TextError.h"

namespace mavmission {

class PlanConsole;

namespace detail {

// The state, all zero at the start. A base class of PlanConsole, so that it lies first, which is cheap to reach on AVR.
class PlanConsoleState {
 protected:
  // How received lines are understood.
  // Refused: up to end or another command lines are ignored.
  enum class Mode : uint8_t { Commands, Text, Ending, Refused };
  // Outputs; of several that are due the first one here is printed first.
  enum Task : uint8_t { kNothing, kSay, kError, kHelp, kList, kStatus, kProgress, kEnded, kStored };
  static_assert(kStored <= 8, "due_ has 8 bits");
  typedef void (*Offer)(PlanConsole& console);
  static constexpr uint8_t kOffers = 5;
  static constexpr uint8_t kQuietMs = 100;  // no pasted text pauses for so long
  static const char kLineEnd[];             // in flash

  Mode mode_;
  TextError error_;         // why the text was refused
  bool isItemHeld_ : 1;     // text_ holds an item for which there is no room
  bool isLineBegun_ : 1;    // a line has begun
  bool isCommand_ : 1;      // the line is a command
  bool wasReturn_ : 1;      // the last character was CR: an LF after it ends no line
  bool isOperation_ : 1;    // the client runs an operation that the console began
  bool isDownload_ : 1;     // it is a download
  bool isStart_ : 1;        // it is start()
  bool isPlanAwaited_ : 1;  // the plan is being committed or erased
  bool isNotStored_ : 1;    // the last load or download has failed, or has not ended
  bool isIgnored_ : 1;      // a text was ignored after it, which may come while a download runs
  bool isOtherAboard_ : 1;  // a plan was loaded since the last upload or verify
  bool isOverrun_ : 1;      // the port's ring was full: commands were lost
  uint8_t length_;          // of the command so far
  uint8_t kept_;            // items in the room
  uint8_t oldest_;          // of them
  uint8_t ring_;
  uint16_t skippedMs_;  // when the last byte was ignored after an overrun
  uint16_t put_;        // items of the text that were given to the plan
  uint16_t told_;       // stored items that were reported
  uint16_t done_;       // the progress that was printed
  uint8_t due_;         // a bit for each Task but kNothing, kSay in the lowest
  Task task_;
  uint8_t step_;   // of the task
  uint16_t item_;  // the item being listed
  StreamRoom portRoom_;
  FlashText said_;     // the text of kSay
  const char* flash_;  // being printed, in flash, if not null,
  const char* ram_;    // and then this, in RAM
};

}  // namespace detail
}  // namespace mavmission
