#include "mavmission/base/FloatBits.h"

#include <doctest/doctest.h>
#include <string.h>

#include <cmath>
#include <initializer_list>
#include <limits>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

uint32_t seed = 7;
uint32_t random32() {
  seed = seed * 1664525 + 1013904223;
  const uint32_t high = seed;
  seed = seed * 1664525 + 1013904223;
  return (high & 0xFFFF0000) | seed >> 16;
}

float fromBits(uint32_t bits) {
  float value;
  memcpy(&value, &bits, sizeof(value));
  return value;
}

uint32_t bitsOf(float value) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof(bits));
  return bits;
}

const float kInfinity = std::numeric_limits<float>::infinity();
const float kNaN = std::numeric_limits<float>::quiet_NaN();

// True if no float is nearer to value / divisor. (long double holds the quotient of these numbers well enough to tell.)
bool isNearest(float found, int32_t value, uint32_t divisor) {
  const long double exact = static_cast<long double>(value) / static_cast<long double>(divisor);
  const long double away = std::fabs(found - exact);
  return away <= std::fabs(std::nextafter(found, kInfinity) - exact) &&
         away <= std::fabs(std::nextafter(found, -kInfinity) - exact);
}

}  // namespace

TEST_CASE("the kind of a float is that of its bits") {
  const float finite[] = {
      0.f, -0.f, 1.f, -1.f, std::numeric_limits<float>::max(), std::numeric_limits<float>::denorm_min()};
  for (float value : finite) CHECK(kindOf(&value) == FloatKind::Finite);
  const float infinite[] = {kInfinity, -kInfinity};
  for (float value : infinite) CHECK(kindOf(&value) == FloatKind::Infinite);
  const uint32_t notNumbers[] = {0x7FC00000, 0xFFC00000, 0x7F800001, 0xFFFFFFFF};
  for (uint32_t bits : notNumbers) CHECK(kindOf(&bits) == FloatKind::NotANumber);
}

TEST_CASE("the kind of a float may be asked for at any address") {
  uint8_t bytes[8];
  for (int offset = 0; offset < 4; ++offset) {
    memcpy(bytes + offset, &kInfinity, 4);
    CHECK(kindOf(bytes + offset) == FloatKind::Infinite);
  }
}

TEST_CASE("each whole number from 0 to 65535 is one, and what lies between is not") {
  for (uint32_t number = 0; number <= 65535; ++number) {
    const float value = static_cast<float>(number), between = value + 0.5f;
    REQUIRE(wholeNumber(&value) == static_cast<int32_t>(number));
    REQUIRE(wholeNumber(&between) == -1);
  }
}

TEST_CASE("what is negative, too large, no number or just beside a whole number is none") {
  const float minusZero = -0.f;
  CHECK(wholeNumber(&minusZero) == 0);
  for (float value : {-1.f, -0.5f, 65536.f, 65535.99f, 1e9f, 1e38f, kInfinity, -kInfinity, kNaN, 0.25f, 1e-30f,
                      std::nextafter(1.f, 2.f), std::nextafter(1.f, 0.f), std::nextafter(32768.f, 0.f)}) {
    CAPTURE(value);
    CHECK(wholeNumber(&value) == -1);
  }
}

TEST_CASE("one more and one less than each whole number") {
  for (uint32_t number = 0; number <= 65535; ++number) {
    REQUIRE(oneMore(static_cast<float>(number)) == static_cast<float>(number + 1));
    REQUIRE(oneLess(static_cast<float>(number)) == static_cast<float>(number == 0 ? 0 : number - 1));
    REQUIRE(floatOf(static_cast<uint16_t>(number)) == static_cast<float>(number));
    float set = -0.f;
    if (number != 0) setWhole(&set, static_cast<uint16_t>(number));
    REQUIRE(set == static_cast<float>(number));
  }
}

TEST_CASE("one less than what is no whole number, or too large a one, is that number") {
  for (float value : {-1.f, 0.5f, 65536.f, 1e9f}) CHECK(oneLess(value) == value);
}

TEST_CASE("a coordinate as a float is the nearest float there is") {
  for (int32_t value : {0, 1, -1, 9999999, 10000000, 10000001, -353632621, 1491652374, 1800000000, -1800000000,
                        900000000, 2147483647, -2147483647 - 1}) {
    CAPTURE(value);
    CHECK(isNearest(quotient(value, 10000000), value, 10000000));
    CHECK(isNearest(quotient(value, 1), value, 1));
  }
  for (int i = 0; i < 300000; ++i) {
    const int32_t value = static_cast<int32_t>(random32() >> (i % 32)) * (i % 2 ? 1 : -1);
    REQUIRE_MESSAGE(isNearest(quotient(value, 10000000), value, 10000000), value);
    REQUIRE_MESSAGE(isNearest(quotient(value, 1), value, 1), value);
  }
}

