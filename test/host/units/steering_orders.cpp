// Steering's orders word by word: the steps of each on both autopilots, and when it is done.
#include <doctest/doctest.h>

#include "SteeredAircraft.h"

using namespace mavmission;
using namespace steered;

namespace {

constexpr LatLon kPlace = {-35.3630000_deg, 149.1652374_deg};

// What an order that has been given sends until it is done, and for how many heartbeats it asks.
std::string done(Aircraft& aircraft) {
  const uint32_t asksBefore = aircraft.asks;
  aircraft.said();
  const Status status = aircraft.end();
  if (status != Status::Done) return "not done: " + std::to_string(static_cast<int>(status));
  return std::to_string(aircraft.asks - asksBefore) + ": " + aircraft.said();
}

#define ORDERED(aircraft, order) ((aircraft).steering.order, done(aircraft))

}  // namespace

TEST_CASE("a copter takes off, flies to places, and is given back to its mission") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.stand(kStabilize);
  CHECK(ORDERED(copter, takeOff(20_m)) ==
        "4: L511 33 500000 0 0 0 0 0, L176 1 4 0 0 0 0 0, L400 1 0 0 0 0 0 0, L22 0 0 0 0 0 0 20");
  CHECK((copter.steering.step() == SteerStep::Confirm));
  CHECK(copter.steering.maySteer());
  copter.pass(600);  // its position has come
  // In its mode already: without the flag that changes the mode.
  CHECK(ORDERED(copter, goTo(kPlace, 30.25_m)) == "2: I192 frame 6 -1 0 0 nan -353630000 1491652374 30.25");
  CHECK(ORDERED(copter, goTo(kPlace, aboveSeaLevel(630.25_m))) ==
        "2: I192 frame 5 -1 0 0 nan -353630000 1491652374 630.25");
  CHECK(ORDERED(copter, goTo(kPlace, aboveTerrain(30_m))) == "2: I192 frame 11 -1 0 0 nan -353630000 1491652374 30");
  CHECK(ORDERED(copter, setSpeed(7.5_mps)) == "1: L178 1 7.5 -1 0 0 0 0");
  CHECK((copter.steering.step() == SteerStep::Command));
  copter.homeMm = 20500;
  CHECK(ORDERED(copter, pause()) == "2: I192 frame 6 -1 0 0 nan -353632621 1491652374 20.5");
  CHECK(ORDERED(copter, resume()) == "2: L176 1 3 0 0 0 0 0");
  CHECK(ORDERED(copter, pause()) == "2: L176 1 4 0 0 0 0 0");
  CHECK(ORDERED(copter, returnHome()) == "2: L176 1 6 0 0 0 0 0");
  CHECK(ORDERED(copter, landNow()) == "2: L176 1 9 0 0 0 0 0");
  CHECK(copter.steering.maySteer());
  CHECK(ORDERED(copter, resume()) == "1: L176 1 3 0 0 0 0 0");
  copter.pass(600);
  // Out of the mission: with the flag.
  CHECK(ORDERED(copter, goTo(kPlace, 30_m)) == "2: I192 frame 6 -1 1 0 nan -353630000 1491652374 30");
}

