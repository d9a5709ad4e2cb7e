#include "mavmission/text/DecimalText.h"

#include <doctest/doctest.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <initializer_list>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

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

DecimalText taken(const std::string& text) {
  // In memory that held something else before.
  DecimalText decimal;
  memset(static_cast<void*>(&decimal), 0xFF, sizeof(decimal));
  decimal.begin();
  for (char c : text) decimal.take(c);
  return decimal;
}

// Those between blanks.
std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), std::istream_iterator<std::string>()};
}

// The compiler's own library is exact.
bool isNearest(const std::string& text) {
  const float expected = strtof(text.c_str(), nullptr);
  float value = -12345;
  const DecimalText decimal = taken(text);
  if (!decimal.toFloat(value)) return expected - expected != 0;  // infinity
  return memcmp(&value, &expected, sizeof(value)) == 0;
}

// "none" if it has no such steps; "~" before those that are rounded.
std::string stepsOf(const std::string& text, uint8_t decimals) {
  uint32_t magnitude = 0xA5A5A5A5;
  bool isExact = false;
  if (!taken(text).toSteps(decimals, magnitude, isExact)) return "none";
  char digits[kWholeText];
  printWhole(magnitude, digits);
  return (isExact ? "" : "~") + std::string(digits);
}

// The same of each text.
std::string steps(const std::string& texts, uint8_t decimals) {
  std::string all;
  for (const std::string& text : wordsOf(texts)) all += (all.empty() ? "" : " ") + stepsOf(text, decimals);
  return all;
}

// Each of the numbers, printed.
template <typename Number>
std::string each(std::string (*print)(Number), std::initializer_list<Number> numbers) {
  std::string all;
  for (Number number : numbers) all += (all.empty() ? "" : " ") + print(number);
  return all;
}
std::string printed(std::initializer_list<float> values) { return each<float>(printed, values); }
std::string degrees(std::initializer_list<int32_t> angles) { return each<int32_t>(degrees, angles); }

// The text of a random number of `digits` digits with a point among them, or an exponent.
std::string randomNumber(uint32_t& seed, uint8_t digits, int exponent) {
  std::string text;
  for (uint8_t i = 0; i < digits; ++i) {
    seed = seed * 1664525 + 1013904223;
    text += static_cast<char>('0' + (seed >> 16) % 10);
  }
  return text + "e" + std::to_string(exponent);
}

}  // namespace

TEST_CASE("a float is printed as a person would write it") {
  CHECK(printed({0, -0.f, 20, -20.5f, 0.1f, 0.001f, 0.0001f}) == "0 -0 20 -20.5 0.1 0.001 0.0001");
  CHECK(printed({149.165237f, 16777216, 65535, 1e9f, 584.1f}) == "149.16524 16777216 65535 1000000000 584.1");
  CHECK(printed({1e20f, -1.5e-10f, std::numeric_limits<float>::quiet_NaN()}) == "1e20 -15e-11 nan");
  CHECK(printed({std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}) == "inf -inf");
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
  CHECK(degrees({0, -5, -353632621, 1800000000}) == "0.0000000 -0.0000005 -35.3632621 180.0000000");
  CHECK(degrees({std::numeric_limits<int32_t>::min()}) == "-214.7483648");
}

TEST_CASE("what is a number, what is a plain one, and what is none") {
  for (const char* text : {"0", "7", "-7", "+7", "007", "2147483648", "12345678901234567890123"}) {
    CHECK(taken(text).isNumber());
    CHECK(taken(text).isPlain());
    CHECK_FALSE(taken(text).isNan());
  }
  for (const char* text : {".5", "-.5", "+.5", "5.", "0.5", "1e5", "1E5", "1e-5", "1e+05", "1.5e5", "5.e1"}) {
    CHECK(taken(text).isNumber());
    CHECK_FALSE(taken(text).isPlain());
    CHECK_FALSE(taken(text).isNan());
  }
  for (const char* text : {"nan", "NaN", "NAN", "-nan", "+nan"}) {
    CHECK(taken(text).isNumber());
    CHECK_FALSE(taken(text).isPlain());
    CHECK(taken(text).isNan());
  }
  for (const char* text :
       {"",     "+",     "-",    ".",    "-.",   "+-1",  "1-",  "1+1", "--1",  "1..",  "1.5.",  ".5.",  "e5",   "1e",
        "1e+",  "1e--5", "1e5.", "1e5-", "1e5e", ".e5",  "n",   "na",  "nan1", "nann", "nanan", "nn",   "naa",  "1n",
        "1.n",  "1en",   "an",   "a",    "inf",  "0x10", "1,5", "1/",  "1:",   "/",    ":",     "1.5/", "1.5:", "1e5/",
        "1e5:", "1.5e/", "1d5",  "1f5",  "m",    "o",    "nbn", "n n", ".n",   "-n1",  "1 ",    "*1",   ",1"}) {
    CAPTURE(text);
    CHECK_FALSE(taken(text).isNumber());
    float value = 5;
    CHECK_FALSE(taken(text).toFloat(value));
    CHECK(stepsOf(text, 0) == "none");
  }
  CHECK(taken("-1").isNegative());
  CHECK(taken("-0").isNegative());
  CHECK_FALSE(taken("+1").isNegative());
  CHECK_FALSE(taken("1").isNegative());
  CHECK_FALSE(taken("1e-5").isNegative());
}

