// VelocityTarget by a whole client: what a velocity is on the wire, and that it ends in standing still.
#include <doctest/doctest.h>
#include <string.h>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint16_t kCommandInt = 75, kCommandLong = 76, kVelocity = 84;
constexpr uint32_t kAuto = 3, kGuided = 4, kLoiter = 5;  // ArduCopter's modes

// A copter that flies its mission, and a sketch that takes it over with a velocity.
struct Flown : ClientOnLine {
  Steering steering;
  VelocityTarget velocity;
  uint32_t mode = kAuto;
  uint32_t answerMs = 0;  // when the heartbeat that was asked for comes

  Flown() : ClientOnLine(kArduPilot), steering(client), velocity(steering) {
    beats = false;
    client.allowWhileArmed(true);
    pass(3000);
  }

  void show() {
    mavlink_heartbeat_t message = mavlink_heartbeat_t();
    message.custom_mode = mode;
    message.type = MAV_TYPE_QUADROTOR;
    message.autopilot = MAV_AUTOPILOT_ARDUPILOTMEGA;
    message.base_mode = 1 | 128;  // armed
    message.system_status = MAV_STATE_ACTIVE;
    message.mavlink_version = 3;
    Bytes payload(sizeof(message));
    memcpy(payload.data(), &message, sizeof(message));
    hear(FrameParts(0, payload, 50));
  }

  // As loop() does, with a heartbeat each quarter of a second, or when it is asked for one.
  void pass(uint32_t ms) {
    for (; ms != 0; --ms) {
      if (nowMs() == answerMs || nowMs() % 250 == 0) show();
      velocity.update();
      run(1);
      if (sent.empty() || sent.back().atMs != nowMs() || sent.back().messageId != kCommandLong) continue;
      if (commandOf(sent.back()) == MAV_CMD_REQUEST_MESSAGE) answerMs = nowMs() + 25;
      if (commandOf(sent.back()) == MAV_CMD_DO_SET_MODE) mode = kGuided;
    }
  }

  static uint16_t commandOf(const SentFrame& frame) {
    return static_cast<uint16_t>(frame.payload[28] | frame.payload[29] << 8);
  }

  void begin(const Velocity& first) {
    velocity.start(first);
    pass(600);
    REQUIRE(velocity.isFlown());
    sent.clear();
  }

  // The hold is under way: its first step is to ask for the position.
  bool asksForPlace() const {
    for (const SentFrame& frame : sent) {
      if (frame.messageId == kCommandLong && commandOf(frame) == MAV_CMD_SET_MESSAGE_INTERVAL) return true;
    }
    return false;
  }

  // The last one that has left.
  mavlink_set_position_target_local_ned_t last() const {
    mavlink_set_position_target_local_ned_t message = mavlink_set_position_target_local_ned_t();
    for (const SentFrame& frame : sent) {
      if (frame.messageId == kVelocity) memcpy(&message, frame.payload.data(), sizeof(message));
    }
    return message;
  }
};

}  // namespace

TEST_CASE("a velocity is that of the sketch, in the frame and with the turn that it names") {
  Flown flight;
  flight.begin(EarthVelocity(2_mps, MetresPerSecond(-1), 3_mps));
  for (int i = 0; i < 6; ++i) {
    CHECK((flight.velocity.renew(BodyVelocity(1_mps, 2_mps, MetresPerSecond(-3)).turning(180_dps)) ==
           Status::Transferring));
    flight.pass(100);
  }
  const mavlink_set_position_target_local_ned_t message = flight.last();
  // As copies: the message's own fields need not be aligned.
  CHECK(float{message.vx} == 1.0f);
  CHECK(float{message.vy} == 2.0f);
  CHECK(float{message.vz} == 3.0f);
  CHECK(float{message.yaw_rate} == doctest::Approx(3.1415927f));
  CHECK(uint8_t{message.coordinate_frame} == MAV_FRAME_BODY_NED);
  CHECK(uint16_t{message.type_mask} == 0x05C7);
}

TEST_CASE("a velocity that is not renewed is one of 0, and then the aircraft is told where to stay") {
  Flown flight;
  flight.begin(EarthVelocity(2_mps, 0_mps).facing(90_deg));
  flight.pass(1500);
  CHECK(float{flight.last().vx} == 0.0f);
  CHECK((flight.velocity.status() == Status::Transferring));
  CHECK((flight.velocity.renew(EarthVelocity(2_mps, 0_mps)) == Status::NotRenewed));
  CHECK_FALSE(flight.asksForPlace());
  flight.sent.clear();
  flight.pass(2500);
  for (const SentFrame& frame : flight.sent) {
    if (frame.messageId != kVelocity) continue;
    mavlink_set_position_target_local_ned_t message;
    memcpy(&message, frame.payload.data(), sizeof(message));
    CHECK(float{message.vx} == 0.0f);
    CHECK(float{message.yaw_rate} == 0.0f);
    CHECK(uint16_t{message.type_mask} == 0x05C7);
  }
  CHECK(flight.asksForPlace());
}

TEST_CASE("a heartbeat with a pilot's mode ends the velocities, at once and for good") {
  Flown flight;
  flight.begin(BodyVelocity(2_mps));
  flight.velocity.stop();
  flight.pass(300);
  flight.mode = kLoiter;
  flight.pass(260);
  flight.sent.clear();
  CHECK((flight.velocity.status() == Status::PilotHasIt));
  flight.mode = kGuided;
  CHECK((flight.velocity.renew(BodyVelocity(2_mps)) == Status::PilotHasIt));
  flight.pass(3000);
  CHECK(flight.timesOf(kVelocity, 0).empty());
  CHECK(flight.timesOf(kCommandInt, 0).empty());
}

TEST_CASE("one stream at a time: a place that is followed ends the velocity without a gap, and a velocity ends it") {
  Flown flight;
  MovingTarget place(flight.steering);
  flight.begin(BodyVelocity(2_mps));
  const LatLon here = {1_deg, 1_deg};
  for (bool isPlace : {true, false}) {
    flight.hear(FrameParts(33, Bytes(28, 1), 104));  // its position
    flight.pass(1);
    isPlace ? place.start(here, 20_m) : flight.velocity.start(BodyVelocity(2_mps));
    flight.sent.clear();
    for (int ms = 0; ms < 2000; ++ms) {
      place.renew(here, 20_m);
      flight.velocity.renew(BodyVelocity(2_mps));
      place.update();
      flight.pass(1);
    }
    CHECK(place.isFollowed() == isPlace);
    CHECK(flight.velocity.isFlown() != isPlace);
    const std::vector<uint32_t> places = flight.timesOf(86, 0), velocities = flight.timesOf(kVelocity, 0);
    const std::vector<uint32_t>&ended = isPlace ? velocities : places, &begun = isPlace ? places : velocities;
    REQUIRE_FALSE(begun.empty());
    CHECK((ended.empty() || ended.back() <= begun.front()));
    CHECK(((isPlace ? flight.velocity.status() : place.status()) == Status::Cancelled));
  }
}
