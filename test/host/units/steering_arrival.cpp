// Steering: when an aircraft has arrived, what its position and its target say, and what it begins with.
#include <doctest/doctest.h>

#include <initializer_list>
#include <new>

#include "SteeredAircraft.h"

using namespace mavmission;
using namespace steered;

namespace {

constexpr LatLon kPlace = {-35.3630000_deg, 149.1652374_deg};
constexpr int32_t kLatitude = -353630000, kLongitude = 1491652374;

LatLon at(int32_t latitude, int32_t longitude) { return {Degrees::fromE7(latitude), Degrees::fromE7(longitude)}; }

// One that has been sent to the place.
struct Sent : Aircraft {
  explicit Sent(Altitude altitude, uint8_t firmware = kArduPilot) : Aircraft(firmware) {
    fly(firmware == kPx4 ? uint32_t{kPx4Mission} : uint32_t{kAuto});
    seaMm = 604000;
    homeMm = 20000;
    steering.goTo(kPlace, altitude);
    REQUIRE((end() == Status::Done));
    hasPosition = false;  // from now on the test tells it
  }
  bool isThere(int32_t latitude, int32_t longitude, int32_t aboveHomeMm = 20000, uint16_t withinCm = 200) {
    here = at(latitude, longitude);
    homeMm = aboveHomeMm;
    seaMm = 584000 + aboveHomeMm;
    tellPosition();
    pass(2);
    return steering.hasArrived(withinCm);
  }
};

// Whether the order waits for the autopilot to name this target, having named another one before.
struct Named {
  uint8_t firmware;
  Altitude altitude;
  bool isTaken(int32_t latitude, int32_t longitude, float targetAltitude) const {
    Aircraft aircraft(firmware);
    aircraft.fly(firmware == ClientOnLine::kPx4 ? uint32_t{kPx4Mission} : uint32_t{kAuto});
    aircraft.tellTarget(1, 2, 3);
    aircraft.pass(5);
    aircraft.steering.goTo(kPlace, altitude);
    REQUIRE(aircraft.passUntil(192));
    aircraft.pass(1200);
    REQUIRE(aircraft.client.isBusy());
    aircraft.tellTarget(latitude, longitude, targetAltitude);
    aircraft.pass(5);
    return !aircraft.client.isBusy() && aircraft.ended == Status::Done;
  }
};

}  // namespace

