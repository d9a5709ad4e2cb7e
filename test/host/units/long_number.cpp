#include "mavmission/text/LongNumber.h"

#include <doctest/doctest.h>

#include <initializer_list>
#include <new>

using namespace mavmission::detail;

namespace {

constexpr int16_t kBits = 192;

LongNumber of(uint64_t value) {
  LongNumber number;
  for (uint8_t i = 0; i < 8; ++i, value >>= 8) number.setByte(i, static_cast<uint8_t>(value));
  return number;
}

uint64_t valueOf(const LongNumber& number) {
  uint64_t value = 0;
  for (uint8_t i = 8; i-- != 0;) value = value << 8 | number.byteAt(i);
  return value;
}

// 2 to the power of `place`.
LongNumber bit(int16_t place) {
  LongNumber number;
  number.setByte(static_cast<uint8_t>(place / 8), static_cast<uint8_t>(1 << place % 8));
  return number;
}

}  // namespace

TEST_CASE("a number is 0 at first, and as long as its highest byte that is not 0") {
  // In memory that held something else before.
  alignas(LongNumber) unsigned char used[sizeof(LongNumber)];
  for (unsigned char& byte : used) byte = 0xA5;
  const LongNumber& fresh = *new (used) LongNumber();
  CHECK(fresh.length() == 0);
  CHECK(fresh.highestBit() == -1);
  CHECK(of(1).length() == 1);
  CHECK(of(0xFF).length() == 1);
  CHECK(of(0x100).length() == 2);
  CHECK(bit(kBits - 1).length() == kBits / 8);
}

TEST_CASE("each bit is found in its place, and none beyond either end") {
  for (int16_t place = 0; place < kBits; ++place) {
    const LongNumber number = bit(place);
    CHECK(number.highestBit() == place);
    for (int16_t other = -9; other < kBits + 9; ++other) CHECK(number.isSet(other) == (other == place));
    CHECK_FALSE(number.hasBitsBelow(place));
    CHECK(number.hasBitsBelow(place + 1));
    CHECK_FALSE(number.hasBitsBelow(0));
  }
  // A lower bit does not hide a higher one.
  CHECK(of(0x8001).highestBit() == 15);
  CHECK(of(0x8001).hasBitsBelow(15));
  CHECK_FALSE(LongNumber().hasBitsBelow(kBits));
}

TEST_CASE("multiplication carries from byte to byte, adds, and loses what does not fit into 192 bits") {
  LongNumber number = of(0xFFFFFFFFFF);
  number.multiply(255, 255);
  CHECK(valueOf(number) == 0xFFFFFFFFFFu * 255 + 255);
  LongNumber all;
  for (uint8_t i = 0; i < kBits / 8; ++i) all.setByte(i, 0xFF);
  all.multiply(2);  // all bits but the lowest
  CHECK(all.length() == kBits / 8);
  CHECK(all.highestBit() == kBits - 1);
  CHECK_FALSE(all.isSet(0));
  for (int16_t place = 1; place < kBits; ++place) CHECK(all.isSet(place));
}

TEST_CASE("division leaves the quotient, and gives the remainder") {
  for (uint64_t value : {0ull, 1ull, 124ull, 125ull, 126ull, 0xFFFFull, 1234567890123456789ull}) {
    for (uint8_t divisor : {1, 2, 5, 10, 125, 255}) {
      LongNumber number = of(value);
      CHECK(number.divide(divisor) == value % divisor);
      CHECK(valueOf(number) == value / divisor);
    }
  }
}

TEST_CASE("powers of 5 are multiplied by and divided by, and a remainder is told whichever step it is of") {
  uint64_t power = 1;
  for (uint8_t exponent = 0; exponent <= 20; ++exponent, power *= 5) {
    LongNumber number = of(3);
    number.multiplyByPowerOf5(exponent);
    CHECK(valueOf(number) == 3 * power);
    CHECK_FALSE(number.divideByPowerOf5(exponent));
    CHECK(valueOf(number) == 3);
    for (uint64_t less = 1; less < power; less *= 5) {
      LongNumber rest = of(3 * power + less);
      CHECK(rest.divideByPowerOf5(exponent));
      CHECK(valueOf(rest) == 3);
      LongNumber other = of(3 * power - less);
      CHECK(other.divideByPowerOf5(exponent));
      CHECK(valueOf(other) == 2);
    }
  }
}

TEST_CASE("a number is shifted to the nearest one, half up, and 32 bits of it are kept") {
  CHECK(of(0).shiftedRight(0) == 0);
  CHECK(of(0x12345678).shiftedRight(0) == 0x12345678);
  CHECK(of(0x12345678).shiftedRight(8) == 0x123456);
  CHECK(of(0x12345680).shiftedRight(8) == 0x123457);
  CHECK(of(0x1234567F).shiftedRight(8) == 0x123456);
  CHECK(of(5).shiftedRight(1) == 3);
  CHECK(of(6).shiftedRight(2) == 2);
  CHECK(of(5).shiftedRight(2) == 1);
  CHECK(of(5).shiftedRight(3) == 1);
  CHECK(of(5).shiftedRight(4) == 0);
  CHECK(of(5).shiftedRight(5) == 0);
  CHECK(of(5).shiftedRight(-4) == 80);
  CHECK(of(0xABCDEF0123456789).shiftedRight(16) == 0xEF012345);
  LongNumber high = of(0xDEADBEEF);
  for (uint8_t i = 0; i < 20; ++i) high.multiply(255, 0);
  for (uint8_t i = 0; i < 20; ++i) high.divide(255);
  CHECK(high.shiftedRight(0) == 0xDEADBEEF);
}