TEST_CASE("PX4 is asked whether it flies, where home is and how high it is, and gets each altitude above the sea") {
  Aircraft px4(ClientOnLine::kPx4);
  px4.stand(kPx4Position);
  CHECK(ORDERED(px4, takeOff(20_m)) ==
        "4: L512 245 0 0 0 0 0 0, L512 242 0 0 0 0 0 0, L511 33 500000 0 0 0 0 0, L400 1 0 0 0 0 0 0, "
        "L22 -1 0 0 nan nan nan 604, L512 245 0 0 0 0 0 0");
  CHECK((px4.steering.step() == SteerStep::Confirm));
  px4.homeMm = 20000;
  px4.seaMm = 604000;
  px4.landed = 2;
  px4.tellPosition();
  px4.pass(10);
  px4.mode = kPx4Hold;  // it has come to its height
  px4.pass(1000);
  CHECK(ORDERED(px4, goTo(kPlace, 30.5_m)) ==
        "2: L512 245 0 0 0 0 0 0, L512 242 0 0 0 0 0 0, I192 frame 5 -1 0 0 nan -353630000 1491652374 614.5");
  CHECK(ORDERED(px4, goTo(kPlace, aboveSeaLevel(630.25_m))) ==
        "2: L512 245 0 0 0 0 0 0, I192 frame 5 -1 0 0 nan -353630000 1491652374 630.25");
  CHECK(ORDERED(px4, setSpeed(7_mps)) == "1: L178 1 7 -1 0 0 0 0");
  CHECK(ORDERED(px4, pause()) == "2: L512 245 0 0 0 0 0 0, L192 -1 0 0 nan nan nan nan");
  CHECK(ORDERED(px4, resume()) == "2: L512 245 0 0 0 0 0 0, L176 1 4 4 0 0 0 0");
  CHECK(ORDERED(px4, pause()) == "2: L512 245 0 0 0 0 0 0, L192 -1 1 0 nan nan nan nan");
  CHECK(ORDERED(px4, returnHome()) == "2: L512 245 0 0 0 0 0 0, L176 1 4 5 0 0 0 0");
  CHECK(ORDERED(px4, landNow()) == "2: L512 245 0 0 0 0 0 0, L176 1 4 6 0 0 0 0");
  px4.pass(600);
  CHECK(ORDERED(px4, goTo(kPlace, aboveSeaLevel(630_m))) ==
        "2: L512 245 0 0 0 0 0 0, I192 frame 5 -1 1 0 nan -353630000 1491652374 630");
}

TEST_CASE("PX4 that would fly its mission, take off, or miss its targets, when it is armed is set to HOLD first") {
  for (uint32_t mode : {kPx4Mission, kPx4TakeOff, kPx4Offboard}) {
    Aircraft px4(ClientOnLine::kPx4);
    px4.stand(mode);
    CHECK(ORDERED(px4, takeOff(20_m)) ==
          "5: L512 245 0 0 0 0 0 0, L512 242 0 0 0 0 0 0, L511 33 500000 0 0 0 0 0, L176 1 4 3 0 0 0 0, "
          "L400 1 0 0 0 0 0 0, L22 -1 0 0 nan nan nan 604, L512 245 0 0 0 0 0 0");
  }
  for (uint32_t mode : {kPx4Hold, kPx4Rtl}) {
    Aircraft px4(ClientOnLine::kPx4);
    px4.stand(mode);
    CHECK(ORDERED(px4, takeOff(20_m)) ==
          "4: L512 245 0 0 0 0 0 0, L512 242 0 0 0 0 0 0, L511 33 500000 0 0 0 0 0, L400 1 0 0 0 0 0 0, "
          "L22 -1 0 0 nan nan nan 604, L512 245 0 0 0 0 0 0");
  }
}

TEST_CASE("a copter in GUIDED is not set to it again, and one that is armed already is not armed") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.stand(kGuided);
  CHECK(ORDERED(copter, takeOff(20_m)) == "3: L511 33 500000 0 0 0 0 0, L400 1 0 0 0 0 0 0, L22 0 0 0 0 0 0 20");
  Aircraft armed(ClientOnLine::kArduPilot);
  armed.stand(kAuto);
  armed.isArmed = true;
  CHECK(ORDERED(armed, takeOff(20_m)) == "3: L511 33 500000 0 0 0 0 0, L176 1 4 0 0 0 0 0, L22 0 0 0 0 0 0 20");
  Aircraft px4(ClientOnLine::kPx4);
  px4.stand(kPx4Mission);
  px4.isArmed = true;
  CHECK(ORDERED(px4, takeOff(20_m)) ==
        "4: L512 245 0 0 0 0 0 0, L512 242 0 0 0 0 0 0, L511 33 500000 0 0 0 0 0, L176 1 4 3 0 0 0 0, "
        "L22 -1 0 0 nan nan nan 604, L512 245 0 0 0 0 0 0");
}

