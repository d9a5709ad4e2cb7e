// A decimal number as text, taken character by character, and given as whole steps or as the nearest float: exactly, by
// integers only. (On AVR a `double` is a 32-bit float, so strtod() would lose digits of a longitude.)
#pragma once

#include <stdint.h>

namespace mavmission {
namespace detail {

class LongNumber;

class DecimalText {
 public:
  DecimalText() { begin(); }

  // Forgets all characters.
  void begin();

  // Takes the next character: digits, a sign, a point, an exponent (1e-05), or the word nan. At most 255 of them.
  void take(char c);

  // True if the characters are a number, or nan.
  bool isNumber() const { return state_ == State::Whole || state_ == State::Decimals || isFinished(); }
  bool isPlain() const { return state_ == State::Whole; }  // digits, and perhaps a sign
  bool isNan() const { return state_ == State::Nan; }
  bool isNegative() const { return isNegative_; }

  // The magnitude in steps of 10^-decimals, to the nearest, half away from 0. False beyond 2^31 - 1, and for nan.
  // `isExact`: nothing was rounded.
  bool toSteps(uint8_t decimals, uint32_t& magnitude, bool& isExact) const;

  // The nearest float, or the even one of two equally near ones; digits beyond the 19th decide only between those two.
  // False if it is no number, or beyond the largest float.
  bool toFloat(float& value) const;

  // As if the digits of `digits`, shifted by this many decimal places, had been taken.
  void set(uint32_t digits, int16_t exponent, bool isNegative);

 private:
  enum class State : uint8_t { Start, Signed, Whole, Point, Decimals, E, SignedE, Exponent, N, Na, Nan, Bad };

  bool isFinished() const { return state_ == State::Exponent || state_ == State::Nan; }
  void takeDigit(uint8_t digit);
  int16_t exponent() const;
  LongNumber significant() const;

  static constexpr uint8_t kMostDigits = 19;  // that fit into 64 bits; further ones only decide the rounding
  static constexpr uint8_t kMantissaBytes = 8;

  uint8_t mantissa_[kMantissaBytes];  // the significant digits, the lowest byte first
  int16_t places_;                    // digits after the point
  int16_t written_;                   // the exponent after an e
  uint8_t digits_;                    // in mantissa_
  uint8_t zeros_;                     // taken after those; they count only if another digit follows
  State state_;
  bool isNegative_ : 1;
  bool isExponentNegative_ : 1;
  bool isCut_ : 1;  // a digit other than 0 was left out
};

// The shortest text of 6 to 9 significant digits that reads back as this float, ending with 0; `text` has room for
// kFloatText bytes. Also "nan" and "inf".
constexpr uint8_t kFloatText = 20;
void printFloat(float value, char* text);

// A whole number as text; `text` has room for kWholeText bytes.
constexpr uint8_t kWholeText = 11;
void printWhole(uint32_t value, char* text);

// A coordinate [1e-7 degrees] as text with seven decimals; `text` has room for kDegreesText bytes.
constexpr uint8_t kDegreesText = 13;
void printDegrees(int32_t e7, char* text);

}  // namespace detail
}  // namespace mavmission
