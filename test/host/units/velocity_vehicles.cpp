// VelocityTarget: which velocities each vehicle takes, what is wrong with the others, and what a rover is sent.
#include <doctest/doctest.h>

#include <limits>

#include "VelocityAircraft.h"

using namespace mavmission;
using namespace steered;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

struct Kind {
  uint8_t autopilot, type;
};
constexpr uint8_t kArduPilot = ClientOnLine::kArduPilot, kPx4 = ClientOnLine::kPx4;
constexpr Kind kCopter = {kArduPilot, MAV_TYPE_QUADROTOR}, kRover = {kArduPilot, MAV_TYPE_GROUND_ROVER};
constexpr Kind kBoat = {kArduPilot, MAV_TYPE_SURFACE_BOAT}, kSubmarine = {kArduPilot, MAV_TYPE_SUBMARINE};
constexpr Kind kPlane = {kArduPilot, MAV_TYPE_FIXED_WING}, kPx4Copter = {kPx4, MAV_TYPE_QUADROTOR};
constexpr Kind kPx4Rover = {kPx4, MAV_TYPE_GROUND_ROVER}, kPx4Plane = {kPx4, MAV_TYPE_FIXED_WING};

struct Flown : VelocityAircraft {
  explicit Flown(const Kind& it) : VelocityAircraft(it.autopilot, it.type) {}
};

// What start() comes to for a vehicle; Transferring: it is flown.
Status begun(const Kind& kind, const Velocity& velocity, ItemField field) {
  Flown flight(kind);
  const bool isCar = kind.type == MAV_TYPE_SURFACE_BOAT || kind.type == MAV_TYPE_FIXED_WING;
  isCar&& kind.autopilot == kArduPilot ? flight.fly(kRoverAuto) : flight.inMission();
  flight.show(flight.mode);
  flight.forget();
  flight.velocity.start(velocity);
  flight.pass(5);
  if (flight.client.isBusy()) return Status::Transferring;
  CHECK((flight.client.differingField() == field));
  CHECK(flight.said() == "");
  CHECK(flight.asks == 0);
  CHECK((flight.velocity.status() == flight.ended));
  return flight.ended;
}

constexpr DegreesPerSecond turn(float value) { return DegreesPerSecond(value); }

// Right above 100, the next float.
float above(float value) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof(bits));
  ++bits;
  memcpy(&value, &bits, sizeof(value));
  return value;
}

}  // namespace

TEST_CASE("a copter takes each speed up to 100 m/s, and each turn up to 360 degrees/s; the wrong number is named") {
  const struct {
    Velocity velocity;
    Status status;
    ItemField field;
  } kCases[] = {
      {earth(100, -100, 100), Status::Transferring, ItemField::None},
      {body(-100, 100, -100), Status::Transferring, ItemField::None},
      {body(above(100)), Status::BadSpeed, ItemField::Param1},
      {body(0, -above(100)), Status::BadSpeed, ItemField::Param2},
      {body(0, 0, above(100)), Status::BadSpeed, ItemField::Param3},
      {earth(kNan, kInfinity), Status::NotANumber, ItemField::Param1},
      {earth(0, kNan, 101), Status::NotANumber, ItemField::Param2},
      {earth(0, 0, kNan).turning(turn(361)), Status::NotANumber, ItemField::Param3},
      {earth(-kInfinity, 0), Status::NotFinite, ItemField::Param1},
      {earth(0, kInfinity), Status::NotFinite, ItemField::Param2},
      {earth(0, 0, kInfinity), Status::NotFinite, ItemField::Param3},
      {body(1).turning(turn(360)), Status::Transferring, ItemField::None},
      {body(1).turning(turn(-360)), Status::Transferring, ItemField::None},
      {body(1).turning(turn(above(360))), Status::BadSpeed, ItemField::Param4},
      {earth(1, 0).turning(turn(-above(360))), Status::BadSpeed, ItemField::Param4},
      {earth(1, 0).turning(turn(kNan)), Status::NotANumber, ItemField::Param4},
      {earth(1, 0).turning(turn(kInfinity)), Status::NotFinite, ItemField::Param4},
      {earth(1, 0).facing(Yaw(360_deg)), Status::Transferring, ItemField::None},
      {earth(1, 0, 1).facing(-90_deg), Status::Transferring, ItemField::None},
  };
  for (const auto& one : kCases) CHECK((begun(kCopter, one.velocity, one.field) == one.status));
}

TEST_CASE("a rover neither climbs nor drives sideways, and over the ground it looks where it drives") {
  for (const Kind& kind : {kRover, kBoat}) {
    const struct {
      Velocity velocity;
      ItemField field;  // None: it is driven
    } kCases[] = {
        {earth(2, -1), ItemField::None},
        {earth(0, 0), ItemField::None},
        {earth(2, 0, -0.0f), ItemField::None},
        {body(-2), ItemField::None},
        {body(2, -0.0f).turning(turn(20)), ItemField::None},
        {earth(2, 0, 0.1f), ItemField::Param3},
        {body(2, 0, -0.1f), ItemField::Param3},
        {body(2, 1e-45f), ItemField::Param2},
        {body(2, -0.5f).turning(turn(20)), ItemField::Param2},
        {earth(2, 0).facing(0_deg), ItemField::Param4},
        {earth(2, 0).turning(turn(1)), ItemField::Param4},
    };
    for (const auto& one : kCases) {
      const bool isDriven = one.field == ItemField::None;
      const Status expected = isDriven ? Status::Transferring : Status::CommandUnsupported;
      CHECK((begun(kind, one.velocity, one.field) == expected));
    }
    CHECK((begun(kind, earth(101, 0), ItemField::Param1) == Status::BadSpeed));
  }
}