TEST_CASE("a quotient is the nearest float, or one of two equally near") {
  // Ties: halves of the last bit, with a divisor that is a power of two.
  for (uint32_t shift = 0; shift <= 28; ++shift) {
    for (int32_t value :
         {0x1000001, 0x1000002, 0x1000003, 0x2000002, 0x2000006, 0x7FFFFF40, 0x7FFFFFC0, 0x1FFFFFF, 0x3FFFFFE}) {
      CAPTURE(shift);
      CAPTURE(value);
      const uint32_t divisor = 1u << shift;
      CHECK(isNearest(quotient(value, divisor), value, divisor));
      CHECK(isNearest(quotient(-value, divisor), -value, divisor));
    }
  }
}

TEST_CASE("the whole part of a number is without what is after the point") {
  for (int i = 0; i < 100000; ++i) {
    const float value = fromBits(random32());
    if (kindOf(&value) != FloatKind::Finite) continue;
    float whole = value;
    makeWhole(&whole);
    REQUIRE(whole == std::trunc(value));
  }
}

TEST_CASE("a float times a whole number is the nearest whole number to it") {
  for (int i = 0; i < 100000; ++i) {
    const float degrees = static_cast<float>(static_cast<int32_t>(random32() % 3600000001u - 1800000000) * 1e-7);
    const int32_t bits = static_cast<int32_t>(bitsOf(degrees));
    const double product = static_cast<double>(degrees) * 1e7;
    if (std::fabs(product) >= 2147483647.0) continue;
    REQUIRE_MESSAGE(timesWhole(bits, 10000000) == static_cast<int32_t>(std::lround(product)), degrees);
  }
}

TEST_CASE("a float times any factor is the nearest whole number, or 0 where that does not fit") {
  const auto check = [](float value, uint32_t factor) {
    const double product = std::fabs(static_cast<double>(value)) * factor;
    const double nearest = std::floor(product + 0.5);
    const int32_t expected = nearest > 2147483647.0 ? 0 : static_cast<int32_t>(std::copysign(nearest, value));
    REQUIRE_MESSAGE(timesWhole(static_cast<int32_t>(bitsOf(value)), factor) == expected, value << " times " << factor);
  };
  for (uint32_t factor : {1u, 2u, 3u, 100u, 255u, 1000u, 65536u, 10000000u, 0xFFFFFFu, 0x1000000u}) {
    for (uint32_t exponent = 1; exponent < 255; ++exponent) {
      for (uint32_t mantissa : {0u, 1u, 0x400000u, 0x7FFFFFu, 0x7FFFFEu, static_cast<uint32_t>(random32()) >> 9}) {
        check(fromBits(exponent << 23 | mantissa), factor);
        check(fromBits(0x80000000u | exponent << 23 | mantissa), factor);
      }
    }
    for (double limit : {2147483647.0, 2147483647.5, 2147483648.0, 4294967296.0}) {
      const float near = static_cast<float>(limit / factor);
      for (float value : {std::nextafter(near, 0.f), near, std::nextafter(near, kInfinity)}) check(value, factor);
    }
  }
}

TEST_CASE("a product is that of floats, to the last bit") {
  const float pi = 3.14159265358979f;
  const struct {
    Times times;
    float factor;
  } kAll[] = {{Times::Hundred, 100.f},
              {Times::Hundredth, 0.01f},
              {Times::Radian, pi / 180},
              {Times::Degree, 180 / pi},
              {Times::T256, 256.f}};
  for (const auto& one : kAll) {
    for (int i = 0; i < 100000; ++i) {
      const float value = fromBits(random32());
      if (kindOf(&value) != FloatKind::Finite || std::fabs(value) > 1e30f || std::fabs(value) < 1e-30f) continue;
      float product = value;
      multiply(&product, one.times);
      REQUIRE_MESSAGE(bitsOf(product) == bitsOf(value * one.factor), value << " times " << one.factor);
    }
    float zero = 0.f;
    multiply(&zero, one.times);
    CHECK(zero == 0.f);
  }
}

TEST_CASE("what is left of hundredths is what floats leave") {
  for (int i = 0; i < 300000; ++i) {
    const float value = static_cast<float>(static_cast<int32_t>(random32()) % 8300000) / (i % 3 == 0 ? 100.f : 1000.f);
    float kept = value;
    makeHundredths(&kept);
    REQUIRE_MESSAGE(kept == static_cast<float>(static_cast<int32_t>(value * 100.0f)) * 0.01f, value);
  }
}

TEST_CASE("a heading through radians is what floats make of it") {
  const float pi = 3.14159265358979f, turn = 2 * pi, radian = pi / 180, degree = 180 / pi;
  for (int i = 0; i < 300000; ++i) {
    const float heading = static_cast<float>(random32() % 540000001u) / 1e6f - 180.f;
    float radians = heading * radian;
    if (radians < 0) radians = radians + turn;
    if (radians >= turn) radians = radians - turn;
    float kept = heading;
    makeTurn(&kept);
    REQUIRE_MESSAGE(bitsOf(kept) == bitsOf(radians * degree), heading);
  }
  for (const float heading : {0.f, 360.f}) {
    float kept = heading;
    makeTurn(&kept);
    CHECK(kept == 0.f);
  }
}
