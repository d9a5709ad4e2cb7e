// What Steering refuses before anything is sent, with the field that it names; and who has the aircraft.
#include <doctest/doctest.h>

#include <initializer_list>

#include "SteeredAircraft.h"

using namespace mavmission;
using namespace steered;

namespace {

constexpr uint8_t kFirmwares[] = {ClientOnLine::kArduPilot, ClientOnLine::kPx4};
constexpr LatLon kPlace = {-35.3630000_deg, 149.1652374_deg};

uint32_t missionOf(uint8_t firmware) {
  return firmware == ClientOnLine::kPx4 ? uint32_t{kPx4Mission} : uint32_t{kAuto};
}

// A copter that flies its mission.
struct Flying : Aircraft {
  explicit Flying(uint8_t firmware, uint8_t vehicleType = 2) : Aircraft(firmware, vehicleType) {
    fly(missionOf(firmware));
  }

  // Whether an order that has been given is refused at once with this status and field, and nothing is sent.
  bool refuses(Status status, ItemField field) {
    said();
    return end(50) == status && client.differingField() == field && said().empty() && tookMs <= 2;
  }
  bool refusesPlace(const LatLon& place, Altitude altitude, Status status, ItemField field) {
    steering.goTo(place, altitude);
    return refuses(status, field);
  }
  bool takesPlace(const LatLon& place, Altitude altitude) {
    steering.goTo(place, altitude);
    const bool isTaken = end(10000) == Status::Done;
    return isTaken;
  }
  bool refusesSpeed(float speed, Status status) {
    steering.setSpeed(MetresPerSecond(speed));
    return refuses(status, ItemField::Param2);
  }
  bool takesSpeed(float speed) {
    steering.setSpeed(MetresPerSecond(speed));
    return end(5000) == Status::Done;
  }
};

const float kNan = __builtin_nanf(""), kInfinite = __builtin_inff();

}  // namespace

TEST_CASE("a height is a number of up to 10 km above or below its reference") {
  for (uint8_t firmware : kFirmwares) {
    Flying flying(firmware);
    CHECK(flying.refusesPlace(kPlace, Metres(kNan), Status::NotANumber, ItemField::Height));
    CHECK(flying.refusesPlace(kPlace, Metres(kInfinite), Status::NotFinite, ItemField::Height));
    CHECK(flying.refusesPlace(kPlace, Metres(-kInfinite), Status::NotFinite, ItemField::Height));
    for (float metres : {10000.01f, 65536.f, 131072.f, 262144.f, 30000000.f, 1e9f, 3e38f}) {
      CAPTURE(metres);
      CHECK(flying.refusesPlace(kPlace, Metres(metres), Status::BadAltitude, ItemField::Height));
      CHECK(flying.refusesPlace(kPlace, Metres(-metres), Status::BadAltitude, ItemField::Height));
    }
    for (float metres : {10000.f, -10000.f, 0.f, -20.f}) {
      CAPTURE(metres);
      CHECK(flying.takesPlace(kPlace, Metres(metres)));
    }
  }
}

TEST_CASE("a place is on the earth, and not 0 N 0 E") {
  const struct {
    int32_t latitude, longitude;
    Status status;
    ItemField field;
  } kRefused[] = {
      {900000001, 0, Status::BadLatitude, ItemField::Latitude},
      {-900000001, 0, Status::BadLatitude, ItemField::Latitude},
      {INT32_MIN, 0, Status::BadLatitude, ItemField::Latitude},
      {0, 1800000001, Status::BadLongitude, ItemField::Longitude},
      {0, -1800000001, Status::BadLongitude, ItemField::Longitude},
      {900000001, 1800000001, Status::BadLatitude, ItemField::Latitude},
      {0, 0, Status::NeedsCoordinates, ItemField::Latitude},
  };
  Flying flying(ClientOnLine::kArduPilot);
  for (const auto& one : kRefused) {
    const LatLon place = {Degrees::fromE7(one.latitude), Degrees::fromE7(one.longitude)};
    CHECK(flying.refusesPlace(place, 20_m, one.status, one.field));
  }
  const int32_t kTaken[][2] = {{900000000, 1}, {-900000000, 1}, {1, 1800000000}, {1, -1800000000}, {0, 1}, {1, 0}};
  for (const auto& one : kTaken) {
    CAPTURE(one[0]);
    CAPTURE(one[1]);
    CHECK(flying.takesPlace({Degrees::fromE7(one[0]), Degrees::fromE7(one[1])}, 20_m));
  }
}

