// MovingTarget by a whole client: which targets are sent, when, and with what it ends.
#include <doctest/doctest.h>

#include <algorithm>
#include <initializer_list>
#include <new>

#include "Messages.h"
#include "SteeredAircraft.h"

using namespace mavmission;
using namespace steered;

namespace {

constexpr uint16_t kTarget = 86;
constexpr LatLon kPlace = {-35.3630000_deg, 149.1652374_deg};
constexpr LatLon kOther = {-35.3620000_deg, 149.1650000_deg};
constexpr uint8_t kFirmwares[] = {ClientOnLine::kArduPilot, ClientOnLine::kPx4};
// What a copter is told that is to stay where it is.
const char kHold[] = "I192 frame 6 -1 0 0 nan -353632621 1491652374 0";
const MissionItem kPlan[] = {waypoint(1_deg, 2_deg, 3_m)};

typedef mavlink_set_position_target_global_int_t Message;

// An aircraft in its mission, and a sketch that renews a target every 50 ms.
struct Follower : Aircraft {
  MovingTarget target;
  bool renews = true;
  bool isStuck = false;  // loop() does not get there
  LatLon place = kPlace;
  Altitude altitude = 20_m;
  Status renewed = Status::Idle;
  std::string ends;  // what update() has returned beside Transferring and Idle

  explicit Follower(uint8_t firmware = kArduPilot, uint8_t vehicleType = 2)
      : Aircraft(firmware, vehicleType), target(steering), firmware_(firmware) {}
  bool isPx4() const { return firmware_ == kPx4; }

  void loop() override {
    if (isStuck) return;
    const Status status = target.update();
    if (status != Status::Transferring && status != Status::Idle) {
      ends += std::string(ends.empty() ? "" : " ") + nameOf(status);
    }
    if (renews && nowMs() % 50 == 0) renewed = target.renew(place, altitude);
  }

  // What happens, one after the other.
  Follower& inMission() {
    fly(type == 10 ? uint32_t{kRoverAuto} : isPx4() ? uint32_t{kPx4Mission} : uint32_t{kAuto});
    return *this;
  }
  Follower& start(Altitude height = 20_m) {
    altitude = height;
    CHECK((target.start(place, altitude) == Status::WaitingForAutopilot));
    return *this;
  }
  // Until it is followed, and for so long.
  Follower& follow(Altitude height = 20_m, uint32_t ms = 0) {
    inMission().start(height);
    REQUIRE((end(20000) == Status::Done));
    REQUIRE(target.isFollowed());
    if (ms != 0) wait(ms).said();
    return *this;
  }
  Follower& wait(uint32_t ms) {
    pass(ms);
    return *this;
  }
  Follower& upTo(uint32_t ms) {
    while (nowMs() != ms) pass(1);
    return *this;
  }
  Follower& answering(uint16_t command, int result = kUnheard) {
    gives[command] = result;
    return *this;
  }
  Follower& until(uint16_t command) {
    REQUIRE(passUntil(command));
    return *this;
  }
  // The aircraft says nothing any more, or again.
  Follower& silence(bool isSilent = true) {
    beatsBySecond = beatsWhenAsked = hasPosition = !isSilent;
    return *this;
  }
  Follower& stop() {
    target.stop();
    return *this;
  }
  // loop() stands still.
  Follower& standStill(uint32_t ms) {
    run(ms, ms);
    return *this;
  }
  // It hears another operation, which keeps the client busy.
  Follower& beginUpload() {
    client.allowWhileArmed(true);
    client.upload(inRam(kPlan));
    REQUIRE(client.isBusy());
    return *this;
  }

  // How an operation ends, then what update() has returned of the following, and what the aircraft was told.
  std::string how(uint32_t limitMs = 60000) {
    const std::string status = nameOf(end(limitMs));
    pass(2);
    return status + ", " + told() + ": " + said();
  }
  // The ends of the following since the last call; the last of them is its status.
  std::string told() {
    const std::string text = ends.empty() ? "goes on" : ends;
    CHECK((ends.empty() || ends.substr(ends.rfind(' ') + 1) == nameOf(target.status())));
    ends.clear();
    return text;
  }

