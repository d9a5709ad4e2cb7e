#include "FloatBits.h"

#include <string.h>

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

// `mantissa` has its highest bit at bit 23; the value is mantissa * 2^(exponent - 23).
float assemble(uint32_t mantissa, int8_t exponent) {
  const uint8_t biased = static_cast<uint8_t>(kBias + exponent);
  return fromBits((mantissa & (kHidden - 1)) | static_cast<uint32_t>(biased) << 23);
}

}  // namespace

FloatKind kindOf(const void* bytes) {
  uint32_t magnitude;
  memcpy(&magnitude, bytes, sizeof(magnitude));
  magnitude &= ~kSign;
  if (magnitude < kInfinity) return FloatKind::Finite;
  return magnitude == kInfinity ? FloatKind::Infinite : FloatKind::NotANumber;
}

bool isWholeNumber(float value, uint16_t& whole) {
  const uint32_t bits = bitsOf(value);
  whole = 0;
  if ((bits & ~kSign) == 0) return true;
  if ((bits & kSign) != 0) return false;
  const uint8_t biased = static_cast<uint8_t>(bits >> 23);
  if (biased < kBias || biased > kBias + 15) return false;
  uint32_t mantissa = (bits & (kHidden - 1)) | kHidden;
  for (uint8_t shift = 23 - (biased - kBias); shift != 0; --shift) {
    if ((mantissa & 1) != 0) return false;
    mantissa >>= 1;
  }
  whole = static_cast<uint16_t>(mantissa);
  return true;
}

float oneMore(float whole) {
  const uint32_t bits = bitsOf(whole);
  if (bits == 0) return 1;
  // One at the place of the units; a carry out of the mantissa raises the exponent, as it should.
  uint32_t unit = kHidden;
  for (uint8_t biased = static_cast<uint8_t>(bits >> 23); biased != kBias; --biased) unit >>= 1;
  return fromBits(bits + unit);
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