TEST_CASE("only ArduPilot takes an altitude above the ground; other frames are those of no altitude") {
  for (uint8_t firmware : kFirmwares) {
    Flying flying(firmware);
    CHECK(flying.takesPlace(kPlace, aboveHome(20_m)));
    CHECK(flying.takesPlace(kPlace, aboveSeaLevel(620_m)));
    CHECK(flying.takesPlace(kPlace, Altitude(20_m, CoordinateFrame::GlobalRelativeInt)));
    CHECK(flying.takesPlace(kPlace, Altitude(620_m, CoordinateFrame::GlobalInt)));
    CHECK(
        flying.refusesPlace(kPlace, Altitude(20_m, CoordinateFrame::Mission), Status::BadFrame, ItemField::Reference));
    CHECK(flying.refusesPlace(kPlace, Altitude(20_m, static_cast<CoordinateFrame>(1)), Status::BadFrame,
                              ItemField::Reference));
    if (firmware == ClientOnLine::kArduPilot) {
      CHECK(flying.takesPlace(kPlace, aboveTerrain(20_m)));
      CHECK(flying.takesPlace(kPlace, Altitude(20_m, CoordinateFrame::GlobalTerrainInt)));
    } else {
      CHECK(flying.refusesPlace(kPlace, aboveTerrain(20_m), Status::BadFrame, ItemField::Reference));
    }
  }
}

TEST_CASE("a speed is a number above 0, and up to 100 m/s") {
  for (uint8_t firmware : kFirmwares) {
    Flying flying(firmware);
    CHECK(flying.refusesSpeed(kNan, Status::NotANumber));
    CHECK(flying.refusesSpeed(kInfinite, Status::NotFinite));
    for (float speed : {0.f, -0.f, -1e-45f, -0.01f, -5.f, 100.00001f, 200.f, 200000.f, 30000000.f, 3e38f, -3e38f}) {
      CAPTURE(speed);
      CHECK(flying.refusesSpeed(speed, Status::BadSpeed));
    }
    for (float speed : {1e-45f, 0.004f, 5.f, 100.f}) {
      CAPTURE(speed);
      CHECK(flying.takesSpeed(speed));
    }
  }
}

TEST_CASE("a takeoff leads upwards, and up to 10 km") {
  for (uint8_t firmware : kFirmwares) {
    Aircraft aircraft(firmware);
    aircraft.stand(0);
    for (float metres : {0.f, 0.004f, -5.f, 10000.01f, 1e9f}) {
      CAPTURE(metres);
      aircraft.steering.takeOff(Metres(metres));
      CHECK((aircraft.end(50) == Status::BadAltitude));
      CHECK((aircraft.client.differingField() == ItemField::Height));
    }
    aircraft.steering.takeOff(Metres(kNan));
    CHECK((aircraft.end(50) == Status::NotANumber));
    aircraft.steering.takeOff(Metres(kInfinite));
    CHECK((aircraft.end(50) == Status::NotFinite));
    CHECK(aircraft.said() == "");
    aircraft.steering.takeOff(0.01_m);
    CHECK((aircraft.end(5000) == Status::Done));
  }
}

