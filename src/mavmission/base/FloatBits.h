// The few operations on floats, done on their bits: this saves the flash of avr-gcc's float routines.
#pragma once

#include <stdint.h>

#include "Config.h"

namespace mavmission {
namespace detail {

enum class FloatKind : uint8_t { Finite, Infinite, NotANumber };
// The kind of the float that lies at `bytes`.
FloatKind kindOf(const void* bytes);

// The whole number from 0 to 65535 that the float at `number` is, or -1 if it is none.
int32_t wholeNumber(const void* number);

// A whole number as a float.
MAVMISSION_APART float floatOf(uint16_t whole);

// A whole number from 0 to 65535 as a float, plus one.
float oneMore(float whole);
// The same, minus one. 0 stays 0, and what is no such number stays as it is.
float oneLess(float whole);

// The float whose bits are `bits`, times `factor`, to the nearest whole number; 0 if it does not fit. `factor` is 1 to
// 2^24.
int32_t timesWhole(int32_t bits, uint32_t factor);

// The following work on the float that lies at `number`, which makes small calls on AVR.

// Makes it a whole number from 1 on: less code than floatOf() where numbers are rounded, too.
void setWhole(void* number, uint16_t whole);

// Cuts off the fraction.
MAVMISSION_APART void makeWhole(void* number);

// The factors of multiply().
enum class Times : uint8_t {
  Hundred,
  Hundredth,
  Radian,
  Degree,
  T256
};  // Radian: degrees to radians; Degree: radians to degrees
// Multiplies, and rounds to the nearest float. A number below 1e-33 becomes 0.
MAVMISSION_APART void multiply(void* number, Times factor);

// Cuts a number to whole hundredths and makes a float of them again, with ArduPilot's float operations.
void makeHundredths(void* number);

// Changes a heading from -180 to 360 degrees as PX4 does: to radians, into one turn, back to degrees, with its float
// operations.
MAVMISSION_APART void makeTurn(void* degrees);

// Rounds an integer as a conversion to float and back does.
void throughFloat(void* integer);

// value / divisor as the nearest float. `divisor` is 1 to 2^28.
float quotient(int32_t value, uint32_t divisor);

}  // namespace detail
}  // namespace mavmission
