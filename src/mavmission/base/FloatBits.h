// The few things done with floats, done on their bits, for the flash that avr-gcc's float routines would take.
#pragma once

#include <stdint.h>

#include "../Config.h"

namespace mavmission {
namespace detail {

enum class FloatKind : uint8_t { Finite, Infinite, NotANumber };
// Of the float that lies at `bytes`.
FloatKind kindOf(const void* bytes);

// The same value: any NaN is the same as any other, 0 the same as -0.
MAVMISSION_APART bool isSame(const void* a, const void* b);

// The whole number from 0 to 65535 that `value` is, or -1 if it is none.
int32_t wholeNumber(float value);

// A whole number from 0 to 65535 as a float, and one more.
float oneMore(float whole);
// And one less, from 1 on; 0 stays 0.
float oneLess(float whole);

// The float whose bits are `bits`, times `factor`, to the nearest whole number; `factor` is 1 to 2^24. Beyond what fits
// it is 0.
int32_t timesWhole(int32_t bits, uint32_t factor);

// The following work on the float that lies at `number`: calls are small, and that is what counts on AVR.

// Cuts off what is behind the point.
MAVMISSION_APART void makeWhole(void* number);

// What a number is multiplied with.
enum class Times : uint8_t {
  Hundred,
  Hundredth,
  Radian,
  Degree,
  T256
};  // a radian: of one degree, and the other way round
// Multiplies, to the nearest float. What is below 1e-33 becomes 0.
MAVMISSION_APART void multiply(void* number, Times factor);

// Makes of a number what is left of it when whole hundredths have been kept, and put together again as floats:
// ArduPilot's own way.
void makeHundredths(void* number);

// Makes of a heading from -180 to 360 degrees what PX4 gives back: made radians, put into one turn, made degrees again,
// as floats.
MAVMISSION_APART void makeTurn(void* degrees);

// Makes of an integer what is left of one that has been a float.
void throughFloat(void* integer);

// value / divisor as the nearest float. `divisor` is 1 to 2^28.
float quotient(int32_t value, uint32_t divisor);

}  // namespace detail
}  // namespace mavmission
