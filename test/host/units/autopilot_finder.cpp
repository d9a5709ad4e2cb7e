#include "mavmission/autopilot/AutopilotFinder.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>

#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

struct Finder : AutopilotFinder {
  Finder() { memset(static_cast<void*>(this), 0, sizeof(*this)); }
};

Heartbeat from(uint8_t systemId, uint8_t componentId, uint8_t autopilot = MAV_AUTOPILOT_PX4,
               uint8_t type = MAV_TYPE_QUADROTOR, uint8_t baseMode = 0) {
  return Heartbeat{0, type, autopilot, baseMode, MAV_STATE_STANDBY, systemId, componentId};
}

}  // namespace

TEST_CASE("nothing is found before a heartbeat") {
  Finder finder;
  CHECK_FALSE(finder.isFound());
  CHECK_FALSE(finder.isCertain());
  CHECK(finder.firmware() == Firmware::Unknown);
  CHECK_FALSE(finder.isFrom(0, 0));
}

TEST_CASE("an autopilot is found by its heartbeat, and certain when a second would have been heard") {
  Finder finder;
  finder.onHeartbeat(from(7, 1), 65000);  // across the wrap of the clock
  CHECK(finder.isFound());
  CHECK(finder.isFrom(7, 1));
  CHECK_FALSE(finder.isFrom(7, 2));
  finder.onTime(static_cast<uint16_t>(65000 + AutopilotFinder::kSettleMs - 1));
  CHECK_FALSE(finder.isCertain());
  finder.onTime(static_cast<uint16_t>(65000 + AutopilotFinder::kSettleMs));
  CHECK(finder.isCertain());
}

TEST_CASE("firmware is told by the heartbeat") {
  for (unsigned autopilot = 0; autopilot < 30; ++autopilot) {
    Finder finder;
    finder.onHeartbeat(from(1, 1, static_cast<uint8_t>(autopilot)), 0);
    const bool isNobody = autopilot == MAV_AUTOPILOT_INVALID || autopilot == MAV_AUTOPILOT_GENERIC;
    const Firmware expected = isNobody                                   ? Firmware::Unknown
                              : autopilot == MAV_AUTOPILOT_ARDUPILOTMEGA ? Firmware::ArduPilot
                              : autopilot == MAV_AUTOPILOT_PX4           ? Firmware::Px4
                                                                         : Firmware::Other;
    CAPTURE(autopilot);
    CHECK(finder.firmware() == expected);
  }
}

TEST_CASE("what says GENERIC is an autopilot only where it was named") {
  Finder finder;
  finder.onHeartbeat(from(1, 158, MAV_AUTOPILOT_GENERIC), 0);
  CHECK_FALSE(finder.isHeard());
  finder.setTargetIds(1, 158);
  finder.onHeartbeat(from(1, 158, MAV_AUTOPILOT_GENERIC), 0);
  CHECK(finder.isCertain());
  CHECK(finder.firmware() == Firmware::Other);
}

TEST_CASE("what is not a vehicle is not taken for an autopilot, whatever autopilot it names") {
  for (unsigned type : {MAV_TYPE_GCS, MAV_TYPE_GIMBAL, MAV_TYPE_ONBOARD_CONTROLLER, MAV_TYPE_CAMERA, MAV_TYPE_ADSB,
                        MAV_TYPE_ANTENNA_TRACKER, MAV_TYPE_ODID, MAV_TYPE_BATTERY, MAV_TYPE_WINCH}) {
    Finder finder;
    finder.onHeartbeat(from(1, 1, MAV_AUTOPILOT_PX4, static_cast<uint8_t>(type)), 0);
    CAPTURE(type);
    CHECK_FALSE(finder.isFound());
  }
  for (unsigned type : {MAV_TYPE_QUADROTOR, MAV_TYPE_FIXED_WING, MAV_TYPE_GROUND_ROVER, MAV_TYPE_SUBMARINE,
                        MAV_TYPE_GENERIC, MAV_TYPE_VTOL_TILTROTOR}) {
    Finder finder;
    finder.onHeartbeat(from(1, 1, MAV_AUTOPILOT_PX4, static_cast<uint8_t>(type)), 0);
    CHECK(finder.isFound());
  }
}

