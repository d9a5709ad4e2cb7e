// The text of a .waypoints file (QGC WPL 110, as Mission Planner writes it), taken character by character and given
// item by item: no line is kept, no float is computed with. tools/plan reads such a file by this class too, so this is
// the one description of the format:
//
//   QGC WPL 110
//   number current frame command param1 param2 param3 param4 latitude longitude altitude autocontinue
//
// Words and fields are separated by tabs or blanks. Lines end with LF, CR LF or CR; the last one may end with the text.
// Empty lines are skipped, and lines whose first character that is no blank is a #: these may be of any length and hold
// any bytes, others have up to 255. "current" is 1, or counts as 0. A UTF-8 byte order mark may precede the text. A
// number may have a sign and an exponent; number, current, frame, command and autocontinue have digits alone. NaN, in
// parameters 1 to 4: unset.
//
// Line 0 of such a file is home if its command is NAV_WAYPOINT, or 0: it is read, and is no item of the plan. With any
// other command it is the first item, as in files of fences and rally points, and in those that begin with a takeoff.
// Commands from 5000 on are a fence's, those from 5100 on rally points.
//
// An item of a command without a place goes out in MAV_FRAME_MISSION, whatever its frame is. If it has a place all the
// same, in degrees, and the command has no parameters 5 and 6, that place is left out.
#pragma once

#include <stdint.h>

#include "../base/Config.h"
#include "../base/TextError.h"
#include "../item/MissionItem.h"
#include "../item/PlanType.h"
#include "DecimalText.h"

namespace mavmission {
namespace detail {

// The reader of a .waypoints text.
class WaypointsText {
 public:
  // More: needs more characters. Item: item() is the next one. Bad: error() says why; further characters are ignored.
  enum class Step : uint8_t { More, Item, Bad };

  // The greatest number of items, without home.
  static constexpr uint16_t kMostItems = 0xFFFE;

  WaypointsText() { begin(); }

  // To be called before the first character of a text.
  void begin();
  // To be called before the first character of the line with this number, within a text. Line numbers are not known
  // then.
  MAVMISSION_APART void beginAt(uint16_t number);

  // Takes the next character.
  Step take(char c);
  // To be called at the end of the text. Item: the text ended with an item; call end() once more. More: the text is
  // complete and good.
  MAVMISSION_APART Step end();

  // True if the next character begins a line.
  bool isAtLineStart() const { return length_ == 0; }

  // True within a field. The character that ends a field takes the most time; docs/measurements.md has it.
  bool isInField() const { return isInField_; }

  // The last item, in the sketch's numbers: 0 is the first one after home. Valid until the next character.
  const MissionItem& item() const { return item_; }
  uint16_t count() const { return number_ - firstNumber_; }  // items so far
  // The number of the first item in the file: 1 after home, 0 where line 0 is an item. Known after line 0.
  uint8_t firstNumber() const { return firstNumber_; }
  // The kind of plan. Known after the first item.
  PlanType type() const { return type_; }

  // Why the text is bad, and where.
  TextError error() const { return error_; }
  uint16_t errorLine() const { return line_; }   // from 1 on; 0: not known
  uint8_t errorField() const { return field_; }  // from 1 to 12; 0: the line as a whole
  // Ends the text as bad, for a reason that the caller has found.
  MAVMISSION_APART Step fail(TextError error);

 private:
  Step takeHeader(char c);
  MAVMISSION_APART Step takeField(char c);
  MAVMISSION_APART Step endField();
  Step endLine();
  TextError store();
  MAVMISSION_APART TextError storePlace();

  static constexpr uint8_t kFields = 12;

  DecimalText decimal_;      // the field being taken
  uint16_t line_;            // from 1 on
  uint16_t number_;          // the file's number of the next line that is no comment
  uint16_t farthestTarget_;  // of all jumps, as a number of the file
  uint16_t farthestLine_;    // the line with that jump
  uint8_t length_;           // of the line so far
  uint8_t field_;            // the field being taken, from 1 on; 0 before the first
  uint8_t firstNumber_;      // of the first item; 0 up to the end of line 0
  PlanType type_;
  bool isHeader_ : 1;
  bool isInField_ : 1;
  bool isInMark_ : 1;  // in the byte order mark
  bool isComment_ : 1;
  bool isLineUnknown_ : 1;
  bool isAfterReturn_ : 1;  // the last character was a CR, which has ended its line
  TextError error_;
  MissionItem item_;
};

}  // namespace detail
}  // namespace mavmission
