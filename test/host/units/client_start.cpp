// start() and startMission() by a whole client: what is refused before anything leaves, and what each step says.
#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint8_t kDisarmed = 1, kArmed = 1 | 128;  // HEARTBEAT.base_mode
constexpr uint32_t kStabilize = 0, kAuto = 3;
constexpr uint32_t kPx4Mission = 4ul << 24 | 4ul << 16, kPx4Position = 3ul << 16;
constexpr uint16_t kSetCurrent = MAVLINK_MSG_ID_MISSION_SET_CURRENT, kCommand = MAVLINK_MSG_ID_COMMAND_LONG;
const MissionItem kPlan[] = {takeoff(20_m), changeSpeed(5_mps), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
                             returnToLaunch()};

// A vehicle whose heartbeats and answers the test gives.
struct Flight : ClientOnLine {
  const bool isPx4;
  uint8_t type = MAV_TYPE_QUADROTOR;
  uint8_t baseMode = kDisarmed;
  uint32_t mode = kStabilize;
  uint16_t flown = 1;                    // the item that it says it flies, in its own numbers
  uint16_t refusedOn = 0, silentOn = 0;  // the command that it refuses, or does not hear
  int firstItem = -1;                    // of MISSION_SET_CURRENT
  std::vector<uint16_t> orders;          // the commands that move something
  std::vector<float> parameters;         // and the first parameter of each

  explicit Flight(uint8_t autopilot = kArduPilot, uint8_t is = MAV_TYPE_QUADROTOR)
      : ClientOnLine(autopilot), isPx4(autopilot == kPx4), type(is) {
    beats = false;
    if (isPx4) mode = kPx4Position;
    fly(3000);
  }

  void beat() {
    mavlink_heartbeat_t message = mavlink_heartbeat_t();
    message.custom_mode = mode;
    message.type = type;
    message.autopilot = isPx4 ? MAV_AUTOPILOT_PX4 : MAV_AUTOPILOT_ARDUPILOTMEGA;
    message.base_mode = baseMode;
    message.system_status = MAV_STATE_ACTIVE;
    message.mavlink_version = 3;
    tell(0, 50, message);
  }
  template <typename Message>
  void tell(uint16_t id, uint8_t crcExtra, const Message& message) {
    Bytes payload(sizeof(Message));
    memcpy(payload.data(), &message, sizeof(Message));
    hear(FrameParts(id, payload, crcExtra));
  }
  // It beats once a second, and when it is asked to, and it obeys.
  void fly(uint32_t ms) {
    for (uint32_t at = 0; at < ms; at += 5) {
      if (nowMs() % 1000 < 5) beat();
      const size_t before = sent.size();
      run(5);
      for (size_t i = before; i < sent.size(); ++i) obey(SentFrame(sent[i]));
    }
  }
  void obey(const SentFrame& frame) {
    if (isForHeartbeat(frame)) return beat();
    if (frame.messageId == kSetCurrent) {
      firstItem = frame.payload[0] | frame.payload[1] << 8;
      current_ = static_cast<uint16_t>(firstItem == 0 && !isPx4 ? 1 : firstItem);
      return tellCurrent(current_, MISSION_STATE_NOT_STARTED);
    }
    if (frame.messageId != kCommand) return;
    const uint16_t command = commandOf(frame);
    if (command == MAV_CMD_DO_VTOL_TRANSITION) return;
    if (command == MAV_CMD_REQUEST_MESSAGE) return tellCurrent(mode == kAuto ? flown : current_);
    orders.push_back(command);
    parameters.push_back(paramOf(frame, 0));
    if (command == silentOn) return;
    const bool isRefused = command == refusedOn;
    if (!isRefused && command == MAV_CMD_DO_SET_MODE && !isPx4) mode = static_cast<uint32_t>(paramOf(frame, 1));
    if (!isRefused && command == MAV_CMD_DO_SET_MODE && isPx4) mode = kPx4Mission;
    if (!isRefused && command == MAV_CMD_MISSION_START) mode = isPx4 ? kPx4Mission : kAuto;
    if (!isRefused && command == MAV_CMD_MISSION_START && isPx4) baseMode = kArmed;
    if (!isRefused && command == MAV_CMD_COMPONENT_ARM_DISARM) baseMode = paramOf(frame, 0) == 1 ? kArmed : kDisarmed;
    answer(command, isRefused ? 4 : 0);
    beat();
  }
  static uint16_t commandOf(const SentFrame& frame) {
    return static_cast<uint16_t>(frame.payload[28] | frame.payload[29] << 8);
  }
  static float paramOf(const SentFrame& frame, size_t index) {
    float value;
    memcpy(&value, &frame.payload[4 * index], sizeof(value));
    return value;
  }
  static bool isForHeartbeat(const SentFrame& frame) {
    return frame.messageId == kCommand && commandOf(frame) == MAV_CMD_REQUEST_MESSAGE && paramOf(frame, 0) == 0;
  }
  void answer(uint16_t command, uint8_t result) {
    hear(FrameParts(
        77, {static_cast<uint8_t>(command), static_cast<uint8_t>(command >> 8), result, 0, 0, 0, 0, 0, 1, 191}, 143));
  }
  void tellCurrent(uint16_t item, uint8_t state = MISSION_STATE_ACTIVE, uint16_t total = 4) {
    mavlink_mission_current_t message = mavlink_mission_current_t();
    message.seq = item;
    message.total = total;
    message.mission_state = state;
    tell(MAVLINK_MSG_ID_MISSION_CURRENT, MAVLINK_MSG_ID_MISSION_CURRENT_CRC, message);
  }
  void upload() {
    client.upload(inRam(kPlan));
    fly(100);
    const uint16_t items = isPx4 ? 4 : 5;
    for (uint16_t item = 0; item < items; ++item) {
      hear(requestParts(item));
      fly(10);
    }
    hear(ackParts(0));
    fly(10);
    REQUIRE((client.aboard() == Aboard::OurPlan));
    sent.clear();
    ended = Status::Idle;
  }
  Status refusal() {
    ended = Status::Idle;
    fly(1200);
    CHECK(orders.empty());
    CHECK(firstItem == -1);
    return ended;
  }

