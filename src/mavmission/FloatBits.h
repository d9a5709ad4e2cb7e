// The few things done with floats, done on their bits, for the flash that avr-gcc's float routines would take.
#pragma once

#include <stdint.h>

#include "Config.h"

namespace mavmission {

enum class FloatKind : uint8_t { Finite, Infinite, NotANumber };
// Of the float that lies at `bytes`.
FloatKind kindOf(const void* bytes);

// The same value: any NaN is the same as any other, 0 the same as -0.
MAVMISSION_APART bool isSame(float a, float b);
bool isNegative(float value);

// The whole number from 0 to 65535 that `value` is, or -1 if it is none.
int32_t wholeNumber(float value);

// A whole number from 0 to 65535 as a float, and one more.
float oneMore(float whole);
// And one less, from 1 on; 0 stays 0.
float oneLess(float whole);

// The float whose bits are `bits`, times `factor`, to the nearest whole number; `factor` is 1 to 2^24. Beyond what fits it
// is 0.
int32_t timesWhole(int32_t bits, uint32_t factor);

// `value` without what is behind the point.
float wholePart(float value);

// a * b, to the nearest float; 0 where that is far below 1e-30. Both are finite, b is not 0, the product is below 2^127.
MAVMISSION_APART float product(float a, float b);
// a - b, to the nearest float, for a from b on, and b from 0 on.
MAVMISSION_APART float minus(float a, float b);

// `value` without its sign.
float magnitudeOf(float value);

// A number that has been cut to whole hundredths and put together again by ArduPilot's own way: as floats, one after the
// other. Below 83,886.08.
float inHundredths(float value);

// A heading from -180 to 360 degrees as PX4 gives it back, from 0 to 360: made radians, put into one turn, made degrees
// again, each as floats.
float throughRadians(float degrees);
// False for what is beyond that, and not NaN.
bool isHeading(float degrees);

// The integer that is left of one that has been a float, as far as it fits.
int32_t throughFloat(int32_t value);

// value / divisor as the nearest float. `divisor` is 1 to 2^28.
float quotient(int32_t value, uint32_t divisor);

}  // namespace mavmission
