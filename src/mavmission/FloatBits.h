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

// An altitude [m] in the centimetres that ArduPilot keeps of it: a float product with 100, cut off, as its own code has
// it. Below 0.01 m it is 0; from 32,768 m on, with the sign, 0x3FFFFFFF.
int32_t centimetresKept(float metres);
// The nearest centimetres to an altitude [m] that was read back; from 32,768 m on, with the sign, 0x40000000, which is
// never what was kept.
int32_t centimetresRead(float metres);

// value / divisor as the nearest float. `divisor` is 1 to 2^28.
float quotient(int32_t value, uint32_t divisor);

}  // namespace mavmission
