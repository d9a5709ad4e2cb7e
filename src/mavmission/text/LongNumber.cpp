#include "LongNumber.h"

namespace mavmission {
namespace detail {

uint8_t LongNumber::length() const {
  uint8_t length = kBytes;
  while (length != 0 && bytes_[length - 1] == 0) --length;
  return length;
}

void LongNumber::multiply(uint8_t factor, uint8_t more) {
  uint16_t carry = more;
  for (uint8_t& byte : bytes_) {
    carry += static_cast<uint16_t>(byte) * factor;
    byte = static_cast<uint8_t>(carry);
    carry >>= 8;
  }
}

uint8_t LongNumber::divide(uint8_t divisor) {
  uint16_t rest = 0;
  for (uint8_t index = length(); index-- != 0;) {
    rest = static_cast<uint16_t>(rest << 8 | bytes_[index]);
    bytes_[index] = static_cast<uint8_t>(rest / divisor);
    rest %= divisor;
  }
  return static_cast<uint8_t>(rest);
}

void LongNumber::multiplyByPowerOf5(uint8_t power) {
  for (; power >= 3; power -= 3) multiply(125);
  for (; power != 0; --power) multiply(5);
}

bool LongNumber::divideByPowerOf5(uint8_t power) {
  uint8_t rests = 0;
  for (; power >= 3; power -= 3) rests |= divide(125);
  for (; power != 0; --power) rests |= divide(5);
  return rests != 0;
}

bool LongNumber::isSet(int16_t place) const {
  if (place < 0 || place >= kBytes * 8) return false;
  return (bytes_[place / 8] >> (place % 8) & 1) != 0;
}

int16_t LongNumber::highestBit() const {
  int16_t place = length() * 8 - 1;
  while (place >= 0 && !isSet(place)) --place;
  return place;
}

bool LongNumber::hasBitsBelow(int16_t place) const {
  while (--place >= 0) {
    if (isSet(place)) return true;
  }
  return false;
}

uint32_t LongNumber::shiftedRight(int16_t shift) const {
  uint32_t kept = 0;
  for (int16_t place = highestBit(); place >= shift; --place) kept = kept << 1 | isSet(place);
  return isSet(shift - 1) ? kept + 1 : kept;
}

}  // namespace detail
}  // namespace mavmission
