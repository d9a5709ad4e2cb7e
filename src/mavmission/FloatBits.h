// The few things done with floats, done on their bits: avr-gcc's float routines would cost 900 bytes of flash.
#pragma once

#include <stdint.h>

namespace mavmission {

enum class FloatKind : uint8_t { Finite, Infinite, NotANumber };
// Of the float that lies at `bytes`.
FloatKind kindOf(const void* bytes);

// The whole number from 0 to 65535 that `value` is, in `whole`; false if it is none.
bool isWholeNumber(float value, uint16_t& whole);

// A whole number from 0 to 65535 as a float, and one more.
float oneMore(float whole);

// value / divisor as the nearest float. `divisor` is 1 to 2^28.
float quotient(int32_t value, uint32_t divisor);

}  // namespace mavmission
