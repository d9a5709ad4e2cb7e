// A decimal number as text, taken character by character, as whole steps or as the nearest float: exactly, by integers
// only. (On AVR a `double` is a 32-bit float, and strtod() takes the digits of a longitude for it.)
#pragma once

#include <stdint.h>

namespace mavmission {
namespace detail {

class LongNumber;

class DecimalText {
 public:
  DecimalText() { begin(); }

  // Forgets what was taken.
  void begin();

  // Takes the next character: digits, a sign, a point, an exponent (1e-05), or the word nan. At most 255 of them.
  void take(char c);

  // True if what was taken is a number, or nan.
  bool isNumber() const { return state_ == State::Whole || state_ == State::Decimals || isFinished(); }
  bool isPlain() const { return state_ == State::Whole; }  // digits, and perhaps a sign
  bool isNan() const { return state_ == State::Nan; }
  bool isNegative() const { return isNegative_; }

  // The number in steps of 10^-decimals, to the nearest, half away from 0; its magnitude. False beyond 2^31 - 1, and
  // for nan. `isExact`: nothing was rounded.
  bool toSteps(uint8_t decimals, uint32_t& magnitude, bool& isExact) const;

  // The nearest float, the even one of two equally near; of more than 19 digits the rest decides only that. False if it
  // is no number, or beyond the largest.
  bool toFloat(float& value) const;

  // As if the digits of `digits`, with so many places moved to the left, had been taken.
  void set(uint32_t digits, int16_t exponent, bool isNegative);

 private:
  enum class State : uint8_t { Start, Signed, Whole, Point, Decimals, E, SignedE, Exponent, N, Na, Nan, Bad };

  bool isFinished() const { return state_ == State::Exponent || state_ == State::Nan; }
  void takeDigit(uint8_t digit);
  void takeExponentDigit(uint8_t digit);
  int16_t exponent() const;
  LongNumber significant() const;

  static constexpr uint8_t kMostDigits = 19;  // that 64 bits hold; what is behind them only decides a rounding
  static constexpr uint8_t kMantissaBytes = 8;

  uint8_t mantissa_[kMantissaBytes];  // the significant digits, the lowest byte first
  int16_t places_;                    // digits behind the point
  int16_t written_;                   // the exponent behind an e
  uint8_t digits_;                    // in mantissa_
  uint8_t zeros_;                     // taken behind those: they count only when another digit follows
  State state_;
  bool isNegative_ : 1;
  bool isExponentNegative_ : 1;
  bool isCut_ : 1;  // a digit other than 0 was left out
};

// The shortest of 6 to 9 significant digits that are this float again, as text that ends with 0; `text` has room for
// kFloatText bytes. "nan" and "inf" are spelt so.
constexpr uint8_t kFloatText = 20;
void printFloat(float value, char* text);

// A whole number; `text` has room for kWholeText bytes.
constexpr uint8_t kWholeText = 11;
void printWhole(uint32_t value, char* text);

// A coordinate [1e-7 degrees] with its seven decimals; `text` has room for kDegreesText bytes.
constexpr uint8_t kDegreesText = 13;
void printDegrees(int32_t e7, char* text);

}  // namespace detail
}  // namespace mavmission