TEST_CASE("an aircraft has arrived within the distance north and south, east and west, up and down") {
  Sent sent(20_m);
  for (uint16_t within : {0, 1, 200, 5000, 65535}) {
    CAPTURE(within);
    const LatLon edge = moved(kPlace, within, within);
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
  const int32_t north = moved(kPlace, 200, 200).latitude.e7() - kLatitude;
  sent.isThere(kLatitude + north, kLongitude);
  CHECK(sent.steering.hasArrived());
  sent.isThere(kLatitude + north + 1, kLongitude);
  CHECK_FALSE(sent.steering.hasArrived());
}

TEST_CASE("180 degrees west is 180 degrees east, to the last step within the distance") {
  constexpr int32_t kEdge = 1800000000;
  for (int32_t side : {-1, 1}) {
    Aircraft aircraft(ClientOnLine::kArduPilot);
    aircraft.fly(kAuto);
    aircraft.homeMm = 20000;
    const LatLon place = at(-160000000, side * (kEdge - 50));
    aircraft.steering.goTo(place, 20_m);
    REQUIRE((aircraft.end() == Status::Done));
    aircraft.hasPosition = false;
    const int32_t east = (moved(place, 200, 200).longitude - place.longitude).e7();
    REQUIRE(east > 60);
    for (int32_t off = 0; off <= 4 * east; ++off) {
      int64_t longitude = side * (int64_t{kEdge} - 50 + off);
      if (off > 50) longitude -= side * 2 * int64_t{kEdge};
      aircraft.here = at(-160000000, static_cast<int32_t>(longitude));
      aircraft.tellPosition();
      aircraft.run(1);
      if (aircraft.steering.hasArrived() != (off <= east)) {
        CAPTURE(off);
        CHECK(aircraft.steering.hasArrived() == (off <= east));
      }
    }
  }
}

TEST_CASE("a height above the sea is compared with that, and one above the ground with nothing") {
  Sent sea(aboveSeaLevel(604_m));
  CHECK(sea.isThere(kLatitude, kLongitude, 22000));
  CHECK_FALSE(sea.isThere(kLatitude, kLongitude, 22010));
  CHECK(sea.isThere(kLatitude, kLongitude, 18000));
  CHECK_FALSE(sea.isThere(kLatitude, kLongitude, 17990));
  Sent ground(aboveTerrain(20_m));
  CHECK(ground.isThere(kLatitude, kLongitude, 0));
  CHECK(ground.isThere(kLatitude, kLongitude, 500000));
  CHECK_FALSE(ground.isThere(kLatitude + 1000, kLongitude, 0));
  // PX4's heights above home are heights above the sea, by what both were when the order came.
  Sent px4(20_m, ClientOnLine::kPx4);
  CHECK(px4.isThere(kLatitude, kLongitude, 22000));
  CHECK_FALSE(px4.isThere(kLatitude, kLongitude, 22010));
  px4.seaMm = 700000;  // the height above home alone says nothing
  px4.homeMm = 20000;
  px4.tellPosition();
  px4.pass(2);
  CHECK_FALSE(px4.steering.hasArrived());
}

TEST_CASE("a rover arrives at its place at whatever height that is") {
  Aircraft rover(ClientOnLine::kArduPilot, 10);
  rover.fly(kRoverAuto);
  rover.steering.goTo(kPlace, 500_m);
  REQUIRE((rover.end() == Status::Done));
  rover.here = kPlace;
  rover.tellPosition();
  rover.pass(2);
  CHECK(rover.steering.hasArrived());
}

TEST_CASE("a takeoff has arrived at its height, wherever that is") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.stand(kStabilize);
  copter.steering.takeOff(20_m);
  REQUIRE((copter.end() == Status::Done));
  copter.hasPosition = false;
  for (int32_t mm : {17990, 18000, 20000, 22000, 22010}) {
    CAPTURE(mm);
    copter.homeMm = mm;
    copter.here = at(mm, mm);
    copter.tellPosition();
    copter.pass(2);
    CHECK(copter.steering.hasArrived() == (mm >= 18000 && mm <= 22000));
  }
  copter.homeMm = 20000;
  copter.tellPosition();
  copter.pass(2);
  copter.steering.goTo(kPlace, 20_m);  // and a takeoff behind a place is none to that place
  REQUIRE((copter.end() == Status::Done));
  CHECK_FALSE(copter.steering.hasArrived());
}

TEST_CASE("a position counts for three seconds") {
  Sent sent(20_m);
  REQUIRE(sent.isThere(kLatitude, kLongitude));
  sent.hasPosition = false;
  sent.pass(2900);
  CHECK(sent.steering.hasArrived());
  sent.pass(1300);
  for (int i = 0; i < 300; ++i) {  // nor does it become young again
    sent.pass(1000);
    if (sent.steering.hasArrived()) FAIL(i);
  }
  sent.hasPosition = true;
  CHECK(sent.isThere(kLatitude, kLongitude));
}

TEST_CASE("an aircraft that is not heard any more has not arrived") {
  Sent sent(20_m);
  REQUIRE(sent.isThere(kLatitude, kLongitude));
  sent.beatsBySecond = false;
  sent.pass(5100);
  CHECK_FALSE(sent.steering.hasArrived());
}

TEST_CASE("while an order runs, and when another mode was shown, it has not arrived") {
  Sent sent(20_m);
  REQUIRE(sent.isThere(kLatitude, kLongitude));
  sent.steering.setSpeed(5_mps);
  CHECK_FALSE(sent.steering.hasArrived());
  REQUIRE((sent.end() == Status::Done));
  CHECK(sent.steering.hasArrived());  // a speed changes no target
  sent.show(kLoiter);
  CHECK_FALSE(sent.steering.hasArrived());
  sent.show(kGuided);
  CHECK_FALSE(sent.steering.hasArrived());
}

