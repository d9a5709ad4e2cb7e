// The gate: whatever takes an aircraft, arms it or lets its motors start leaves right after a heartbeat, each time.
#include <doctest/doctest.h>

#include <functional>

#include "SteeredAircraft.h"
#include "mavmission/autopilot/Guarded.h"

using namespace mavmission;
using namespace steered;

namespace {

const LatLon kPlace = {-35.3630000_deg, 149.1652374_deg};
constexpr int kFailed = 4;

bool isGuardedFrame(const SentFrame& frame) {
  if (frame.messageId != 76 && frame.messageId != 75) return false;
  return detail::isGuarded(static_cast<uint16_t>(frame.payload[28] | frame.payload[29] << 8));
}

struct Begun {
  const char* name;
  bool flies;
  std::function<void(Aircraft&)> begin;
};
FlightCommand command;
void send(Aircraft& aircraft, uint16_t id, float param1 = 0) {
  command = flightCommand(id, param1);
  aircraft.client.send(command, CommandRepeat::Always);
}
const Begun kBegun[] = {
    {"takeOff", false, [](Aircraft& a) { a.steering.takeOff(10_m); }},
    {"goTo", true, [](Aircraft& a) { a.steering.goTo(kPlace, 20_m); }},
    {"returnHome", true, [](Aircraft& a) { a.steering.returnHome(); }},
    {"setSpeed", true, [](Aircraft& a) { a.steering.setSpeed(5_mps); }},
    {"arm", false, [](Aircraft& a) { a.client.arm(); }},
    {"disarm", true, [](Aircraft& a) { a.client.disarm(); }},
    {"setMode", true, [](Aircraft& a) { a.client.setMode(FlightMode::Land); }},
    {"startMission", true, [](Aircraft& a) { a.client.startMission(); }},
    {"send MISSION_START", true, [](Aircraft& a) { send(a, 300); }},
    {"send NAV_TAKEOFF", true, [](Aircraft& a) { send(a, 22); }},
    {"send NAV_VTOL_TAKEOFF", true, [](Aircraft& a) { send(a, 84); }},
    {"send NAV_LAND", true, [](Aircraft& a) { send(a, 21); }},
    {"send DO_ORBIT", true, [](Aircraft& a) { send(a, 34); }},
    {"send DO_MOTOR_TEST", false, [](Aircraft& a) { send(a, 209, 1); }},
    {"send DO_ENGINE_CONTROL", false, [](Aircraft& a) { send(a, 223, 1); }},
    {"send DO_SET_STANDARD_MODE", true, [](Aircraft& a) { send(a, 262, 1); }},
    {"send DO_PAUSE_CONTINUE", true, [](Aircraft& a) { send(a, 193); }},
    {"send COMPONENT_ARM_DISARM", false, [](Aircraft& a) { send(a, 400, 1); }},
};

}  // namespace

TEST_CASE("without a heartbeat nothing that takes, arms or starts leaves, and none of its repeats") {
  for (const Begun& one : kBegun) {
    for (bool leavesOnce : {false, true}) {
      CAPTURE(one.name);
      CAPTURE(leavesOnce);
      Aircraft aircraft(ClientOnLine::kArduPilot);
      if (one.flies) {
        aircraft.fly(kAuto);
      } else {
        aircraft.stand(kGuided);  // the mode of a takeoff
      }
      for (int id : {21, 22, 34, 84, 176, 178, 192, 193, 209, 223, 262, 300, 400}) aircraft.gives[id] = kUnheard;
      aircraft.pass(450);
      aircraft.forget();
      aircraft.beatsBySecond = aircraft.beatsWhenAsked = leavesOnce;
      one.begin(aircraft);
      size_t left = 0;
      for (uint32_t ms = 0; ms < 4000; ++ms) {
        const size_t before = aircraft.sent.size();
        aircraft.pass(1);
        for (size_t i = before; i < aircraft.sent.size(); ++i) left += isGuardedFrame(aircraft.sent[i]);
        if (left != 0) aircraft.beatsBySecond = aircraft.beatsWhenAsked = false;
      }
      CHECK(left == (leavesOnce ? 1 : 0));
      CHECK(aircraft.asks > 0);
    }
  }
}

