#include "Comparison.h"

#include <stddef.h>
#include <string.h>

#include "../autopilot/Rules.h"
#include "../base/Flash.h"
#include "../base/FloatBits.h"

namespace mavmission {
namespace detail {

using namespace keeping;

namespace {

// The largest whole numbers that each kind from U1 on keeps: above 0, and the magnitude below 0.
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
    {0, 0},          // kOnlyZero
};
constexpr uint8_t kOnlyZero = To360 + 1;

// param1 to param4, x, y and z lie one after the other, four bytes each.
constexpr uint8_t kParam3 = 2, kYaw = 3, kX = 4, kY = 5, kZ = 6;
static_assert(offsetof(MissionItem, x) == sizeof(float) * kX && offsetof(MissionItem, y) == sizeof(float) * kY &&
                  offsetof(MissionItem, z) == sizeof(float) * kZ,
              "param1 to param4, x, y and z must lie one after the other, as kX, kY and kZ number them");
static_assert(static_cast<uint8_t>(ItemField::Latitude) == static_cast<uint8_t>(ItemField::Param1) + kX &&
                  static_cast<uint8_t>(ItemField::Height) == static_cast<uint8_t>(ItemField::Param1) + kZ,
              "ItemField must name the fields of MissionItem in their order");

// A further flag beside those of a Keeper: x and y are converted to floats and back, as in PX4 when an item has no
// place.
constexpr uint8_t kInFloats = kOnlyArduPilot ? 0 : 128;

// A field of an item, four bytes: a float or an integer.
struct Four {
  union {
    uint8_t bytes[4];
    uint32_t bits;
    float number;
  };
  bool isBelow0() const { return (bytes[3] & 0x80) != 0; }
};

// (A loop over the bytes takes less code than a comparison of all four.)
MAVMISSION_APART bool isEqual(const Four& a, const Four& b) {
  for (uint8_t i = 0; i < 4; ++i) {
    if (a.bytes[i] != b.bytes[i]) return false;
  }
  return true;
}

// True for equal floats and for neighbours: iNav divides its centimetres by 100, where others multiply them by 0.01.
bool isNext(const Four& a, const Four& b) { return a.bits - b.bits + 1 <= 2; }

// True if a Special field is kept in its meaning. Such fields are: a number of turns, kept in 256ths below 1; the
// radius of turns, kept in tens of metres above 255; the mode of a region of interest, which with a place is "none" or
// "a place", and without a place is "none" or "an item". `value` is the magnitude of the field, and is overwritten.
bool isSpecialKept(Four& value, bool isBelow0, uint8_t field, Keeper keeper) {
  if (isByPx4(keeper)) {
    makeWhole(&value);
    const uint16_t mode = static_cast<uint16_t>(wholeNumber(&value));
    return (keeper & kInFloats) != 0 ? mode < 3 : mode == 0 || mode == 3;
  }
  const int32_t number = wholeNumber(&value);
  uint16_t whole = static_cast<uint16_t>(number);  // 65535, which none of these keeps, if it is none
  if (field == kParam3) {
    if (whole > 255 && whole <= 2550) {
      do whole -= 10;
      while (whole > 255);
      return whole == 250;
    }
  } else {
    if (isBelow0) return false;
    if (number < 0) {
      multiply(&value, Times::T256);
      whole = static_cast<uint16_t>(wholeNumber(&value));
    }
  }
  return whole <= 255;
}

bool areNoNumbers(const void* a, const void* b) {
  return kindOf(a) == FloatKind::NotANumber && kindOf(b) == FloatKind::NotANumber;
}

// Makes `kept` of the field as it was sent: the value that the autopilot keeps. The slow conversions are left out when
// the field as it was read `is` the same as it was sent. False if the kept value would not mean the same.
MAVMISSION_APART MAVMISSION_ONE_EXIT bool keep(Four& kept, const Four& sent, uint8_t kind, uint8_t field, Keeper keeper,
                                               bool is) {
  const bool isZ = field == kZ;
  kept = sent;
  if (kind == D || (kind == NoYaw && field == kYaw) || (kind == Later && field == 0)) {
    kept.bits = 0;
    return true;
  }
  if (field == kX || field == kY) {
    if (kind == U8) return (kept.bytes[1] | kept.bytes[2] | kept.bytes[3]) == 0;
    if (kind == I16) return static_cast<uint16_t>((kept.bits + 0x8000) >> 16) == 0;
    if ((keeper & kInFloats) == 0) return true;
    throughFloat(&kept);
    return kind == Rounded || isEqual(kept, sent);
  }
  if (kind == K) return true;
  if (kind == Height && isZ) {
    if (!is && (isByArduPilot(keeper) || isByOwn(keeper))) makeHundredths(&kept);
    return true;
  }
  if (kServesArduPilot && kind == Centimetres) {
    if (kept.bits >= 0x4423D70A) return false;  // 655.36; negative numbers have larger bits
    makeHundredths(&kept);
    return true;
  }
  const uint8_t sign = kept.bytes[3] & 0x80;
  if (kind == Yaw360) {
    if (kindOf(&kept) == FloatKind::NotANumber) return true;
    if ((kept.bits & 0x7FFFFFFF) > (sign != 0 ? 0x43340000 : 0x43B40000)) return false;  // 180, 360
    if (!is) makeTurn(&kept);
    return true;
  }
  kept.bytes[3] &= 0x7F;  // the magnitude, for the time being
  static_assert(Zero == Special, "a Zero is told from a Special by its field");
  // A Zero is in param2 or param4; no table of its own has a Special.
  if (kind == NoHold || (kind == Zero && ((field & 1) != 0 || (keeper & kOwn) != 0))) kind = kOnlyZero;
  const int32_t number = wholeNumber(&kept);
  const uint16_t whole = static_cast<uint16_t>(number);  // 65535 if it is none
  if (kind >= U1) {
    const uint16_t* limit = &kLimits[kind - U1].positive;
    if (sign != 0) ++limit;
    if (whole != 0) kept.bytes[3] |= sign;
    if (isByOwn(keeper) && kind == To360 && (whole >= 360 || kept.isBelow0())) return false;
    return number >= 0 && whole <= fromFlash(limit);
  }
  if (kind == Special) {
    const bool isKept = isSpecialKept(kept, sign != 0, field, keeper);
    kept = sent;
    // PX4 does not give back the mode of a region of interest that has a place.
    if (isByPx4(keeper) && (keeper & kInFloats) == 0) kept.bits = 0;
    return isKept;
  }
  if (isByOwn(keeper)) return sign == 0 && whole == 3;  // no table of its own has a Sign
  if (!kServesArduPilot) return true;                   // no other has a Sign, or a MountMode
  kept.bits = 0;
  kept.bytes[3] = 0x40;  // 2
  if (!isZ) {
    kept.bytes[2] = 0x80;
    kept.bytes[3] = 0x3F | sign;  // 1 or -1
  }
  return (keeper & kByPlane) == 0 || isZ || whole <= 1;
}

// PX4 keeps NAV_ROI as DO_SET_ROI, and from 1.18 on CONDITION_DELAY as NAV_DELAY.
bool isKeptAs(uint16_t sent, uint16_t read) {
  return (sent == kNavRoi && read == kDoSetRoi) || (sent == kConditionDelay && read == kNavDelay);
}

bool isSameFrame(const MissionItem& sent, const MissionItem& read, const Rules& rules, Keeper keeper) {
  const CoordinateFrame found = modern(read.frame);
  if (found == modern(sent.frame)) return true;
  // Items of a fence, which have no altitude, are read back with CoordinateFrame::Global, whatever frame was sent. So
  // are ArduPilot's items without a place.
  if (found != CoordinateFrame::Global) return false;
  if (isByArduPilot(keeper) && (sent.frame == CoordinateFrame::Mission || rules.has(kHasNoPlace))) return true;
  return isByEither(keeper) && (keeper & kOfFence) != 0;
}

}  // namespace

ItemField difference(const MissionItem& sent, const MissionItem& read, Keeper keeper) {
  if (read.command != sent.command && !(isByPx4(keeper) && isKeptAs(sent.command, read.command)))
    return ItemField::Command;
  const Rules rules = rulesOf(sent, keeper);
  if (!isSameFrame(sent, read, rules, keeper)) return ItemField::Reference;
  uint32_t kinds = rules.bits;
  if (!isByEither(keeper) && !isByOwn(keeper)) kinds = 0;  // all fields are kept
  if (isByPx4(keeper) && sent.frame == CoordinateFrame::Mission) keeper |= kInFloats;
  const Four* wasSent = reinterpret_cast<const Four*>(&sent);
  const Four* wasRead = reinterpret_cast<const Four*>(&read);
  for (uint8_t field = 0; field <= kZ; ++field, ++wasSent, ++wasRead, kinds >>= 4) {
    const uint8_t kind = static_cast<uint8_t>(kinds) & 15;
    Four kept;
    const bool isSame = isEqual(*wasRead, *wasSent);
    const bool isKept = keep(kept, *wasSent, kind, field, keeper, isSame) &&
                        (isSame || isEqual(*wasRead, kept) || (field == kYaw && areNoNumbers(wasRead, wasSent)) ||
                         ((keeper & kOwn) != 0 && field == kZ && isNext(*wasRead, kept)));
    if (!isKept) return static_cast<ItemField>(static_cast<uint8_t>(ItemField::Param1) + field);
  }
  // It stops at no item, or refuses to.
  if ((keeper & kOwn) != 0 && sent.autocontinue != 1) return ItemField::Autocontinue;
  // In a read-back, autocontinue is 0 in fence and rally items, and 1 in the items of ArduPilot's missions.
  const uint8_t found = read.autocontinue;
  const bool isKept =
      (keeper & (kOfFence | kOfRally)) != 0 || found == sent.autocontinue || (found == 1 && isByArduPilot(keeper));
  return isKept ? ItemField::None : ItemField::Autocontinue;
}

}  // namespace detail
}  // namespace mavmission