 private:
  uint16_t current_ = 1;
};

}  // namespace

TEST_CASE(
    "a start is refused before anything leaves: without our plan, while it is armed, for an item that is not there") {
  Flight flight;
  flight.client.start();
  CHECK((flight.refusal() == Status::Unproven));
  flight.upload();
  flight.client.start(4);
  CHECK((flight.refusal() == Status::NoSuchItem));
  flight.client.start(65535);
  CHECK((flight.refusal() == Status::NoSuchItem));
  flight.baseMode = kArmed;
  flight.fly(1100);
  flight.client.start();
  CHECK((flight.refusal() == Status::Armed));
  flight.client.allowWhileArmed(true);
  flight.client.start();
  CHECK((flight.client.start(2) == Status::Busy));
  flight.fly(5000);
  CHECK((flight.ended == Status::Done));
  CHECK(flight.firstItem == 0);
}

TEST_CASE("a vehicle whose modes are not known is not started") {
  Flight flight(ClientOnLine::kArduPilot, MAV_TYPE_ROCKET);
  flight.upload();
  flight.client.start();
  CHECK((flight.refusal() == Status::NoSuchMode));
  flight.baseMode = kArmed;
  flight.fly(1100);
  flight.client.startMission();
  CHECK((flight.refusal() == Status::NoSuchMode));
}

TEST_CASE("ArduPilot is given its own number of the item where the start begins, and 0 for the first one") {
  for (uint16_t item : {0, 1, 2, 3}) {
    Flight flight;
    flight.upload();
    flight.client.start(item);
    flight.fly(2000);
    CHECK(flight.firstItem == (item == 0 ? 0 : item + 1));
  }
}

TEST_CASE("a copter is started step by step, and flies to the first item that can be flown to, or to another one") {
  for (uint16_t flown : {1, 3, 4}) {
    Flight flight;
    flight.upload();
    flight.flown = flown;
    flight.client.start();
    CHECK((flight.client.startArming() == StartArming::Untouched));
    flight.fly(15000);
    CHECK(flight.orders ==
          std::vector<uint16_t>{MAV_CMD_DO_SET_MODE, MAV_CMD_COMPONENT_ARM_DISARM, MAV_CMD_MISSION_START});
    CHECK(flight.parameters.back() == 0);
    CHECK(flight.mode == kAuto);
    CHECK((flight.client.startArming() == StartArming::Armed));
    CHECK((flight.ended == (flown == 1 ? Status::Done : Status::OtherItem)));
    if (flown != 1) CHECK(flight.client.failedItem() == flown - 1);
  }
}

