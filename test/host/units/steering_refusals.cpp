// What Steering refuses before anything is sent, with the field that it names; and who has the aircraft.
#include <doctest/doctest.h>

#include <initializer_list>

#include "SteeredAircraft.h"

using namespace mavmission;
using namespace steered;

namespace {

constexpr uint8_t kArduPilot = ClientOnLine::kArduPilot, kPx4 = ClientOnLine::kPx4;
constexpr uint8_t kFirmwares[] = {kArduPilot, kPx4};
const float kNan = __builtin_nanf(""), kInfinite = __builtin_inff();

// What an order that has been given comes to: "Done"; or why it is refused, with the field, at once and unsent.
std::string verdict(Aircraft& aircraft) {
  aircraft.said();
  const std::string status = aircraft.status(10000);
  if (status == "Done") return status;
  CHECK(aircraft.tookMs <= 2);
  CHECK(aircraft.said() == "");
  const ItemField field = aircraft.client.differingField();
  return status + (field == ItemField::None ? "" : std::string(" of ") + nameOf(field));
}

// One that flies its mission.
struct Flying : Aircraft {
  explicit Flying(uint8_t firmware) : Aircraft(firmware) { inMission(); }
  std::string placed(const LatLon& place, Altitude altitude) { return verdict(goTo(place, altitude)); }
  std::string placed(Altitude altitude) { return verdict(goTo(altitude)); }
};

}  // namespace

TEST_CASE("a height is a number of up to 10 km above or below its reference") {
  for (uint8_t firmware : kFirmwares) {
    Flying flying(firmware);
    CHECK(flying.placed(Metres(kNan)) == "NotANumber of Height");
    CHECK(flying.placed(Metres(kInfinite)) == "NotFinite of Height");
    CHECK(flying.placed(Metres(-kInfinite)) == "NotFinite of Height");
    for (float metres : {10000.01f, 65536.f, 131072.f, 262144.f, 30000000.f, 1e9f, 3e38f}) {
      CAPTURE(metres);
      CHECK(flying.placed(Metres(metres)) == "BadAltitude of Height");
      CHECK(flying.placed(Metres(-metres)) == "BadAltitude of Height");
    }
    for (float metres : {10000.f, -10000.f, 0.f, -20.f}) {
      CAPTURE(metres);
      CHECK(flying.placed(Metres(metres)) == "Done");
    }
  }
}

TEST_CASE("a place is on the earth, and not 0 N 0 E") {
  const struct {
    int32_t latitude, longitude;
    const char* verdict;
  } kCases[] = {
      {900000001, 0, "BadLatitude of Latitude"},
      {-900000001, 0, "BadLatitude of Latitude"},
      {INT32_MIN, 0, "BadLatitude of Latitude"},
      {0, 1800000001, "BadLongitude of Longitude"},
      {0, -1800000001, "BadLongitude of Longitude"},
      {900000001, 1800000001, "BadLatitude of Latitude"},
      {0, 0, "NeedsCoordinates of Latitude"},
      {900000000, 1, "Done"},
      {-900000000, 1, "Done"},
      {1, 1800000000, "Done"},
      {1, -1800000000, "Done"},
      {0, 1, "Done"},
      {1, 0, "Done"},
  };
  Flying flying(kArduPilot);
  for (const auto& one : kCases) {
    CAPTURE(one.latitude);
    CAPTURE(one.longitude);
    CHECK(flying.placed({Degrees::fromE7(one.latitude), Degrees::fromE7(one.longitude)}, 20_m) == one.verdict);
  }
}

TEST_CASE("only ArduPilot takes an altitude above the ground; other frames are those of no altitude") {
  for (uint8_t firmware : kFirmwares) {
    Flying flying(firmware);
    CHECK(flying.placed(aboveHome(20_m)) == "Done");
    CHECK(flying.placed(aboveSeaLevel(620_m)) == "Done");
    CHECK(flying.placed(Altitude(20_m, CoordinateFrame::GlobalRelativeInt)) == "Done");
    CHECK(flying.placed(Altitude(620_m, CoordinateFrame::GlobalInt)) == "Done");
    CHECK(flying.placed(Altitude(20_m, CoordinateFrame::Mission)) == "BadFrame of Reference");
    CHECK(flying.placed(Altitude(20_m, static_cast<CoordinateFrame>(1))) == "BadFrame of Reference");
    const char* const overGround = firmware == kArduPilot ? "Done" : "BadFrame of Reference";
    CHECK(flying.placed(aboveTerrain(20_m)) == overGround);
    CHECK(flying.placed(Altitude(20_m, CoordinateFrame::GlobalTerrainInt)) == overGround);
  }
}

