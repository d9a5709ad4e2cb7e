// Steering by a whole client: whose aircraft it is, and what is sent when.
#include <doctest/doctest.h>

#include <initializer_list>

#include "SteeredAircraft.h"

using namespace mavmission;
using namespace steered;

namespace {

// A copter in its mission, which is given an order; the test is its autopilot as soon as that has left.
struct Ordered : Aircraft {
  Ordered() : Aircraft(kArduPilot) { inMission().answering(192).answering(176); }
  Ordered& left(uint16_t command) {
    REQUIRE(passUntil(command));
    silence();
    return *this;
  }
  // A heartbeat of the aircraft in this mode, and a second without another one.
  Ordered& shows(uint32_t inMode) {
    show(inMode);
    pass(999);
    return *this;
  }
};

}  // namespace

TEST_CASE("an aircraft that was armed before the sketch began is not steered until that is allowed") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.isArmed = true;
  copter.state = kActive;
  copter.stand(kAuto);
  CHECK(copter.goTo().how(50) == "Armed at None: ");
  CHECK(copter.returnHome().how(50) == "Armed at None: ");
  copter.client.allowWhileArmed(true);
  CHECK(copter.goTo().passUntil(511, 100));
}

TEST_CASE("in each mode that nobody here has set it says who has the aircraft, and sends nothing") {
  typedef Aircraft& (*Order)(Aircraft& copter);
  const Order kOrders[] = {
      [](Aircraft& copter) -> Aircraft& { return copter.goTo(); },
      [](Aircraft& copter) -> Aircraft& { return copter.pause(); },
      [](Aircraft& copter) -> Aircraft& { return copter.resume(); },
      [](Aircraft& copter) -> Aircraft& { return copter.landNow(); },
      [](Aircraft& copter) -> Aircraft& { return copter.returnHome(); },
      [](Aircraft& copter) -> Aircraft& { return copter.setSpeed(5); },
      [](Aircraft& copter) -> Aircraft& { return copter.takeOff(5_m); },
  };
  for (uint32_t mode : {kGuided, kLoiter, kRtl, kLand}) {
    for (uint8_t state : {kActive, kCritical}) {
      Aircraft copter(ClientOnLine::kArduPilot);
      copter.stand().fly(mode).state = state;
      copter.wait(1000).forget();
      const bool isFailsafe = mode == kRtl || mode == kLand || state == kCritical;
      for (Order order : kOrders) CHECK(order(copter).status(50) == (isFailsafe ? "FailsafeHasIt" : "PilotHasIt"));
      CHECK(copter.said() == "");
      CHECK_FALSE(copter.steering.maySteer());
    }
  }
}

TEST_CASE("a mode that an order has undone is set again at once, and flies when the order ends") {
  Ordered copter;
  copter.landNow();
  copter.left(176).show(kRtl);
  CHECK(copter.wait(10).client.isBusy());
  copter.show(kLand);
  REQUIRE(copter.passUntil(176, 20));
  CHECK(copter.said() == "L176 1 9 0 0 0 0 0, L176 1 6 0 0 0 0 0");
  CHECK((copter.steering.step() == SteerStep::GiveBack));
  copter.show(kRtl);
  CHECK(copter.client.isBusy());  // a repeat of the command may still arrive
  copter.show(kRtl);
  CHECK((copter.wait(10).ended == Status::FailsafeHasIt));
  CHECK_FALSE(copter.steering.maySteer());

  Ordered overruled;  // it is not set again in time
  overruled.landNow();
  overruled.left(176).show(kLoiter);
  overruled.wait(10).show(kLand);
  REQUIRE(overruled.passUntil(176, 20));
  overruled.answer(176, 4);
  CHECK((overruled.wait(10).ended == Status::Overruled));
  CHECK_FALSE(overruled.steering.maySteer());
}

TEST_CASE("a mode that the sketch sets by setMode() is its own until another one is shown") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.fly(kLoiter).client.setMode(FlightMode::Guided);
  CHECK((copter.end() == Status::Done));
  CHECK(copter.steering.maySteer());
  CHECK(copter.wait(2000).steering.maySteer());
  for (uint32_t mode : {kLoiter, kGuided}) {
    copter.show(mode);
    CHECK_FALSE(copter.steering.maySteer());
  }
}

TEST_CASE("a place is confirmed by an answer and by a heartbeat that comes after it, within 7.5 s") {
  Ordered copter;
  copter.goTo();
  CHECK(copter.left(192).wait(50).client.isBusy());
  copter.answer(192, 0);
  CHECK(copter.wait(10).client.isBusy());
  CHECK(copter.shows(kAuto).client.isBusy());  // sent before the answer
  CHECK((copter.shows(kGuided).ended == Status::Done));
  CHECK(copter.steering.maySteer());
  CHECK_FALSE(copter.steering.hasArrived());

  Aircraft early(ClientOnLine::kArduPilot);  // hardly found, it has never named a target, and none is waited for
  early.silence();
  for (uint32_t shown : {kStabilize, kStabilize, kAuto}) {
    early.isArmed = shown == kAuto;
    early.state = early.isArmed ? kActive : kStandby;
    early.show(shown);
    early.pass(999);
  }
  early.beatsWhenAsked = true;
  CHECK(early.goTo().status() == "Done");

  Ordered other;
  other.goTo();
  other.left(192).answer(192, 0);
  other.pass(10);
  for (int second = 0; second < 7; ++second) other.shows(kAuto);
  CHECK(other.client.isBusy());
  CHECK((other.shows(kAuto).ended == Status::Unconfirmed));
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
    Aircraft copter(ClientOnLine::kArduPilot);
    copter.inMission().goTo(one.target, 20_m).done().here = one.here;
    CHECK(copter.atHeight(20000).steering.hasArrived() == one.hasArrived);
  }
}

TEST_CASE("a pilot who takes over before the answer keeps the aircraft: nothing is repeated") {
  Ordered copter;
  copter.goTo();
  copter.left(192).said();
  CHECK(copter.shows(kLoiter).client.isBusy());  // the order may be under way still, and undo it
  CHECK((copter.shows(kLoiter).ended == Status::PilotHasIt));
  for (int second = 0; second < 9; ++second) copter.shows(kLoiter);
  CHECK(copter.said() == "");
}

TEST_CASE("a second object that is refused does not get the first one's answers") {
  Aircraft copter(ClientOnLine::kArduPilot);
  Steering other(copter.client);
  copter.inMission().goTo();
  CHECK((other.goTo(kThere, 30_m) == Status::Busy));
  CHECK(copter.how() == "Done at Confirm: L511 33 500000 0 0 0 0 0, I192 frame 6 -1 1 0 nan -353630000 1491652374 20");
  CHECK(copter.steering.maySteer());
}
