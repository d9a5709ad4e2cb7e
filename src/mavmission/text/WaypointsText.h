// The text of a .waypoints file (QGC WPL 110, as Mission Planner writes it), taken character by character, item by
// item: no line is kept, no float is computed with.
//
// Line 0 of such a file is home, which is read and is no item of the plan, if its command is NAV_WAYPOINT, or 0. Any
// other command there is the first item: so it is in files of fences and rally points, and in those that begin with a
// takeoff.
//
//   QGC WPL 110
//   number current frame command param1 param2 param3 param4 latitude longitude altitude autocontinue
//
// Fields are apart by tabs or blanks. Empty lines and those that begin with # are passed over. Lines end with LF or CR
// LF, the last one with either or with the text.
#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../MissionItem.h"
#include "../PlanType.h"
#include "../TextError.h"
#include "DecimalText.h"

namespace mavmission {
namespace detail {

// The reader of such a text.
class WaypointsText {
 public:
  // More: nothing whole yet. Item: item() is the next one. Bad: error() says why; nothing more is taken.
  enum class Step : uint8_t { More, Item, Bad };

  // The most items behind home.
  static constexpr uint16_t kMostItems = 0xFFFE;

  WaypointsText() { begin(); }

  // Before the first character of a text.
  void begin();
  // Before the first character of the line with this number, in the midst of a text. Line numbers are not known then.
  MAVMISSION_APART void beginAt(uint16_t number);

  // The next character.
  Step take(char c);
  // The text is over. Item: it ended with an item, and end() is to be called once more. More: it is whole, and good.
  MAVMISSION_APART Step end();

  // True if the next character begins a line.
  bool isAtLineStart() const { return length_ == 0; }

  // True within a field. The character that ends one costs most, a number of 19 digits near the smallest float by far
  // (DESIGN.md, "Plans from text, and in EEPROM").
  bool isInField() const { return isInField_; }

  // The last item, in the sketch's numbers: 0 is the first one that is not home. Until the next character is taken.
  const MissionItem& item() const { return item_; }
  uint16_t count() const { return number_ - firstNumber_; }  // items so far
  // The number of the first item, as the file counts: 1 behind home, 0 where line 0 is an item. Known behind that line.
  uint8_t firstNumber() const { return firstNumber_; }
  // What the items are, all of them. Known behind the first one.
  PlanType type() const { return type_; }

  // Why it is bad, and where.
  TextError error() const { return error_; }
  uint16_t errorLine() const { return line_; }   // from 1 on; 0: not known
  uint8_t errorField() const { return field_; }  // from 1 to 12; 0: the line as a whole
  // Ends the text as bad, for a reason of the reader's.
  MAVMISSION_APART Step fail(TextError error);

 private:
  Step takeHeader(char c);
  MAVMISSION_APART Step takeField(char c);
  MAVMISSION_APART Step endField();
  Step endLine();
  TextError store();
  MAVMISSION_APART TextError storePlace();

  static constexpr uint8_t kFields = 12;

  DecimalText decimal_;  // the field that is being taken
  MissionItem item_;
  uint16_t line_;            // from 1 on
  uint16_t number_;          // of the next line that is no comment, as the file counts
  uint16_t farthestTarget_;  // of all jumps, as the file counts
  uint16_t farthestLine_;    // where that is
  uint8_t length_;           // of the line so far
  uint8_t field_;            // that is being taken, from 1 on; 0 before the first
  uint8_t firstNumber_;      // of the first item; 0 up to the end of line 0
  PlanType type_;
  bool isHeader_ : 1;
  bool isInField_ : 1;
  bool isComment_ : 1;
  bool isLineUnknown_ : 1;
  TextError error_;
};

}  // namespace detail
}  // namespace mavmission