TEST_CASE("a rover stops in HOLD, and stays in GUIDED") {
  for (uint8_t type : {10, 11}) {
    Aircraft rover(ClientOnLine::kArduPilot, type);
    rover.fly(kRoverAuto);
    CHECK(ORDERED(rover, goTo(kPlace, 20_m)) ==
          "2: L511 33 500000 0 0 0 0 0, I192 frame 6 -1 1 0 nan -353630000 1491652374 20");
    CHECK(ORDERED(rover, pause()) == "3: L176 1 4 0 0 0 0 0, L176 1 15 0 0 0 0 0");
    CHECK(rover.steering.maySteer());
    CHECK(ORDERED(rover, resume()) == "2: L176 1 10 0 0 0 0 0");
    CHECK(ORDERED(rover, pause()) == "2: L176 1 15 0 0 0 0 0");
    CHECK(ORDERED(rover, setSpeed(3_mps)) == "1: L178 1 3 -1 0 0 0 0");
    CHECK(ORDERED(rover, returnHome()) == "2: L176 1 11 0 0 0 0 0");
    CHECK(ORDERED(rover, goTo(kPlace, 0_m)) == "2: I192 frame 6 -1 1 0 nan -353630000 1491652374 0");
  }
}

TEST_CASE("a plane is asked whether it can hover, before it takes off, and for nothing else") {
  Aircraft plane(ClientOnLine::kArduPilot, 1);
  plane.stand(0);
  plane.vtol = 3;  // MAV_VTOL_STATE_MC
  CHECK(ORDERED(plane, takeOff(5_m)) ==
        "4: L512 245 0 0 0 0 0 0, L511 33 500000 0 0 0 0 0, L176 1 15 0 0 0 0 0, L400 1 0 0 0 0 0 0, "
        "L22 0 0 0 0 0 0 5");
  plane.pass(600);
  CHECK(ORDERED(plane, goTo(kPlace, 50_m)) == "2: I192 frame 6 -1 0 0 nan -353630000 1491652374 50");
  CHECK(ORDERED(plane, resume()) == "1: L176 1 10 0 0 0 0 0");
  CHECK(ORDERED(plane, landNow()) == "2: L176 1 20 0 0 0 0 0");

  Aircraft fixed(ClientOnLine::kArduPilot, 1);
  fixed.stand(0);
  fixed.steering.takeOff(5_m);
  CHECK((fixed.end() == Status::CommandUnsupported));
  CHECK(fixed.said() == "L512 245 0 0 0 0 0 0");
  CHECK((fixed.steering.step() == SteerStep::AskLanded));
  fixed.fly(kPlaneAuto);
  fixed.steering.landNow();
  CHECK((fixed.end() == Status::NoSuchMode));
  CHECK(fixed.said() == "");

  // Its type in a heartbeat is 20, a VTOL's.
  Aircraft quadPlane(ClientOnLine::kArduPilot, 20);
  quadPlane.stand(0);
  quadPlane.vtol = 3;
  CHECK(ORDERED(quadPlane, takeOff(5_m)) ==
        "4: L512 245 0 0 0 0 0 0, L511 33 500000 0 0 0 0 0, L176 1 15 0 0 0 0 0, L400 1 0 0 0 0 0 0, "
        "L22 0 0 0 0 0 0 5");
  quadPlane.pass(600);
  CHECK(ORDERED(quadPlane, landNow()) == "2: L176 1 20 0 0 0 0 0");
  CHECK(ORDERED(quadPlane, returnHome()) == "1: L176 1 11 0 0 0 0 0");
  quadPlane.pass(600);
  quadPlane.show(kPlaneQRtl);  // by itself, near home
  CHECK(quadPlane.steering.maySteer());
  CHECK((quadPlane.client.takenBy() == Status::Idle));
  CHECK(ORDERED(quadPlane, goTo(kPlace, 50_m)) == "2: I192 frame 6 -1 1 0 nan -353630000 1491652374 50");
  quadPlane.show(kPlaneQRtl);  // nobody has ordered it
  CHECK_FALSE(quadPlane.steering.maySteer());
  CHECK((quadPlane.client.takenBy() == Status::FailsafeHasIt));

  const struct {
    uint8_t type;
    uint32_t guided, shown;
    Status taker;
  } kTaken[] = {
      {2, kGuided, 21, Status::FailsafeHasIt},        // SMART_RTL of a copter
      {10, kRoverGuided, 12, Status::FailsafeHasIt},  // SMART_RTL of a rover
      {10, kRoverGuided, 21, Status::PilotHasIt},
      {12, kGuided, 21, Status::PilotHasIt},  // SURFTRAK of a submarine, which a pilot sets
  };
  for (const auto& taken : kTaken) {
    Aircraft aircraft(ClientOnLine::kArduPilot, taken.type);
    aircraft.fly(taken.guided);
    aircraft.steering.requestControl();
    aircraft.pass(1000);
    aircraft.show(taken.shown);
    CHECK((aircraft.client.takenBy() == taken.taker));
    CHECK_FALSE(aircraft.steering.maySteer());
  }

  Aircraft near(ClientOnLine::kArduPilot, 20);
  near.fly(kPlaneAuto);
  near.gives[176] = kUnheard;  // it goes over to QRTL at once
  near.steering.returnHome();
  REQUIRE(near.passUntil(176));
  near.show(kPlaneQRtl);
  CHECK((near.ended == Status::Done));
  CHECK(near.steering.maySteer());

  Aircraft px4(ClientOnLine::kPx4, 1);  // a plane of PX4 is told what any vehicle is told
  px4.stand(kPx4Position);
  px4.steering.takeOff(5_m);
  CHECK((px4.end() == Status::Done));
}

