// Adjustments: what a copter is told of its heading and its speeds up and down, and which numbers are refused.
#include "mavmission/steering/Adjustments.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <limits>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint16_t kCommandLong = MAVLINK_MSG_ID_COMMAND_LONG;
constexpr uint32_t kAuto = 3, kLoiter = 5, kRtl = 6;  // ArduCopter's modes
constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

// An aircraft that follows its mission, with a sketch that may steer it.
struct Flown : ClientOnLine {
  Steering steering;
  Adjustments adjustments;
  const uint8_t autopilot, type;
  uint32_t mode = kAuto;
  uint8_t result = MAV_RESULT_ACCEPTED;
  std::vector<mavlink_command_long_t> commands;  // but for requests of heartbeats
  uint32_t answerMs = 0;                         // when the heartbeat that was asked for comes

  explicit Flown(uint8_t madeBy = kArduPilot, uint8_t itsType = MAV_TYPE_QUADROTOR)
      : ClientOnLine(madeBy), steering(client), adjustments(steering), autopilot(madeBy), type(itsType) {
    beats = false;
    client.allowWhileArmed(true);
    pass(3000);
  }

  void show() {
    mavlink_heartbeat_t message = mavlink_heartbeat_t();
    message.custom_mode = mode;
    message.type = type;
    message.autopilot = autopilot;
    message.base_mode = MAV_MODE_FLAG_CUSTOM_MODE_ENABLED | MAV_MODE_FLAG_SAFETY_ARMED;
    message.system_status = MAV_STATE_ACTIVE;
    message.mavlink_version = 3;
    Bytes payload(sizeof(message));
    memcpy(payload.data(), &message, sizeof(message));
    hear(FrameParts(MAVLINK_MSG_ID_HEARTBEAT, payload, MAVLINK_MSG_ID_HEARTBEAT_CRC));
  }

  void pass(uint32_t ms) {
    for (; ms != 0; --ms) {
      if (nowMs() == answerMs || nowMs() % 1000 == 0) show();
      const size_t before = sent.size();
      run(1);
      for (size_t i = before; i < sent.size(); ++i) take(sent[i]);
    }
  }
  void take(const SentFrame& frame) {
    if (frame.messageId != kCommandLong) return;
    mavlink_command_long_t command;
    memcpy(&command, frame.payload.data(), sizeof(command));
    if (command.command == MAV_CMD_REQUEST_MESSAGE) {
      answerMs = nowMs() + 25;
      return;
    }
    commands.push_back(command);
    const uint8_t low = static_cast<uint8_t>(command.command), high = static_cast<uint8_t>(command.command >> 8);
    hear(FrameParts(MAVLINK_MSG_ID_COMMAND_ACK, {low, high, result, 0, 0, 0, 0, 0, 1, 191},
                    MAVLINK_MSG_ID_COMMAND_ACK_CRC));
  }

  // What an operation that has just begun comes to.
  Status end() {
    ended = Status::Idle;
    commands.clear();
    pass(500);
    CHECK_FALSE(client.isBusy());
    return ended;
  }
  // The same, if it must not be sent: the number that is wrong is this one.
  Status refused(ItemField field) {
    sent.clear();
    const Status status = end();
    CHECK(timesOf(kCommandLong, 0).empty());  // nor is a heartbeat asked for
    CHECK((client.differingField() == field));
    return status;
  }
};

constexpr DegreesPerSecond perSecond(float degrees) { return DegreesPerSecond(degrees); }
constexpr MetresPerSecond speed(float metres) { return MetresPerSecond(metres); }

// A heading that was computed.
Yaw yaw(float degrees) { return Yaw(Degrees::fromE7(static_cast<int32_t>(degrees * 1e7f))); }

}  // namespace

TEST_CASE("a heading is one from 0 to 360 degrees on the wire, with its turn, and done when it is acknowledged") {
  const struct {
    Yaw heading;
    float told;
  } kHeadings[] = {{90_deg, 90},       {-90_deg, 270}, {0_deg, 0},      {yaw(200.25f), 200.25f},
                   {-0.5_deg, 359.5f}, {180_deg, 180}, {-180_deg, 180}, {yaw(0.01f), 0.01f}};
  Flown flight;
  for (const auto& one : kHeadings) {
    CAPTURE(one.told);
    flight.adjustments.turnTo(one.heading, perSecond(30.5f));
    CHECK((flight.end() == Status::Done));
    REQUIRE(flight.commands.size() == 1);
    const mavlink_command_long_t& command = flight.commands[0];
    CHECK((command.command == MAV_CMD_CONDITION_YAW));
    CHECK(float{command.param1} == doctest::Approx(one.told));
    CHECK((command.param2 == 30.5f));
    CHECK((command.param3 == 0));
    CHECK((command.param4 == 0));
    CHECK((command.target_system == 1));
    CHECK((command.target_component == 1));
  }
  flight.adjustments.turnTo(90_deg);
  CHECK((flight.end() == Status::Done));
  CHECK((flight.commands.at(0).param2 == 0));
  CHECK(flight.mode == kAuto);
}

TEST_CASE("a speed upwards or downwards is told alone") {
  for (bool isClimb : {true, false}) {
    for (float metres : {1e-45f, 0.005f, 1.5f, 20.0f}) {
      Flown flight;
      isClimb ? flight.adjustments.setClimbSpeed(speed(metres)) : flight.adjustments.setDescentSpeed(speed(metres));
      CHECK((flight.end() == Status::Done));
      REQUIRE(flight.commands.size() == 1);
      const mavlink_command_long_t& command = flight.commands[0];
      CHECK((command.command == MAV_CMD_DO_CHANGE_SPEED));
      CHECK((command.param1 == (isClimb ? 2 : 3)));
      CHECK((command.param2 == metres));
      CHECK((command.param3 == -1));
      CHECK((command.param4 == 0));
    }
  }
}