  // The targets that have left. One that was withdrawn while it left is none.
  std::vector<Message> messages() const {
    std::vector<Message> found;
    for (const SentFrame& frame : sent) {
      if (isTarget(frame)) found.push_back(messageIn<Message>(frame.payload));
    }
    return found;
  }
  static bool isTarget(const SentFrame& frame) {
    return frame.messageId == kTarget && frame.frame == packedAgain(frame, 5);
  }
  // When they left, and when loop() gave them, as they say themselves [ms, since `from`].
  std::vector<uint32_t> times(uint32_t from) const {
    std::vector<uint32_t> found;
    for (const SentFrame& frame : sent) {
      if (isTarget(frame)) found.push_back(frame.atMs - from);
    }
    return found;
  }
  std::vector<uint32_t> given(uint32_t from = 0) const {
    std::vector<uint32_t> found;
    for (const Message& message : messages()) found.push_back(message.time_boot_ms - from);
    return found;
  }
  // The last one as "latitude longitude altitude frame"; "" if none was sent.
  std::string last() const {
    const std::vector<Message> all = messages();
    if (all.empty()) return "";
    const Message& message = all.back();
    return std::to_string(message.lat_int) + " " + std::to_string(message.lon_int) + " " + shortest(message.alt) + " " +
           std::to_string(message.coordinate_frame);
  }

 private:
  uint8_t firmware_;
};

}  // namespace

TEST_CASE("a copter that is followed gets its place five times a second, with every field") {
  Follower copter;
  CHECK((copter.target.status() == Status::Idle));
  copter.follow();
  CHECK(copter.said() == "L511 33 500000 0 0 0 0 0, L176 1 4 0 0 0 0 0");
  CHECK(copter.asks == 2);
  CHECK(copter.messages().empty());
  CHECK((copter.target.status() == Status::Transferring));
  CHECK((copter.target.update() == Status::Transferring));
  copter.sent.clear();
  const uint32_t beganMs = copter.nowMs();
  copter.pass(2000);
  const std::vector<uint32_t> times = copter.times(beganMs);
  REQUIRE(times.size() == 10);
  CHECK(times[0] <= 3);
  for (size_t i = 0; i < 10; ++i) CHECK(times[i] == times[0] + 200 * i);
  CHECK((copter.renewed == Status::Transferring));
  const uint32_t givenMs = copter.given()[9];
  CHECK(givenMs >= beganMs + times[9] - 3);
  CHECK(givenMs < beganMs + times[9]);
  CHECK(wordsOf(kTarget, bytesOf(copter.messages()[9])) ==
        "SET_POSITION_TARGET_GLOBAL_INT time_boot_ms " + std::to_string(givenMs) +
            " target_system 1 target_component 1 coordinate_frame 6 type_mask 3576 lat_int -353630000 "
            "lon_int 1491652374 alt 20");
  copter.place = kOther;
  copter.altitude = 25.5_m;
  copter.pass(260);
  CHECK(copter.last() == "-353620000 1491650000 25.5 6");
  CHECK(copter.said() == "");
  CHECK(copter.told() == "goes on");
}

TEST_CASE("an altitude is above the sea, above the ground, or above home as the sketch says, for a rover too") {
  CHECK(Follower().follow(aboveSeaLevel(620.25_m)).wait(10).last() == "-353630000 1491652374 620.25 5");
  CHECK(Follower().follow(aboveTerrain(-3_m)).wait(10).last() == "-353630000 1491652374 -3 11");
  CHECK(Follower(ClientOnLine::kPx4).follow(aboveSeaLevel(620.25_m)).wait(10).last() ==
        "-353630000 1491652374 620.25 5");
  Follower rover(ClientOnLine::kArduPilot, 10);
  CHECK(rover.follow().wait(10).last() == "-353630000 1491652374 20 6");
  CHECK(rover.said() == "L511 33 500000 0 0 0 0 0, L176 1 15 0 0 0 0 0");
}

TEST_CASE("PX4 gets a second of targets, then its mode, and each height above home as one above the sea") {
  Follower px4(ClientOnLine::kPx4);
  px4.homeMm = 5000;
  px4.seaMm = 604000;
  px4.inMission().start().until(176);
  CHECK(px4.said() == "L512 245 0 0 0 0 0 0, L512 242 0 0 0 0 0 0, L511 33 500000 0 0 0 0 0, L176 1 6 0 0 0 0 0");
  const std::vector<uint32_t> times = px4.times(0);
  REQUIRE(times.size() == 6);
  for (size_t i = 1; i < times.size(); ++i) CHECK((times[i] - times[i - 1]) / 2 == 100);
  CHECK(px4.nowMs() - times[0] >= 1000);
  CHECK(px4.nowMs() - times[0] <= 1030);
  CHECK(px4.last() == "-353630000 1491652374 619 5");
  CHECK((px4.end() == Status::Done));
  px4.homeMm = 6000;  // home has been set elsewhere
  CHECK(px4.wait(800).last() == "-353630000 1491652374 618 5");
}