TEST_CASE("an order that leads elsewhere takes the target away when it has been sent") {
  for (int order = 0; order < 4; ++order) {
    CAPTURE(order);
    Sent sent(20_m);
    REQUIRE(sent.isThere(kLatitude, kLongitude));
    if (order == 0) sent.steering.pause();
    if (order == 1) sent.steering.returnHome();
    if (order == 2) sent.steering.landNow();
    if (order == 3) sent.steering.goTo(at(10, 20), 20_m);
    sent.hasPosition = true;
    REQUIRE((sent.end() == Status::Done));
    sent.hasPosition = false;
    sent.isThere(kLatitude, kLongitude);
    CHECK_FALSE(sent.steering.hasArrived());
  }
  Sent sea(aboveSeaLevel(604_m));
  REQUIRE(sea.isThere(kLatitude, kLongitude));
  sea.steering.returnHome();
  REQUIRE((sea.end() == Status::Done));
  CHECK_FALSE(sea.isThere(kLatitude, kLongitude));
  // One that is refused before it was sent does not.
  Sent sent(20_m);
  REQUIRE(sent.isThere(kLatitude, kLongitude));
  sent.steering.goTo(at(0, 0), 20_m);
  CHECK((sent.end() == Status::NeedsCoordinates));
  CHECK(sent.isThere(kLatitude, kLongitude));
  // One that was refused by the autopilot does: nobody knows where it flies.
  sent.gives[192] = 4;
  sent.steering.goTo(at(10, 20), 20_m);
  sent.end();
  CHECK((sent.ended == Status::CommandFailed));
  CHECK_FALSE(sent.isThere(kLatitude, kLongitude));
}

TEST_CASE("the target that the autopilot names is the place within 2 steps of a degree") {
  for (uint8_t firmware : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    const Named named = {firmware, aboveSeaLevel(620_m)};
    CHECK(named.isTaken(kLatitude, kLongitude, 620));
    for (int32_t side : {-1, 1}) {
      CHECK(named.isTaken(kLatitude + side * 2, kLongitude, 620));
      CHECK_FALSE(named.isTaken(kLatitude + side * 3, kLongitude, 620));
      CHECK(named.isTaken(kLatitude, kLongitude + side * 2, 620));
      CHECK_FALSE(named.isTaken(kLatitude, kLongitude + side * 3, 620));
    }
  }
}

TEST_CASE("PX4's target has the altitude too, within 10 cm; ArduPilot's may have any") {
  const Named sea = {ClientOnLine::kPx4, aboveSeaLevel(620_m)};
  CHECK(sea.isTaken(kLatitude, kLongitude, 620.10f));
  CHECK(sea.isTaken(kLatitude, kLongitude, 619.90f));
  CHECK_FALSE(sea.isTaken(kLatitude, kLongitude, 620.11f));
  CHECK_FALSE(sea.isTaken(kLatitude, kLongitude, 619.89f));
  const Named home = {ClientOnLine::kPx4, 30_m};
  CHECK(home.isTaken(kLatitude, kLongitude, 614.05f));
  CHECK_FALSE(home.isTaken(kLatitude, kLongitude, 30));
  const Named copter = {ClientOnLine::kArduPilot, 30_m};
  CHECK(copter.isTaken(kLatitude, kLongitude, 0));
}

TEST_CASE("a target is waited for if one was named within five heartbeats") {
  for (int beats : {3, 4}) {  // and those that are asked for
    Aircraft copter(ClientOnLine::kArduPilot);
    copter.fly(kAuto);
    copter.steering.pause();
    REQUIRE((copter.end() == Status::Done));
    copter.steering.setSpeed(5_mps);
    REQUIRE((copter.end() == Status::Done));
    copter.beatsBySecond = false;
    copter.tellPosition();
    copter.tellTarget(1, 2, 3);
    copter.pass(1);
    for (int i = 0; i < beats; ++i) {
      copter.show(kGuided);
      copter.tellPosition();
      copter.pass(1);
    }
    copter.steering.goTo(kPlace, 20_m);
    REQUIRE(copter.passUntil(192));
    copter.pass(100);
    CHECK(copter.client.isBusy() == (beats == 3));
  }
}

