#include "Comparison.h"

#include <stddef.h>
#include <string.h>

#include "Flash.h"
#include "FloatBits.h"
#include "Rules.h"

namespace mavmission {

using namespace keeping;

namespace {

// The whole numbers that a kind keeps, from U1 on.
struct Limit {
  uint16_t positive, negative;
};

const Limit kLimits[] PROGMEM = {
    {1, 0},          // U1
    {255, 0},        // U8
    {127, 128},      // I8
    {65535, 0},      // U16
    {32767, 32768},  // I16
    {65535, 65535},  // Radius
    {180, 180},      // To180
    {90, 90},        // To90
    {360, 180},      // To360
};

bool isWithin(uint8_t kind, uint32_t magnitude, bool isBelow0) {
  const Limit* limit = &kLimits[kind - U1];
  return magnitude <= (isBelow0 ? fromFlash(&limit->negative) : fromFlash(&limit->positive));
}

// param1 to param4, x, y, z lie one behind the other, four bytes each.
constexpr uint8_t kParam3 = 2, kX = 4, kY = 5, kZ = 6;
static_assert(offsetof(MissionItem, x) == sizeof(float) * kX && offsetof(MissionItem, y) == sizeof(float) * kY &&
                  offsetof(MissionItem, z) == sizeof(float) * kZ,
              "in their order");
static_assert(static_cast<uint8_t>(Field::Latitude) == static_cast<uint8_t>(Field::Param1) + kX &&
                  static_cast<uint8_t>(Field::Height) == static_cast<uint8_t>(Field::Param1) + kZ,
              "fields have the same order");

// What one field of an item is asked about.
struct Asked {
  const MissionItem& item;
  Keeper keeper;
  uint8_t field;

  bool isIn(Firmware firmware) const { return keeper.firmware == firmware; }
  bool isInFloats() const { return isIn(Firmware::Px4) && item.frame == Frame::Mission; }  // x and y are
};

// Turns in 256ths below 1, the radius of turns in tens of metres beyond 255, the radius of a fence, the mode of a region of
// interest: none or a place, or without a place none or an item. `whole`: its magnitude, -1 if that is no whole number.
bool isSpecialKept(float value, int32_t whole, const Asked& asked) {
  if (asked.isIn(Firmware::Px4)) {
    whole = wholeNumber(wholePart(value));
    return asked.isInFloats() ? whole >= 0 && whole <= 2 : whole == 0 || whole == 3;
  }
  const bool isBelow0 = isNegative(value);
  if (asked.keeper.type == PlanType::Fence) return !isBelow0 && whole != 0;
  if (asked.field == kParam3) {
    if (whole <= 255) return whole >= 0;
    for (; whole > 0; whole -= 10) {
      if (whole > 2550) return false;
    }
    return whole == 0;
  }
  if (whole < 0) whole = wholeNumber(product(value, 256));
  return !isBelow0 && whole >= 0 && whole <= 255;
}

// Whether what is kept of a number means the same, and was read; or what was sent was.
bool isNumberKept(uint8_t kind, float sent, float read, const Asked& asked) {
  const bool isZ = asked.field == kZ;
  const bool same = isSame(read, sent);
  if (kind == K) return same;
  const bool isBelow0 = isNegative(sent);
  const int32_t whole = wholeNumber(magnitudeOf(sent));
  float kept = 0;
  switch (kind) {
    case D:
    case NoYaw:
      break;
    case Yaw360:  // or Height
      if (isZ ? !asked.isIn(Firmware::ArduPilot) : !isHeading(sent)) return same && isZ;
      if (same) return true;
      kept = isZ ? inHundredths(sent) : throughRadians(sent);
      break;
    case Sign:  // or MountMode
      if (isZ) {
        kept = 2;
      } else {
        if (asked.keeper.isPlane && (whole < 0 || whole > 1)) return false;
        kept = isBelow0 ? -1 : 1;
      }
      break;
    case Special:
      if (!isSpecialKept(sent, whole, asked)) return false;
      if (!asked.isIn(Firmware::Px4) || asked.isInFloats()) return same;
      break;
    case Centimetres: {
      const float centimetres = product(sent, 100);
      if (wholeNumber(wholePart(centimetres)) < 0) return false;  // negative, too
      kept = inHundredths(sent);
      break;
    }
    default:
      return same && whole >= 0 && isWithin(kind, static_cast<uint32_t>(whole), isBelow0);
  }
  return same || isSame(read, kept);
}

// The same of x and y.
bool isIntegerKept(uint8_t kind, int32_t sent, int32_t read, const Asked& asked) {
  int32_t kept = sent;
  if (kind == D) {
    kept = 0;
  } else if (kind >= U1) {
    const bool isBelow0 = sent < 0;
    if (!isWithin(kind, isBelow0 ? 0 - static_cast<uint32_t>(sent) : static_cast<uint32_t>(sent), isBelow0)) return false;
  } else if (asked.isInFloats()) {
    kept = throughFloat(sent);
    if (kind == K && kept != sent) return false;
  }
  return read == sent || read == kept;
}

bool isSameFrame(const MissionItem& sent, const MissionItem& read, const Rules& rules, Keeper keeper) {
  if (modern(sent.frame) == modern(read.frame)) return true;
  if (modern(read.frame) != Frame::Global || keeper.firmware == Firmware::Other) return false;
  // So come those of a fence, which has no altitude, and on ArduPilot those of items without a place, whatever they had.
  const bool isNowhere = sent.frame == Frame::Mission || rules.has(kHasNoPlace);
  return keeper.type == PlanType::Fence || (keeper.firmware == Firmware::ArduPilot && isNowhere);
}

}  // namespace

Field difference(const MissionItem& sent, const MissionItem& read, Keeper keeper) {
  if (read.command != sent.command) return Field::Command;
  const Rules rules = rulesOf(sent, keeper);
  if (!isSameFrame(sent, read, rules, keeper)) return Field::Reference;
  const bool isKnown = keeper.firmware == Firmware::ArduPilot || keeper.firmware == Firmware::Px4;
  const uint8_t* sentBytes = reinterpret_cast<const uint8_t*>(&sent);
  const uint8_t* readBytes = reinterpret_cast<const uint8_t*>(&read);
  Asked asked = {sent, keeper, 0};
  for (; asked.field <= kZ; ++asked.field, sentBytes += 4, readBytes += 4) {
    const uint8_t kind = isKnown ? rules.kindOf(asked.field) : static_cast<uint8_t>(K);
    bool isKept;
    if (asked.field == kX || asked.field == kY) {
      int32_t sentInteger, readInteger;
      memcpy(&sentInteger, sentBytes, 4);
      memcpy(&readInteger, readBytes, 4);
      isKept = isIntegerKept(kind, sentInteger, readInteger, asked);
    } else {
      float sentNumber, readNumber;
      memcpy(&sentNumber, sentBytes, 4);
      memcpy(&readNumber, readBytes, 4);
      isKept = isNumberKept(kind, sentNumber, readNumber, asked);
    }
    if (!isKept) return static_cast<Field>(static_cast<uint8_t>(Field::Param1) + asked.field);
  }
  // Fence and rally items come back with 0, those of ArduPilot's missions with 1.
  const bool isAlways1 = keeper.firmware == Firmware::ArduPilot && read.autocontinue == 1;
  if (keeper.type == PlanType::Mission && !isAlways1 && read.autocontinue != sent.autocontinue) return Field::Autocontinue;
  return Field::None;
}

}  // namespace mavmission
