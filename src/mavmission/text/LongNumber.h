// A whole number of up to 192 bits, for turning decimals into floats and back exactly. Small rather than fast.
#pragma once

#include <stdint.h>
#include <string.h>

namespace mavmission {
namespace detail {

class LongNumber {
 public:
  static constexpr uint8_t kBytes = 24;

  LongNumber() { memset(bytes_, 0, sizeof(bytes_)); }

  uint8_t byteAt(uint8_t index) const { return bytes_[index]; }
  void setByte(uint8_t index, uint8_t value) { bytes_[index] = value; }

  // The number of bytes up to the highest one that is not 0; 0 for 0.
  uint8_t length() const;

  // Multiplies by `factor` and adds `more`. Bits that do not fit are lost.
  void multiply(uint8_t factor, uint8_t more = 0);
  // Divides by `divisor`, and returns the remainder.
  uint8_t divide(uint8_t divisor);
  // Multiplies by 5 to the power of `power`.
  void multiplyByPowerOf5(uint8_t power);
  // Divides by 5 to the power of `power`; true if there is a remainder.
  bool divideByPowerOf5(uint8_t power);

  // The bit of value 2^place; false beyond either end.
  bool isSet(int16_t place) const;
  // The place of the highest bit that is set; -1 for 0.
  int16_t highestBit() const;
  // True if any bit below `place` is set.
  bool hasBitsBelow(int16_t place) const;
  // This number divided by 2^shift (multiplied, if `shift` is negative), to the nearest, half up. At most 32 bits are
  // kept.
  uint32_t shiftedRight(int16_t shift) const;

 private:
  uint8_t bytes_[kBytes];  // the lowest first
};

}  // namespace detail
}  // namespace mavmission