TEST_CASE("no other vehicle of ArduPilot's takes a velocity, nor another one of PX4's than a copter") {
  for (const Kind& kind : {kSubmarine, kPlane, kPx4Rover, kPx4Plane}) {
    CAPTURE(int{kind.type});
    CHECK((begun(kind, body(1), ItemField::None) == Status::CommandUnsupported));
  }
  CHECK((begun(kPx4Copter, body(1, 1, 1), ItemField::None) == Status::Transferring));
}

TEST_CASE("the first velocity is flown without another call, and a start() while it is flown changes nothing") {
  Flown flight(kCopter);
  flight.begin(body(2));
  CHECK(flight.last() == "body 2 0 0, yaw 0, turn 0, mask 0x5c7");
  CHECK((flight.velocity.renew(body(2)) == Status::Transferring));
  CHECK((flight.velocity.start(body(5)) == Status::Busy));
  flight.sent.clear();
  flight.pass(250);
  CHECK(flight.last() == "body 2 0 0, yaw 0, turn 0, mask 0x5c7");
}

TEST_CASE("before the vehicle is known a renewal is refused for its numbers alone, and then for what it is, too") {
  Flown flight(kRover);
  flight.inMission();
  flight.velocity.start(body(2));
  CHECK((flight.velocity.renew(body(2, 1)) == Status::Transferring));
  CHECK((flight.velocity.renew(body(2, 101)) == Status::BadSpeed));
  CHECK((flight.velocity.renew(body(2)) == Status::Transferring));
  REQUIRE((flight.end() == Status::Done));
  REQUIRE(flight.velocity.isFlown());
  CHECK((flight.velocity.renew(body(2, 1)) == Status::CommandUnsupported));
  CHECK((flight.client.differingField() == ItemField::Param2));
  CHECK((flight.velocity.renew(body(3)) == Status::Transferring));
}

TEST_CASE("a copter faces where it is told, by an angle from north, or keeps its heading") {
  Flown flight(kCopter);
  flight.begin(earth(1, 2));  // the turn counts, and is 0
  CHECK(flight.last() == "earth 1 2 0, yaw 0, turn 0, mask 0x5c7");
  // The heading counts, and no turn.
  CHECK(flight.flown(earth(1, 2, 3).facing(90_deg)) == "earth 1 2 -3, yaw 1.5708, turn 0, mask 0x9c7");
  CHECK(flight.flown(earth(1, 2).facing(0_deg)) == "earth 1 2 0, yaw 0, turn 0, mask 0x9c7");
  CHECK(flight.flown(earth(1, 2).turning(turn(-90))) == "earth 1 2 0, yaw 0, turn -1.5708, mask 0x5c7");
  // One that stands still over the ground stays one over the ground.
  CHECK(flight.flown(earth(0, 0, 1).facing(45_deg)) == "earth 0 0 -1, yaw 0.7854, turn 0, mask 0x9c7");
}

TEST_CASE("a rover drives where it looks, and one that stands still over the ground does not turn to the north") {
  Flown flight(kRover);
  flight.begin(earth(1, -2));
  CHECK(flight.last() == "earth 1 -2 0, yaw 0, turn 0, mask 0xdc7");  // the velocity alone
  CHECK(flight.flown(earth(1, 0)) == "earth 1 0 0, yaw 0, turn 0, mask 0xdc7");
  CHECK(flight.flown(earth(0, 1)) == "earth 0 1 0, yaw 0, turn 0, mask 0xdc7");
  CHECK(flight.flown(earth(-1, 0)) == "earth -1 0 0, yaw 0, turn 0, mask 0xdc7");
  CHECK(flight.flown(earth(0, -1)) == "earth 0 -1 0, yaw 0, turn 0, mask 0xdc7");
  CHECK(flight.flown(earth(0, -0.0f)) == "body 0 0 0, yaw 0, turn 0, mask 0x5c7");
  CHECK(flight.flown(body(-1).turning(turn(90))) == "body -1 0 0, yaw 0, turn 1.5708, mask 0x5c7");
  CHECK(flight.flown(body(0).turning(turn(90))) == "body 0 0 0, yaw 0, turn 1.5708, mask 0x5c7");
}

TEST_CASE("after a loop() that stood still for 0.6 s a heartbeat comes first, and then the velocity again") {
  Flown flight(kCopter);
  flight.begin(body(2)).silence();
  CHECK((flight.velocity.renew(body(2)) == Status::Transferring));
  flight.run(700, 700);
  flight.sent.clear();
  CHECK((flight.velocity.renew(body(2)) == Status::Transferring));
  CHECK(flight.wait(5).timesOf(kVelocity, 0).empty());
  flight.silence(false).pass(600);
  CHECK(flight.last() == "body 2 0 0, yaw 0, turn 0, mask 0x5c7");
  CHECK(flight.velocity.isFlown());
}