TEST_CASE("a speed is a number above 0, and up to 100 m/s") {
  for (uint8_t firmware : kFirmwares) {
    Flying flying(firmware);
    CHECK(verdict(flying.setSpeed(kNan)) == "NotANumber of Param2");
    CHECK(verdict(flying.setSpeed(kInfinite)) == "NotFinite of Param2");
    for (float speed : {0.f, -0.f, -1e-45f, -0.01f, -5.f, 100.00001f, 200.f, 200000.f, 30000000.f, 3e38f, -3e38f}) {
      CAPTURE(speed);
      CHECK(verdict(flying.setSpeed(speed)) == "BadSpeed of Param2");
    }
    for (float speed : {1e-45f, 0.004f, 5.f, 100.f}) {
      CAPTURE(speed);
      CHECK(verdict(flying.setSpeed(speed)) == "Done");
    }
  }
}

TEST_CASE("a takeoff leads upwards, and up to 10 km") {
  for (uint8_t firmware : kFirmwares) {
    Aircraft aircraft(firmware);
    aircraft.stand(0);
    for (float metres : {0.f, 0.004f, -5.f, 10000.01f, 1e9f}) {
      CAPTURE(metres);
      CHECK(verdict(aircraft.takeOff(Metres(metres))) == "BadAltitude of Height");
    }
    CHECK(verdict(aircraft.takeOff(Metres(kNan))) == "NotANumber of Height");
    CHECK(verdict(aircraft.takeOff(Metres(kInfinite))) == "NotFinite of Height");
    CHECK(verdict(aircraft.takeOff(0.01_m)) == "Done");
  }
}

TEST_CASE("a number is checked before it is asked who has the aircraft") {
  Flying flying(kArduPilot);
  flying.fly(kLoiter);
  CHECK(flying.placed(10001_m) == "BadAltitude of Height");
  CHECK(flying.placed(20_m) == "PilotHasIt");
}

TEST_CASE("CRITICAL is a failsafe of PX4 in any mode, and of ArduPilot only where it flies in no mode of ours") {
  const struct {
    uint8_t firmware;
    uint32_t mode;
    const char* verdict;
  } kCases[] = {
      {kPx4, kPx4Mission, "FailsafeHasIt"}, {kArduPilot, kAuto, "Done"}, {kArduPilot, kLoiter, "FailsafeHasIt"}};
  for (uint8_t state : {kCritical, kEmergency}) {
    for (const auto& one : kCases) {
      Flying flying(one.firmware);
      CHECK(flying.steering.maySteer());
      flying.fly(one.mode).state = state;
      const bool mayBeSteered = flying.wait(1000).steering.maySteer();
      CHECK(mayBeSteered == (std::string(one.verdict) == "Done"));
      CHECK(flying.placed(20_m) == one.verdict);
    }
  }
  Flying px4(kPx4);  // one that begins in the mode of an order ends that mode's being ours
  CHECK(px4.goTo().done().steering.maySteer());
  px4.state = kCritical;
  CHECK_FALSE(px4.wait(1000).steering.maySteer());
  px4.state = kActive;  // HOLD is somebody's who has ended the failsafe
  CHECK_FALSE(px4.wait(1000).steering.maySteer());
}

TEST_CASE("the modes of PX4 say who has the aircraft") {
  const struct {
    uint32_t mode;
    const char* verdict;
  } kCases[] = {{kPx4Position, "PilotHasIt"}, {kPx4Hold, "PilotHasIt"},   {kPx4Offboard, "PilotHasIt"},
                {kPx4TakeOff, "PilotHasIt"},  {kPx4Rtl, "FailsafeHasIt"}, {kPx4Land, "FailsafeHasIt"}};
  for (const auto& one : kCases) {
    Flying px4(kPx4);
    CHECK_FALSE(px4.fly(one.mode).steering.maySteer());
    CHECK(verdict(px4.resume()) == one.verdict);
  }
}

