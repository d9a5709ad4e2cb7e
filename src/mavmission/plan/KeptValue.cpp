// What an autopilot would make of a value that it does not keep. In a file of its own, since few sketches use it.
#include <string.h>

#include "../autopilot/Rules.h"
#include "../base/FloatBits.h"
#include "Comparison.h"

namespace mavmission {
namespace detail {

using namespace keeping;

namespace {

constexpr uint32_t kNotKnown = 0x7FC00000;  // NaN

float fromBits(uint32_t bits) {
  float value;
  memcpy(&value, &bits, sizeof(value));
  return value;
}

uint32_t bitsOf(float value) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof(bits));
  return bits;
}

// The whole part of a number below 2^31; false if it is beyond that.
bool whole(float number, int32_t& found) {
  const uint32_t bits = bitsOf(number);
  const uint8_t biased = static_cast<uint8_t>(bits >> 23);
  if (biased > 127 + 30) return false;
  uint32_t magnitude = 0;
  if (biased >= 127) {
    magnitude = (bits & 0x7FFFFF) | 0x800000;
    for (uint8_t i = biased; i < 127 + 23; ++i) magnitude >>= 1;
    for (uint8_t i = 127 + 23; i < biased; ++i) magnitude <<= 1;
  }
  found = (bits & 0x80000000) != 0 ? -static_cast<int32_t>(magnitude) : static_cast<int32_t>(magnitude);
  return true;
}

// The nearest float; between two equally near floats, the one with the even mantissa.
float number(int32_t value) {
  const uint32_t magnitude = value < 0 ? 0 - static_cast<uint32_t>(value) : static_cast<uint32_t>(value);
  uint8_t shift = 0;
  while (magnitude >> shift >= 0x1000000) ++shift;
  uint32_t kept = magnitude;
  if (shift != 0) {
    const uint32_t step = static_cast<uint32_t>(1) << shift;
    const uint32_t rest = magnitude & (step - 1);
    kept -= rest;
    if (rest > step / 2 || (rest == step / 2 && (kept & step) != 0)) kept += step;
  }
  const float found = quotient(static_cast<int32_t>(kept & 0x7FFFFFFF), 1);
  const uint32_t sign = value < 0 ? 0x80000000 : 0;
  return fromBits(((kept & 0x80000000) != 0 ? 0x4F000000 : bitsOf(found)) | sign);
}

// The value that an integer of `bits` bits keeps.
float wrapped(float value, uint8_t bits, bool isSigned) {
  int32_t found;
  if (!whole(value, found) || (found < 0 && !isSigned)) return fromBits(kNotKnown);
  const int32_t size = static_cast<int32_t>(1) << bits;
  found &= size - 1;
  if (isSigned && found >= size / 2) found -= size;
  return number(found);
}

int32_t atMost(int32_t value, int32_t limit) { return value < limit ? value : limit; }

float keptSpecial(float value, bool isRadius, Keeper keeper) {
  int32_t found;
  if (isByPx4(keeper) || !whole(value, found)) return fromBits(kNotKnown);  // not taken
  if (isRadius) {
    const bool isBelow0 = found < 0;
    if (isBelow0) found = -found;
    // ArduPilot compares the number with 255 before it cuts off the fraction: 255.5 m does not count as 255 m.
    if ((bitsOf(value) & 0x7FFFFFFF) > 0x437F0000) found = atMost(found / 10, 255) * 10;  // 255
    return number(isBelow0 ? -found : found);
  }
  if ((bitsOf(value) & 0x80000000) != 0) return fromBits(kNotKnown);
  if (found != 0) return number(atMost(found, 255));
  multiply(&value, Times::T256);
  whole(value, found);  // below 256
  return quotient(found, 256);
}

float keptHundredths(float value) {
  multiply(&value, Times::Hundred);
  value = wrapped(value, 16, false);
  if (value == value) multiply(&value, Times::Hundredth);
  return value;
}

}  // namespace

