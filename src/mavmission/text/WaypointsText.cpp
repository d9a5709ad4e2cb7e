#include "WaypointsText.h"

#include "../autopilot/Commands.h"
#include "../base/Flash.h"
#include "../base/FloatBits.h"
#include "../plan/WirePlan.h"

namespace mavmission {
namespace detail {
namespace {

const char kHeader[] PROGMEM = "QGC WPL 110";
constexpr uint8_t kHeaderLength = sizeof(kHeader) - 1;
const uint8_t kByteOrderMark[] PROGMEM = {0xEF, 0xBB, 0xBF};  // some editors put it before the text

constexpr uint8_t kMayLackReference = kHasNoPlace | kPlaceIsOptional | kAsItsFrameSays;

PlanType typeOf(uint16_t command) {
  command -= kFenceReturnPoint;
  if (command < kRallyPoint - kFenceReturnPoint) return PlanType::Fence;
  return command < 200 ? PlanType::Rally : PlanType::Mission;
}

MAVMISSION_APART bool isBlank(char c) { return c == ' ' || c == '\t'; }

}  // namespace

MAVMISSION_APART void WaypointsText::begin() {
  beginAt(0);
  line_ = 1;
  firstNumber_ = 0;
  type_ = PlanType::Mission;
  isHeader_ = true;
  isLineUnknown_ = false;
}

void WaypointsText::beginAt(uint16_t number) {
  line_ = 0;
  number_ = number;
  farthestTarget_ = 0;
  length_ = 0;
  field_ = 0;
  isHeader_ = false;
  isInField_ = false;
  isInMark_ = false;
  isComment_ = false;
  isLineUnknown_ = true;
  isAfterReturn_ = false;
  error_ = TextError::None;
}

WaypointsText::Step WaypointsText::fail(TextError error) {
  error_ = error;
  return Step::Bad;
}

WaypointsText::Step WaypointsText::take(char c) {
  if (error_ != TextError::None) return Step::Bad;
  const bool isSecond = isAfterReturn_ && c == '\n';
  isAfterReturn_ = c == '\r';
  if (isSecond) return Step::More;
  if (c == '\n' || c == '\r') return endLine();
  if (isComment_) return Step::More;
  if (length_ == 255) {
    field_ = 0;
    return fail(TextError::LineTooLong);
  }
  ++length_;
  return isHeader_ ? takeHeader(c) : takeField(c);
}

// Here field_ counts the characters of the header so far.
WaypointsText::Step WaypointsText::takeHeader(char c) {
  const uint8_t byte = static_cast<uint8_t>(c);
  const bool mayBeMark = length_ == 1 || isInMark_;
  if (mayBeMark && byte == fromFlash(&kByteOrderMark[length_ - 1])) {
    isInMark_ = length_ != sizeof(kByteOrderMark);
    return Step::More;
  }
  const uint8_t expected = pgm_read_byte(&kHeader[field_]);  // 0 after the last word
  const bool isGap = expected == ' ' || expected == 0;
  if (!isInMark_ && (isGap ? isBlank(c) : byte == expected)) {
    if (expected != 0) ++field_;
    return Step::More;
  }
  if (field_ != 0 && pgm_read_byte(&kHeader[field_ - 1]) == ' ' && isBlank(c)) return Step::More;
  field_ = 0;
  return fail(TextError::NotWaypoints);
}

WaypointsText::Step WaypointsText::takeField(char c) {
  if (isBlank(c)) return isInField_ ? endField() : Step::More;
  if (c == '\0' || c == '\xFF') return fail(TextError::Padding);
  if (!isInField_) {
    if (field_ == 0) {
      if (c == '#') isComment_ = true;
      if (isComment_) return Step::More;
      if (c == 'Q') return fail(TextError::SecondPlan);
    }
    if (field_ == kFields) {
      field_ = 0;
      return fail(TextError::TooManyFields);
    }
    ++field_;
    isInField_ = true;
    decimal_.begin();
  }
  decimal_.take(c);
  return Step::More;
}

WaypointsText::Step WaypointsText::endField() {
  isInField_ = false;
  const TextError error = store();
  return error == TextError::None ? Step::More : fail(error);
}

TextError WaypointsText::store() {
  if (!decimal_.isNumber()) return TextError::BadNumber;
  if (field_ >= 5 && field_ != 9 && field_ != 10 && field_ != 12) {
    float value;
    if (!decimal_.toFloat(value)) return TextError::TooLarge;
    if (field_ == 11) {
      if (decimal_.isNan()) return TextError::BadNumber;
      item_.z = value;
    } else {
      // param1 to param4 lie one after the other.
      memcpy(reinterpret_cast<uint8_t*>(&item_) + static_cast<uint8_t>(4 * (field_ - 5)), &value, sizeof(value));
    }
    return TextError::None;
  }
  if (field_ == 9 || field_ == 10) return storePlace();
  uint32_t whole;
  bool isExact;
  if (!decimal_.isPlain()) return TextError::NotWhole;
  if (!decimal_.toSteps(0, whole, isExact)) return TextError::TooLarge;
  if (decimal_.isNegative() && whole != 0) {
    if (field_ == 1) return TextError::OutOfOrder;
    if (field_ != 2) return TextError::BadNumber;
    whole = 0;
  }
  switch (field_) {
    case 1: return whole == number_ ? TextError::None : TextError::OutOfOrder;
    case 2: item_.current = whole == 1; break;
    case 3: {
      if (whole > 11) return TextError::BadTextFrame;
      constexpr uint16_t kTaken = 1 << 0 | 1 << 2 | 1 << 3 | 1 << 5 | 1 << 6 | 1 << 10 | 1 << 11;
      if ((kTaken >> whole & 1) == 0) return TextError::BadTextFrame;
      item_.frame = modern(static_cast<CoordinateFrame>(whole));
      break;
    }
    case 4:
      if (whole > 0xFFFF) return TextError::TooLarge;
      item_.command = static_cast<uint16_t>(whole);
      if (traitsOf(item_.command) & kHasNoPlace) item_.frame = CoordinateFrame::Mission;
      break;
    default:
      if (whole > 1) return TextError::NotZeroOrOne;
      item_.autocontinue = static_cast<uint8_t>(whole);
      break;
  }
  return TextError::None;
}

// Latitude and longitude [1e-7 degrees], or param5 and param6 without coordinates: whole numbers on the wire.
TextError WaypointsText::storePlace() {
  const bool isPlace = item_.frame != CoordinateFrame::Mission;
  if (decimal_.isNan()) return TextError::BadNumber;
  uint32_t magnitude;
  bool isExact;
  if (!decimal_.toSteps(isPlace ? 7 : 0, magnitude, isExact)) return TextError::TooLarge;
  if (!isPlace && !isExact) {
    if ((traitsOf(item_.command) & kMayLackReference) == 0) {
      field_ = 3;
      return TextError::NoReference;
    }
    if (!dropsPlace(item_.command)) return TextError::NotWhole;
    magnitude = 0;
  }
  if (isPlace && field_ == 9 && magnitude > 900000000) return TextError::BeyondLatitude;
  if (isPlace && field_ == 10 && magnitude > 1800000000) return TextError::BeyondLongitude;
  const int32_t value = static_cast<int32_t>(decimal_.isNegative() ? 0 - magnitude : magnitude);
  if (field_ == 9) {
    item_.x = value;
  } else {
    item_.y = value;
  }
  return TextError::None;
}

WaypointsText::Step WaypointsText::endLine() {
  if (isInField_ && endField() == Step::Bad) return Step::Bad;
  const bool isItem = !isComment_ && !isHeader_ && field_ != 0;
  if (isHeader_ && field_ != kHeaderLength) {
    field_ = 0;
    return fail(TextError::NotWaypoints);
  }
  if (isItem && field_ != kFields) {
    field_ = 0;
    return fail(TextError::TooFewFields);
  }
  bool isHome = false;
  if (isItem) {
    if (item_.frame == CoordinateFrame::Mission && (traitsOf(item_.command) & kMayLackReference) == 0 &&
        hasHeight(item_)) {
      field_ = 3;
      return fail(TextError::NoReference);
    }
    if (number_ == 0 && (item_.command == kNavWaypoint || item_.command == 0)) firstNumber_ = 1;
    isHome = number_ < firstNumber_;
    const PlanType type = typeOf(item_.command);
    if (number_ <= firstNumber_) type_ = type;  // that of home is overwritten by that of the first item
    if (type_ != type) {
      field_ = 4;
      return fail(TextError::MixedKinds);
    }
  }
  if (isItem && !isHome && item_.command == kDoJump) {
    const int32_t target = wholeNumber(&item_.param1);
    if (target < firstNumber_) {
      field_ = 5;
      return fail(TextError::BadTarget);
    }
    if (target > farthestTarget_) {
      farthestTarget_ = static_cast<uint16_t>(target);
      farthestLine_ = line_;
    }
    if (firstNumber_ != 0) item_.param1 = oneLess(item_.param1);
  }
  length_ = 0;
  field_ = 0;
  isHeader_ = false;
  isComment_ = false;
  if (!isLineUnknown_) ++line_;
  if (!isItem) return Step::More;
  if (!isHome && count() >= kMostItems) return fail(TextError::NoRoom);
  ++number_;
  return isHome ? Step::More : Step::Item;
}

WaypointsText::Step WaypointsText::end() {
  if (error_ != TextError::None) return Step::Bad;
  if (length_ != 0 || isHeader_) {
    const Step last = endLine();
    if (last != Step::More) return last;
  }
  if (count() == 0) return fail(TextError::NoItems);
  if (farthestTarget_ >= number_) {
    line_ = farthestLine_;
    field_ = 5;
    return fail(TextError::BadTarget);
  }
  return Step::More;
}

}  // namespace detail
}  // namespace mavmission