TEST_CASE("a place whose target is never named is unconfirmed 7.5 s behind its acceptance") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.fly(kAuto);
  copter.steering.goTo(kPlace, 20_m);
  REQUIRE(copter.passUntil(192));
  const uint32_t sentMs = copter.nowMs();
  for (int i = 0; i < 76; ++i) {
    copter.tellTarget(1, 2, 3);
    copter.pass(100);
    if (!copter.client.isBusy()) break;
  }
  CHECK((copter.ended == Status::Unconfirmed));
  CHECK(copter.nowMs() - sentMs >= 7500);
}

TEST_CASE("the top of PX4's takeoff, at which it goes over to HOLD by itself, is within 2 m of the height") {
  const struct {
    int32_t aboveHomeMm;
    bool isOurs;
  } kCases[] = {{17990, false}, {18000, true}, {22000, true}, {22010, false}, {0, false}};
  for (const auto& one : kCases) {
    for (bool isAdjusted : {false, true}) {
      CAPTURE(one.aboveHomeMm);
      Aircraft px4(ClientOnLine::kPx4);
      px4.stand(kPx4Position);
      px4.steering.takeOff(20_m);
      REQUIRE((px4.end() == Status::Done));
      if (isAdjusted) {
        px4.steering.setSpeed(5_mps);
        REQUIRE((px4.end() == Status::Done));
      }
      CHECK(px4.steering.maySteer());
      px4.hasPosition = false;
      px4.homeMm = one.aboveHomeMm;
      px4.seaMm = 584000 + one.aboveHomeMm;
      px4.tellPosition();
      px4.pass(2);
      px4.show(kPx4Hold);
      CHECK(px4.steering.maySteer() == one.isOurs);
      CHECK(px4.steering.hasArrived() == one.isOurs);
    }
  }
}

TEST_CASE("whose HOLD it is behind a takeoff is told by the next position, where the last one is not of the top") {
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
      Aircraft px4(ClientOnLine::kPx4);
      px4.stand(kPx4Position);
      px4.steering.takeOff(20_m);
      REQUIRE((px4.end() == Status::Done));
      px4.hasPosition = false;
      const auto tell = [&](int32_t mm) {
        px4.homeMm = mm;
        px4.seaMm = 584000 + mm;
        px4.tellPosition();
        px4.pass(2);
      };
      tell(one.lastMm);
      CHECK(px4.steering.maySteer());
      CHECK_FALSE(px4.steering.hasArrived());  // it shows its takeoff still
      px4.pass(one.agoMs);
      px4.said();
      if (isOrdered) px4.steering.goTo(kPlace, 20_m);
      for (int ms = 0; isOrdered && ms < 3000 && px4.steering.step() != SteerStep::AskPosition; ++ms) px4.pass(1);
      const bool isWaiting = px4.client.isBusy() && px4.steering.step() == SteerStep::AskPosition;
      px4.show(kPx4Hold);
      px4.pass(500);
      CHECK(px4.client.isBusy() == (isWaiting && one.agoMs < 8000));
      for (int32_t mm : one.then) {
        if (mm == 0) px4.pass(10000);
        if (mm != 0) tell(mm);
        px4.pass(500);
      }
      if (one.isOurs) CHECK((px4.client.takenBy() == Status::Idle));
      if (isWaiting) {
        if (px4.client.isBusy()) px4.end();
        CHECK((px4.ended == (one.isOurs ? Status::Done : Status::PilotHasIt)));
        CHECK((px4.said().find("I192") != std::string::npos) == one.isOurs);
      }
      if (isOrdered) continue;
      CHECK(px4.steering.maySteer() == one.isOurs);
      CHECK(px4.steering.hasArrived() == (one.isOurs && one.then.back() >= 18000 && one.then.back() <= 22000));
      px4.hasPosition = true;
      px4.steering.goTo(kPlace, 20_m);
      CHECK((px4.end() == (one.isOurs ? Status::Done : Status::PilotHasIt)));
    }
  }
}