TEST_CASE("what is refused by goTo() is refused by start(), and told by update() too") {
  const struct {
    uint8_t type;
    uint32_t mode;
    LatLon place;
    Altitude altitude;
    Status status;
  } kCases[] = {
      {2, kAuto, {0_deg, 0_deg}, 20_m, Status::NeedsCoordinates},
      {2, kAuto, kPlace, 10001_m, Status::BadAltitude},
      {2, kAuto, kPlace, Altitude(20_m, CoordinateFrame::Mission), Status::BadFrame},
      {2, kLoiter, kPlace, 20_m, Status::PilotHasIt},
      {1, kPlaneAuto, kPlace, 20_m, Status::CommandUnsupported},  // a plane is not followed at all
  };
  for (const auto& one : kCases) {
    Follower aircraft(ClientOnLine::kArduPilot, one.type);
    aircraft.fly(one.mode);
    aircraft.renews = false;
    aircraft.target.start(one.place, one.altitude);
    CHECK((aircraft.end(1000) == one.status));
    CHECK((aircraft.target.status() == one.status));  // before update() has told it
    CHECK(aircraft.wait(2).told() == nameOf(one.status));
    CHECK(aircraft.said() == "");
    CHECK_FALSE(aircraft.target.isFollowed());
    CHECK((aircraft.target.renew(kPlace, 20_m) == one.status));
  }
  Follower silent;  // it is not heard
  silent.beatsBySecond = false;
  silent.client.setAutopilotTimeout(3);
  CHECK(silent.start().how(5000) == "NoAutopilot, NoAutopilot: ");
  Follower rover(ClientOnLine::kArduPilot, 10);  // it does not say what it is
  rover.saysVehicle = false;
  CHECK((rover.answering(3000).inMission().start().end(20000) == Status::NoAnswer));
  CHECK((rover.target.status() == Status::NoAnswer));
}

TEST_CASE("only one begins at a time, and again when it has ended") {
  Follower copter;
  copter.inMission().steering.setSpeed(5_mps);
  CHECK((copter.target.start(kPlace, 20_m) == Status::Busy));
  CHECK((copter.target.status() == Status::Idle));
  REQUIRE((copter.end() == Status::Done));
  copter.start();
  CHECK((copter.target.start(kOther, 30_m) == Status::Busy));
  REQUIRE((copter.end() == Status::Done));
  CHECK((copter.target.start(kOther, 30_m) == Status::Busy));
  CHECK(copter.wait(1000).last() == "-353630000 1491652374 20 6");
  copter.said();
  CHECK(copter.stop().how() == std::string("Done, Done: ") + kHold);
  copter.place = kOther;
  CHECK((copter.start(aboveSeaLevel(620_m)).end() == Status::Done));
  CHECK(copter.target.isFollowed());
  CHECK(copter.wait(10).last() == "-353620000 1491650000 620 5");
}

TEST_CASE("an end that was not told yet is not that of the next start()") {
  Follower copter;
  copter.inMission().renews = false;
  copter.target.start({0_deg, 0_deg}, 20_m);
  REQUIRE((copter.end(1000) == Status::NeedsCoordinates));
  copter.renews = true;
  CHECK(copter.start().wait(10).told() == "goes on");
  CHECK((copter.end() == Status::Done));
}

TEST_CASE("a renewal with a number that cannot be meant does not count, and names its field") {
  Follower copter;
  copter.follow().renews = false;
  copter.pass(900);
  const float nan = __builtin_nanf("");
  const struct {
    LatLon place;
    Altitude altitude;
    Status status;
    ItemField field;
  } kCases[] = {{kPlace, Metres(nan), Status::NotANumber, ItemField::Height},
                {kPlace, 10001_m, Status::BadAltitude, ItemField::Height},
                {{0_deg, 0_deg}, 20_m, Status::NeedsCoordinates, ItemField::Latitude},
                {kPlace, aboveSeaLevel(620_m), Status::BadFrame, ItemField::Reference},
                {kPlace, aboveTerrain(20_m), Status::BadFrame, ItemField::Reference}};
  for (const auto& one : kCases) {
    CHECK((copter.target.renew(one.place, one.altitude) == one.status));
    CHECK((copter.client.differingField() == one.field));
  }
  CHECK((copter.target.renew(kOther, Altitude(21_m, CoordinateFrame::GlobalRelativeInt)) == Status::Transferring));
  CHECK(copter.wait(205).last() == "-353620000 1491650000 21 6");
  CHECK((copter.target.renew(kPlace, 10001_m) == Status::BadAltitude));
  copter.pass(1000);
  CHECK((copter.target.renew(kPlace, 20_m) == Status::NotRenewed));
}

