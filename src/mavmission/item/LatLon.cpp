#include "LatLon.h"

namespace mavmission {
namespace {

// Fractions are in units of 2^-30.
constexpr uint8_t kBits = 30;
constexpr int64_t kOne = int64_t{1} << kBits;
constexpr int64_t kHalfTurn = 1800000000;  // [1e-7 deg]
constexpr uint32_t kFarthestCm = 2000000000;

// The length of a degree of longitude at a latitude of 89 degrees [mm]. It is used nearer to a pole, too, where east
// has hardly a meaning, and keeps the divisor from becoming 0.
constexpr int64_t kShortest = 1949000;

int64_t times(int64_t a, int64_t b) { return (a * b) >> kBits; }

// The cosine of an angle of up to 90 degrees [1e-7 deg], by the first terms of its series; the error is 1e-7 at 80
// degrees.
int64_t cosine(int32_t e7) {
  const int64_t radians = e7 * int64_t{187403301} / 100000000;  // pi / 180 / 1e7 is 1.87403301 * 2^-30
  const int64_t square = times(radians, radians);
  int64_t sum = kOne;
  for (uint8_t n = 10; n != 0; n -= 2) sum = kOne - times(square, sum) / (int64_t{n} * (n - 1));
  return sum;
}

int32_t rounded(int64_t dividend, int64_t divisor) {
  const int64_t half = dividend < 0 ? -divisor / 2 : divisor / 2;
  return static_cast<int32_t>((dividend + half) / divisor);
}

// In 32 bits without a sign, which do not overflow: an autopilot, or a sketch, may say any number.
Degrees farther(Degrees from, int32_t steps) {
  return Degrees::fromE7(static_cast<int32_t>(static_cast<uint32_t>(from.e7()) + static_cast<uint32_t>(steps)));
}

int32_t latitudeOf(const LatLon& place) {
  constexpr int32_t kPole = 900000000;
  const int32_t e7 = place.latitude.e7();
  return e7 < -kPole ? -kPole : e7 > kPole ? kPole : e7;
}

// The length of a degree at a latitude [mm]: a series of cosines of multiples of the latitude (the usual series for WGS
// 84), written here in powers of the cosine.
struct Degree {
  int64_t north;
  int64_t east;

  explicit Degree(const LatLon& place) {
    const int64_t c = cosine(latitudeOf(place));
    const int64_t c2 = times(c, c);
    const int64_t c4 = times(c2, c2);
    north = 111132954 - times(559822, 2 * c2 - kOne) + times(1175, 8 * c4 - 8 * c2 + kOne);
    east = times(c, 111412840 - times(93500, 4 * c2 - 3 * kOne) + times(118, 16 * c4 - 20 * c2 + 5 * kOne));
    if (east < kShortest) east = kShortest;
  }
};

constexpr int64_t kStepsPerCm = 100000000;  // 1e7 in a degree, 10 mm in a centimetre

}  // namespace

LatLon moved(const LatLon& from, int32_t northCm, int32_t eastCm) {
  const Degree degree(from);
  return LatLon{farther(from.latitude, rounded(northCm * kStepsPerCm, degree.north)),
                farther(from.longitude, rounded(eastCm * kStepsPerCm, degree.east))};
}

uint32_t distanceCm(const LatLon& from, const LatLon& to) {
  const Degree degree(from);
  int64_t stepsEast = int64_t{to.longitude.e7()} - from.longitude.e7();
  if (stepsEast > kHalfTurn) stepsEast -= 2 * kHalfTurn;
  if (stepsEast < -kHalfTurn) stepsEast += 2 * kHalfTurn;
  const int64_t north = rounded((int64_t{latitudeOf(to)} - latitudeOf(from)) * degree.north, kStepsPerCm);
  const int64_t east = rounded(stepsEast * degree.east, kStepsPerCm);
  // The root, a bit at a time from above.
  const uint64_t square = static_cast<uint64_t>(north * north) + static_cast<uint64_t>(east * east);
  uint32_t root = 0;
  for (uint32_t bit = uint32_t{1} << 31; bit != 0; bit >>= 1) {
    const uint32_t next = root | bit;
    if (uint64_t{next} * next <= square) root = next;
  }
  if (square - uint64_t{root} * root > root) ++root;
  return root < kFarthestCm ? root : kFarthestCm;
}

}  // namespace mavmission
