// Prints a PlanConsole's plan as a .waypoints file.
#include "PlanConsole.h"

#include <Arduino.h>

#include "../base/FloatBits.h"

namespace mavmission {
using namespace detail;

// Line 0, home, is all zeros: home is not known here.
bool PlanConsole::composeList(PlanConsole& console) {
  uint8_t& step = console.step_;
  if (step == 0) {
    console.item_ = 0;
    console.put(F("QGC WPL 110\r\n0\t0\t0\t16\t0\t0\t0\t0\t0\t0\t0\t1"));
    return true;
  }
  if (step == 13) {
    if (++console.item_ >= console.plan_.count()) {
      console.putLineEnd();
      return false;
    }
    step = 1;
  }
  console.put(step == 1 ? F("\r\n") : F("\t"));
  console.composeField(step);
  return true;
}

void PlanConsole::composeField(uint8_t field) {
  MissionItem item;
  const ItemSource source = plan_.source();
  if (!source.read(source.context, item_, item)) return;
  ram_ = piece_;
  const bool isPlace = item.frame != CoordinateFrame::Mission;
  switch (field) {
    case 1: return putNumber(item_ + 1u);
    case 2: return putNumber(item.current);
    case 3: return putNumber(static_cast<uint8_t>(item.frame));
    case 4: return putNumber(item.command);
    case 5: return printFloat(item.command == kDoJump ? oneMore(item.param1) : item.param1, piece_);
    case 6: return printFloat(item.param2, piece_);
    case 7: return printFloat(item.param3, piece_);
    case 8: return printFloat(item.param4, piece_);
    case 9:
    case 10: {
      const int32_t value = field == 9 ? item.x : item.y;
      if (isPlace) return printDegrees(value, piece_);
      const uint32_t whole = static_cast<uint32_t>(value);
      piece_[0] = '-';
      return value < 0 ? printWhole(0 - whole, piece_ + 1) : printWhole(whole, piece_);
    }
    case 11: return printFloat(item.z, piece_);
    default: return putNumber(item.autocontinue);
  }
}

}  // namespace mavmission
