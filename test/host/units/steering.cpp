// Steering by a whole client: whose aircraft it is, and what is sent when.
#include <doctest/doctest.h>
#include <string.h>

#include <cmath>
#include <initializer_list>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint16_t kCommandInt = 75, kCommandLong = 76;
constexpr uint8_t kDisarmed = 1, kArmed = 1 | 128;  // HEARTBEAT.base_mode
constexpr uint8_t kStandby = 3, kActive = 4, kCritical = 5;
constexpr uint32_t kAuto = 3, kGuided = 4, kLoiter = 5, kRtl = 6, kLand = 9;  // ArduCopter's modes
constexpr LatLon kPlace = {-35.3630000_deg, 149.1652374_deg};

// A copter whose heartbeats the test sends.
struct Flown : ClientOnLine {
  Steering steering;

  explicit Flown(uint8_t baseMode = kDisarmed, uint32_t mode = 0, uint8_t state = kStandby)
      : ClientOnLine(kArduPilot), steering(client) {
    beats = false;
    for (int second = 0; second < 3; ++second) beat(baseMode, mode, state);
  }

  void beat(uint8_t baseMode, uint32_t mode, uint8_t state) {
    show(baseMode, mode, state);
    run(1000);
  }
  void show(uint8_t baseMode, uint32_t mode, uint8_t state) {
    mavlink_heartbeat_t message = mavlink_heartbeat_t();
    message.custom_mode = mode;
    message.type = MAV_TYPE_QUADROTOR;
    message.autopilot = MAV_AUTOPILOT_ARDUPILOTMEGA;
    message.base_mode = baseMode;
    message.system_status = state;
    message.mavlink_version = 3;
    Bytes payload(sizeof(message));
    memcpy(payload.data(), &message, sizeof(message));
    hear(FrameParts(0, payload, 50));
  }
  void show(uint32_t mode) { show(kArmed, mode, kActive); }
  void fly(uint32_t mode, uint8_t state = kActive) { beat(kArmed, mode, state); }

  void answer(uint16_t command, uint8_t result) {
    hear(FrameParts(
        77, {static_cast<uint8_t>(command), static_cast<uint8_t>(command >> 8), result, 0, 0, 0, 0, 0, 1, 191}, 143));
  }

  // Its position, of which the test is the GPS.
  void stand(const LatLon& place, int32_t aboveHomeMm) {
    mavlink_global_position_int_t message = mavlink_global_position_int_t();
    message.lat = place.latitude.e7();
    message.lon = place.longitude.e7();
    message.relative_alt = aboveHomeMm;
    Bytes payload(sizeof(message));
    memcpy(payload.data(), &message, sizeof(message));
    hear(FrameParts(33, payload, 104));
    run(10);
  }

  // What an order ends with, and whether anything but a heartbeat has left by then.
  Status refusal() {
    ended = Status::Idle;
    run(50);
    return ended;
  }
  // A heartbeat that is asked for moves nothing.
  bool hasSent() const {
    for (const SentFrame& frame : sent) {
      const bool isCommand = frame.messageId == kCommandInt || frame.messageId == kCommandLong;
      if (isCommand && !isForHeartbeat(frame)) return true;
    }
    return false;
  }
  static bool isForHeartbeat(const SentFrame& frame) {
    return frame.messageId == kCommandLong && frame.payload[28] == 0 && frame.payload[29] == 2;  // 512
  }
  // The order that changes the mode leaves behind the heartbeat that was asked for.
  bool runUntilOrdered(uint16_t messageId, uint32_t mode) {
    if (!runUntilSent(kCommandLong, 100) || !isForHeartbeat(sent.back())) return false;
    run(25);  // the time that an answer takes
    show(mode);
    return runUntilSent(messageId, 20);
  }
  // The last command, and its second parameter.
  uint16_t command() const {
    const SentFrame& frame = sent.back();
    return static_cast<uint16_t>(frame.payload[28] | frame.payload[29] << 8);
  }
};

}  // namespace

TEST_CASE("an aircraft that was armed before the sketch began is not steered until that is allowed") {
  Flown flight(kArmed, kAuto, kActive);
  flight.steering.goTo(kPlace, 20_m);
  CHECK((flight.refusal() == Status::Armed));
  flight.steering.returnHome();
  CHECK((flight.refusal() == Status::Armed));
  CHECK_FALSE(flight.hasSent());
  flight.client.allowWhileArmed(true);
  flight.steering.goTo(kPlace, 20_m);
  CHECK(flight.runUntilSent(kCommandLong, 100));
}