TEST_CASE("nobody steers an aircraft that is not heard") {
  Aircraft aircraft(kArduPilot);
  CHECK_FALSE(aircraft.steering.maySteer());
  CHECK(aircraft.inMission().steering.maySteer());
  aircraft.beatsBySecond = false;
  CHECK(aircraft.wait(3990).steering.maySteer());
  CHECK_FALSE(aircraft.wait(20).steering.maySteer());
}

TEST_CASE("an aircraft on the ground takes only a takeoff, and one in the air takes none; a rover has to be armed") {
  Aircraft copter(kArduPilot);
  copter.stand(kAuto);
  CHECK(verdict(copter.goTo()) == "NotArmed");
  CHECK(verdict(copter.resume()) == "NotArmed");
  copter.isArmed = true;
  CHECK(verdict(copter.wait(1000).goTo()) == "NotFlying");
  CHECK(verdict(copter.setSpeed(5)) == "NotFlying");
  copter.state = kActive;
  CHECK(verdict(copter.wait(1000).takeOff()) == "Armed");
  copter.isArmed = false;  // the heartbeat that says so may still say ACTIVE
  CHECK(verdict(copter.wait(1000).takeOff()) == "Done");
  Aircraft rover(kArduPilot, 10);
  CHECK(verdict(rover.stand(kRoverAuto).resume()) == "NotArmed");
  rover.isArmed = true;
  rover.state = kStandby;
  CHECK(verdict(rover.wait(1000).goTo(0_m)) == "Done");
}

TEST_CASE("PX4 is asked whether it flies, and each answer but that it stands is one that it does") {
  for (uint8_t landed = 0; landed <= 4; ++landed) {
    CAPTURE(landed);
    Flying px4(kPx4);
    px4.landed = landed;
    CHECK(px4.resume().status() == (landed >= 2 ? "Done" : "NotFlying"));
    CHECK(px4.said() == "L512 245 0 0 0 0 0 0");  // it flies its mission already
    px4.takesOff = false;
    CHECK(px4.takeOff(5_m).status() == (landed >= 2 ? "Armed" : "Unconfirmed"));
  }
}

TEST_CASE("a vehicle that has no command for it takes no takeoff, and one of an unknown type no order") {
  for (uint8_t type : {10, 11, 12, 7}) {  // a rover, a boat, a submarine, a blimp
    CAPTURE(type);
    Aircraft vehicle(kArduPilot, type);
    CHECK(verdict(vehicle.stand(19).takeOff(5_m)) == (type == 7 ? "NoSuchMode" : "CommandUnsupported"));
  }
  CHECK(verdict(Aircraft(kArduPilot, 0).stand(0).takeOff(5_m)) == "NoSuchMode");
  CHECK(verdict(Aircraft(kArduPilot, 12).fly(3).returnHome()) == "NoSuchMode");
}

TEST_CASE("PX4's takeoff is that of what flies: it would arm a rover, a boat or a submarine, too") {
  for (uint8_t type : {1, 2, 7, 10, 11, 12, 22}) {
    CAPTURE(type);
    CHECK(Aircraft(kPx4, type).stand(kPx4Position).takeOff(5_m).status() ==
          (type >= 10 && type <= 12 ? "CommandUnsupported" : "Done"));
  }
}

TEST_CASE("a second order is refused while one runs, and changes nothing of it") {
  Flying flying(kArduPilot);
  CHECK((flying.steering.goTo(kThere, 20_m) == Status::WaitingForAutopilot));
  CHECK((flying.steering.takeOff(7_m) == Status::Busy));
  CHECK((flying.steering.goTo({1_deg, 2_deg}, aboveSeaLevel(70_m)) == Status::Busy));
  CHECK((flying.steering.setSpeed(7_mps) == Status::Busy));
  CHECK((flying.steering.pause() == Status::Busy));
  CHECK((flying.steering.resume() == Status::Busy));
  CHECK((flying.steering.returnHome() == Status::Busy));
  CHECK((flying.steering.landNow() == Status::Busy));
  CHECK(flying.status() == "Done");
  CHECK(flying.said() == "L511 33 500000 0 0 0 0 0, I192 frame 6 -1 1 0 nan -353630000 1491652374 20");
}
