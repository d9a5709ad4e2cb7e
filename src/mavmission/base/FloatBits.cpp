#include "FloatBits.h"

#include <string.h>

#include "Config.h"
#include "Flash.h"

namespace mavmission {
namespace detail {
namespace {

constexpr uint32_t kSign = 0x80000000;
constexpr uint32_t kInfinity = 0x7F800000;
constexpr uint32_t kHidden = 0x00800000;  // the leading 1 of a mantissa, which is not stored
constexpr uint8_t kBias = 127;

uint32_t bitsOf(float value) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof(bits));
  return bits;
}

float fromBits(uint32_t bits) {
  float value;
  memcpy(&value, &bits, sizeof(value));
  return value;
}

// (From two bytes: a shift of all four, or of the upper two, takes more code.)
MAVMISSION_INLINE uint8_t biasedExponent(uint32_t bits) {
  uint8_t biased = static_cast<uint8_t>(static_cast<uint8_t>(bits >> 24) << 1);
  if ((static_cast<uint8_t>(bits >> 16) & 0x80) != 0) biased |= 1;
  return biased;
}

uint32_t mantissaOf(uint32_t bits) { return (bits & (kHidden - 1)) | kHidden; }

// The same with 7 bits more, which are 0. (The shift by a whole byte has the hidden bit at the top.)
uint32_t longMantissaOf(uint32_t bits) { return ((bits << 8) | kSign) >> 1; }

// Half the number. Its last bit stays set once a bit that is cut off was set, which is all that rounding asks of the
// lowest bits.
uint32_t halved(uint32_t number) {
  const uint8_t low = static_cast<uint8_t>(number);
  number >>= 1;
  if ((low & 1) != 0) number |= 1;
  return number;
}

// `mantissa` has its highest bit at bit 23; the value is mantissa * 2^(exponent - 23).
float assemble(uint32_t mantissa, int8_t exponent) {
  const uint8_t biased = static_cast<uint8_t>(kBias + exponent);
  return fromBits((mantissa & (kHidden - 1)) | static_cast<uint32_t>(biased) << 23);
}

}  // namespace

FloatKind kindOf(const void* bytes) {
  uint32_t magnitude;
  memcpy(&magnitude, bytes, sizeof(magnitude));
  if ((~static_cast<uint16_t>(magnitude >> 16) & (kInfinity >> 16)) != 0) return FloatKind::Finite;
  magnitude &= ~kSign;
  return magnitude == kInfinity ? FloatKind::Infinite : FloatKind::NotANumber;
}

int32_t wholeNumber(const void* number) {
  uint32_t bits;
  memcpy(&bits, number, sizeof(bits));
  uint16_t mantissa = 0;
  if ((bits & ~kSign) != 0) {
    const uint8_t biased = biasedExponent(bits);
    if ((bits & kSign) != 0 || biased < kBias || biased > kBias + 15 || static_cast<uint8_t>(bits) != 0) return -1;
    mantissa = static_cast<uint16_t>(bits >> 8) | 0x8000;  // of its 24 bits the lowest 8 are after the point
    for (uint8_t i = biased; i != kBias + 15; ++i) {
      if ((mantissa & 1) != 0) return -1;
      mantissa >>= 1;
    }
  }
  return mantissa;
}

int32_t timesWhole(int32_t bits, uint32_t factor) {
  uint8_t biased = biasedExponent(static_cast<uint32_t>(bits));
  if (biased == 0 || biased > kBias + 31) return 0;
  uint32_t mantissa = mantissaOf(static_cast<uint32_t>(bits));
  uint32_t sum = 0;
  uint8_t half = 0;
  // The bits after the point, of which the product keeps one to round by; then the others.
  for (; biased < kBias + 23; ++biased) {
    if ((mantissa & 1) != 0) sum += factor;
    mantissa >>= 1;
    half = static_cast<uint8_t>(sum) & 1;
    sum >>= 1;
  }
  sum += half;
  for (; biased > kBias + 23; --biased) mantissa <<= 1;
  for (; mantissa != 0; mantissa >>= 1) {
    if ((factor & kSign) != 0) return 0;
    if ((mantissa & 1) != 0) sum += factor;
    if ((sum & kSign) != 0) return 0;
    factor <<= 1;
  }
  return bits < 0 ? -static_cast<int32_t>(sum) : static_cast<int32_t>(sum);
}