TEST_CASE("an aircraft that was seen disarmed is steered out of its mission") {
  Flown flight;
  flight.fly(kAuto);
  flight.steering.goTo(kPlace, 20_m);
  CHECK(flight.runUntilSent(kCommandLong, 100));
}

TEST_CASE("in each mode that nobody here has set it says who has the aircraft, and sends nothing") {
  for (uint32_t mode : {kGuided, kLoiter, kRtl, kLand}) {
    for (uint8_t state : {kActive, kCritical}) {
      Flown flight;
      flight.fly(mode, state);
      flight.sent.clear();
      const bool isFailsafe = mode == kRtl || mode == kLand || state == kCritical;
      const Status expected = isFailsafe ? Status::FailsafeHasIt : Status::PilotHasIt;
      flight.steering.goTo(kPlace, 20_m);
      CHECK((flight.refusal() == expected));
      flight.steering.pause();
      CHECK((flight.refusal() == expected));
      flight.steering.resume();
      CHECK((flight.refusal() == expected));
      flight.steering.landNow();
      CHECK((flight.refusal() == expected));
      flight.steering.returnHome();
      CHECK((flight.refusal() == expected));
      flight.steering.setSpeed(5_mps);
      CHECK((flight.refusal() == expected));
      flight.steering.takeOff(5_m);
      CHECK((flight.refusal() == expected));
      CHECK_FALSE(flight.hasSent());
      CHECK_FALSE(flight.steering.maySteer());
    }
  }
}

TEST_CASE("a mode that an order has undone is set again at once, and flies when the order ends") {
  Flown flight;
  flight.fly(kAuto);
  flight.steering.landNow();
  REQUIRE(flight.runUntilOrdered(kCommandLong, kAuto));
  CHECK(flight.sent.back().payload[4 * 1 + 2] == 0x10);  // DO_SET_MODE 9.0f: LAND
  flight.show(kRtl);
  flight.run(10);
  CHECK(flight.client.isBusy());
  flight.show(kLand);
  REQUIRE(flight.runUntilSent(kCommandLong, 20));
  CHECK(flight.command() == 176);
  CHECK(flight.sent.back().payload[4 * 1 + 2] == 0xC0);  // 6.0f: RTL
  CHECK((flight.steering.step() == SteerStep::GiveBack));
  flight.show(kRtl);
  CHECK(flight.client.isBusy());  // a repeat of the command may still arrive
  flight.show(kRtl);
  flight.run(10);
  CHECK((flight.ended == Status::FailsafeHasIt));
  CHECK_FALSE(flight.steering.maySteer());
}

TEST_CASE("a mode of somebody else that is not set again in time is told") {
  Flown flight;
  flight.fly(kAuto);
  flight.steering.landNow();
  REQUIRE(flight.runUntilOrdered(kCommandLong, kAuto));
  flight.show(kLoiter);
  flight.run(10);
  flight.show(kLand);
  REQUIRE(flight.runUntilSent(kCommandLong, 20));
  flight.answer(176, 4);
  flight.run(10);
  CHECK((flight.ended == Status::Overruled));
  CHECK_FALSE(flight.steering.maySteer());
}

TEST_CASE("a mode that the sketch sets by setMode() is its own until another one is shown") {
  Flown flight;
  flight.fly(kLoiter);
  flight.client.setMode(FlightMode::Guided);
  REQUIRE(flight.runUntilOrdered(kCommandLong, kLoiter));
  flight.fly(kGuided);
  CHECK((flight.ended == Status::Done));
  CHECK(flight.steering.maySteer());
  flight.fly(kGuided);
  CHECK(flight.steering.maySteer());
  flight.fly(kLoiter);
  CHECK_FALSE(flight.steering.maySteer());
  flight.fly(kGuided);
  CHECK_FALSE(flight.steering.maySteer());
}