TEST_CASE("an order whose mode the aircraft flies in already is done at its next heartbeat, and sends no command") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.fly(kAuto);
  CHECK(ORDERED(copter, resume()) == "1: ");  // a heartbeat is asked for, which shows the mode
  CHECK(copter.steering.maySteer());
}

TEST_CASE("a position is asked for unless one has come within three seconds") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.fly(kAuto);
  copter.tellPosition();
  copter.pass(2900);
  CHECK(ORDERED(copter, goTo(kPlace, 30_m)) == "2: I192 frame 6 -1 1 0 nan -353630000 1491652374 30");
  Aircraft other(ClientOnLine::kArduPilot);
  other.fly(kAuto);
  other.tellPosition();
  other.pass(4200);
  CHECK(ORDERED(other, goTo(kPlace, 30_m)) ==
        "2: L511 33 500000 0 0 0 0 0, I192 frame 6 -1 1 0 nan -353630000 1491652374 30");
}

TEST_CASE("a pause of a copter in GUIDED waits for the position that comes by itself, and then holds that") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.fly(kAuto);
  CHECK(ORDERED(copter, pause()) == "2: L176 1 4 0 0 0 0 0");
  copter.tellPosition();
  copter.pass(10);
  copter.steering.pause();
  copter.pass(300);
  CHECK((copter.steering.step() == SteerStep::AskPosition));
  CHECK(copter.said() == "");
  copter.here.latitude = Degrees::fromE7(-353600000);
  copter.homeMm = -7777;
  copter.tellPosition();
  CHECK((copter.end() == Status::Done));
  CHECK(copter.said() == "I192 frame 6 -1 0 0 nan -353600000 1491652374 -7.77");
}

TEST_CASE("the speed of an aircraft of PX4 that stands is refused by nobody here: it is not asked whether it flies") {
  Aircraft px4(ClientOnLine::kPx4);
  px4.fly(kPx4Mission);
  px4.landed = 1;
  CHECK(ORDERED(px4, setSpeed(5_mps)) == "1: L178 1 5 -1 0 0 0 0");
}