TEST_CASE("a copter whose target is not renewed for a second holds its position") {
  for (uint16_t timeoutMs : {0, 300}) {
    Follower copter;
    if (timeoutMs != 0) copter.target.setTimeout(timeoutMs);
    copter.follow(20_m, 1000).renews = false;
    const uint32_t limitMs = timeoutMs != 0 ? timeoutMs : 1000, renewedMs = copter.nowMs();
    REQUIRE((copter.target.renew(kPlace, 20_m) == Status::Transferring));
    while (copter.target.isFollowed()) copter.pass(1);
    CHECK(copter.nowMs() - renewedMs == limitMs + 2);
    CHECK((copter.target.status() == Status::Transferring));
    CHECK((copter.target.renew(kPlace, 20_m) == Status::NotRenewed));
    const uint32_t lastMs = copter.times(0).back();
    CHECK(lastMs - renewedMs <= limitMs + 2);
    CHECK(copter.how() == std::string("Done, NotRenewed: ") + kHold);
    CHECK(copter.times(0).back() == lastMs);
    CHECK((copter.target.renew(kPlace, 20_m) == Status::NotRenewed));
    CHECK(copter.wait(3000).told() == "goes on");  // it is told once
    CHECK(copter.steering.maySteer());
  }
}

TEST_CASE("stop() makes it hold its position, and that is done") {
  for (uint8_t firmware : kFirmwares) {
    Follower aircraft(firmware);
    aircraft.follow(20_m, 1000).stop();
    CHECK((aircraft.target.renew(kPlace, 20_m) == Status::Cancelled));
    CHECK_FALSE(aircraft.wait(1).target.isFollowed());
    CHECK((aircraft.target.renew(kPlace, 20_m) == Status::Done));
    const std::string how = aircraft.how();
    CHECK((aircraft.target.renew(kPlace, 20_m) == Status::Done));
    if (firmware == ClientOnLine::kPx4) {
      CHECK(how.find("Done, Done: L512 245 0 0 0 0 0 0") == 0);
      CHECK(how.find(", L192 -1 1 0 nan nan nan nan") == how.size() - 29);
    } else {
      CHECK(how == std::string("Done, Done: ") + kHold);
    }
  }
}

TEST_CASE("a start() that is stopped, not renewed, or cancelled before it is followed is given up: nothing holds it") {
  for (uint8_t firmware : kFirmwares) {
    for (bool isStopped : {false, true}) {
      Follower aircraft(firmware);
      aircraft.answering(511).inMission().renews = false;
      CHECK(aircraft.start().wait(500).client.isBusy());
      if (isStopped) aircraft.stop();
      aircraft.end(1000);
      CHECK(aircraft.wait(2).told() == (isStopped ? "Cancelled" : "NotRenewed"));
      CHECK(aircraft.tookMs <= (isStopped ? 5 : 505));
      CHECK(aircraft.messages().empty());
    }
  }
  Follower copter;
  copter.inMission().start().until(176).client.cancel();
  CHECK(copter.wait(3000).told() == "Cancelled");
  CHECK(copter.said() == "L511 33 500000 0 0 0 0 0, L176 1 4 0 0 0 0 0");
  CHECK(copter.messages().empty());
  Follower other;  // it is cancelled for another operation
  other.inMission().start().until(511).client.cancel();
  other.steering.setSpeed(5_mps);
  CHECK(other.wait(2).told() == "Cancelled");
}

