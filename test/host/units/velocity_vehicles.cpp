// VelocityTarget: which velocities each vehicle takes, what is wrong with the others, and what a rover is sent.
#include <doctest/doctest.h>
#include <string.h>

#include <limits>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint16_t kCommandLong = MAVLINK_MSG_ID_COMMAND_LONG, kVelocity = MAVLINK_MSG_ID_SET_POSITION_TARGET_LOCAL_NED;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

struct Kind {
  uint8_t autopilot, type;
  uint32_t autoMode, guided;
};
constexpr Kind kCopter = {ClientOnLine::kArduPilot, MAV_TYPE_QUADROTOR, 3, 4};
constexpr Kind kRover = {ClientOnLine::kArduPilot, MAV_TYPE_GROUND_ROVER, 10, 15};
constexpr Kind kBoat = {ClientOnLine::kArduPilot, MAV_TYPE_SURFACE_BOAT, 10, 15};
constexpr Kind kSubmarine = {ClientOnLine::kArduPilot, MAV_TYPE_SUBMARINE, 3, 4};
constexpr Kind kPlane = {ClientOnLine::kArduPilot, MAV_TYPE_FIXED_WING, 10, 15};
constexpr uint32_t kPx4Mission = 4ul << 24 | 4ul << 16;
constexpr Kind kPx4Copter = {ClientOnLine::kPx4, MAV_TYPE_QUADROTOR, kPx4Mission, 6ul << 16};
constexpr Kind kPx4Rover = {ClientOnLine::kPx4, MAV_TYPE_GROUND_ROVER, kPx4Mission, 6ul << 16};
constexpr Kind kPx4Plane = {ClientOnLine::kPx4, MAV_TYPE_FIXED_WING, kPx4Mission, 6ul << 16};

// One that follows its mission, armed, and a sketch that takes it over.
struct Flown : ClientOnLine {
  Steering steering;
  VelocityTarget velocity;
  const Kind kind;
  uint32_t mode;
  uint32_t answerMs = 0;  // when the heartbeat that was asked for comes

  explicit Flown(const Kind& it)
      : ClientOnLine(it.autopilot), steering(client), velocity(steering), kind(it), mode(it.autoMode) {
    beats = false;
    client.allowWhileArmed(true);
    pass(3000);
  }

  void show() {
    mavlink_heartbeat_t message = mavlink_heartbeat_t();
    message.custom_mode = mode;
    message.type = kind.type;
    message.autopilot = kind.autopilot;
    message.base_mode = MAV_MODE_FLAG_CUSTOM_MODE_ENABLED | MAV_MODE_FLAG_SAFETY_ARMED;
    message.system_status = MAV_STATE_ACTIVE;
    message.mavlink_version = 3;
    Bytes payload(sizeof(message));
    memcpy(payload.data(), &message, sizeof(message));
    hear(FrameParts(MAVLINK_MSG_ID_HEARTBEAT, payload, MAVLINK_MSG_ID_HEARTBEAT_CRC));
  }

  // As loop() does, with a heartbeat each quarter of a second, or when it is asked for one.
  void pass(uint32_t ms) {
    for (; ms != 0; --ms) {
      if (nowMs() == answerMs || nowMs() % 250 == 0) show();
      velocity.update();
      run(1);
      if (sent.empty() || sent.back().atMs != nowMs() || sent.back().messageId != kCommandLong) continue;
      mavlink_command_long_t command;
      memcpy(&command, sent.back().payload.data(), sizeof(command));
      if (command.command == MAV_CMD_REQUEST_MESSAGE) answerMs = nowMs() + 25;
      if (command.command == MAV_CMD_DO_SET_MODE) mode = kind.guided;
    }
  }

  void begin(const Velocity& first) {
    velocity.start(first);
    pass(600);
    REQUIRE(velocity.isFlown());
    sent.clear();
    pass(250);
  }

  // Of what it flies now, the last message.
  mavlink_set_position_target_local_ned_t flown(const Velocity& it) {
    CHECK((velocity.renew(it) == Status::Transferring));
    sent.clear();
    pass(450);
    return last();
  }
  mavlink_set_position_target_local_ned_t last() const {
    mavlink_set_position_target_local_ned_t message = mavlink_set_position_target_local_ned_t();
    for (const SentFrame& frame : sent) {
      if (frame.messageId == kVelocity) memcpy(&message, frame.payload.data(), sizeof(message));
    }
    return message;
  }
};

// What start() comes to for a vehicle; Transferring: it is flown.
Status begun(const Kind& kind, const Velocity& velocity, ItemField field) {
  Flown flight(kind);
  flight.sent.clear();
  flight.ended = Status::Idle;
  flight.velocity.start(velocity);
  flight.pass(5);
  if (flight.client.isBusy()) return Status::Transferring;
  CHECK((flight.client.differingField() == field));
  CHECK(flight.timesOf(kCommandLong, 0).empty());
  CHECK((flight.velocity.status() == flight.ended));
  return flight.ended;
}

constexpr EarthVelocity earth(float north, float east, float up = 0) {
  return EarthVelocity(MetresPerSecond(north), MetresPerSecond(east), MetresPerSecond(up));
}
constexpr BodyVelocity body(float forward, float right = 0, float up = 0) {
  return BodyVelocity(MetresPerSecond(forward), MetresPerSecond(right), MetresPerSecond(up));
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
  CHECK(float{flight.last().vx} == 2.0f);
  CHECK(uint8_t{flight.last().coordinate_frame} == MAV_FRAME_BODY_NED);
  CHECK((flight.velocity.renew(body(2)) == Status::Transferring));
  CHECK((flight.velocity.start(body(5)) == Status::Busy));
  flight.sent.clear();
  flight.pass(250);
  CHECK(float{flight.last().vx} == 2.0f);
}