TEST_CASE("CRITICAL does not say that an ArduPilot flies: on the ground it has not taken off, and is not left armed") {
  for (uint8_t state : {kCritical, kEmergency}) {
    for (int answer : {0, kFailed}) {
      CAPTURE(answer);
      Aircraft copter(ClientOnLine::kArduPilot);
      copter.stand(kStabilize);
      copter.takesOff = false;
      copter.gives[22] = answer;
      copter.steering.takeOff(10_m);
      for (uint32_t ms = 0; ms < 40000 && copter.client.isBusy(); ++ms) {
        copter.pass(1);
        if (copter.isArmed) copter.state = state;
      }
      CHECK((copter.client.status() == (answer == 0 ? Status::Unconfirmed : Status::CommandFailed)));
      CHECK_FALSE(copter.isArmed);
    }
    Aircraft standing(ClientOnLine::kArduPilot);
    standing.stand(kAuto);
    standing.isArmed = true;
    standing.state = state;
    standing.pass(1500);
    standing.steering.goTo(kPlace, 10_m);
    CHECK((standing.end() == Status::NotFlying));
    standing.landed = 2;  // and in the air it is asked, and believed
    standing.steering.goTo(kPlace, 10_m);
    CHECK((standing.end() == Status::Done));
  }
}

TEST_CASE("one stream at a time: the one that is started ends the other, which goes on until then") {
  for (bool isPlaceFirst : {false, true}) {
    CAPTURE(isPlaceFirst);
    struct Streams : Aircraft {
      MovingTarget target;
      VelocityTarget velocity;
      Streams() : Aircraft(kArduPilot), target(steering), velocity(steering) {}
      void loop() override {
        target.update();
        velocity.update();
        target.renew(kPlace, 20_m);
        velocity.renew(BodyVelocity(2_mps));
      }
      Status start(bool isPlace) { return isPlace ? target.start(kPlace, 20_m) : velocity.start(BodyVelocity(2_mps)); }
    } aircraft;
    aircraft.fly(kAuto);
    aircraft.start(isPlaceFirst);
    REQUIRE((aircraft.end() == Status::Done));
    aircraft.pass(1500);
    aircraft.start(!isPlaceFirst);
    CHECK((aircraft.end() == Status::Done));
    aircraft.pass(500);
    aircraft.sent.clear();
    aircraft.pass(2000);
    size_t places = 0, velocities = 0;
    for (const SentFrame& frame : aircraft.sent) {
      places += frame.messageId == 86;
      velocities += frame.messageId == 84;
    }
    CHECK(places == (isPlaceFirst ? 0 : 10));
    CHECK(velocities == (isPlaceFirst ? 10 : 0));
    CHECK(((isPlaceFirst ? aircraft.target.status() : aircraft.velocity.status()) == Status::Cancelled));
    CHECK(((isPlaceFirst ? aircraft.velocity.status() : aircraft.target.status()) == Status::Transferring));
  }
}

TEST_CASE("the number of a mode that would be cut is no mode, and nothing is sent") {
  for (uint32_t number : {0xFFFFFFFFu, 0x10001u, 0xFFFF0001u, 0xFFFFu}) {
    for (uint8_t firmware : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
      CAPTURE(number);
      Aircraft aircraft(firmware);
      aircraft.stand(firmware == ClientOnLine::kPx4 ? uint32_t{kPx4Hold} : uint32_t{kGuided});
      aircraft.client.setCustomMode(number);
      CHECK((aircraft.end() == Status::NoSuchMode));
      for (const SentFrame& frame : aircraft.sent) CHECK_FALSE(isGuardedFrame(frame));
    }
  }
}