TEST_CASE("a heartbeat with another mode, a failsafe, or no arms ends the following at once, and says who has it") {
  const struct {
    uint8_t firmware;
    uint32_t mode;  // what it shows
    bool isArmed;
    uint8_t state;
    Status status;  // Transferring: it is followed
  } kCases[] = {
      {ClientOnLine::kArduPilot, kLoiter, true, kActive, Status::PilotHasIt},
      {ClientOnLine::kArduPilot, kRtl, true, kActive, Status::FailsafeHasIt},
      {ClientOnLine::kArduPilot, kGuided, false, kActive, Status::NotArmed},
      {ClientOnLine::kArduPilot, kGuided, true, kCritical, Status::Transferring},
      {ClientOnLine::kArduPilot, kAuto, true, kActive, Status::PilotHasIt},  // somebody goes on with the mission
      {ClientOnLine::kPx4, kPx4Position, true, kActive, Status::PilotHasIt},
      {ClientOnLine::kPx4, kPx4Rtl, true, kActive, Status::FailsafeHasIt},
      {ClientOnLine::kPx4, kPx4Offboard, false, kActive, Status::NotArmed},
      {ClientOnLine::kPx4, kPx4Offboard, true, kCritical, Status::FailsafeHasIt},
      {ClientOnLine::kPx4, kPx4Mission, true, kActive, Status::PilotHasIt},
  };
  for (const auto& one : kCases) {
    CAPTURE(one.firmware);
    CAPTURE(one.mode);
    Follower aircraft(one.firmware);
    aircraft.follow(20_m, 1000);
    aircraft.isArmed = one.isArmed;
    aircraft.state = one.state;
    aircraft.show(one.mode);
    aircraft.wait(4).sent.clear();
    const bool isFollowed = one.status == Status::Transferring;
    CHECK(aircraft.target.isFollowed() == isFollowed);
    CHECK(aircraft.told() == (isFollowed ? "goes on" : nameOf(one.status)));
    CHECK((aircraft.target.renew(kPlace, 20_m) == one.status));
    CHECK(aircraft.wait(3000).messages().empty() != isFollowed);
    CHECK(aircraft.said() == "");
    CHECK(aircraft.told() == "goes on");
  }
  // What loop() hears last decides: a stop() after a pilot's heartbeat is the pilot's.
  Follower copter;
  copter.follow(20_m, 1000).mode = kLoiter;
  copter.beat();
  copter.run(3);
  CHECK((copter.stop().target.update() == Status::PilotHasIt));
}

TEST_CASE("another order of the sketch ends the following, and a speed does not") {
  Follower copter;
  copter.follow(20_m, 1000).steering.setSpeed(5_mps);
  REQUIRE((copter.end() == Status::Done));
  CHECK(copter.target.isFollowed());
  copter.said();
  copter.steering.goTo(kOther, 30_m);
  CHECK_FALSE(copter.wait(2).target.isFollowed());
  CHECK((copter.target.renew(kPlace, 20_m) == Status::Cancelled));
  CHECK(copter.how() == "Done, Cancelled: I192 frame 6 -1 0 0 nan -353620000 1491650000 30");
}

TEST_CASE("an order that leads into another mode ends with that mode, and one that fails is followed by a hold") {
  Follower copter;
  copter.follow(20_m, 10).steering.landNow();
  CHECK(copter.how() == "Done, Cancelled: L176 1 9 0 0 0 0 0");
  Follower refused;
  refused.follow(20_m, 1000).answering(176, 4).steering.landNow();
  CHECK((refused.end() == Status::CommandFailed));
  CHECK(refused.how() == std::string("Done, Cancelled: L176 1 9 0 0 0 0 0, ") + kHold);
  // PX4 that the sketch lands gets targets until its mode has changed.
  Follower px4(ClientOnLine::kPx4);
  px4.follow(aboveSeaLevel(620_m), 3000).answering(176).steering.landNow();
  px4.wait(1000).sent.clear();
  CHECK(px4.wait(1000).messages().size() == 5);
  CHECK(px4.last() == "-353632621 1491652374 584 5");
}

TEST_CASE("loop() that has stood still for 0.6 s sends nothing until a new heartbeat shows who has the aircraft") {
  for (uint32_t stillMs : {599, 600}) {
    CAPTURE(stillMs);
    Follower copter;
    copter.follow(20_m, 1000).silence().wait(10).beat();  // heard when loop() goes on
    copter.asks = 0;
    copter.standStill(stillMs).target.renew(kPlace, 20_m);
    copter.sent.clear();
    CHECK(copter.wait(150).messages().empty() == (stillMs == 600));
    CHECK(copter.asks == (stillMs == 600 ? 2 : 0));
    if (stillMs < 600) continue;
    copter.wait(100).beat();
    CHECK_FALSE(copter.wait(150).messages().empty());
    CHECK(copter.target.isFollowed());
  }
}

TEST_CASE("an aircraft at a place is not known to be there after a standstill, nor when it is followed") {
  for (bool isStill : {true, false}) {
    Follower copter;
    copter.inMission().homeMm = 20000;
    copter.here = kPlace;
    copter.steering.goTo(kPlace, 20_m);
    REQUIRE((copter.end() == Status::Done));
    REQUIRE(copter.wait(600).steering.hasArrived());
    copter.said();
    if (isStill) {
      copter.hasPosition = false;
      copter.standStill(700).pass(1);
    } else {
      REQUIRE((copter.start().end() == Status::Done));
      CHECK(copter.said() == "");
    }
    CHECK_FALSE(copter.steering.hasArrived());
    if (isStill) continue;
    CHECK(copter.stop().wait(1000).told() == "Done");
    CHECK(copter.said() == "I192 frame 6 -1 0 0 nan -353630000 1491652374 20");
  }
}