TEST_CASE("a start from a command begins with the next item that can be flown to") {
  Flight flight;
  flight.upload();
  flight.flown = 3;
  flight.client.start(1);
  flight.fly(15000);
  CHECK((flight.ended == Status::Done));
}

TEST_CASE("a step that is refused is the status, and what has been armed is disarmed") {
  const struct {
    uint16_t command;
    StartStep step;
    StartArming arming;
  } kRefusals[] = {{MAV_CMD_COMPONENT_ARM_DISARM, StartStep::Arm, StartArming::Untouched},
                   {MAV_CMD_DO_SET_MODE, StartStep::ReadyMode, StartArming::Untouched},
                   {MAV_CMD_MISSION_START, StartStep::Begin, StartArming::Disarmed}};
  for (const auto& one : kRefusals) {
    Flight flight;
    flight.upload();
    flight.refusedOn = one.command;
    flight.client.start();
    flight.fly(15000);
    CHECK((flight.ended == Status::CommandFailed));
    CHECK((flight.client.startStep() == one.step));
    CHECK((flight.client.startArming() == one.arming));
    CHECK(flight.baseMode == kDisarmed);
  }
}

TEST_CASE("a step without an answer is told as such") {
  Flight flight;
  flight.upload();
  flight.silentOn = MAV_CMD_COMPONENT_ARM_DISARM;
  flight.client.start();
  flight.fly(20000);
  CHECK((flight.ended == Status::NoAnswer));
  CHECK((flight.client.startStep() == StartStep::Arm));
}

TEST_CASE("another plan that is named meanwhile is the end, and it is known that it is aboard") {
  Flight flight;
  flight.upload();
  flight.silentOn = MAV_CMD_COMPONENT_ARM_DISARM;
  flight.client.start();
  flight.fly(3000);
  for (int i = 0; i < 3; ++i) {
    flight.tellCurrent(1, MISSION_STATE_NOT_STARTED, 9);
    flight.fly(1000);
  }
  CHECK((flight.ended == Status::Unproven));
  CHECK((flight.client.aboard() == Aboard::OtherPlan));
}

TEST_CASE("PX4 is started with the item as the command's parameter") {
  for (uint16_t item : {0, 2}) {
    Flight flight(ClientOnLine::kPx4);
    flight.upload();
    flight.client.start(item);
    flight.fly(4000);
    REQUIRE(!flight.orders.empty());
    CHECK(flight.orders.back() == MAV_CMD_MISSION_START);
    CHECK(flight.parameters.back() == item);
  }
}

TEST_CASE("startMission() is for an armed aircraft") {
  for (uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    Flight flight(autopilot);
    flight.client.startMission();
    CHECK((flight.refusal() == Status::NotArmed));
  }
}

TEST_CASE("startMission() of an ArduPilot in AUTO waits for the answer to its command") {
  Flight flight;
  flight.baseMode = kArmed;
  flight.mode = kAuto;
  flight.fly(1100);
  flight.silentOn = MAV_CMD_MISSION_START;
  flight.client.startMission();
  flight.fly(1200);
  CHECK(flight.orders == std::vector<uint16_t>{MAV_CMD_MISSION_START});
  CHECK(flight.client.isBusy());
  flight.answer(MAV_CMD_MISSION_START, 0);
  flight.fly(1100);
  CHECK((flight.ended == Status::Done));
}

TEST_CASE("startMission() of a PX4 sets its mode, and sends nothing that arms") {
  Flight flight(ClientOnLine::kPx4);
  flight.baseMode = kArmed;
  flight.fly(1100);
  flight.client.startMission();
  flight.fly(2200);
  CHECK((flight.ended == Status::Done));
  CHECK(flight.orders == std::vector<uint16_t>{MAV_CMD_DO_SET_MODE});
  CHECK(flight.mode == kPx4Mission);
}
