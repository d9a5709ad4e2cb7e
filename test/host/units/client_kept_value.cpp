// keptValue() by a whole client: of the item that was refused since the autopilot would not keep one of its values.
#include <doctest/doctest.h>

#include <cmath>

#include "Conversation.h"

using namespace mavmission;

namespace {

// ArduPilot keeps whole seconds of a wait.
const MissionItem kPlan[] = {takeoff(20_m), waypoint(-35_deg, 149_deg, 20_m),
                             anyCommandAt(kNavWaypoint, -35_deg, 149_deg, 20_m, 2.5f)};

struct Keeping : Conversation {
  Keeping() : Conversation(kArduPilot, kPlan) {}
  bool isNothingKept() { return std::isnan(client.keptValue()); }
};

}  // namespace

TEST_CASE("what an autopilot would keep in the place of the refused value is read from the plan again") {
  Keeping desk;
  CHECK(desk.isNothingKept());
  desk.plays("upload");
  CHECK(desk.isNothingKept());
  CHECK(desk.plays("50 ms") == "-> NotKept at 2 in Param1 (NotKnown)");
  CHECK(desk.client.keptValue() == 2);
  CHECK(desk.client.keptValue() == 2);
}

TEST_CASE("after another status, with another plan aboard, or without a source, no value is known") {
  const MissionItem bad[] = {kPlan[1], anyCommandAt(kNavWaypoint, 91_deg, 0_deg, 20_m, 2.5f)};
  Keeping desk;
  CHECK(desk.isAbout(inRam(bad)).plays("upload, 50 ms") == "-> BadLatitude at 1 (NotKnown)");
  CHECK(desk.isNothingKept());

  const MissionItem plan[] = {anyCommandAt(kNavWaypoint, -35_deg, 149_deg, 20_m, 3)};
  desk.isAbout(inRam(plan)).held[1].param1 = 4;
  CHECK(desk.plays("verify, until LIST, count, items") ==
        "LIST, REQUEST 0-1, -> Differs at 0 in Param1 (NotKnown), ACK cancelled");
  CHECK(desk.isNothingKept());

  Keeping late;
  static bool isThere;
  isThere = true;
  const auto read = [](void*, uint16_t index, MissionItem& item) {
    item = kPlan[index];
    return isThere;
  };
  CHECK(late.isAbout(fromFunction(read, 3)).plays("upload, 50 ms") == "-> NotKept at 2 in Param1 (NotKnown)");
  CHECK(late.client.keptValue() == 2);
  isThere = false;
  CHECK(late.isNothingKept());
}
