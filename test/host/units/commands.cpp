#include "mavmission/autopilot/Commands.h"

#include <doctest/doctest.h>

#include <initializer_list>
#include <map>
#include <set>
#include <string>

#include "RecordedItems.h"
#include "mavmission/autopilot/FlightCommand.h"
#include "mavmission/autopilot/Rules.h"
#include "mavmission/item/MissionItem.h"

using namespace mavmission;
using namespace mavmission::detail;

TEST_CASE("a command that is not in the table has a place or not as its frame says") {
  for (const uint16_t command : {0, 15, 3001, 65535}) CHECK(traitsOf(command) == kAsItsFrameSays);
  CHECK(traitsOf(19) == 0);
}

TEST_CASE("what moves, releases, takes a picture or restarts is sent once only, and nothing else is") {
  const std::set<uint16_t> once = {181, 182, 183, 184, 185, 187, 203, 208, 209, 211, 246, 2000, 30001, 42600};
  for (uint32_t id = 0; id < 65536; ++id) {
    CHECK(isOnceOnly(static_cast<uint16_t>(id)) == (once.count(static_cast<uint16_t>(id)) != 0));
  }
}

TEST_CASE("each maker of an item without a place makes one that is known to have none") {
  const MissionItem items[] = {returnToLaunch(),      delay(1_s),        changeSpeed(1_mps), jump(0, 1),
                               setServo(1, 1500),     setRelay(0, true), takePicture(),      cameraTriggerDistance(5_m),
                               regionOfInterestOff(), turnTo(90_deg)};
  for (const MissionItem& item : items) {
    CAPTURE(item.command);
    CHECK((item.frame == CoordinateFrame::Mission));
    CHECK((traitsOf(item.command) & kHasNoPlace) != 0);
  }
}

TEST_CASE("each maker that leaves the yaw open makes a command whose yaw may be open") {
  const MissionItem items[] = {takeoff(1_m), takeoff(1_deg, 1_deg, 1_m), waypoint(1_deg, 1_deg, 1_m),
                               land(),       land(1_deg, 1_deg),         loiterUnlimited(1_deg, 1_deg, 1_m)};
  for (const MissionItem& item : items) {
    CAPTURE(item.command);
    CHECK(item.param4 != item.param4);
    for (const Firmware firmware : {Firmware::ArduPilot, Firmware::Px4, Firmware::Other}) {
      CHECK(rulesOf(item, keeperOf(firmware, 2, PlanType::Mission)).hasYaw());
      CHECK(rulesOf(item, keeperOf(firmware, 1, PlanType::Mission)).hasYaw());
    }
  }
}

TEST_CASE("ArduPilot's planes are told by their type, and nobody else is one") {
  for (unsigned type = 0; type < 256; ++type) {
    CAPTURE(type);
    const bool isPlane = type == 1 || (type >= 19 && type <= 25);
    const Keeper keeper = keeperOf(Firmware::ArduPilot, static_cast<uint8_t>(type), PlanType::Mission);
    CHECK(((keeper & kByPlane) != 0) == isPlane);
    CHECK(keeperOf(Firmware::Px4, static_cast<uint8_t>(type), PlanType::Mission) == kByPx4);
    CHECK(keeperOf(Firmware::Other, static_cast<uint8_t>(type), PlanType::Mission) == 0);
  }
}

TEST_CASE("a plane has rules of its own for a waypoint, and no splines") {
  const MissionItem here = waypoint(1_deg, 1_deg, 1_m);
  MissionItem spline = here;
  spline.command = kNavSplineWaypoint;
  const Keeper copter = keeperOf(Firmware::ArduPilot, 2, PlanType::Mission);
  const Keeper plane = keeperOf(Firmware::ArduPilot, 1, PlanType::Mission);
  CHECK(rulesOf(here, copter).bits != rulesOf(here, plane).bits);
  CHECK_FALSE(rulesOf(spline, copter).has(kIsNotTaken));
  CHECK(rulesOf(spline, plane).has(kIsNotTaken));
}

TEST_CASE("a command that a vehicle was recorded to take is not refused for it, and one that only others took is") {
  std::map<std::string, std::set<uint16_t>> taken;
  std::map<std::string, Keeper> keepers;
  std::set<uint16_t> all;
  for (const RecordedItem& row : recordedItems()) {
    if (row.type != PlanType::Mission || !row.isRead) continue;
    taken[row.vehicle].insert(row.command);
    keepers[row.vehicle] = row.keeper;
    all.insert(row.command);
  }
  all.erase(kFenceReturnPoint);  // PX4 takes it in a mission too; ArduPilot in its fence alone
  CHECK(all.size() > 70);
  for (const auto& vehicle : taken) {
    for (const uint16_t command : all) {
      MissionItem item = anyCommandAt(command, 1_deg, 1_deg, 20_m);
      CAPTURE(vehicle.first);
      CAPTURE(command);
      // DO_AUTOTUNE_ENABLE: PX4 takes it from 1.18 on, which was not recorded, and an older one refuses it itself.
      const bool isTaken = vehicle.second.count(command) != 0 || (command == 212 && vehicle.first == "px4");
      CHECK(rulesOf(item, keepers[vehicle.first]).has(kIsNotTaken) == !isTaken);
    }
  }
}

TEST_CASE("a command that was taken with a place is not sent without one") {
  unsigned places = 0;
  for (const RecordedItem& row : recordedItems()) {
    const bool isPlace =
        row.isRead && row.sent.frame != CoordinateFrame::Mission && (row.read.x > 65535 || row.read.x < -65535);
    if (!isPlace) continue;
    ++places;
    REQUIRE_FALSE(rulesOf(row.sent, row.keeper).has(kHasNoPlace));
  }
  CHECK(places > 1000);
}

TEST_CASE("a command that is not in the table has no place when its frame says so") {
  for (const Keeper keeper : {Keeper(kByArduPilot), Keeper(kByPx4), Keeper(0)}) {
    CHECK(rulesOf(anyCommand(31337), keeper).has(kHasNoPlace));
    CHECK_FALSE(rulesOf(anyCommandAt(31337, 1_deg, 1_deg, 1_m), keeper).has(kHasNoPlace));
  }
}

TEST_CASE("CONDITION_GATE is a command of PX4's, with a place, and ArduPilot does not take it") {
  const MissionItem gate = anyCommandAt(4501, 1_deg, 1_deg, 20_m);
  CHECK(rulesOf(gate, kByArduPilot).has(kIsNotTaken));
  CHECK_FALSE(rulesOf(gate, kByPx4).has(kIsNotTaken));
  CHECK_FALSE(rulesOf(gate, kByPx4).has(kHasNoPlace));
}