TEST_CASE("a loop() that stood still until its target was old makes the aircraft hold when that is heard again") {
  for (uint32_t stillMs : {1500, 7000}) {  // in the second, the autopilot counts as lost
    CAPTURE(stillMs);
    Follower copter;
    copter.follow(20_m, 1000).silence().renews = false;
    copter.standStill(stillMs);
    CHECK((copter.target.renew(kPlace, 20_m) == Status::NotRenewed));
    copter.said();
    CHECK((copter.wait(2000).target.status() == Status::Transferring));
    CHECK_FALSE(copter.target.isFollowed());
    CHECK(copter.said() == "");
    CHECK(copter.silence(false).wait(5000).told() == "NotRenewed");
    CHECK(copter.said().find(kHold) != std::string::npos);
  }
  // A hold that is blind for 5 s has no autopilot any more, to the millisecond.
  Follower lost;
  lost.follow(20_m, 1000).silence().renews = false;
  lost.standStill(1500).upTo(lost.nowMs() + 5000);
  CHECK((lost.target.status() == Status::Transferring));
  CHECK(lost.told() == "goes on");
  CHECK(lost.wait(1).told() == "NoAutopilot");
}

TEST_CASE("an autopilot that is silent gets its last target before 0.6 s, is asked from 0.3 s on, and lost after 5 s") {
  Follower copter;
  CHECK(copter.follow(20_m, 1000).silence().wait(3500).target.isFollowed());
  CHECK(copter.wait(2500).told() == "NoAutopilot");

  Follower due;  // a target is due in the loop() that hears its last heartbeat
  due.follow(20_m, 1000).silence();
  const uint32_t dueMs = due.given().back() + 400;
  due.upTo(dueMs - 1).sent.clear();
  due.beat();
  CHECK(due.wait(1000).given(dueMs).back() < 600);
  const std::vector<uint32_t> askedMs = due.timesOf(76, dueMs);
  REQUIRE(askedMs.size() >= 4);
  CHECK(askedMs[0] == 301);
  CHECK(askedMs[3] - askedMs[2] == 100);

  Follower other;
  other.follow(20_m, 3000).silence().beat();
  const uint32_t heardMs = other.wait(1).nowMs();
  other.forget();
  const std::vector<uint32_t> targets = other.wait(1500).times(heardMs), asked = other.timesOf(76, heardMs);
  REQUIRE_FALSE(targets.empty());
  CHECK(targets.back() > 400);
  CHECK(targets.back() <= 602);
  REQUIRE(asked.size() == 12);
  for (size_t i = 0; i < asked.size(); ++i) {
    CHECK(asked[i] >= 300 + 100 * i);
    CHECK(asked[i] <= 302 + 101 * i);
  }
  CHECK(other.target.isFollowed());
  other.beat();
  CHECK(other.wait(205).times(heardMs).size() > targets.size());

  Follower mission;  // where nothing is followed, no heartbeat is asked for
  mission.inMission().beatsBySecond = false;
  CHECK(mission.wait(2000).asks == 0);
}

TEST_CASE("a target that is half sent when it is no longer true is withdrawn, and stays so") {
  enum What { StandStill, OtherMode, Stop, StopAndOtherMode };
  for (What what : {StandStill, OtherMode, Stop, StopAndOtherMode}) {
    CAPTURE(int{what});
    Follower copter;
    copter.follow(20_m, 1000).hasPosition = false;
    copter.upTo(copter.given().back() + 400).line.room = 20;
    copter.wait(3).sent.clear();
    if (what == StandStill) copter.standStill(700);
    if (what == Stop || what == StopAndOtherMode) copter.stop();
    if (what == OtherMode || what == StopAndOtherMode) {
      copter.mode = kLoiter;
      copter.beat();
    }
    copter.wait(3).line.room = MemoryStream::kAlwaysRoom;
    copter.pass(20);
    const auto first = std::find_if(copter.sent.begin(), copter.sent.end(),
                                    [](const SentFrame& frame) { return frame.messageId == kTarget; });
    REQUIRE(first != copter.sent.end());
    CHECK_FALSE(Follower::isTarget(*first));
  }
}

