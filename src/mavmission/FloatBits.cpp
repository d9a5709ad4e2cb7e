#include "FloatBits.h"

#include <string.h>

#include "Config.h"

namespace mavmission {
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

// (A shift of the upper half is half the code of one of the whole.)
uint8_t biasedExponent(uint32_t bits) { return static_cast<uint8_t>(static_cast<uint16_t>(bits >> 16) >> 7); }

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

bool isSame(float a, float b) {
  const uint32_t bitsA = bitsOf(a);
  const uint32_t bitsB = bitsOf(b);
  if (bitsA == bitsB || ((bitsA | bitsB) & ~kSign) == 0) return true;
  return (bitsA & ~kSign) > kInfinity && (bitsB & ~kSign) > kInfinity;
}

bool isNegative(float value) { return (bitsOf(value) & kSign) != 0; }

int32_t wholeNumber(float value) {
  const uint32_t bits = bitsOf(value);
  if ((bits & ~kSign) == 0) return 0;
  const uint16_t biased = static_cast<uint16_t>(bits >> 16) >> 7;  // the sign above it: beyond any
  if (biased < kBias || biased > kBias + 15) return -1;
  uint32_t mantissa = (bits & (kHidden - 1)) | kHidden;
  for (uint8_t shift = 23 - (biased - kBias); shift != 0; --shift) {
    if ((mantissa & 1) != 0) return -1;
    mantissa >>= 1;
  }
  return static_cast<int32_t>(mantissa);
}

int32_t timesWhole(int32_t bits, uint32_t factor) {
  const uint32_t magnitude = static_cast<uint32_t>(bits) & ~kSign;
  const uint8_t biased = static_cast<uint8_t>(magnitude >> 23);
  if (biased == 0 || biased > kBias + 31) return 0;
  uint64_t product = static_cast<uint64_t>((magnitude & (kHidden - 1)) | kHidden) * factor;
  int16_t exponent = static_cast<int16_t>(biased) - kBias - 23;
  for (; exponent > 0; --exponent) product <<= 1;
  // From -149 on at most.  NOLINTNEXTLINE(bugprone-too-small-loop-variable)
  for (; exponent < -1; ++exponent) product >>= 1;
  if (exponent < 0) product = (product + 1) >> 1;
  if (product > 0x7FFFFFFF) return 0;
  return bits < 0 ? -static_cast<int32_t>(product) : static_cast<int32_t>(product);
}

float wholePart(float value) {
  const uint32_t bits = bitsOf(value);
  const uint8_t biased = biasedExponent(bits);
  if (biased < kBias) return 0;
  if (biased >= kBias + 23) return value;
  return fromBits(bits & ~((kHidden - 1) >> (biased - kBias)));
}

namespace {

// The magnitude of metres * 100, times two, cut off; `rounded`: the product is rounded to a float's 24 bits first.
MAVMISSION_APART uint32_t doubledCentimetres(float metres, bool rounded) {
  const uint32_t bits = bitsOf(metres);
  const uint8_t biased = biasedExponent(bits);
  if (biased >= kBias + 14 + 1) return 0x7FFFFFFF;
  if (biased < kBias - 8) return 0;
  // The exponent of the last bit of the doubled product.
  int8_t exponent = static_cast<int8_t>(biased - kBias - 23 + 1);
  uint32_t product = ((bits & (kHidden - 1)) | kHidden) * 100;
  if (rounded) {
    bool half = false, more = false;  // what is cut off: its highest bit, and any below
    for (; static_cast<uint8_t>(product >> 24) != 0; product >>= 1, ++exponent) {
      more |= half;
      half = (product & 1) != 0;
    }
    if (half && (more || (product & 1) != 0)) ++product;
  }
  for (; exponent < 0 && product != 0; ++exponent) product >>= 1;
  return product;
}

}  // namespace

int32_t centimetresKept(float metres) {
  const int32_t kept = static_cast<int32_t>(doubledCentimetres(metres, true) >> 1);
  return isNegative(metres) ? -kept : kept;
}

int32_t centimetresRead(float metres) {
  const int32_t nearest = static_cast<int32_t>((doubledCentimetres(metres, false) + 1) >> 1);
  return isNegative(metres) ? -nearest : nearest;
}

namespace {

// One at the place of the units of a whole number from 1 on.
uint32_t unitBit(uint32_t bits) {
  uint32_t unit = kHidden;
  for (uint8_t biased = biasedExponent(bits); biased > kBias; --biased) unit >>= 1;
  return unit;
}

}  // namespace

float oneMore(float whole) {
  const uint32_t bits = bitsOf(whole);
  if (bits == 0) return 1;
  return fromBits(bits + unitBit(bits));  // a carry out of the mantissa raises the exponent, as it should
}

float oneLess(float whole) {
  const uint32_t bits = bitsOf(whole);
  const uint8_t biased = biasedExponent(bits);
  if (biased <= kBias) return 0;
  // Below a power of two the unit is worth twice as many bits.
  const bool isPower = (bits & (kHidden - 1)) == 0;
  return fromBits(bits - (isPower ? unitBit(bits) << 1 : unitBit(bits)));
}

float quotient(int32_t value, uint32_t divisor) {
  if (value == 0) return 0;
  uint32_t rest = value < 0 ? 0 - static_cast<uint32_t>(value) : static_cast<uint32_t>(value);
  // Long division in binary: the whole part, then bits behind the point until there are 25, one of them to round by.
  uint32_t quotient = 0;
  if (divisor == 1) {
    quotient = rest;
    rest = 0;
  }
  for (; rest >= divisor; rest -= divisor) ++quotient;  // at most 214 times for an angle
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

}  // namespace mavmission
