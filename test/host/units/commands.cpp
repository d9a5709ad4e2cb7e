#include "mavmission/autopilot/Commands.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include "mavmission/MissionItem.h"
#include "mavmission/autopilot/Rules.h"

using namespace mavmission;
using namespace mavmission::detail;

TEST_CASE("a command that is not in the table has a place or not as its frame says") {
  for (const uint16_t command : {0, 15, 3001, 65535}) CHECK(traitsOf(command) == kAsItsFrameSays);
  CHECK(traitsOf(19) == 0);
}

TEST_CASE("each maker of an item without a place makes one that is known to have none") {
  const MissionItem items[] = {returnToLaunch(),      delay(1_s),        changeSpeed(1_mps), jump(0, 1),
                               setServo(1, 1500),     setRelay(0, true), takePicture(),      cameraTriggerDistance(5_m),
                               regionOfInterestOff(), turnTo(90_deg)};
  for (const MissionItem& item : items) {
    CAPTURE(item.command);
    CHECK((item.frame == Frame::Mission));
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