TEST_CASE("PX4's targets go on until its mode is HOLD, and name where it is") {
  Follower px4(ClientOnLine::kPx4);
  px4.follow(aboveSeaLevel(620_m), 3000).here = kOther;
  px4.seaMm = 600500;
  CHECK(px4.wait(600).answering(192).stop().wait(1000).last() == "-353620000 1491650000 600.5 5");
  px4.here = kPlace;  // where it was when the hold began
  CHECK(px4.wait(1000).last() == "-353620000 1491650000 600.5 5");
  px4.gives.clear();
  CHECK(px4.how().substr(0, 10) == "Done, Done");
  px4.wait(3).sent.clear();
  CHECK(px4.wait(1000).messages().empty());
}

TEST_CASE("a hold that is refused, taken over by somebody else, or cancelled is told") {
  Follower refused, taken, cancelled;
  CHECK(refused.follow(20_m, 1000).answering(192, 4).stop().how() ==
        std::string("CommandFailed, CommandFailed: ") + kHold);
  taken.follow(20_m, 1000).answering(192).stop().until(192).wait(500).show(kLoiter);
  CHECK(taken.wait(1000).told() == "PilotHasIt");
  cancelled.follow(20_m, 1000).answering(192).stop().until(192).client.cancel();
  CHECK(cancelled.wait(5).told() == "Cancelled");
}

TEST_CASE("a hold waits until the client is free, and the copter is told where to stay meanwhile") {
  Follower copter;
  copter.follow(aboveSeaLevel(620_m), 3000).beginUpload().homeMm = 7000;
  copter.tellPosition();
  copter.wait(20).stop().said();
  CHECK(copter.wait(1000).last() == "-353632621 1491652374 7 6");
  CHECK(copter.said() == "");
  copter.client.cancel();
  copter.ends.clear();
  CHECK(copter.how().substr(0, 10) == "Done, Done");
}

TEST_CASE("a hold aims where the aircraft was told to be within three seconds, or when that is told") {
  for (uint32_t ms : {2900, 4200}) {
    CAPTURE(ms);
    Follower copter;
    copter.follow(20_m, 3000).beginUpload().hasPosition = false;
    copter.homeMm = 9000;
    copter.tellPosition();
    copter.wait(ms).stop().wait(3).sent.clear();
    CHECK(copter.wait(220).last() == (ms == 2900 ? "-353632621 1491652374 9 6" : ""));
  }
  Follower px4(ClientOnLine::kPx4);
  px4.follow(aboveSeaLevel(620_m), 1000).hasPosition = false;
  px4.wait(5000).answering(512).stop().wait(100).sent.clear();
  CHECK(px4.wait(500).messages().empty());
  px4.here = kOther;
  px4.tellPosition();
  CHECK(px4.wait(300).last() == "-353620000 1491650000 584 5");
}

TEST_CASE("a mode that start() has undone is set again") {
  Follower copter;
  copter.inMission().start().answering(176).until(176).show(kLoiter);
  copter.wait(5).said();
  copter.show(kGuided);
  CHECK(copter.passUntil(176, 50));
  CHECK(copter.said() == "L176 1 5 0 0 0 0 0");
  copter.show(kLoiter);
  copter.show(kLoiter);
  CHECK(copter.wait(500).told() == "PilotHasIt");
}

TEST_CASE("PX4's mode is ordered again when it is not answered, and its targets then name where it is") {
  Follower px4(ClientOnLine::kPx4);
  px4.inMission().answering(176).start(aboveSeaLevel(620_m)).until(176);
  REQUIRE(px4.passUntil(176, 1700));
  px4.renews = false;
  CHECK(px4.wait(800).last() == "-353630000 1491652374 620 5");
  CHECK(px4.wait(450).last() == "-353632621 1491652374 584 5");
}

TEST_CASE("a MovingTarget in memory that was used before begins like any other") {
  for (int fill : {0, 0x55, 0xFF}) {
    CAPTURE(fill);
    alignas(16) static uint8_t memory[sizeof(Follower)];
    memset(memory, fill, sizeof(memory));
    Follower& copter = *new (memory) Follower;
    CHECK((copter.target.status() == Status::Idle));
    CHECK_FALSE(copter.target.isFollowed());
    CHECK((copter.target.renew(kPlace, 20_m) == Status::Idle));
    CHECK(copter.wait(2000).told() == "goes on");
    CHECK((copter.target.update() == Status::Idle));
    CHECK(copter.follow().wait(1000).messages().size() == 5);
    copter.~Follower();
  }
}

