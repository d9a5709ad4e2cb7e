#include "../LatLon.h"

namespace mavmission {
namespace {

// Fractions are in units of 2^-30.
constexpr uint8_t kBits = 30;
constexpr int64_t kOne = int64_t{1} << kBits;

// A degree of longitude at 89 degrees [mm]: nearer to a pole there is no east to speak of, and no division by 0.
constexpr int64_t kShortest = 1949000;

int64_t times(int64_t a, int64_t b) { return (a * b) >> kBits; }

// Of an angle of up to 90 degrees [1e-7 deg], by the first terms of its series; off by 1e-7 at 80 degrees.
int64_t cosine(int32_t e7) {
  const int64_t radians = e7 * int64_t{187403301} / 100000000;  // pi / 180 / 1e7 is 1.87403301 * 2^-30
  const int64_t square = times(radians, radians);
  int64_t sum = kOne;
  for (uint8_t n = 10; n != 0; n -= 2) sum = kOne - times(square, sum) / (n * (n - 1));
  return sum;
}

int32_t rounded(int64_t dividend, int64_t divisor) {
  const int64_t half = dividend < 0 ? -divisor / 2 : divisor / 2;
  return static_cast<int32_t>((dividend + half) / divisor);
}

}  // namespace

// What a degree is long is a series of cosines of multiples of the latitude (the usual one for WGS 84), written by
// powers of the cosine [mm].
LatLon moved(const LatLon& from, int32_t northCm, int32_t eastCm) {
  const int64_t c = cosine(from.latitude.e7());
  const int64_t c2 = times(c, c);
  const int64_t c4 = times(c2, c2);
  const int64_t north = 111132954 - times(559822, 2 * c2 - kOne) + times(1175, 8 * c4 - 8 * c2 + kOne);
  int64_t east = times(c, 111412840 - times(93500, 4 * c2 - 3 * kOne) + times(118, 16 * c4 - 20 * c2 + 5 * kOne));
  if (east < kShortest) east = kShortest;
  const int64_t kStepsPerCm = 100000000;  // 1e7 in a degree, 10 mm in a centimetre
  return LatLon{from.latitude + Degrees::fromE7(rounded(northCm * kStepsPerCm, north)),
                from.longitude + Degrees::fromE7(rounded(eastCm * kStepsPerCm, east))};
}

}  // namespace mavmission
