// Steering: when an aircraft has arrived, what its position and its target say, and what it begins with.
#include <doctest/doctest.h>

#include <initializer_list>
#include <new>

#include "SteeredAircraft.h"

using namespace mavmission;
using namespace steered;

namespace {

constexpr uint8_t kArduPilot = ClientOnLine::kArduPilot, kPx4 = ClientOnLine::kPx4;
constexpr int32_t kLatitude = -353630000, kLongitude = 1491652374;  // kThere

LatLon at(int32_t latitude, int32_t longitude) { return {Degrees::fromE7(latitude), Degrees::fromE7(longitude)}; }

// One that has been sent to kThere.
struct Sent : Aircraft {
  explicit Sent(Altitude altitude = 20_m, uint8_t firmware = kArduPilot) : Aircraft(firmware) {
    inMission().seaMm = 604000;
    homeMm = 20000;
    REQUIRE((goTo(altitude).end() == Status::Done));
    hasPosition = false;  // from now on the test tells it
  }
  bool isThere(int32_t latitude = kLatitude, int32_t longitude = kLongitude, int32_t aboveHomeMm = 20000,
               uint16_t withinCm = 200) {
    here = at(latitude, longitude);
    atHeight(aboveHomeMm);
    return steering.hasArrived(withinCm);
  }
  bool isThereAt(int32_t aboveHomeMm) { return isThere(kLatitude, kLongitude, aboveHomeMm); }
};

// Whether the order waits for the autopilot to name this target, having named another one before.
struct Named {
  uint8_t firmware;
  Altitude altitude;
  bool isTaken(int32_t latitude, int32_t longitude, float targetAltitude) const {
    Aircraft aircraft(firmware);
    aircraft.inMission().tellTarget(1, 2, 3);
    REQUIRE(aircraft.wait(5).goTo(altitude).until(192).wait(1200).client.isBusy());
    aircraft.tellTarget(latitude, longitude, targetAltitude);
    aircraft.pass(5);
    return !aircraft.client.isBusy() && aircraft.ended == Status::Done;
  }
};

}  // namespace

TEST_CASE("an aircraft has arrived within the distance north and south, east and west, up and down") {
  Sent sent;
  for (uint16_t within : {0, 1, 200, 5000, 65535}) {
    CAPTURE(within);
    const LatLon edge = moved(kThere, within, within);
    const int32_t north = edge.latitude.e7() - kLatitude, east = edge.longitude.e7() - kLongitude;
    for (int32_t side : {-1, 1}) {
      CHECK(sent.isThere(kLatitude + side * north, kLongitude, 20000, within));
      CHECK_FALSE(sent.isThere(kLatitude + side * (north + 1), kLongitude, 20000, within));
      CHECK(sent.isThere(kLatitude, kLongitude + side * east, 20000, within));
      CHECK_FALSE(sent.isThere(kLatitude, kLongitude + side * (east + 1), 20000, within));
      CHECK(sent.isThere(kLatitude, kLongitude, 20000 + side * within * 10, within));
      CHECK_FALSE(sent.isThere(kLatitude, kLongitude, 20000 + side * (within + 1) * 10, within));
    }
  }
  CHECK(sent.isThere(kLatitude, kLongitude, 20009, 0));  // whole centimetres
  const int32_t north = moved(kThere, 200, 200).latitude.e7() - kLatitude;
  for (int32_t off : {0, 1}) {
    sent.isThere(kLatitude + north + off);
    CHECK(sent.steering.hasArrived() == (off == 0));
  }
}

TEST_CASE("180 degrees west is 180 degrees east, to the last step within the distance") {
  constexpr int32_t kEdge = 1800000000;
  for (int32_t side : {-1, 1}) {
    const LatLon place = at(-160000000, side * (kEdge - 50));
    Aircraft aircraft(kArduPilot);
    aircraft.inMission().homeMm = 20000;
    aircraft.goTo(place, 20_m).done().hasPosition = false;
    const int32_t east = (moved(place, 200, 200).longitude - place.longitude).e7();
    REQUIRE(east > 60);
    for (int32_t off = 0; off <= 4 * east; ++off) {
      int64_t longitude = side * (int64_t{kEdge} - 50 + off);
      if (off > 50) longitude -= side * 2 * int64_t{kEdge};
      aircraft.here = at(-160000000, static_cast<int32_t>(longitude));
      aircraft.tellPosition();
      aircraft.run(1);
      if (aircraft.steering.hasArrived() == (off <= east)) continue;
      CAPTURE(off);
      CHECK(aircraft.steering.hasArrived() == (off <= east));
    }
  }
}