TEST_CASE("a place is confirmed by an answer and by a heartbeat that comes behind it") {
  Flown flight;
  flight.fly(kAuto);
  flight.steering.goTo(kPlace, 20_m);
  REQUIRE(flight.runUntilSent(kCommandLong, 100));
  flight.answer(511, 0);
  REQUIRE(flight.runUntilOrdered(kCommandInt, kAuto));
  CHECK(flight.command() == 192);
  CHECK(flight.sent.back().payload[32] == 6);  // the frame: above home
  flight.run(50);
  CHECK(flight.client.isBusy());
  flight.answer(192, 0);
  flight.run(10);
  CHECK(flight.client.isBusy());
  flight.fly(kAuto);  // sent before the answer
  CHECK(flight.client.isBusy());
  flight.fly(kGuided);
  CHECK((flight.ended == Status::Done));
  CHECK(flight.steering.maySteer());
  CHECK_FALSE(flight.steering.hasArrived());
}

TEST_CASE("an aircraft arrives across the antimeridian, and nowhere else") {
  const LatLon east = {-16_deg, 179.9999995_deg}, west = {-16_deg, -179.9999995_deg};
  const struct {
    LatLon target, here;
    bool hasArrived;
  } kCases[] = {
      {east, west, true},
      {west, east, true},
      {east, east, true},
      {east, {-16_deg, -179.999_deg}, false},
      {east, {-16_deg, -34.4_deg}, false},  // 214.4 degrees: beyond 2^31 steps
      {west, {-16_deg, 34.4_deg}, false},
      {{-16_deg, 179_deg}, {-16_deg, -70.5_deg}, false},
  };
  for (const auto& one : kCases) {
    CAPTURE(one.here.longitude.e7());
    Flown flight;
    flight.fly(kAuto);
    flight.steering.goTo(one.target, 20_m);
    REQUIRE(flight.runUntilSent(kCommandLong, 100));
    flight.answer(511, 0);
    REQUIRE(flight.runUntilOrdered(kCommandInt, kAuto));
    flight.answer(192, 0);
    flight.run(10);
    flight.fly(kGuided);
    REQUIRE((flight.ended == Status::Done));
    flight.stand(one.here, 20000);
    CHECK(flight.steering.hasArrived() == one.hasArrived);
  }
}

TEST_CASE("no heartbeat in the mode leaves an accepted place unconfirmed after 7.5 s") {
  Flown flight;
  flight.fly(kAuto);
  flight.steering.goTo(kPlace, 20_m);
  REQUIRE(flight.runUntilSent(kCommandLong, 100));
  flight.answer(511, 0);
  REQUIRE(flight.runUntilOrdered(kCommandInt, kAuto));
  flight.answer(192, 0);
  flight.run(10);
  for (int second = 0; second < 7; ++second) flight.fly(kAuto);
  CHECK(flight.client.isBusy());
  flight.fly(kAuto);
  CHECK((flight.ended == Status::Unconfirmed));
}

TEST_CASE("a pilot who takes over before the answer keeps the aircraft: nothing is repeated") {
  Flown flight;
  flight.fly(kAuto);
  flight.steering.goTo(kPlace, 20_m);
  REQUIRE(flight.runUntilSent(kCommandLong, 100));
  flight.answer(511, 0);
  REQUIRE(flight.runUntilOrdered(kCommandInt, kAuto));
  flight.sent.clear();
  flight.fly(kLoiter);  // the order may be under way still, and undo it
  CHECK(flight.client.isBusy());
  flight.fly(kLoiter);
  CHECK((flight.ended == Status::PilotHasIt));
  for (int second = 0; second < 9; ++second) flight.fly(kLoiter);
  CHECK_FALSE(flight.hasSent());
}

TEST_CASE(
    "what is wrong with an order is named, and a second object that is refused does not get the first one's answers") {
  Flown flight;
  Steering other(flight.client);
  flight.fly(kAuto);
  flight.steering.goTo(kPlace, Metres(NAN));
  CHECK((flight.refusal() == Status::NotANumber));
  CHECK((flight.client.differingField() == ItemField::Height));
  flight.steering.goTo(kPlace, 20_m);
  CHECK((other.goTo(kPlace, 30_m) == Status::Busy));
  REQUIRE(flight.runUntilSent(kCommandLong, 100));
  flight.answer(511, 0);
  REQUIRE(flight.runUntilOrdered(kCommandInt, kAuto));
  CHECK(flight.command() == 192);
  flight.answer(192, 0);
  flight.run(10);
  flight.fly(kGuided);
  CHECK((flight.ended == Status::Done));
  CHECK(flight.steering.maySteer());
}
