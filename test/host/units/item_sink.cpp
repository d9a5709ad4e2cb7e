#include <doctest/doctest.h>

#include "mavmission/plan/ItemSink.h"

using namespace mavmission;

TEST_CASE("an array takes each item in its place, as many as it has room for, and home in none") {
  MissionItem plan[2] = {land(), land()};
  const ItemSink sink = toRam(plan);
  CHECK(sink.limit == 2);
  CHECK(sink.write(sink.context, 1, takeoff(20_m)));
  CHECK(plan[1].command == kNavTakeoff);
  CHECK(sink.write(sink.context, kHomeIndex, returnToLaunch()));
  CHECK(plan[0].command == kNavLand);
  CHECK(plan[1].command == kNavTakeoff);
}