TEST_CASE("a text is read as the nearest float, the even one of two that are equally near") {
  for (const std::string& text :
       wordsOf("0 -0 0.000 1 -1 10 0.1 .1 5. -35.3632621 149.16523740 16777217 16777219 "
               "16777216.9999999999999999999999 16777217.0000000000000000000001 33554433 8388608.5 8388609.5 "
               "0.00000000000000000000000000001 3.4028234e38 3.40282346638528859811704183484516925440e38 "
               "340282346638528859811704183484516925440 1.401298464324817e-45 7.0064923216240853e-46 "
               "7.0064923216240854e-46 7.006492321624085e-46 7.0064923216240862e-46 1e-45 2e-45 1e-46 1.17549435e-38 "
               "1.1754943e-38 1.1754942e-38 1.1754944e-38 5.877471754111438e-39 1e38 1e-38 1e10 1e-10 "
               "123456789012345678901234567890 0.000000123456789012345678901234567890 9999999999999999999e19 "
               "9999999999999999999e-64 1e-64 1e-65 9e-63 10000000000000000000e-64 0e99 0.0e-99 "
               "1000000000000000000000000e-24 1.0000000000000000000000000e0 1e+5 1E-5 1e005 100e-2 "
               "0.00000000000000000000000000000000000000000000001e47 1.25e1 -1.5e-10 1e-999 1e-1001 1e-99999 70e-46 "
               "0.000000000000000000000000000000000000000000000000000000001e10")) {
    CAPTURE(text);
    CHECK(isNearest(text));
  }
  float value = 5;
  for (const char* text : {"1e39", "3.5e38", "9e99", "1e999", "1e1001", "1e99999", "3.4028236e38", "-1e39", "1e65536",
                           "3402823567797336617e20", "1e38000", "100e37", "12345678901234567890123e17"}) {
    CAPTURE(text);
    CHECK_FALSE(taken(text).toFloat(value));
  }
  CHECK(taken("nan").toFloat(value));
  CHECK(value != value);
  uint32_t seed = 5;
  for (int exponent = -64; exponent <= 38; ++exponent) {
    for (uint8_t digits = 1; digits <= 26; ++digits) {
      const std::string text = randomNumber(seed, digits, exponent - digits / 2);
      CAPTURE(text);
      CHECK(isNearest(text));
    }
  }
}

TEST_CASE("a number exactly between two floats goes to the even one, and to the nearer one by any further digit") {
  uint32_t seed = 9;
  for (int i = 0; i < 300; ++i) {
    seed = seed * 1664525 + 1013904223;
    // 24 bits, and a 25th that is 1; exact with at most 19 digits.
    const uint64_t odd = (0x1000000u | seed >> 8) * 2ull + 1;
    char text[64];
    for (const char* form : {"%llu", "%llu.00000000000000000000", "%llu.00000000000000000000000001", "%llu.5"}) {
      snprintf(text, sizeof(text), form, static_cast<unsigned long long>(odd << i % 20));
      CAPTURE(text);
      CHECK(isNearest(text));
    }
    // The same among fractions, where what is divided away is the further digit.
    snprintf(text, sizeof(text), "%.30g", static_cast<double>(odd) / static_cast<double>(1ull << i % 34));
    CAPTURE(text);
    CHECK(isNearest(text));
  }
}

