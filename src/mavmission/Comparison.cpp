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

// param1 to param4, x, y, z lie one behind the other, four bytes each.
constexpr uint8_t kParam3 = 2, kX = 4, kY = 5, kZ = 6;
static_assert(offsetof(MissionItem, x) == sizeof(float) * kX && offsetof(MissionItem, y) == sizeof(float) * kY &&
                  offsetof(MissionItem, z) == sizeof(float) * kZ,
              "in their order");
static_assert(static_cast<uint8_t>(Field::Latitude) == static_cast<uint8_t>(Field::Param1) + kX &&
                  static_cast<uint8_t>(Field::Height) == static_cast<uint8_t>(Field::Param1) + kZ,
              "fields have the same order");

// Beside the flags of a Keeper: x and y go through floats, as PX4 has them where there is no place.
constexpr uint8_t kInFloats = 128;

// Four bytes of an item, whatever they are.
struct Four {
  union {
    uint8_t bytes[4];
    uint32_t bits;
    float number;
  };
  bool isBelow0() const { return (bytes[3] & 0x80) != 0; }
};

// An integer that a float holds.
MAVMISSION_APART bool fitsFloat(uint32_t integer) {
  uint32_t magnitude = static_cast<int32_t>(integer) < 0 ? 0 - integer : integer;
  for (; static_cast<uint8_t>(magnitude >> 24) != 0; magnitude >>= 1) {
    if ((magnitude & 1) != 0) return false;
  }
  return true;
}

MAVMISSION_APART bool isIntegerKept(uint8_t kind, uint32_t sent, uint32_t read, Keeper keeper) {
  if (kind == D && read == 0) return true;
  if (kind == Rounded && fitsFloat(read) && static_cast<uint8_t>(read >> 24) != 0) {
    constexpr uint8_t kHalfStep = 64;  // of a float, at most
    return read - sent + kHalfStep <= 2 * kHalfStep;
  }
  if (read != sent) return false;
  if (kind == U8) return sent <= 0xFF;
  if (kind == I16) return sent + 0x8000 <= 0xFFFF;
  return kind != K || (keeper & kInFloats) == 0 || fitsFloat(sent);
}

// Turns in 256ths below 1, the radius of turns in tens of metres beyond 255, the radius of a fence, the mode of a region of
// interest: none or a place, or where it has no place none or an item. `whole`: its magnitude, -1 if that is not whole.
MAVMISSION_APART bool isSpecialKept(Four sent, int32_t whole, uint8_t field, Keeper keeper) {
  if ((keeper & kByPx4) != 0) {
    makeWhole(&sent);
    const uint32_t mode = static_cast<uint32_t>(wholeNumber(sent.number));
    return mode <= 3 && mode != ((keeper & kInFloats) != 0 ? 3 : 2) && (mode != 1 || (keeper & kInFloats) != 0);
  }
  if (field == kParam3) {
    if (whole > 2550) return false;
    while (whole > 255) {
      whole -= 10;
      if (whole <= 250) return whole == 250;
    }
    return whole >= 0;
  }
  if (sent.isBelow0()) return false;
  if ((keeper & kOfFence) != 0) return whole != 0;
  if (whole < 0) {
    multiply(&sent, Times::T256);
    whole = wholeNumber(sent.number);
  }
  return static_cast<uint32_t>(whole) <= 255;
}

MAVMISSION_APART bool isNumberKept(uint8_t kind, const Four& sent, const Four& read, uint8_t field, Keeper keeper) {
  const bool same = isSame(&read, &sent);
  if (kind == K) return same;
  Four kept = sent;
  kept.bytes[3] &= 0x7F;
  const int32_t whole = wholeNumber(kept.number);
  if (kind >= U1) {
    const uint16_t* limit = &kLimits[kind - U1].positive;
    if (sent.isBelow0()) ++limit;
    return same && whole >= 0 && static_cast<uint16_t>(whole) <= fromFlash(limit);
  }
  const bool isZ = field == kZ;
  switch (kind) {
    case Special:
      if (!isSpecialKept(sent, whole, field, keeper)) return false;
      if ((keeper & (kByPx4 | kInFloats)) != kByPx4) return same;
      kept.bits = 0;
      break;
    case Sign:
      if ((keeper & kByPlane) != 0 && !isZ && static_cast<uint32_t>(whole) > 1) return false;
      kept.number = 1;
      if (isZ) kept.number = 2;
      kept.bytes[3] |= sent.bytes[3] & 0x80;
      break;
    case Yaw360:
      if (!isZ) {
        constexpr uint32_t k360 = 0x43B40000, k180 = 0x43340000;
        if (kept.bits <= 0x7F800000 && kept.bits > (sent.isBelow0() ? k180 : k360)) return false;
      } else if ((keeper & kByArduPilot) == 0) {
        return same;
      }
      if (same) return true;
      kept = sent;
      if (isZ) {
        makeHundredths(&kept);
      } else {
        makeTurn(&kept);
      }
      break;
    case Centimetres:
      if (sent.bits >= 0x4423D70A) return false;  // 655.36, and what is negative
      makeHundredths(&kept);
      break;
    default:
      kept.bits = 0;
      break;
  }
  return same || isSame(&read, &kept);
}

MAVMISSION_APART bool isSameFrame(const MissionItem& sent, const MissionItem& read, const Rules& rules, Keeper keeper) {
  const Frame found = modern(read.frame);
  if (modern(sent.frame) == found) return true;
  if (found != Frame::Global || (keeper & (kByArduPilot | kByPx4)) == 0) return false;
  // So come those of a fence, which has no altitude, and on ArduPilot those of items without a place, whatever they had.
  const bool isNowhere = sent.frame == Frame::Mission || rules.has(kHasNoPlace);
  return (keeper & kOfFence) != 0 || ((keeper & kByArduPilot) != 0 && isNowhere);
}

}  // namespace

Field difference(const MissionItem& sent, const MissionItem& read, Keeper keeper) {
  if (read.command != sent.command) return Field::Command;
  Rules rules = rulesOf(sent, keeper);
  if (!isSameFrame(sent, read, rules, keeper)) return Field::Reference;
  if ((keeper & (kByArduPilot | kByPx4)) == 0) rules.bits = 0;  // all is kept
  uint8_t flags = keeper;
  if ((keeper & kByPx4) != 0 && sent.frame == Frame::Mission) flags |= kInFloats;
  const Four* wasSent = reinterpret_cast<const Four*>(&sent);
  const Four* wasRead = reinterpret_cast<const Four*>(&read);
  for (uint8_t field = 0; field <= kZ; ++field, ++wasSent, ++wasRead, rules.bits >>= 4) {
    const uint8_t kind = static_cast<uint8_t>(rules.bits) & 15;
    const bool isKept = field == kX || field == kY ? isIntegerKept(kind, wasSent->bits, wasRead->bits, flags)
                                                   : isNumberKept(kind, *wasSent, *wasRead, field, flags);
    if (!isKept) return static_cast<Field>(static_cast<uint8_t>(Field::Param1) + field);
  }
  // Fence and rally items come back with 0, those of ArduPilot's missions with 1.
  const bool isAlways1 = (keeper & kByArduPilot) != 0 && read.autocontinue == 1;
  if ((keeper & (kOfFence | kOfRally)) == 0 && !isAlways1 && read.autocontinue != sent.autocontinue) return Field::Autocontinue;
  return Field::None;
}

}  // namespace mavmission
