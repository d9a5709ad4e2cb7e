// keptValue() by a whole client: of the item that was refused since the autopilot would not keep one of its values.
#include <doctest/doctest.h>

#include <cmath>

#include "ClientOnLine.h"
#include "PlanFrames.h"

using namespace mavmission;

namespace {

constexpr LatLon kPlace = {-35.3632621_deg, 149.1652374_deg};

// ArduPilot keeps whole seconds of a wait, and no more than 255 turns.
const MissionItem kPlan[] = {takeoff(20_m), waypoint(kPlace.latitude, kPlace.longitude, 20_m),
                             anyCommandAt(kNavWaypoint, kPlace.latitude, kPlace.longitude, 20_m, 2.5f)};

bool isNothing(float value) { return std::isnan(value); }

}  // namespace

TEST_CASE("what an autopilot would keep in the place of the refused value is read from the plan again") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(3000);
  CHECK(isNothing(desk.client.keptValue()));
  desk.client.upload(inRam(kPlan));
  CHECK(isNothing(desk.client.keptValue()));
  desk.run(50);
  REQUIRE((desk.ended == Status::NotKept));
  CHECK(desk.client.failedItem() == 2);
  CHECK((desk.client.differingField() == ItemField::Param1));
  CHECK(desk.client.keptValue() == 2);
  CHECK(desk.client.keptValue() == 2);
}

TEST_CASE("after another status, or without an item, no value is known") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(3000);
  const MissionItem bad[] = {waypoint(-35_deg, 149_deg, 20_m), anyCommandAt(kNavWaypoint, 91_deg, 0_deg, 20_m, 2.5f)};
  desk.client.upload(inRam(bad));
  desk.run(50);
  REQUIRE((desk.ended != Status::NotKept));
  REQUIRE(desk.client.failedItem() == 1);
  CHECK(isNothing(desk.client.keptValue()));
}

TEST_CASE("a plan that is another one aboard has no kept value") {
  const MissionItem plan[] = {anyCommandAt(kNavWaypoint, kPlace.latitude, kPlace.longitude, 20_m, 3)};
  MissionItem aboard = plan[0];
  aboard.param1 = 4;
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(3000);
  desk.client.verify(inRam(plan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  for (const FrameParts& parts : {countParts(2), itemParts(0, homeItem()), itemParts(1, aboard)}) {
    desk.hear(parts);
    desk.run(5);
  }
  REQUIRE((desk.ended == Status::Differs));
  REQUIRE((desk.client.differingField() == ItemField::Param1));
  CHECK(desk.client.failedItem() == 0);
  CHECK(isNothing(desk.client.keptValue()));
}

TEST_CASE("a source that can no longer be read has no kept value") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(3000);
  static bool isThere;
  isThere = true;
  const ItemSource source = fromFunction(
      [](void*, uint16_t index, MissionItem& item) {
        item = kPlan[index];
        return isThere;
      },
      3);
  desk.client.upload(source);
  desk.run(50);
  REQUIRE((desk.ended == Status::NotKept));
  CHECK(desk.client.keptValue() == 2);
  isThere = false;
  CHECK(isNothing(desk.client.keptValue()));
}