TEST_CASE("PX4's second of targets begins anew after a gap of 0.6 s") {
  Follower px4(ClientOnLine::kPx4);
  px4.inMission().start(aboveSeaLevel(620_m));
  while (px4.messages().size() < 3) px4.pass(1);
  const uint32_t sentMs = px4.given().back(), updatedMs = px4.nowMs() - 1;
  REQUIRE(px4.nowMs() < sentMs + 10);
  px4.isStuck = true;
  px4.upTo(sentMs + 600);
  REQUIRE(px4.nowMs() - updatedMs < 600);
  px4.isStuck = false;
  px4.until(176);
  REQUIRE(px4.given(sentMs).size() > 3);
  CHECK(px4.given(sentMs)[3] == 600);
  CHECK(px4.nowMs() >= sentMs + 1600);
}

TEST_CASE("PX4's mode is due when the first target left 1000 ms ago: then a heartbeat is asked for") {
  Follower px4(ClientOnLine::kPx4);
  px4.inMission().start(aboveSeaLevel(620_m));
  while (px4.messages().empty()) px4.pass(1);
  const uint32_t beganMs = px4.given()[0];
  px4.beatsBySecond = px4.beatsWhenAsked = false;
  px4.upTo(beganMs + 600).beat();  // so none is asked for by the target: it has heard the autopilot
  px4.upTo(beganMs + 850).tellLanded();
  px4.asks = 0;
  CHECK(px4.upTo(beganMs + 999).asks == 0);
  CHECK(px4.wait(1).asks == 1);
}

TEST_CASE("PX4's mode is not ordered when the last target left 600 ms ago") {
  for (uint32_t gapMs : {599, 600}) {  // it leaves in the update() after the heartbeat
    CAPTURE(gapMs);
    Follower px4(ClientOnLine::kPx4);
    px4.inMission().start(aboveSeaLevel(620_m));
    while (px4.messages().size() < 5) px4.pass(1);
    px4.beatsBySecond = px4.beatsWhenAsked = false;
    px4.isStuck = true;
    px4.said();
    CHECK(px4.upTo(px4.given().back() + gapMs - 2).said() == "");  // no heartbeat
    px4.beat();
    CHECK(px4.wait(5).said() == (gapMs == 599 ? "L176 1 6 0 0 0 0 0" : ""));
  }
}

TEST_CASE("an answer to a heartbeat's request is none to the sketch's own request of a message") {
  Follower copter;
  copter.follow(20_m, 21000);  // nobody expects answers to the beginning any more
  copter.silence().wait(20).beat();
  copter.wait(250).answering(512);
  static const FlightCommand kOwn = flightCommand(512, 148);
  copter.client.send(kOwn);
  copter.asks = 0;
  for (int ms = 0; ms < 200 && copter.asks == 0; ++ms) copter.pass(1);
  CHECK(copter.asks == 1);
  CHECK(copter.client.isBusy());
  copter.ended = Status::Idle;
  copter.answer(512, 3);
  CHECK(copter.wait(3).client.isBusy());
  copter.answer(512, 0);
  CHECK((copter.wait(3).ended == Status::Done));
}

TEST_CASE("an order that asks for a heartbeat waits 100 ms after the target's request, too") {
  Follower copter;
  copter.follow(20_m, 1000).silence().beat();
  copter.asks = 0;
  while (copter.asks == 0) copter.pass(1);
  copter.wait(50).steering.landNow();
  CHECK(copter.wait(60).asks == 3);  // one by the order, 50 ms between two by the target
  copter.sent.clear();
  const std::vector<uint32_t> asked = copter.wait(1000).timesOf(76, 0);
  REQUIRE(asked.size() >= 10);
  // (The client's clock is the next millisecond's here.)
  for (size_t i = 1; i < asked.size(); ++i) CHECK((asked[i] - asked[i - 1] + 1) % 100 <= 2);
}

TEST_CASE("a target that is due when nothing was heard for 600 ms is not sent") {
  Follower copter;
  copter.follow(20_m, 1000).silence().answering(2500);
  const uint32_t dueMs = copter.given().back() + 400;
  copter.upTo(dueMs - 1).beat();
  copter.wait(290).forget();
  copter.line.room = 0;  // so the requests for a heartbeat are in the way of no target
  static const FlightCommand kOwn = flightCommand(2500);
  copter.client.send(kOwn);
  copter.wait(20).line.room = MemoryStream::kAlwaysRoom;
  copter.pass(500);
  CHECK(copter.given(dueMs) == std::vector<uint32_t>{400});
  CHECK(copter.asks >= 4);
}
