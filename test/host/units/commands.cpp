#include "mavmission/Commands.h"

#include <doctest/doctest.h>

#include "mavmission/MissionItem.h"

using namespace mavmission;

TEST_CASE("a command that is not in the table has no traits") {
  CHECK(traitsOf(0) == 0);
  CHECK(traitsOf(19) == 0);
  CHECK(traitsOf(65535) == 0);
}

TEST_CASE("each maker of an item without a place makes one that is known to have none") {
  const MissionItem items[] = {returnToLaunch(),  delay(1_s),           changeSpeed(1_mps),
                               jump(0, 1),        setServo(1, 1500),    setRelay(0, true),
                               takePicture(),     cameraTriggerDistance(5_m), regionOfInterestOff(),
                               turnTo(90_deg)};
  for (const MissionItem& item : items) {
    CAPTURE(item.command);
    CHECK((item.frame == Frame::Mission));
    CHECK((traitsOf(item.command) & kHasNoPlace) != 0);
  }
}

TEST_CASE("each maker that leaves the yaw open makes a command whose yaw may be open") {
  const MissionItem items[] = {takeoff(1_m), takeoff(1_deg, 1_deg, 1_m), waypoint(1_deg, 1_deg, 1_m), land(),
                               land(1_deg, 1_deg), loiterUnlimited(1_deg, 1_deg, 1_m)};
  for (const MissionItem& item : items) {
    CAPTURE(item.command);
    CHECK(item.param4 != item.param4);
    CHECK((traitsOf(item.command) & kYawInParam4) != 0);
  }
}