namespace {

uint32_t load(const void* number) {
  uint32_t bits;
  memcpy(&bits, number, sizeof(bits));
  return bits;
}

void store(void* number, uint32_t bits) { memcpy(number, &bits, sizeof(bits)); }

// Stores the nearest float and keeps the sign that is there. `biased` is the exponent for a mantissa, never 0, whose
// leading 1 is at bit 31. Below its highest 25 bits it is enough that any bit is set if one would be.
MAVMISSION_APART void storeRounded(uint8_t* number, uint32_t mantissa, uint8_t biased) {
  for (; (mantissa & kSign) == 0; --biased) mantissa <<= 1;
  // The lowest byte is below the last bit: more than half of it, or just that and it is odd.
  if ((static_cast<uint8_t>(mantissa) | (static_cast<uint8_t>(mantissa >> 8) & 1)) > 0x80) {
    mantissa += 0x100;
    if (static_cast<uint8_t>(mantissa >> 24) == 0) ++biased;  // carried out of it: the other bits are 0, too
  }
  number[0] = static_cast<uint8_t>(mantissa >> 8);
  number[1] = static_cast<uint8_t>(mantissa >> 16);
  uint8_t high = static_cast<uint8_t>(mantissa >> 24) & 0x7F;
  if ((biased & 1) != 0) high |= 0x80;
  number[2] = high;
  number[3] = (number[3] & 0x80) | biased >> 1;
}

// The mantissa of a factor, from its lowest byte on, and its exponent plus 1, since the product's leading 1 is at bit
// 30 if no bit is carried.
#define MAVMISSION_FACTOR(mantissa, exponent) \
  {(mantissa) & 0xFF, (mantissa) >> 8 & 0xFF, (mantissa) >> 16, static_cast<uint8_t>((exponent) + 1)}
const uint8_t kFactors[][4] PROGMEM = {
    MAVMISSION_FACTOR(0xC80000, 6),   // 100
    MAVMISSION_FACTOR(0xA3D70A, -7),  // 0.01
    MAVMISSION_FACTOR(0x8EFA35, -6),  // a degree in radians
    MAVMISSION_FACTOR(0xE52EE0, 5),   // a radian in degrees
    MAVMISSION_FACTOR(0x800000, 8),   // 256
};
#undef MAVMISSION_FACTOR

}  // namespace

void makeWhole(void* number) {
  uint32_t bits = load(number);
  const uint8_t biased = biasedExponent(bits);
  if (biased >= kBias + 23) return;
  if (biased < kBias) bits = 0;
  const uint8_t fractionBits = kBias + 23 - biased;
  for (uint8_t i = fractionBits; i != 0; --i) bits >>= 1;
  for (uint8_t i = fractionBits; i != 0; --i) bits <<= 1;
  store(number, bits);
}

MAVMISSION_ONE_EXIT void multiply(void* number, Times by) {
  uint32_t bits = load(number);
  const uint8_t biased = biasedExponent(bits);
  if (biased < 16) return store(number, 0);
  bits = longMantissaOf(bits);
  const uint8_t* factor = kFactors[static_cast<uint8_t>(by)];
  uint32_t sum = 0;
  uint8_t left = 0;
  for (uint8_t i = 24; i != 0; --i) {
    if ((i & 7) == 0) left = fromFlash(factor++);
    sum = halved(sum);
    if ((left & 1) != 0) sum += bits;
    left >>= 1;
  }
  storeRounded(static_cast<uint8_t*>(number), sum, static_cast<uint8_t>(biased + fromFlash(factor)));
}