TEST_CASE("a number is given in whole steps, to the nearest, half away from 0") {
  CHECK(steps("35.3632621 -35.3632621 149.16523740", 7) == "353632621 353632621 1491652374");
  CHECK(steps("149.165237400000000000000000000000 0.00000005", 7) == "1491652374 ~1");
  CHECK(steps("0.00000004999999999999999999999 0.0000000499999999999999999999999999 0.000000005", 7) == "~0 ~0 ~0");
  CHECK(steps("0.00000009 0.00000000000000000001", 7) == "~1 ~0");
  CHECK(steps("0.9 0.09 9.5 9.4 15 15.0 1.5e1 1500e-2 1501e-2 1510e-2", 0) == "~1 ~0 ~10 ~9 15 15 15 15 ~15 ~15");
  CHECK(steps("12345.00000000000000000001", 0) == "~12345");
  CHECK(steps("0 -0.000 0e99", 7) == "0 0 0");
  CHECK(steps("1e9 1e-999 0.0000000000000000000000000000000021e41", 0) == "1000000000 ~0 210000000");
  CHECK(steps("0.21474836465", 10) == "~2147483647");
}

TEST_CASE("steps beyond 2147483647 are none") {
  CHECK(steps("2147483647 2147483646.5 2147483647.4 2147483647.5", 0) == "2147483647 ~2147483647 ~2147483647 none");
  CHECK(steps("2147483648 4294967295.5 4294967296 4294967297 1099511627776", 0) == "none none none none none");
  CHECK(steps("214.7483647 214.7483648", 7) == "2147483647 none");
  CHECK(steps("1e10 1e11 1e999 1e1001 nan 12345678901234567890", 0) == "none none none none none none");
  CHECK(steps("99999999999999999999e-11", 0) == "~1000000000");
}

TEST_CASE("a float is printed with as few digits as read back the same, and neither more nor longer than it has room") {
  CHECK(printed({1e10f, 1234567936, 123456789012.f, 0.01f, 0.0012f}) == "1e10 1234568000 12345679e4 0.01 0.0012");
  CHECK(printed({0.00012f, 0.00001f, 0.000012f, 1.5f, 12.25f, 100}) == "0.00012 1e-5 12e-6 1.5 12.25 100");
  CHECK(printed({1e-45f, 3.4028235e38f, -1.1754944e-38f}) == "1e-45 34028235e31 -11754944e-45");
  CHECK(printed({9.999999e9f, 999999.94f}) == "9999999000 999999.94");
  // As few digits as will do, from six on.
  uint32_t seed = 21;
  for (int i = 0; i < 20000; ++i) {
    seed = seed * 1664525 + 1013904223;
    const uint32_t bits = seed ^ seed >> 13;
    if ((bits & 0x7F800000) == 0x7F800000 || (bits & 0x7FFFFFFF) == 0) continue;
    const float value = fromBits(bits);
    char text[32];
    size_t digits = 6;
    for (; digits < 9; ++digits) {
      snprintf(text, sizeof(text), "%.*e", static_cast<int>(digits - 1), static_cast<double>(value));
      if (strtof(text, nullptr) == value) break;
    }
    std::string significant;
    for (char c : printed(value).substr(0, printed(value).find('e'))) {
      if (c >= '0' && c <= '9') significant += c;
    }
    significant.erase(0, significant.find_first_not_of('0'));
    significant.erase(significant.find_last_not_of('0') + 1);
    CAPTURE(printed(value));
    CHECK(significant.size() <= digits);
    CHECK(strtof(printed(value).c_str(), nullptr) == value);
  }
}

TEST_CASE("a float that six digits give is printed with six, where floats are farther apart than seven digits") {
  for (int digits = 990353; digits < 1000000; digits += 7) {
    std::string text = std::to_string(digits);
    text.erase(text.find_last_not_of('0') + 1);
    const int zeros = 6 - static_cast<int>(text.size());
    CHECK(printed(parsed(std::to_string(digits) + "e22")) == text + "e" + std::to_string(22 + zeros));
  }
}

TEST_CASE("digits that are set are as those that are taken, whatever was taken before") {
  for (const char* before : {"", "-9.99e-9", "12345678901234567890123", "nan", "x", "700000"}) {
    DecimalText decimal = taken(before);
    float value = 0;
    decimal.set(4294967295, -2, true);
    CHECK(decimal.toFloat(value));
    CHECK(value == -42949672.95f);
    decimal.set(5, 1, false);
    CHECK(decimal.toFloat(value));
    CHECK(value == 50);
  }
}

TEST_CASE("a whole number is printed with all its digits and no more") {
  char text[kWholeText];
  for (uint32_t value : {0u, 1u, 9u, 10u, 11u, 99u, 100u, 999999999u, 1000000000u, 4294967295u}) {
    printWhole(value, text);
    CHECK(std::string(text) == std::to_string(value));
  }
  CHECK(degrees({5, 10000000, 9999999, -1}) == "0.0000005 1.0000000 0.9999999 -0.0000001");
}