float keptValue(const MissionItem& item, ItemField field, Keeper keeper) {
  const uint8_t index = static_cast<uint8_t>(field) - static_cast<uint8_t>(ItemField::Param1);
  if (index > 6) return fromBits(kNotKnown);
  uint32_t bits;
  memcpy(&bits, reinterpret_cast<const uint8_t*>(&item) + sizeof(bits) * index, 4);
  float value = fromBits(bits);
  uint32_t rules = rulesOf(item, keeper).bits;
  for (uint8_t i = 0; i < index; ++i) rules >>= 4;
  const uint8_t kind = static_cast<uint8_t>(rules) & 15;
  if (field == ItemField::Latitude || field == ItemField::Longitude) {
    const int32_t integer = static_cast<int32_t>(bits);
    value = number(integer);
    if (kind == U8) return number(integer & 0xFF);
    if (kind == I16) return number(static_cast<int16_t>(bits));
    return bitsOf(value) == 0x4F000000 ? fromBits(kNotKnown) : value;  // 2^31, which does not fit
  }
  const bool isPlanesDistance = (keeper & kByPlane) != 0 && item.command == kNavWaypoint;
  const bool isAttitude = item.command == 42703;  // NAV_ATTITUDE_TIME
  int32_t found = 0;
  const bool isInt32 = whole(value, found);
  if (isByArduPilot(keeper) && item.command >= kFenceCircleInclusion && (keeper & kOfFence) != 0 && index == 0) {
    return number(found);  // the radius of a circle (Areas)
  }
  if (isByOwn(keeper) && has(kGenericFirmware, kKeptByVersion) && (kind == Three || kind >= U1)) {
    return fromBits(kNotKnown);
  }
  switch (kind) {
    case NoHold: return 0;
    case Sign: return (bits & 0x80000000) != 0 ? -1 : 1;
    case Special:
      if (field == ItemField::Param2 || field == ItemField::Param4 || isByOwn(keeper)) return 0;  // Zero
      return keptSpecial(value, field == ItemField::Param3, keeper);
    case Centimetres: return keptHundredths(value);
    case U1:
      if (item.command == 223 && field == ItemField::Param4)
        return found < 0 || !isInt32 ? fromBits(kNotKnown) : number(found & 1);
      return bits != 0 && bits < 0x80000000 ? 1 : 0;
    case U8:
      if (isPlanesDistance) {
        value = wrapped(value, 16, false);
        return whole(value, found) ? number(atMost(found, 255)) : fromBits(kNotKnown);
      }
      return wrapped(value, 8, false);
    case I8: return wrapped(value, 8, true);
    case U16:
      if (isAttitude) return number((bits & 0x80000000) != 0 ? 0 : !isInt32 || found > 65535 ? 65535 : found);
      // PX4 rounds the number of corners.
      if (isByPx4(keeper) && (keeper & kOfFence) != 0) value = number(timesWhole(bits, 1));
      return wrapped(value, 16, false);
    case I16:
      // ArduPilot refuses a rally point whose height does not fit.
      if ((keeper & kOfRally) != 0 && (!isInt32 || found != static_cast<int16_t>(found))) return fromBits(kNotKnown);
      return wrapped(value, 16, true);
    case Radius: {
      const uint32_t sign = bits & 0x80000000;
      return fromBits(bitsOf(wrapped(fromBits(bits & 0x7FFFFFFF), 16, false)) | sign);
    }
    case To180:
    case To90:
    case To360: {
      // Here, too, ArduPilot compares the number with its limit before it cuts off the fraction.
      const bool isTurn = kind == To360 && (bits & 0x80000000) == 0;
      const uint32_t limit = isTurn ? 0x43B40000 : kind == To90 ? 0x42B40000 : 0x43340000;  // 360, 90, 180
      return (bits & 0x7FFFFFFF) <= limit ? number(found) : 0;
    }
    default: return fromBits(kNotKnown);
  }
}

}  // namespace detail
}  // namespace mavmission