TEST_CASE("a height above the sea is compared with that, and one above the ground with nothing, nor a rover's") {
  // PX4's heights above home are heights above the sea, by what both were when the order came.
  Sent sea(aboveSeaLevel(604_m)), px4(20_m, kPx4), ground(aboveTerrain(20_m));
  for (Sent* sent : {&sea, &px4}) {
    for (int32_t mm : {17990, 18000, 22000, 22010}) CHECK(sent->isThereAt(mm) == (mm >= 18000 && mm <= 22000));
  }
  px4.seaMm = 700000;  // the height above home alone says nothing
  px4.homeMm = 20000;
  px4.tellPosition();
  CHECK_FALSE(px4.wait(2).steering.hasArrived());
  CHECK(ground.isThereAt(0));
  CHECK(ground.isThereAt(500000));
  CHECK_FALSE(ground.isThere(kLatitude + 1000, kLongitude, 0));
  Aircraft rover(kArduPilot, 10);
  rover.inMission().goTo(500_m).done().here = kThere;
  rover.tellPosition();
  CHECK(rover.wait(2).steering.hasArrived());
}

TEST_CASE("a takeoff has arrived at its height, wherever that is") {
  Aircraft copter(kArduPilot);
  copter.stand().takeOff().done().hasPosition = false;
  for (int32_t mm : {17990, 18000, 20000, 22000, 22010}) {
    CAPTURE(mm);
    copter.here = at(mm, mm);
    CHECK(copter.atHeight(mm).steering.hasArrived() == (mm >= 18000 && mm <= 22000));
  }
  // A takeoff after a place is none to that place.
  CHECK_FALSE(copter.atHeight(20000).goTo().done().steering.hasArrived());
  Sent sent;
  sent.landNow().done().isArmed = false;
  sent.state = kStandby;
  sent.wait(1000).hasPosition = true;
  sent.takeOff().done();
  CHECK(sent.isThere(500000, 600000));
}

TEST_CASE("a position counts for three seconds, and none of an aircraft that is not heard any more") {
  Sent sent, silent;
  REQUIRE(sent.isThere());
  CHECK(sent.wait(2900).steering.hasArrived());
  sent.pass(1300);
  for (int i = 0; i < 300; ++i) {  // nor does it become young again
    sent.pass(1000);
    if (sent.steering.hasArrived()) FAIL(i);
  }
  sent.hasPosition = true;
  CHECK(sent.isThere());
  REQUIRE(silent.isThere());
  silent.beatsBySecond = false;
  CHECK_FALSE(silent.wait(5100).steering.hasArrived());
}

TEST_CASE("while an order runs, and when another mode was shown, it has not arrived") {
  Sent sent;
  REQUIRE(sent.isThere());
  CHECK_FALSE(sent.setSpeed(5).steering.hasArrived());
  CHECK(sent.done().steering.hasArrived());  // a speed changes no target
  for (uint32_t mode : {kLoiter, kGuided}) {
    sent.show(mode);
    CHECK_FALSE(sent.steering.hasArrived());
  }
}

TEST_CASE("an order that leads elsewhere takes the target away when it has been sent") {
  enum Order { Pause, ReturnHome, LandNow, GoElsewhere };
  for (Order order : {Pause, ReturnHome, LandNow, GoElsewhere}) {
    CAPTURE(int{order});
    Sent sent;
    REQUIRE(sent.isThere());
    if (order == Pause) sent.pause();
    if (order == ReturnHome) sent.returnHome();
    if (order == LandNow) sent.landNow();
    if (order == GoElsewhere) sent.goTo(at(10, 20), 20_m);
    sent.hasPosition = true;
    REQUIRE((sent.end() == Status::Done));
    sent.hasPosition = false;
    CHECK_FALSE(sent.isThere());
  }
  Sent sea(aboveSeaLevel(604_m)), sent;
  REQUIRE(sea.isThere());
  REQUIRE((sea.returnHome().end() == Status::Done));
  CHECK_FALSE(sea.isThere());
  // One that is refused before it was sent does not.
  REQUIRE(sent.isThere());
  CHECK(sent.goTo(at(0, 0), 20_m).status() == "NeedsCoordinates");
  CHECK(sent.isThere());
  // One that was refused by the autopilot does: nobody knows where it flies.
  CHECK(sent.answering(192, 4).goTo(at(10, 20), 20_m).status() == "CommandFailed");
  CHECK_FALSE(sent.isThere());
}

