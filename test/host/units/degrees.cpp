#include "mavmission/item/Degrees.h"

#include <doctest/doctest.h>

#include "mavmission/item/MissionItem.h"

using namespace mavmission;

namespace {
// Known to the compiler, or this does not compile.
static_assert((-35.3632621_deg).e7() == -353632621, "every digit");
static_assert((149.1652374_deg).e7() == 1491652374, "every digit");
static_assert((0.0000001_deg).e7() == 1, "the smallest step");
static_assert((180_deg).e7() == 1800000000, "the largest angle");
static_assert((-180.0000000_deg).e7() == -1800000000, "the largest angle, west");
static_assert((35.363200000000_deg).e7() == 353632000, "zeros after the seventh decimal change nothing");
static_assert((0_deg).e7() == 0, "nothing");
static_assert((0.5_deg).e7() == 5000000, "a 0 before the point");
static_assert((.5_deg).e7() == 5000000, "no digit before the point");
static_assert((7._deg).e7() == 70000000, "no digit after the point");
}  // namespace

TEST_CASE("a literal is exact where a float is not") {
  CHECK(static_cast<double>(179.9999999f) * 1e7 == 1800000000.0);
  CHECK((149.1652374_deg).e7() == 1491652374);
  CHECK((179.9999999_deg).e7() == 1799999999);
  CHECK((89.9999999_deg).e7() == 899999999);
  CHECK((1.2345678_deg).e7() == 12345678);
}

TEST_CASE("angles are added, subtracted, turned round and multiplied exactly") {
  CHECK((1.0000001_deg + 2.0000002_deg).e7() == 30000003);
  CHECK((1.0000001_deg - 2.0000002_deg).e7() == -10000001);
  CHECK((-(1.0000001_deg)).e7() == -10000001);
  CHECK((0.0000003_deg * -7).e7() == -21);
  CHECK(1_deg == Degrees::fromE7(10000000));
  CHECK(1_deg != Degrees::fromE7(10000001));
  CHECK(Degrees() == 0_deg);
}

TEST_CASE("lengths, times and speeds are what was written") {
  CHECK((20_m).value == 20.f);
  CHECK((20.25_m).value == 20.25f);
  CHECK((-(2_m)).value == -2.f);
  CHECK((90_s).value == 90.f);
  CHECK((1.5_s).value == 1.5f);
  CHECK((5_mps).value == 5.f);
  CHECK((0.25_mps).value == 0.25f);
}

TEST_CASE("a heading is in degrees, and one that is not given is NaN") {
  CHECK(Yaw(90_deg).inDegrees() == 90.f);
  CHECK(Yaw(-90.5_deg).inDegrees() == -90.5f);
  CHECK(Yaw(270_deg).inDegrees() == 270.f);
  CHECK(Yaw(359.9_deg).inDegrees() == 359.9f);
  CHECK(Yaw(360_deg).inDegrees() == 360.f);
  CHECK(turnTo(270_deg).param1 == 270.f);
  CHECK(Yaw().inDegrees() != Yaw().inDegrees());
}

TEST_CASE("an altitude says what it is measured from") {
  CHECK(Altitude(20_m).frame() == CoordinateFrame::GlobalRelative);
  CHECK(aboveHome(20_m).frame() == CoordinateFrame::GlobalRelative);
  CHECK(aboveSeaLevel(20_m).frame() == CoordinateFrame::Global);
  CHECK(aboveTerrain(20_m).frame() == CoordinateFrame::GlobalTerrain);
  CHECK(aboveTerrain(20.5_m).metres() == 20.5f);
}