TEST_CASE("before the vehicle is known a renewal is refused for its numbers alone, and then for what it is, too") {
  Flown flight(kRover);
  flight.velocity.start(body(2));
  CHECK((flight.velocity.renew(body(2, 1)) == Status::Transferring));
  CHECK((flight.velocity.renew(body(2, 101)) == Status::BadSpeed));
  CHECK((flight.velocity.renew(body(2)) == Status::Transferring));
  flight.pass(600);
  REQUIRE(flight.velocity.isFlown());
  CHECK((flight.velocity.renew(body(2, 1)) == Status::CommandUnsupported));
  CHECK((flight.client.differingField() == ItemField::Param2));
  CHECK((flight.velocity.renew(body(3)) == Status::Transferring));
}

TEST_CASE("a copter faces where it is told, by an angle from north, or keeps its heading") {
  Flown flight(kCopter);
  flight.begin(earth(1, 2));
  CHECK(uint16_t{flight.last().type_mask} == 0x05C7);  // the turn counts, and is 0
  CHECK(float{flight.last().yaw_rate} == 0.0f);
  CHECK(uint8_t{flight.last().coordinate_frame} == MAV_FRAME_LOCAL_NED);
  const mavlink_set_position_target_local_ned_t facing = flight.flown(earth(1, 2, 3).facing(90_deg));
  CHECK(float{facing.yaw} == doctest::Approx(1.5707963f));
  CHECK(uint16_t{facing.type_mask} == 0x09C7);  // the heading counts, and no turn
  CHECK(float{facing.vx} == 1.0f);
  CHECK(float{facing.vy} == 2.0f);
  CHECK(float{facing.vz} == -3.0f);
  const mavlink_set_position_target_local_ned_t north = flight.flown(earth(1, 2).facing(0_deg));
  CHECK(float{north.yaw} == 0.0f);
  CHECK(uint16_t{north.type_mask} == 0x09C7);
  const mavlink_set_position_target_local_ned_t turning = flight.flown(earth(1, 2).turning(turn(-90)));
  CHECK(float{turning.yaw_rate} == doctest::Approx(-1.5707963f));
  CHECK(uint16_t{turning.type_mask} == 0x05C7);
  // One that stands still over the ground stays one over the ground.
  const mavlink_set_position_target_local_ned_t still = flight.flown(earth(0, 0, 1).facing(45_deg));
  CHECK(uint8_t{still.coordinate_frame} == MAV_FRAME_LOCAL_NED);
  CHECK(float{still.vz} == -1.0f);
  CHECK(uint16_t{still.type_mask} == 0x09C7);
}

TEST_CASE("a rover drives where it looks, and one that stands still over the ground does not turn to the north") {
  Flown flight(kRover);
  flight.begin(earth(1, -2));
  CHECK(uint8_t{flight.last().coordinate_frame} == MAV_FRAME_LOCAL_NED);
  CHECK(uint16_t{flight.last().type_mask} == 0x0DC7);  // the velocity alone
  CHECK(float{flight.last().vx} == 1.0f);
  CHECK(float{flight.last().vy} == -2.0f);
  const Velocity kMoving[] = {earth(1, 0), earth(0, 1), earth(-1, 0), earth(0, -1)};
  for (const Velocity& moving : kMoving) {
    const mavlink_set_position_target_local_ned_t message = flight.flown(moving);
    CHECK(uint8_t{message.coordinate_frame} == MAV_FRAME_LOCAL_NED);
    CHECK(uint16_t{message.type_mask} == 0x0DC7);
  }
  const mavlink_set_position_target_local_ned_t still = flight.flown(earth(0, -0.0f));
  CHECK(uint8_t{still.coordinate_frame} == MAV_FRAME_BODY_NED);
  CHECK(uint16_t{still.type_mask} == 0x05C7);
  CHECK(float{still.vx} == 0.0f);
  CHECK(float{still.yaw_rate} == 0.0f);
  const mavlink_set_position_target_local_ned_t back = flight.flown(body(-1).turning(turn(90)));
  CHECK(uint8_t{back.coordinate_frame} == MAV_FRAME_BODY_NED);
  CHECK(uint16_t{back.type_mask} == 0x05C7);
  CHECK(float{back.vx} == -1.0f);
  CHECK(float{back.yaw_rate} == doctest::Approx(1.5707963f));
  const mavlink_set_position_target_local_ned_t spinning = flight.flown(body(0).turning(turn(90)));
  CHECK(float{spinning.yaw_rate} == doctest::Approx(1.5707963f));
}

TEST_CASE("behind a loop() that stood still for 0.6 s a heartbeat comes first, and then the velocity again") {
  Flown flight(kCopter);
  flight.begin(body(2));
  CHECK((flight.velocity.renew(body(2)) == Status::Transferring));
  flight.run(700, 700);
  flight.sent.clear();
  CHECK((flight.velocity.renew(body(2)) == Status::Transferring));
  flight.velocity.update();
  flight.run(1);
  CHECK(flight.timesOf(kVelocity, 0).empty());
  flight.pass(600);
  CHECK_FALSE(flight.timesOf(kVelocity, 0).empty());
  CHECK(float{flight.last().vx} == 2.0f);
  CHECK(flight.velocity.isFlown());
}