TEST_CASE("the target that the autopilot names is the place within 2 steps of a degree, PX4's within 10 cm of height") {
  for (uint8_t firmware : {kArduPilot, kPx4}) {
    const Named named = {firmware, aboveSeaLevel(620_m)};
    CHECK(named.isTaken(kLatitude, kLongitude, 620));
    for (int32_t off : {-3, -2, 2, 3}) {
      CHECK(named.isTaken(kLatitude + off, kLongitude, 620) == (off * off == 4));
      CHECK(named.isTaken(kLatitude, kLongitude + off, 620) == (off * off == 4));
    }
  }
  const struct {
    Named named;
    float altitude;
    bool isTaken;
  } kCases[] = {{{kPx4, aboveSeaLevel(620_m)}, 620.10f, true},
                {{kPx4, aboveSeaLevel(620_m)}, 619.90f, true},
                {{kPx4, aboveSeaLevel(620_m)}, 620.11f, false},
                {{kPx4, aboveSeaLevel(620_m)}, 619.89f, false},
                {{kPx4, 30_m}, 614.05f, true},
                {{kPx4, 30_m}, 30, false},
                {{kArduPilot, 30_m}, 0, true}};  // any
  for (const auto& one : kCases) CHECK(one.named.isTaken(kLatitude, kLongitude, one.altitude) == one.isTaken);
}

TEST_CASE("a target is waited for if one was named within five heartbeats") {
  for (int beats : {3, 4}) {  // and those that are asked for
    Aircraft copter(kArduPilot);
    copter.inMission().pause().done().setSpeed(5).done().beatsBySecond = false;
    copter.tellPosition();
    copter.tellTarget(1, 2, 3);
    copter.pass(1);
    for (int i = 0; i < beats; ++i) {
      copter.show(kGuided);
      copter.tellPosition();
      copter.pass(1);
    }
    CHECK(copter.goTo().until(192).wait(100).client.isBusy() == (beats == 3));
  }
}

TEST_CASE("a place whose target is never named is unconfirmed 7.5 s after its acceptance") {
  Aircraft copter(kArduPilot);
  const uint32_t sentMs = copter.inMission().goTo().until(192).nowMs();
  for (int i = 0; i < 76 && copter.client.isBusy(); ++i) {
    copter.tellTarget(1, 2, 3);
    copter.pass(100);
  }
  CHECK((copter.ended == Status::Unconfirmed));
  CHECK(copter.nowMs() - sentMs >= 7500);
}

TEST_CASE("the top of PX4's takeoff, at which it goes over to HOLD by itself, is within 2 m of the height") {
  for (int32_t mm : {17990, 18000, 22000, 22010, 0}) {
    for (bool isAdjusted : {false, true}) {
      CAPTURE(mm);
      const bool isOurs = mm >= 18000 && mm <= 22000;
      Aircraft px4(kPx4);
      px4.stand(kPx4Position).takeOff().done();
      if (isAdjusted) px4.setSpeed(5).done();
      CHECK(px4.steering.maySteer());
      px4.hasPosition = false;
      px4.atHeight(mm).show(kPx4Hold);
      CHECK(px4.steering.maySteer() == isOurs);
      CHECK(px4.steering.hasArrived() == isOurs);
    }
  }
}

TEST_CASE("whose HOLD it is after a takeoff is told by the next position, where the last one is not of the top") {
  // `agoMs`: how old the last position is when HOLD is shown. `then`: the heights of the positions that follow, 0 for
  // 10 s without one.
  const struct {
    int32_t lastMm;
    uint32_t agoMs;
    std::vector<int32_t> then;
    bool isOurs;
  } kCases[] = {{15000, 0, {18000}, true},
                {15000, 7000, {22000}, true},
                {20000, 7000, {20000}, true},
                {15000, 0, {17990}, false},
                {15000, 0, {17990, 20000}, false},
                {15000, 0, {0, 20000}, false},
                {15000, 10000, {20000}, false},
                {20000, 0, {22010}, true},
                {15000, 0, {22000, 17000}, true},
                {15000, 0, {20000, 20000}, true},
                {15000, 0, {0}, false}};
  for (const auto& one : kCases) {
    for (bool isOrdered : {false, true}) {
      CAPTURE(one.agoMs);
      CAPTURE(one.then[0]);
      CAPTURE(isOrdered);
      Aircraft px4(kPx4);
      px4.stand(kPx4Position).takeOff().done().hasPosition = false;
      CHECK(px4.atHeight(one.lastMm).steering.maySteer());
      CHECK_FALSE(px4.steering.hasArrived());  // it shows its takeoff still
      px4.wait(one.agoMs).said();
      if (isOrdered) px4.goTo();
      for (int ms = 0; isOrdered && ms < 3000 && px4.steering.step() != SteerStep::AskPosition; ++ms) px4.pass(1);
      const bool isWaiting = px4.client.isBusy() && px4.steering.step() == SteerStep::AskPosition;
      px4.show(kPx4Hold);
      CHECK(px4.wait(500).client.isBusy() == (isWaiting && one.agoMs < 8000));
      for (int32_t mm : one.then) {
        if (mm == 0) px4.pass(10000);
        if (mm != 0) px4.atHeight(mm);
        px4.pass(500);
      }
      if (one.isOurs) CHECK((px4.client.takenBy() == Status::Idle));
      if (isWaiting) {
        if (px4.client.isBusy()) px4.end();
        CHECK((px4.ended == (one.isOurs ? Status::Done : Status::PilotHasIt)));
        CHECK((px4.times("I192") != 0) == one.isOurs);
      }
      if (isOrdered) continue;
      CHECK(px4.steering.maySteer() == one.isOurs);
      CHECK(px4.steering.hasArrived() == (one.isOurs && one.then.back() >= 18000 && one.then.back() <= 22000));
      px4.hasPosition = true;
      CHECK(px4.goTo().status() == (one.isOurs ? "Done" : "PilotHasIt"));
    }
  }
}

