#include "mavmission/transfer/ModeOrder.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include "mavmission/autopilot/FlightMode.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef ModeOrder::Sight Sight;

constexpr uint16_t kFrom = 4, kWanted = 3, kForeign = 5, kOther = 6;

ModeOrder order() {
  ModeOrder made = ModeOrder();
  made.begin(kFrom, kWanted);
  return made;
}

}  // namespace

TEST_CASE("the order goes from the mode of before to the wanted one") {
  ModeOrder made = order();
  CHECK(made.wanted() == kWanted);
  CHECK(made.isFrom(kFrom));
  CHECK_FALSE(made.isFrom(kWanted));
  CHECK_FALSE(made.isRestoring());
  CHECK((made.onHeartbeat(kFrom, false, false) == Sight::Before));
  CHECK((made.onHeartbeat(kFrom, true, true) == Sight::Before));
  CHECK((made.onHeartbeat(kWanted, true, true) == Sight::Wanted));
}

TEST_CASE("a foreign mode stays where no order can be under way any more") {
  ModeOrder made = order();
  CHECK((made.onHeartbeat(kForeign, false, true) == Sight::Foreign));
  CHECK((made.onHeartbeat(kForeign, true, false) == Sight::Foreign));
}

TEST_CASE("once the wanted mode was seen after the order, the mode of before is foreign") {
  ModeOrder made = order();
  CHECK((made.onHeartbeat(kWanted, false, false) == Sight::Wanted));  // before the order has left
  CHECK((made.onHeartbeat(kFrom, false, false) == Sight::Before));
  CHECK((made.onHeartbeat(kWanted, true, true) == Sight::Wanted));
  CHECK((made.onHeartbeat(kFrom, true, false) == Sight::Foreign));
}

TEST_CASE("an order that undoes a foreign mode is turned, and sets that mode again") {
  for (uint16_t foreign : {kForeign, kFrom}) {
    ModeOrder made = order();
    CHECK((made.onHeartbeat(kForeign, true, true) == Sight::Doubtful));
    CHECK_FALSE(made.isFrom(kFrom));  // it is foreign now, too
    CHECK((made.onHeartbeat(foreign, true, true) == Sight::Doubtful));
    CHECK_FALSE(made.isRestoring());
    CHECK((made.onHeartbeat(kWanted, true, true) == Sight::Undone));
    CHECK(made.isRestoring());
    CHECK(made.wanted() == foreign);
    CHECK(made.isFrom(kWanted));
    CHECK((made.onHeartbeat(kWanted, true, true) == Sight::Before));
    ModeOrder late = made;
    CHECK((made.onHeartbeat(foreign, true, true) == Sight::Doubtful));
    CHECK((made.onHeartbeat(foreign, true, true) == Sight::Wanted));
    CHECK((late.onHeartbeat(foreign, true, false) == Sight::Wanted));
  }
}

TEST_CASE("a repeat of what sets a mode again undoes another mode, which is set again, too") {
  ModeOrder made = order();
  CHECK((made.onHeartbeat(kForeign, true, true) == Sight::Doubtful));
  CHECK((made.onHeartbeat(kWanted, true, true) == Sight::Undone));
  CHECK((made.onHeartbeat(kForeign, true, true) == Sight::Doubtful));
  CHECK((made.onHeartbeat(kOther, true, true) == Sight::Doubtful));
  CHECK((made.onHeartbeat(kForeign, true, true) == Sight::Undone));
  CHECK(made.wanted() == kOther);
  CHECK((made.onHeartbeat(kOther, true, false) == Sight::Wanted));
}

TEST_CASE("a foreign mode that stays while the order may be under way stays in the end") {
  ModeOrder made = order();
  CHECK((made.onHeartbeat(kForeign, true, true) == Sight::Doubtful));
  CHECK((made.onHeartbeat(kOther, true, true) == Sight::Doubtful));
  CHECK((made.onHeartbeat(kOther, true, false) == Sight::Foreign));
}

TEST_CASE("an order that is turned goes back to the mode of before") {
  ModeOrder made = order();
  made.turn();
  CHECK(made.wanted() == kFrom);
  CHECK((made.onHeartbeat(kWanted, false, false) == Sight::Before));
}

TEST_CASE("where the modes are not known none is foreign") {
  ModeOrder made = ModeOrder();
  made.begin(kFrom, kNoMode);
  CHECK((made.onHeartbeat(kForeign, true, false) == Sight::Wanted));
}