TEST_CASE("a number is checked before it is asked who has the aircraft") {
  Flying flying(ClientOnLine::kArduPilot);
  flying.fly(kLoiter);
  CHECK(flying.refusesPlace(kPlace, 10001_m, Status::BadAltitude, ItemField::Height));
  flying.steering.goTo(kPlace, 20_m);
  CHECK((flying.end(50) == Status::PilotHasIt));
}

TEST_CASE("CRITICAL is a failsafe of PX4 in any mode, and of ArduPilot only where it flies in no mode of ours") {
  for (uint8_t state : {kCritical, kEmergency}) {
    Flying px4(ClientOnLine::kPx4);
    CHECK(px4.steering.maySteer());
    px4.state = state;
    px4.pass(1000);
    CHECK_FALSE(px4.steering.maySteer());
    px4.steering.goTo(kPlace, 20_m);
    CHECK((px4.end(50) == Status::FailsafeHasIt));
    CHECK(px4.said() == "");

    Flying copter(ClientOnLine::kArduPilot);
    copter.state = state;
    copter.pass(1000);
    CHECK(copter.steering.maySteer());
    copter.fly(kLoiter);
    copter.state = state;
    copter.pass(1000);
    CHECK_FALSE(copter.steering.maySteer());
    copter.steering.goTo(kPlace, 20_m);
    CHECK((copter.end(50) == Status::FailsafeHasIt));
  }
}

TEST_CASE("a failsafe of PX4 that begins in the mode of an order ends that mode's being ours") {
  Flying px4(ClientOnLine::kPx4);
  px4.steering.goTo(kPlace, 20_m);
  REQUIRE((px4.end() == Status::Done));
  CHECK(px4.steering.maySteer());
  px4.state = kCritical;
  px4.pass(1000);
  CHECK_FALSE(px4.steering.maySteer());
  px4.state = kActive;  // HOLD is somebody's who has ended the failsafe
  px4.pass(1000);
  CHECK_FALSE(px4.steering.maySteer());
}

TEST_CASE("the modes of PX4 say who has the aircraft") {
  const struct {
    uint32_t mode;
    Status status;
  } kCases[] = {{kPx4Position, Status::PilotHasIt}, {kPx4Hold, Status::PilotHasIt},
                {kPx4Offboard, Status::PilotHasIt}, {kPx4TakeOff, Status::PilotHasIt},
                {kPx4Rtl, Status::FailsafeHasIt},   {kPx4Land, Status::FailsafeHasIt}};
  for (const auto& one : kCases) {
    Flying px4(ClientOnLine::kPx4);
    px4.fly(one.mode);
    CHECK_FALSE(px4.steering.maySteer());
    px4.steering.resume();
    CHECK((px4.end(50) == one.status));
    CHECK(px4.said() == "");
  }
}

TEST_CASE("nobody steers an aircraft that is not heard") {
  Aircraft aircraft(ClientOnLine::kArduPilot);
  CHECK_FALSE(aircraft.steering.maySteer());
  aircraft.fly(kAuto);
  CHECK(aircraft.steering.maySteer());
  aircraft.beatsBySecond = false;
  aircraft.pass(3990);
  CHECK(aircraft.steering.maySteer());
  aircraft.pass(20);
  CHECK_FALSE(aircraft.steering.maySteer());
}

TEST_CASE("an aircraft on the ground takes only a takeoff, and one in the air takes none") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.stand(kAuto);
  copter.steering.goTo(kPlace, 20_m);
  CHECK((copter.end(50) == Status::NotArmed));
  copter.steering.resume();
  CHECK((copter.end(50) == Status::NotArmed));
  copter.isArmed = true;
  copter.pass(1000);
  copter.steering.goTo(kPlace, 20_m);
  CHECK((copter.end(50) == Status::NotFlying));
  copter.steering.setSpeed(5_mps);
  CHECK((copter.end(50) == Status::NotFlying));
  copter.state = kActive;
  copter.pass(1000);
  copter.steering.takeOff(20_m);
  CHECK((copter.end(50) == Status::Armed));
  copter.isArmed = false;  // the heartbeat that says so may still say ACTIVE
  copter.pass(1000);
  CHECK(copter.said() == "");
  copter.steering.takeOff(20_m);
  CHECK((copter.end() == Status::Done));
}