TEST_CASE("HOLD is a pilot's if the aircraft stands, if no position has come, or if it is another mode") {
  enum What { IsOurs, Stands, NoPosition, OtherMode, Failsafe };
  for (What what : {IsOurs, Stands, NoPosition, OtherMode, Failsafe}) {
    CAPTURE(int{what});
    Aircraft px4(kPx4);
    px4.stand(kPx4Position).takeOff().done().hasPosition = false;
    px4.atHeight(20000);
    if (what == Stands) {
      px4.landed = 1;
      px4.tellLanded();
    }
    px4.pass(what == NoPosition ? 4200 : 2900);
    if (what == Failsafe) px4.state = kCritical;
    px4.show(what == OtherMode ? kPx4Position : kPx4Hold);
    CHECK(px4.steering.maySteer() == (what == IsOurs));
    px4.state = kActive;
    px4.show(px4.mode);
    CHECK(px4.steering.maySteer() == (what == IsOurs));
  }
}

TEST_CASE("a Steering in memory that was used before begins like any other") {
  for (int fill : {0, 0x55, 0xAA, 0xFF}) {
    CAPTURE(fill);
    alignas(16) static uint8_t memory[sizeof(Aircraft)];
    memset(memory, fill, sizeof(memory));
    Aircraft& copter = *new (memory) Aircraft(kArduPilot);
    CHECK((copter.steering.step() == SteerStep::None));
    copter.mode = fill * 0x01010101u;  // no mode is its own
    copter.isArmed = true;
    copter.state = kActive;
    copter.tellPosition();
    CHECK_FALSE(copter.wait(3000).steering.maySteer());
    CHECK_FALSE(copter.steering.hasArrived());
    CHECK(copter.resume().status(50) == "Armed");  // it was not seen disarmed
    copter.isArmed = false;
    copter.wait(1000).fly(kLoiter).client.setMode(FlightMode::Guided);
    REQUIRE((copter.end() == Status::Done));
    REQUIRE(copter.steering.maySteer());
    for (const LatLon& place : {copter.here, at(0, 0)}) {  // nobody has sent it anywhere
      copter.here = place;
      copter.tellPosition();
      CHECK_FALSE(copter.wait(5).steering.hasArrived());
    }
    copter.wait(5000).said();
    CHECK(copter.goTo().how() ==
          "Done at Confirm: L511 33 500000 0 0 0 0 0, I192 frame 6 -1 0 0 nan -353630000 1491652374 20");
    copter.~Aircraft();
  }
}

TEST_CASE("an aircraft whose position was never told is asked for it") {
  alignas(16) static uint8_t memory[sizeof(Aircraft)];  // all 0
  Aircraft& copter = *new (memory) Aircraft(kArduPilot);
  copter.beatsBySecond = false;
  copter.wait(10).show(kAuto);
  copter.wait(1300).isArmed = true;
  copter.state = kActive;
  copter.show(kAuto);
  CHECK(copter.goTo().passUntil(511, 100));
  copter.~Aircraft();
}

TEST_CASE("messages of other systems and other components are not the aircraft's") {
  Sent sent;
  REQUIRE_FALSE(sent.isThere(kLatitude + 1000));
  mavlink_global_position_int_t message = mavlink_global_position_int_t();
  message.lat = kLatitude;
  message.lon = kLongitude;
  message.relative_alt = 20000;
  FrameParts parts(33, message, 104);
  parts.systemId = 2;
  sent.hear(parts);
  CHECK_FALSE(sent.wait(5).steering.hasArrived());
}