void throughFloat(void* integer) {
  uint32_t value = load(integer);
  // What the 24 bits of a float count in. (Of a negative number the complement: it has as many bits, but where the
  // number is a power of two, and every unit is right.)
  uint8_t unit = 1, above = static_cast<uint8_t>(value >> 24);
  if ((above & 0x80) != 0) above = static_cast<uint8_t>(~above);
  for (; above != 0; above >>= 1) unit <<= 1;
  // Twice what remains below the units, and 1 if their number is odd: more than half a unit, or just that and odd.
  const uint8_t low = static_cast<uint8_t>(value);
  const uint8_t remainder = low & (unit - 1);
  uint8_t twice = static_cast<uint8_t>(remainder << 1);
  if ((low & unit) != 0) twice |= 1;
  value -= remainder;
  if (twice > unit) value += unit;
  store(integer, value);
}

void makeHundredths(void* number) {
  multiply(number, Times::Hundred);
  makeWhole(number);
  multiply(number, Times::Hundredth);
}

void makeTurn(void* degrees) {
  multiply(degrees, Times::Radian);
  constexpr uint32_t kTurn = 0x40C90FDB;  // in radians
  uint32_t radians = load(degrees);
  if ((radians & kSign) != 0) {
    // A full turn less the angle, with 7 bits more than a float has.
    uint8_t biased = biasedExponent(radians);
    radians = longMantissaOf(radians);
    for (; biased < kBias + 2; ++biased) radians = halved(radians);
    static_cast<uint8_t*>(degrees)[3] = 0;  // its sign
    storeRounded(static_cast<uint8_t*>(degrees), longMantissaOf(kTurn) - radians, kBias + 2 + 1);
  } else if (radians == kTurn) {
    store(degrees, 0);
  }
  multiply(degrees, Times::Degree);
}

void setWhole(void* number, uint16_t whole) {
  static_cast<uint8_t*>(number)[3] = 0;  // its sign
  storeRounded(static_cast<uint8_t*>(number), static_cast<uint32_t>(whole) << 16, kBias + 15);
}

float floatOf(uint16_t whole) {
  if (whole == 0) return 0;
  uint8_t exponent = 15;
  for (; (whole & 0x8000) == 0; --exponent) whole <<= 1;
  return assemble(static_cast<uint32_t>(whole) << 8, static_cast<int8_t>(exponent));
}

float oneMore(float whole) {
  const uint32_t bits = bitsOf(whole);
  if (bits == 0) return 1;
  uint32_t unit = kHidden;  // the mantissa bit that is worth 1 in a whole number from 1 on
  for (uint8_t biased = biasedExponent(bits); biased > kBias; --biased) unit >>= 1;
  return fromBits(bits + unit);  // a carry out of the mantissa raises the exponent, as it should
}

float oneLess(float whole) {
  const int32_t number = wholeNumber(&whole);
  return number > 0 ? floatOf(static_cast<uint16_t>(number - 1)) : whole;
}

float quotient(int32_t value, uint32_t divisor) {
  if (value == 0) return 0;
  uint32_t rest = value < 0 ? 0 - static_cast<uint32_t>(value) : static_cast<uint32_t>(value);
  // Long division in binary: the whole part, then bits after the point until there are 25, one of them to round by.
  uint32_t quotient = rest / divisor;
  rest %= divisor;
  int8_t exponent = 24;
  while (quotient >= kHidden << 2) {
    quotient >>= 1;
    ++exponent;
  }
  while (quotient < kHidden << 1) {
    quotient <<= 1;
    rest <<= 1;
    if (rest >= divisor) {
      rest -= divisor;
      ++quotient;
    }
    --exponent;
  }
  quotient = (quotient + 1) >> 1;
  if (quotient == kHidden << 1) ++exponent;  // rounded up to the next power of two: the bits below are all 0
  const float magnitude = assemble(quotient, exponent);
  return value < 0 ? -magnitude : magnitude;
}

}  // namespace detail
}  // namespace mavmission
