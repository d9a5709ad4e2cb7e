#include "DecimalText.h"

#include <string.h>

#include "LongNumber.h"

namespace mavmission {
namespace detail {

void DecimalText::begin() {
  memset(mantissa_, 0, sizeof(mantissa_));
  places_ = 0;
  written_ = 0;
  digits_ = 0;
  zeros_ = 0;
  state_ = State::Start;
  isNegative_ = false;
  isExponentNegative_ = false;
  isCut_ = false;
}

void DecimalText::take(char c) {
  const bool isDigit = c >= '0' && c <= '9';
  const uint8_t digit = static_cast<uint8_t>(c - '0');
  const bool isSign = c == '+' || c == '-';
  const char lower = static_cast<char>(c | 0x20);
  State next = State::Bad;
  switch (state_) {
    case State::Start:
      if (isSign) {
        isNegative_ = c == '-';
        next = State::Signed;
        break;
      }
      // fall through
    case State::Signed:
      if (isDigit) next = State::Whole;
      if (c == '.') next = State::Point;
      if (lower == 'n') next = State::N;
      break;
    case State::Whole:
      if (isDigit) next = State::Whole;
      if (c == '.') next = State::Decimals;
      if (lower == 'e') next = State::E;
      break;
    case State::Point:
      if (isDigit) next = State::Decimals;
      break;
    case State::Decimals:
      if (isDigit) next = State::Decimals;
      if (lower == 'e') next = State::E;
      break;
    case State::E:
      if (isSign) {
        isExponentNegative_ = c == '-';
        next = State::SignedE;
        break;
      }
      // fall through
    case State::SignedE:
    case State::Exponent:
      if (isDigit) {
        next = State::Exponent;
        if (written_ < 1000) written_ = static_cast<int16_t>(written_ * 10 + digit);
      }
      break;
    case State::N:
      if (lower == 'a') next = State::Na;
      break;
    case State::Na:
      if (lower == 'n') next = State::Nan;
      break;
    case State::Nan:
    case State::Bad: break;
  }
  state_ = next;
  if (!isDigit) return;
  if (next == State::Decimals) ++places_;
  if (next == State::Whole || next == State::Decimals) takeDigit(digit);
}

void DecimalText::takeDigit(uint8_t digit) {
  const bool fits = digits_ + zeros_ < kMostDigits;
  if (digit == 0 || !fits) {
    if (digit != 0) isCut_ = true;
    if (digits_ != 0) ++zeros_;  // else a leading zero
    return;
  }
  // The zeros before this digit count now.
  for (++zeros_; zeros_ != 0; --zeros_) {
    uint16_t carry = zeros_ == 1 ? digit : 0;
    for (uint8_t& byte : mantissa_) {
      carry += static_cast<uint16_t>(byte) * 10;
      byte = static_cast<uint8_t>(carry);
      carry >>= 8;
    }
    ++digits_;
  }
}

void DecimalText::set(uint32_t digits, int16_t exponent, bool isNegative) {
  begin();
  for (uint8_t i = 0; i < 4; ++i, digits >>= 8) mantissa_[i] = static_cast<uint8_t>(digits);
  digits_ = 1;
  places_ = -exponent;
  isNegative_ = isNegative;
  state_ = State::Decimals;
}

// The number is mantissa_ * 10^exponent().
int16_t DecimalText::exponent() const { return zeros_ - places_ + (isExponentNegative_ ? -written_ : written_); }

LongNumber DecimalText::significant() const {
  LongNumber number;
  for (uint8_t i = 0; i < kMantissaBytes; ++i) number.setByte(i, mantissa_[i]);
  return number;
}

bool DecimalText::toSteps(uint8_t decimals, uint32_t& magnitude, bool& isExact) const {
  if (!isNumber() || isNan()) return false;
  magnitude = 0;
  isExact = !isCut_;
  if (digits_ == 0) return true;
  LongNumber number = significant();
  int16_t shift = exponent() + decimals;
  if (shift > 10) return false;
  for (; shift > 0; --shift) number.multiply(10);
  uint8_t rest = 0;
  for (; shift < 0 && number.length() != 0; ++shift) {
    rest = number.divide(10);
    if (rest != 0) isExact = false;
  }
  if (shift < 0) rest = 0;  // all digits are shifted out, and the next one is a 0
  if (number.length() > 4) return false;
  magnitude = number.shiftedRight(0);
  if (magnitude > 0x80000000) return false;
  if (rest >= 5) ++magnitude;
  return magnitude <= 0x7FFFFFFF || (magnitude == 0x80000000 && isNegative_);
}

bool DecimalText::toFloat(float& value) const {
  if (!isNumber()) return false;
  uint32_t bits = isNegative_ ? 0x80000000 : 0;
  if (isNan()) {
    bits |= 0x7FC00000;
  } else if (digits_ != 0 && exponent() >= -64) {  // below that, 19 digits are too small for any float
    // mantissa * 10^exponent = number * 2^binary.
    LongNumber number = significant();
    int16_t binary = exponent();
    bool isCut = isCut_;
    if (binary > 38) return false;
    if (binary >= 0) {
      number.multiplyByPowerOf5(static_cast<uint8_t>(binary));
    } else {
      // Shifted up by whole bytes, far enough for more than 26 bits to remain.
      const uint8_t power = static_cast<uint8_t>(-binary);
      const uint8_t length = number.length();
      const uint8_t needed = static_cast<uint8_t>((28 + power * 7 / 3 + 7) / 8 + 1);
      if (needed > length) {
        const uint8_t up = needed - length;
        for (uint8_t index = needed; index-- != 0;) number.setByte(index, index >= up ? number.byteAt(index - up) : 0);
        binary -= up * 8;
      }
      if (number.divideByPowerOf5(power)) isCut = true;
    }
    const int16_t highest = number.highestBit();
    const int16_t exponent2 = highest + binary;
    if (exponent2 > 127) return false;
    // A denormal float has fewer bits.
    const int16_t kept = exponent2 >= -126 ? 24 : 24 + 126 + exponent2;
    if (kept >= 0) {
      uint32_t mantissa = 0;
      const int16_t lowest = highest - kept + 1;
      for (int16_t place = highest; place >= lowest; --place) mantissa = mantissa << 1 | number.isSet(place);
      const bool isHalf = number.isSet(lowest - 1);
      if (isHalf && ((mantissa & 1) != 0 || isCut || number.hasBitsBelow(lowest - 1))) ++mantissa;
      // The leading 1 of the mantissa, and a carry out of the mantissa, add to the exponent.
      if (exponent2 > -126) mantissa += static_cast<uint32_t>(exponent2 + 126) << 23;
      if (mantissa >= 0x7F800000) return false;
      bits |= mantissa;
    }
  }
  memcpy(&value, &bits, sizeof(value));
  return true;
}

namespace {

// The lowest of its digits, so many.
char* putDigits(char* text, uint32_t value, uint8_t places) {
  char* end = text + places;
  for (char* at = end; at != text; value /= 10) *--at = static_cast<char>('0' + value % 10);
  return end;
}

uint8_t placesOf(uint32_t value) {
  uint8_t places = 1;
  for (; value >= 10; value /= 10) ++places;
  return places;
}

// Nine digits of a finite float other than 0, and their exponent: digits * 10^exponent.
uint32_t nineDigits(uint32_t bits, int16_t& exponent) {
  const uint8_t biased = static_cast<uint8_t>(bits >> 23);
  const uint32_t fraction = bits & 0x007FFFFF;
  const uint32_t mantissa = biased == 0 ? fraction : fraction | 0x00800000;
  const int16_t binary = (biased == 0 ? 1 : biased) - 127 - 23;
  // Begins with an exponent that gives too many digits, and goes on to the one that gives nine.
  exponent = static_cast<int16_t>((binary + 23) * 77 / 256 - 8 - 2);
  for (;; ++exponent) {
    LongNumber number;
    for (uint8_t i = 0; i < 3; ++i) number.setByte(i, static_cast<uint8_t>(mantissa >> (8 * i)));
    // mantissa * 2^binary / 10^exponent = number * 2^-shift
    int16_t shift = exponent - binary;
    if (exponent <= 0) {
      number.multiplyByPowerOf5(static_cast<uint8_t>(-exponent));
    } else {
      // 12 bytes up: 96 bits more than division by 5^30 takes away.
      for (uint8_t i = 0; i < 3; ++i) {
        number.setByte(i + 12, number.byteAt(i));
        number.setByte(i, 0);
      }
      shift += 96;
      number.divideByPowerOf5(static_cast<uint8_t>(exponent));
    }
    if (number.highestBit() - shift > 31) continue;
    const uint32_t digits = number.shiftedRight(shift);
    if (digits < 1000000000) return digits;
  }
}

// Whether these digits are read as this float.
bool isRead(uint32_t digits, int16_t exponent, bool isNegative, float value) {
  DecimalText text;
  text.set(digits, exponent, isNegative);
  float found;
  // Compared bit by bit on purpose: -0 and 0 are two texts.  NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
  return text.toFloat(found) && memcmp(&found, &value, sizeof(value)) == 0;
}

}  // namespace

void printFloat(float value, char* text) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof(bits));
  const bool isNegative = (bits & 0x80000000) != 0;
  bits &= 0x7FFFFFFF;
  if (bits >= 0x7F800000) {
    if (bits == 0x7F800000 && isNegative) *text++ = '-';
    memcpy(text, bits == 0x7F800000 ? "inf" : "nan", 4);
    return;
  }
  if (isNegative) *text++ = '-';
  if (bits == 0) {
    *text++ = '0';
    *text = '\0';
    return;
  }
  int16_t exponent;
  uint32_t digits = nineDigits(bits, exponent);
  int16_t raised = exponent + 3;
  for (uint32_t unit = 1000; unit > 1; unit /= 10, --raised) {
    const uint32_t lower = digits / unit, rest = digits % unit;
    uint32_t shorter = rest < unit / 2 ? lower : lower + 1;
    if (!isRead(shorter, raised, isNegative, value)) {
      // Digits that end with a half may have been rounded up to it: then the lower ones are the nearer.
      shorter = lower;
      if (rest != unit / 2 || !isRead(shorter, raised, isNegative, value)) continue;
    }
    digits = shorter;
    exponent = raised;
    break;
  }
  for (; digits % 10 == 0; ++exponent) digits /= 10;
  const uint8_t places = placesOf(digits);
  if (exponent >= 0 && places + exponent <= 10) {  // whole
    text = putDigits(text, digits, places);
    for (; exponent != 0; --exponent) *text++ = '0';
  } else if (exponent < 0 && places + exponent > -4) {  // a point within the digits, or a few zeros after the point
    const int16_t before = places + exponent;
    if (before > 0) {
      uint32_t unit = 1;
      for (int16_t i = exponent; i < 0; ++i) unit *= 10;
      text = putDigits(text, digits / unit, static_cast<uint8_t>(before));
    } else {
      *text++ = '0';
    }
    *text++ = '.';
    for (int16_t i = before; i < 0; ++i) *text++ = '0';
    text = putDigits(text, digits, before > 0 ? static_cast<uint8_t>(-exponent) : places);
  } else {
    text = putDigits(text, digits, places);
    *text++ = 'e';
    if (exponent < 0) *text++ = '-';
    const uint8_t magnitude = static_cast<uint8_t>(exponent < 0 ? -exponent : exponent);
    text = putDigits(text, magnitude, placesOf(magnitude));
  }
  *text = '\0';
}

void printWhole(uint32_t value, char* text) { *putDigits(text, value, placesOf(value)) = '\0'; }

void printDegrees(int32_t e7, char* text) {
  uint32_t magnitude = static_cast<uint32_t>(e7);
  if (e7 < 0) {
    *text++ = '-';
    magnitude = 0 - magnitude;
  }
  const uint32_t whole = magnitude / 10000000;
  text = putDigits(text, whole, placesOf(whole));
  *text++ = '.';
  text = putDigits(text, magnitude % 10000000, 7);
  *text = '\0';
}

}  // namespace detail
}  // namespace mavmission