TEST_CASE("the numbers of a turn that are refused are named") {
  const struct {
    Yaw heading;
    float turn;
    Status status;
    ItemField field;
  } kCases[] = {
      {360_deg, 360, Status::Done, ItemField::None},
      {-180_deg, -0.0f, Status::Done, ItemField::None},
      {WideHeading(3600001000), 0, Status::BadRange, ItemField::Param1},
      {Yaw(), 0, Status::NotANumber, ItemField::Param1},
      {Yaw(), 400, Status::NotANumber, ItemField::Param1},
      {WideHeading(4000000000), -1, Status::BadRange, ItemField::Param2},
      {0_deg, -1e-45f, Status::BadRange, ItemField::Param2},
      {0_deg, 360.0001f, Status::BadRange, ItemField::Param2},
      {0_deg, -30, Status::BadRange, ItemField::Param2},
      {0_deg, kInfinity, Status::NotFinite, ItemField::Param2},
      {0_deg, kNan, Status::NotANumber, ItemField::Param2},
  };
  for (const auto& one : kCases) {
    CAPTURE(one.heading.inDegrees());
    CAPTURE(one.turn);
    Flown flight;
    flight.adjustments.turnTo(one.heading, perSecond(one.turn));
    const Status status = one.field == ItemField::None ? flight.end() : flight.refused(one.field);
    CHECK((status == one.status));
  }
}

TEST_CASE("a speed is above 0, and at most 20 m/s") {
  for (bool isClimb : {true, false}) {
    const struct {
      float metres;
      Status status;
    } kCases[] = {{0, Status::BadSpeed},          {-0.0f, Status::BadSpeed}, {-1, Status::BadSpeed},
                  {20.00001f, Status::BadSpeed},  {1e9f, Status::BadSpeed},  {kInfinity, Status::NotFinite},
                  {-kInfinity, Status::BadSpeed}, {kNan, Status::NotANumber}};
    for (const auto& one : kCases) {
      CAPTURE(one.metres);
      Flown flight;
      isClimb ? flight.adjustments.setClimbSpeed(speed(one.metres))
              : flight.adjustments.setDescentSpeed(speed(one.metres));
      CHECK((flight.refused(ItemField::Param2) == one.status));
    }
  }
}

TEST_CASE("no other vehicle than ArduCopter takes any of them") {
  const struct {
    uint8_t autopilot, type;
    uint32_t autoMode;
  } kOthers[] = {{ClientOnLine::kArduPilot, MAV_TYPE_GROUND_ROVER, 10},
                 {ClientOnLine::kArduPilot, MAV_TYPE_SUBMARINE, 3},
                 {ClientOnLine::kArduPilot, MAV_TYPE_FIXED_WING, 10},
                 {ClientOnLine::kPx4, MAV_TYPE_QUADROTOR, 4ul << 24 | 4ul << 16}};
  for (const auto& other : kOthers) {
    CAPTURE(int{other.type});
    for (bool isPilots : {false, true}) {
      Flown flight(other.autopilot, other.type);
      flight.mode = other.autoMode;
      if (isPilots) flight.mode = other.autopilot == ClientOnLine::kPx4 ? 3ul << 16 : 0;  // whoever has it
      flight.pass(1500);
      flight.adjustments.turnTo(90_deg, perSecond(-1));
      CHECK((flight.refused(ItemField::None) == Status::CommandUnsupported));
      flight.adjustments.setClimbSpeed(1_mps);
      CHECK((flight.refused(ItemField::None) == Status::CommandUnsupported));
      flight.adjustments.setDescentSpeed(1_mps);
      CHECK((flight.refused(ItemField::None) == Status::CommandUnsupported));
    }
  }
}

TEST_CASE("nothing is adjusted for a pilot, or a failsafe") {
  for (uint32_t mode : {kLoiter, kRtl}) {
    Flown flight;
    flight.mode = mode;
    flight.pass(1500);
    flight.adjustments.turnTo(90_deg);
    CHECK((flight.refused(ItemField::None) == (mode == kRtl ? Status::FailsafeHasIt : Status::PilotHasIt)));
  }
}

TEST_CASE("while another operation runs none begins, and what runs is not changed") {
  Flown flight;
  CHECK((flight.adjustments.turnTo(90_deg, perSecond(20)) != Status::Busy));
  CHECK((flight.adjustments.turnTo(45_deg, perSecond(10)) == Status::Busy));
  CHECK((flight.adjustments.setClimbSpeed(3_mps) == Status::Busy));
  CHECK((flight.adjustments.setDescentSpeed(3_mps) == Status::Busy));
  CHECK((flight.end() == Status::Done));
  REQUIRE(flight.commands.size() == 1);
  CHECK((flight.commands[0].command == MAV_CMD_CONDITION_YAW));
  CHECK((flight.commands[0].param1 == 90));
  CHECK((flight.commands[0].param2 == 20));
}

TEST_CASE("a refusal of the autopilot's is the end") {
  Flown flight;
  flight.result = MAV_RESULT_DENIED;
  flight.adjustments.setClimbSpeed(3_mps);
  CHECK((flight.end() == Status::CommandDenied));
}