TEST_CASE("PX4 is asked whether it flies, and each answer but that it stands is one that it does") {
  for (uint8_t landed = 0; landed <= 4; ++landed) {
    CAPTURE(landed);
    Flying px4(ClientOnLine::kPx4);
    px4.landed = landed;
    px4.steering.resume();
    px4.end();
    CHECK((px4.ended == (landed >= 2 ? Status::Done : Status::NotFlying)));
    CHECK(px4.said() == "L512 245 0 0 0 0 0 0");  // it flies its mission already
    px4.steering.takeOff(5_m);
    px4.takesOff = false;
    px4.end();
    CHECK((px4.ended == (landed >= 2 ? Status::Armed : Status::Unconfirmed)));
  }
}

TEST_CASE("a rover has only to be armed") {
  Aircraft rover(ClientOnLine::kArduPilot, 10);
  rover.stand(kRoverAuto);
  rover.steering.resume();
  CHECK((rover.end(50) == Status::NotArmed));
  rover.isArmed = true;
  rover.state = kStandby;
  rover.pass(1000);
  rover.forget();
  rover.steering.goTo(kPlace, 0_m);
  CHECK((rover.end() == Status::Done));
}

TEST_CASE("a vehicle that has no command for it takes no takeoff, and one of an unknown type no order") {
  for (uint8_t type : {10, 11, 12, 7}) {  // a rover, a boat, a submarine, a blimp
    CAPTURE(type);
    Aircraft vehicle(ClientOnLine::kArduPilot, type);
    vehicle.stand(19);
    vehicle.steering.takeOff(5_m);
    CHECK((vehicle.end(50) == (type == 7 ? Status::NoSuchMode : Status::CommandUnsupported)));
    CHECK(vehicle.said() == "");
  }
  Aircraft unknown(ClientOnLine::kArduPilot, 0);
  unknown.stand(0);
  unknown.steering.takeOff(5_m);
  CHECK((unknown.end(50) == Status::NoSuchMode));
  Aircraft submarine(ClientOnLine::kArduPilot, 12);
  submarine.fly(3);
  submarine.steering.returnHome();
  CHECK((submarine.end(50) == Status::NoSuchMode));
  CHECK(submarine.said() == "");
}

TEST_CASE("PX4's takeoff is that of what flies: it would arm a rover, a boat or a submarine, too") {
  for (uint8_t type : {1, 2, 7, 10, 11, 12, 22}) {
    CAPTURE(type);
    Aircraft px4(ClientOnLine::kPx4, type);
    px4.stand(kPx4Position);
    px4.steering.takeOff(5_m);
    CHECK((px4.end() == (type >= 10 && type <= 12 ? Status::CommandUnsupported : Status::Done)));
  }
}

TEST_CASE("a second order is refused while one runs, and changes nothing of it") {
  Flying flying(ClientOnLine::kArduPilot);
  CHECK((flying.steering.goTo(kPlace, 20_m) == Status::WaitingForAutopilot));
  CHECK((flying.steering.takeOff(7_m) == Status::Busy));
  CHECK((flying.steering.goTo({1_deg, 2_deg}, aboveSeaLevel(70_m)) == Status::Busy));
  CHECK((flying.steering.setSpeed(7_mps) == Status::Busy));
  CHECK((flying.steering.pause() == Status::Busy));
  CHECK((flying.steering.resume() == Status::Busy));
  CHECK((flying.steering.returnHome() == Status::Busy));
  CHECK((flying.steering.landNow() == Status::Busy));
  CHECK((flying.end() == Status::Done));
  CHECK(flying.said() == "L511 33 500000 0 0 0 0 0, I192 frame 6 -1 1 0 nan -353630000 1491652374 20");
}
