// The place so many metres north and east, beside the ellipsoid's radii, summed up in small steps.
#include "mavmission/item/LatLon.h"

#include <doctest/doctest.h>
#include <math.h>
#include <stdlib.h>

#include <initializer_list>

using namespace mavmission;

namespace {

constexpr double kRadius = 6378137, kFlattening = 1 / 298.257223563;
constexpr double kSquare = kFlattening * (2 - kFlattening);
constexpr double kDegree = 3.14159265358979323846 / 180;

double meridianRadius(double latitude) {
  const double sine = sin(latitude * kDegree);
  return kRadius * (1 - kSquare) / pow(1 - kSquare * sine * sine, 1.5);
}
double parallelRadius(double latitude) {
  const double sine = sin(latitude * kDegree);
  return kRadius * cos(latitude * kDegree) / sqrt(1 - kSquare * sine * sine);
}

// [cm]
double northOf(double from, double to) {
  double sum = 0;
  for (int i = 0; i < 100; ++i) sum += meridianRadius(from + (to - from) * (i + 0.5) / 100);
  return sum * (to - from) * kDegree;
}
double eastOf(double latitude, double by) { return parallelRadius(latitude) * by * kDegree * 100; }

}  // namespace

TEST_CASE("a place is moved to within 1 cm and 0.01 % of the way") {
  for (int degree = -80; degree <= 80; ++degree) {
    for (int32_t cm : {0, 1, -1, 50, 1000, -10000, 123456, -500000, 1000000, -1000000}) {
      CAPTURE(degree);
      CAPTURE(cm);
      const LatLon from = {Degrees::fromE7(degree * 10000000), Degrees::fromE7(81234567)};
      const LatLon to = moved(from, cm, -cm);
      const double allowed = 1 + 1e-4 * fabs(cm);
      CHECK(fabs(northOf(degree, to.latitude.e7() / 1e7) - cm) < allowed);
      CHECK(fabs(eastOf(degree, (to.longitude.e7() - 81234567) / 1e7) + cm) < allowed);
      CHECK(fabs(distanceCm(from, to) - sqrt(2.0) * fabs(cm)) < 1 + allowed);
    }
  }
}

TEST_CASE("there and back is the same place, and at a pole nothing breaks") {
  const LatLon from = {-35.3632621_deg, 149.1652374_deg};
  const LatLon there = moved(from, 0, 12345);
  const LatLon back = moved(there, 0, -12345);
  CHECK(back.latitude == from.latitude);
  CHECK(back.longitude == from.longitude);
  const LatLon pole = {90_deg, 0_deg};
  CHECK(moved(pole, 0, 10000).latitude == 90_deg);
  CHECK(moved(pole, -100, 0).latitude != 90_deg);
}

TEST_CASE("a distance is the shorter way around, and ends at half of the earth") {
  const LatLon east = {-35_deg, 179.9999_deg}, west = {-35_deg, -179.9999_deg};
  CHECK(distanceCm(east, west) == distanceCm(west, east));
  CHECK(fabs(distanceCm(east, west) - eastOf(-35, 0.0002)) < 1);
  CHECK(distanceCm(east, east) == 0);
  CHECK(distanceCm({-90_deg, 0_deg}, {90_deg, 180_deg}) == 2000000000);
  CHECK(distanceCm({0_deg, 0_deg}, {0_deg, 90_deg}) == 1001875122);  // a quarter of the equator
}

TEST_CASE("a place that is nowhere on the earth is as far away as the pole, and nothing breaks where it is moved") {
  for (const int32_t e7 : {INT32_MIN, INT32_MAX}) {
    const LatLon nowhere = {Degrees::fromE7(e7), Degrees::fromE7(e7)};
    const LatLon pole = {e7 < 0 ? -90_deg : 90_deg, nowhere.longitude}, equator = {0_deg, nowhere.longitude};
    CHECK(distanceCm(nowhere, pole) == 0);
    CHECK(distanceCm(nowhere, equator) == distanceCm(pole, equator));
    CHECK(distanceCm(equator, nowhere) == distanceCm(equator, pole));
    for (const int32_t cm : {-100, 100}) CHECK(labs(moved(nowhere, cm, cm).latitude.e7()) > 2147483000);
  }
}