TEST_CASE("HOLD is a pilot's if the aircraft stands, if no position has come, or if it is another mode") {
  for (int what = 0; what < 5; ++what) {
    CAPTURE(what);
    Aircraft px4(ClientOnLine::kPx4);
    px4.stand(kPx4Position);
    px4.steering.takeOff(20_m);
    REQUIRE((px4.end() == Status::Done));
    px4.hasPosition = false;
    px4.homeMm = 20000;
    px4.seaMm = 604000;
    px4.tellPosition();
    px4.pass(2);
    if (what == 1) {
      px4.landed = 1;
      px4.tellLanded();
    }
    px4.pass(what == 2 ? 4200 : 2900);
    if (what == 4) px4.state = kCritical;
    px4.show(what == 3 ? kPx4Position : kPx4Hold);
    CHECK(px4.steering.maySteer() == (what == 0));
    px4.state = kActive;
    px4.show(px4.mode);
    CHECK(px4.steering.maySteer() == (what == 0));
  }
}

TEST_CASE("a Steering in memory that was used before begins like any other") {
  for (int fill : {0, 0x55, 0xAA, 0xFF}) {
    CAPTURE(fill);
    alignas(16) static uint8_t memory[sizeof(Aircraft)];
    memset(memory, fill, sizeof(memory));
    Aircraft& copter = *new (memory) Aircraft(ClientOnLine::kArduPilot);
    CHECK((copter.steering.step() == SteerStep::None));
    copter.mode = fill * 0x01010101u;  // no mode is its own
    copter.isArmed = true;
    copter.state = kActive;
    copter.tellPosition();
    copter.pass(3000);
    CHECK_FALSE(copter.steering.maySteer());
    CHECK_FALSE(copter.steering.hasArrived());
    copter.steering.resume();
    CHECK((copter.end(50) == Status::Armed));  // it was not seen disarmed
    copter.isArmed = false;
    copter.pass(1000);
    copter.fly(kLoiter);
    copter.client.setMode(FlightMode::Guided);
    REQUIRE((copter.end() == Status::Done));
    REQUIRE(copter.steering.maySteer());
    copter.tellPosition();
    copter.pass(5);
    CHECK_FALSE(copter.steering.hasArrived());  // nobody has sent it anywhere
    copter.here = at(0, 0);
    copter.tellPosition();
    copter.pass(5);
    CHECK_FALSE(copter.steering.hasArrived());
    copter.pass(5000);
    copter.said();
    copter.steering.goTo(kPlace, 20_m);
    REQUIRE((copter.end() == Status::Done));
    CHECK(copter.said() == "L511 33 500000 0 0 0 0 0, I192 frame 6 -1 0 0 nan -353630000 1491652374 20");
    copter.~Aircraft();
  }
}

TEST_CASE("an aircraft whose position was never told is asked for it") {
  alignas(16) static uint8_t memory[sizeof(Aircraft)];  // all 0
  Aircraft& copter = *new (memory) Aircraft(ClientOnLine::kArduPilot);
  copter.beatsBySecond = false;
  copter.isArmed = false;
  copter.pass(10);
  copter.show(kAuto);
  copter.pass(1300);
  copter.isArmed = true;
  copter.state = kActive;
  copter.show(kAuto);
  copter.steering.goTo(kPlace, 20_m);
  CHECK(copter.passUntil(511, 100));
  copter.~Aircraft();
}

TEST_CASE("a takeoff after a place has arrived at its height wherever that is") {
  Sent sent(20_m);
  sent.steering.landNow();
  REQUIRE((sent.end() == Status::Done));
  sent.isArmed = false;
  sent.state = kStandby;
  sent.pass(1000);
  sent.hasPosition = true;
  sent.steering.takeOff(20_m);
  REQUIRE((sent.end() == Status::Done));
  CHECK(sent.isThere(500000, 600000));
}

TEST_CASE("messages of other systems and other components are not the aircraft's") {
  Sent sent(20_m);
  REQUIRE_FALSE(sent.isThere(kLatitude + 1000, kLongitude));
  mavlink_global_position_int_t message = mavlink_global_position_int_t();
  message.lat = kLatitude;
  message.lon = kLongitude;
  message.relative_alt = 20000;
  Bytes payload(sizeof(message));
  memcpy(payload.data(), &message, sizeof(message));
  FrameParts parts(33, payload, 104);
  parts.systemId = 2;
  sent.hear(parts);
  sent.pass(5);
  CHECK_FALSE(sent.steering.hasArrived());
}
