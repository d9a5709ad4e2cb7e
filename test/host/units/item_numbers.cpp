// The numbers of items, the sketch's and those on the wire, with and without home.
#include "mavmission/plan/ItemNumbers.h"

#include <doctest/doctest.h>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

ItemNumbers numbers(Firmware firmware, bool raw = false, PlanType type = PlanType::Mission) {
  ItemNumbers made;
  made.begin(firmware, type, raw);
  return made;
}

}  // namespace

TEST_CASE("ArduPilot's home is on the wire before the sketch's items") {
  const ItemNumbers made = numbers(Firmware::ArduPilot);
  CHECK(made.before() == 1);
  CHECK(made.home() == 1);
  CHECK(made.isHome(0));
  CHECK_FALSE(made.isHome(1));
  CHECK_FALSE(made.isOwnHome(0));
  CHECK(made.toWire(0) == 1);
  CHECK(made.toWire(41) == 42);
  CHECK(made.toOwn(0) == 0xFFFF);
  CHECK(made.toOwn(42) == 41);
  CHECK(made.toldTotal(5) == 5);
}

TEST_CASE("in raw numbering the sketch counts home, and MISSION_CURRENT.total does not") {
  const ItemNumbers made = numbers(Firmware::ArduPilot, true);
  CHECK(made.before() == 0);
  CHECK(made.home() == 1);
  CHECK(made.isHome(0));
  CHECK_FALSE(made.isHome(1));
  CHECK(made.isOwnHome(0));
  CHECK_FALSE(made.isOwnHome(1));
  CHECK(made.toWire(7) == 7);
  CHECK(made.toOwn(7) == 7);
  CHECK(made.wireCount(1) == 1);
  CHECK(made.toldTotal(5) == 4);
  CHECK(made.toldTotal(0) == 0);
}

TEST_CASE("PX4, fences and rally points have no home") {
  const ItemNumbers without[] = {numbers(Firmware::Px4), numbers(Firmware::Px4, true),
                                 numbers(Firmware::ArduPilot, false, PlanType::Fence),
                                 numbers(Firmware::ArduPilot, true, PlanType::Rally)};
  for (const ItemNumbers& made : without) {
    CHECK(made.before() == 0);
    CHECK(made.home() == 0);
    CHECK_FALSE(made.isHome(0));
    CHECK_FALSE(made.isOwnHome(0));
    CHECK(made.toWire(3) == 3);
    CHECK(made.toOwn(0) == 0);
    CHECK(made.wireCount(3) == 3);
    CHECK(made.ownCount(3) == 3);
    CHECK(made.toldTotal(3) == 3);
    CHECK(made.isCountOf(0, 0));
    CHECK_FALSE(made.isCountOf(0, 1));
  }
}

TEST_CASE("home is not added to an empty plan, and an autopilot without a plan counts 0 or its home") {
  const ItemNumbers made = numbers(Firmware::ArduPilot);
  CHECK(made.wireCount(0) == 0);
  CHECK(made.wireCount(1) == 2);
  CHECK(made.ownCount(0) == 0);
  CHECK(made.ownCount(1) == 0);
  CHECK(made.ownCount(2) == 1);
  CHECK(made.isCountOf(0, 0));
  CHECK(made.isCountOf(0, 1));
  CHECK_FALSE(made.isCountOf(0, 2));
  CHECK(made.isCountOf(1, 2));
  CHECK_FALSE(made.isCountOf(1, 0));
  CHECK_FALSE(made.isCountOf(1, 1));
}

TEST_CASE("no flight begins with home") {
  CHECK(ItemNumbers::firstFlown(0, Firmware::ArduPilot) == 1);
  CHECK(ItemNumbers::firstFlown(2, Firmware::ArduPilot) == 2);
  CHECK(ItemNumbers::firstFlown(0, Firmware::Px4) == 0);
}