TEST_CASE("an autopilot is lost 5 s after its last heartbeat, and found again by the next") {
  Finder finder;
  finder.onHeartbeat(from(1, 1), 0);
  finder.onHeartbeat(from(1, 1), 1000);
  finder.onTime(5999);
  CHECK(finder.isFound());
  finder.onTime(6000);
  CHECK_FALSE(finder.isFound());
  CHECK(finder.firmware() == Firmware::Unknown);
  const uint8_t knowledge = finder.knowledge();
  finder.onTime(6500);
  CHECK(finder.knowledge() == knowledge);
  finder.onHeartbeat(from(2, 1), 6800);
  CHECK_FALSE(finder.isHeard());
  finder.onHeartbeat(from(1, 1), 7000);
  CHECK(finder.isCertain());
  CHECK_FALSE(finder.takeChange());
}

TEST_CASE("an autopilot that is certain stays the one, whoever else is heard, also while it is silent") {
  Finder finder;
  finder.onHeartbeat(from(1, 1), 0);
  finder.onTime(AutopilotFinder::kSettleMs);
  for (uint16_t now = 1300; now < 60000; now = static_cast<uint16_t>(now + 100)) {
    finder.onHeartbeat(from(2, 1), now);
    finder.onTime(now);
    CHECK(finder.isCertain() == (now < AutopilotFinder::kLostMs));
    CHECK_FALSE(finder.severalHeard());
  }
  CHECK_FALSE(finder.takeChange());
  CHECK(finder.heartbeat().systemId == 1);
}

TEST_CASE("another firmware or vehicle with the same ids, a restart, and another name are another autopilot") {
  struct Row {
    Heartbeat next;
    bool isOther;
  };
  Heartbeat boots = from(1, 1);
  boots.state = MAV_STATE_BOOT;
  for (const Row& row : {Row{from(1, 1), false}, Row{from(1, 1, MAV_AUTOPILOT_ARDUPILOTMEGA), true},
                         Row{from(1, 1, MAV_AUTOPILOT_PX4, MAV_TYPE_HEXAROTOR), true}, Row{boots, true}}) {
    Finder finder;
    finder.onHeartbeat(from(1, 1), 0);
    finder.onTime(AutopilotFinder::kSettleMs);
    CHECK_FALSE(finder.takeChange());
    finder.setVehicle(true);
    const uint8_t knowledge = finder.knowledge();
    finder.onHeartbeat(row.next, 1300);
    if (finder.isDoubted()) {  // the next one decides
      CHECK(finder.knowledge() == knowledge);
      finder.onHeartbeat(row.next, 1350);
    }
    CHECK_FALSE(finder.isDoubted());
    CHECK((finder.knowledge() != knowledge) == row.isOther);
    CHECK(finder.isVehicleKnown() == !row.isOther);
    CHECK(finder.takeChange() == row.isOther);
    CHECK_FALSE(finder.takeChange());
    finder.onHeartbeat(row.next, 1400);
    CHECK_FALSE(finder.takeChange());
    finder.setTargetIds(1, 1);
    CHECK_FALSE(finder.takeChange());
    finder.setTargetIds(2, 1);
    CHECK(finder.takeChange());
  }
}

TEST_CASE("one heartbeat of ours that shows another vehicle changes nothing when the next one shows ours again") {
  for (const Heartbeat& odd :
       {from(1, 1, MAV_AUTOPILOT_ARDUPILOTMEGA), from(1, 1, MAV_AUTOPILOT_PX4, MAV_TYPE_OCTOROTOR)}) {
    Finder finder;
    finder.onHeartbeat(from(1, 1), 0);
    finder.onTime(AutopilotFinder::kSettleMs);
    CHECK_FALSE(finder.takeChange());
    for (const uint16_t now : {1300, 2300}) {
      finder.onHeartbeat(odd, now);
      CHECK(finder.isDoubted());
      CHECK(finder.isCertain());
      CHECK(finder.heartbeat().vehicleType == from(1, 1).vehicleType);
      finder.onHeartbeat(from(1, 1), static_cast<uint16_t>(now + 500));
      CHECK_FALSE(finder.isDoubted());
    }
    CHECK_FALSE(finder.takeChange());
    finder.onHeartbeat(odd, 3300);
    finder.setTargetIds(2, 1);
    CHECK_FALSE(finder.isDoubted());
  }
}

