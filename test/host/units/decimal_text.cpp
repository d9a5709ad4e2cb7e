#include "mavmission/text/DecimalText.h"

#include <doctest/doctest.h>
#include <string.h>

#include <limits>
#include <string>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

std::string printed(float value) {
  char text[kFloatText + 1];
  memset(text, '#', sizeof(text));
  printFloat(value, text);
  CHECK(text[kFloatText] == '#');
  CHECK(strlen(text) < kFloatText);
  return text;
}

float parsed(const std::string& text) {
  DecimalText decimal;
  for (char c : text) decimal.take(c);
  float value = -12345;
  CHECK(decimal.toFloat(value));
  return value;
}

float fromBits(uint32_t bits) {
  float value;
  memcpy(&value, &bits, sizeof(value));
  return value;
}

std::string degrees(int32_t e7) {
  char text[kDegreesText];
  printDegrees(e7, text);
  return text;
}

}  // namespace

TEST_CASE("a float is printed as a person would write it") {
  CHECK(printed(0) == "0");
  CHECK(printed(-0.f) == "-0");
  CHECK(printed(20) == "20");
  CHECK(printed(-20.5f) == "-20.5");
  CHECK(printed(0.1f) == "0.1");
  CHECK(printed(0.001f) == "0.001");
  CHECK(printed(0.0001f) == "0.0001");
  CHECK(printed(149.165237f) == "149.16524");
  CHECK(printed(16777216) == "16777216");
  CHECK(printed(65535) == "65535");
  CHECK(printed(1e9f) == "1000000000");
  CHECK(printed(584.1f) == "584.1");
  CHECK(printed(1e20f) == "1e20");
  CHECK(printed(-1.5e-10f) == "-15e-11");
  CHECK(printed(std::numeric_limits<float>::quiet_NaN()) == "nan");
  CHECK(printed(std::numeric_limits<float>::infinity()) == "inf");
  CHECK(printed(-std::numeric_limits<float>::infinity()) == "-inf");
}

TEST_CASE("a printed float is read as the same float, whatever it is") {
  uint32_t seed = 3;
  for (int i = 0; i < 20000; ++i) {
    seed = seed * 1664525 + 1013904223;
    const uint32_t bits = seed ^ seed << 15;
    if ((bits & 0x7F800000) == 0x7F800000) continue;
    const float value = fromBits(bits);
    const float again = parsed(printed(value));
    CHECK(memcmp(&again, &value, sizeof(value)) == 0);
  }
  const uint32_t edges[] = {1, 2, 0x007FFFFF, 0x00800000, 0x7F7FFFFF, 0x3F7FFFFF, 0x3F800001, 0x4B800001, 0x80000001};
  for (uint32_t bits : edges) {
    const float value = fromBits(bits);
    const float again = parsed(printed(value));
    CHECK(memcmp(&again, &value, sizeof(value)) == 0);
  }
}

TEST_CASE("a coordinate is printed with all its digits") {
  CHECK(degrees(0) == "0.0000000");
  CHECK(degrees(-5) == "-0.0000005");
  CHECK(degrees(-353632621) == "-35.3632621");
  CHECK(degrees(1800000000) == "180.0000000");
  CHECK(degrees(std::numeric_limits<int32_t>::min()) == "-214.7483648");
}