TEST_CASE("of two autopilots none is found until one is named or falls silent") {
  Finder finder;
  finder.onHeartbeat(from(1, 1), 0);
  finder.onHeartbeat(from(2, 1), 100);
  CHECK(finder.severalHeard());
  CHECK_FALSE(finder.isFound());
  for (uint16_t now = 200; now < 5000; now += 100) {
    finder.onHeartbeat(from(1, 1), now);
    finder.onTime(now);
  }
  CHECK(finder.severalHeard());
  finder.onTime(5100);
  CHECK_FALSE(finder.severalHeard());
  CHECK(finder.isFrom(1, 1));
  CHECK(finder.isFound());
}

TEST_CASE("the autopilot that was named is taken, certain at once, and no other") {
  Finder finder;
  finder.onHeartbeat(from(1, 1), 0);
  finder.onHeartbeat(from(2, 1), 0);
  finder.setTargetIds(2, 1);
  CHECK_FALSE(finder.isFound());
  finder.onHeartbeat(from(1, 1), 10);
  CHECK_FALSE(finder.isFound());
  finder.onHeartbeat(from(2, 1), 20);
  CHECK(finder.isFound());
  CHECK(finder.isCertain());
  finder.onHeartbeat(from(1, 1), 30);
  CHECK_FALSE(finder.severalHeard());
  CHECK(finder.isFrom(2, 1));
}

TEST_CASE("naming the one that is there already keeps it; naming none forgets it") {
  Finder finder;
  finder.onHeartbeat(from(1, 1), 0);
  finder.setTargetIds(1, 1);
  CHECK(finder.isCertain());
  finder.setTargetIds(0, 0);
  CHECK_FALSE(finder.isFound());
  finder.onHeartbeat(from(3, 1), 0);
  CHECK(finder.isFrom(3, 1));
}

TEST_CASE("armed is what the last heartbeat says, also after 8 s of silence") {
  Finder finder;
  finder.onHeartbeat(from(1, 1, MAV_AUTOPILOT_PX4, MAV_TYPE_QUADROTOR, MAV_MODE_FLAG_SAFETY_ARMED), 0);
  CHECK(finder.isArmed());
  finder.onTime(8000);
  CHECK_FALSE(finder.isFound());
  CHECK(finder.isArmed());
  finder.onHeartbeat(from(1, 1, MAV_AUTOPILOT_PX4, MAV_TYPE_QUADROTOR, 0x7F), 8001);
  CHECK_FALSE(finder.isArmed());
}

TEST_CASE("a plane that says another type is a plane until another is named, also when it was silent") {
  for (const bool isSilent : {false, true}) {
    Finder finder;
    finder.onHeartbeat(from(1, 1, MAV_AUTOPILOT_ARDUPILOTMEGA, MAV_TYPE_HEXAROTOR), 0);
    CHECK_FALSE(finder.isVehicleKnown());
    CHECK(finder.vehicleType() == MAV_TYPE_HEXAROTOR);
    finder.setVehicle(true);
    finder.onHeartbeat(from(1, 1, MAV_AUTOPILOT_ARDUPILOTMEGA, MAV_TYPE_HEXAROTOR), 1000);
    CHECK(finder.isVehicleKnown());
    CHECK(finder.vehicleType() == MAV_TYPE_VTOL_TAILSITTER_QUADROTOR);
    finder.onTime(AutopilotFinder::kSettleMs);
    if (isSilent) finder.onTime(static_cast<uint16_t>(1000 + AutopilotFinder::kLostMs));
    CHECK(finder.isVehicleKnown());
    finder.setTargetIds(2, 1);
    finder.onHeartbeat(from(2, 1, MAV_AUTOPILOT_ARDUPILOTMEGA, MAV_TYPE_HEXAROTOR), 9000);
    CHECK_FALSE(finder.isVehicleKnown());
    CHECK(finder.vehicleType() == MAV_TYPE_HEXAROTOR);
  }
}
