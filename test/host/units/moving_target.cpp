// MovingTarget by a whole client: which targets are sent, when, and with what it ends.
#include <doctest/doctest.h>

#include <algorithm>
#include <initializer_list>
#include <new>

#include "SteeredAircraft.h"
#include "mavmission/base/Checksum.h"

using namespace mavmission;
using namespace steered;

namespace {

constexpr uint16_t kTarget = 86;
constexpr LatLon kPlace = {-35.3630000_deg, 149.1652374_deg};
constexpr LatLon kOther = {-35.3620000_deg, 149.1650000_deg};
constexpr uint8_t kFirmwares[] = {ClientOnLine::kArduPilot, ClientOnLine::kPx4};

typedef mavlink_set_position_target_global_int_t Message;

// An aircraft in its mission, and a sketch that renews a target every 50 ms.
struct Follower : Aircraft {
  MovingTarget target;
  bool renews = true;
  bool isStuck = false;  // loop() does not get there
  LatLon place = kPlace;
  Altitude altitude = 20_m;
  Status renewed = Status::Idle;
  std::vector<Status> ends;  // what update() has returned beside Transferring and Idle

  explicit Follower(uint8_t firmware, uint8_t vehicleType = 2)
      : Aircraft(firmware, vehicleType), target(steering), firmware_(firmware) {}
  Follower& inMission() {
    fly(type == 10 ? uint32_t{kRoverAuto} : isPx4() ? uint32_t{kPx4Mission} : uint32_t{kAuto});
    return *this;
  }
  bool isPx4() const { return firmware_ == kPx4; }

  void loop() override {
    if (isStuck) return;
    const Status status = target.update();
    if (status != Status::Transferring && status != Status::Idle) ends.push_back(status);
    if (renews && nowMs() % 50 == 0) renewed = target.renew(place, altitude);
  }

  // Until it is followed.
  Follower& follow(Altitude height = 20_m) {
    inMission();
    altitude = height;
    CHECK((target.start(place, altitude) == Status::WaitingForAutopilot));
    REQUIRE((end(20000) == Status::Done));
    REQUIRE(target.isFollowed());
    return *this;
  }
  // When the targets left [ms, since `from`]. One that was spoilt while it left is none.
  std::vector<uint32_t> times(uint32_t from) const {
    std::vector<uint32_t> found;
    for (const SentFrame& frame : sent) {
      if (isTarget(frame)) found.push_back(frame.atMs - from);
    }
    return found;
  }
  static bool isTarget(const SentFrame& frame) {
    if (frame.messageId != kTarget) return false;
    const uint8_t extra = 5;
    uint16_t crc = detail::kChecksumStart;
    for (size_t i = 1; i + 2 < frame.frame.size(); ++i) crc = detail::checksum(crc, &frame.frame[i], 1);
    crc = detail::checksum(crc, &extra, 1);
    const size_t end = frame.frame.size();
    return frame.frame[end - 2] == static_cast<uint8_t>(crc) && frame.frame[end - 1] == crc >> 8;
  }
  std::vector<Message> messages() const {
    std::vector<Message> found;
    for (const SentFrame& frame : sent) {
      if (!isTarget(frame)) continue;
      Message message;
      memcpy(&message, frame.payload.data(), sizeof(message));
      found.push_back(message);
    }
    return found;
  }
  // When loop() gave them [ms, since `from`], as they say themselves.
  std::vector<uint32_t> given(uint32_t from) const {
    std::vector<uint32_t> found;
    for (const Message& message : messages()) found.push_back(message.time_boot_ms - from);
    return found;
  }
  // The last target as "latitude longitude altitude frame"; "" if none was sent.
  std::string last() const {
    const std::vector<Message> all = messages();
    if (all.empty()) return "";
    const Message& message = all.back();
    char text[100];
    snprintf(text, sizeof(text), "%d %d %g %d", int{message.lat_int}, int{message.lon_int}, double{float{message.alt}},
             int{message.coordinate_frame});
    return text;
  }
  // The ends since the last call.
  bool ended(Status status) {
    const bool isSo = ends.size() == 1 && ends[0] == status && target.status() == status;
    ends.clear();
    return isSo;
  }

 private:
  uint8_t firmware_;
};

}  // namespace

TEST_CASE("a copter that is followed gets its place five times a second, with every field") {
  Follower copter(ClientOnLine::kArduPilot);
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
  const Message message = copter.messages()[9];
  CHECK(uint32_t{message.time_boot_ms} >= beganMs + times[9] - 3);
  CHECK(uint32_t{message.time_boot_ms} < beganMs + times[9]);
  CHECK(uint8_t{message.target_system} == 1);
  CHECK(uint8_t{message.target_component} == 1);
  CHECK(int32_t{message.lat_int} == -353630000);
  CHECK(int32_t{message.lon_int} == 1491652374);
  CHECK(float{message.alt} == 20.0f);
  CHECK(uint8_t{message.coordinate_frame} == 6);
  CHECK(uint16_t{message.type_mask} == 0x0DF8);
  for (float rest : {float{message.vx}, float{message.vy}, float{message.vz}, float{message.afx}, float{message.afy},
                     float{message.afz}, float{message.yaw}, float{message.yaw_rate}})
    CHECK(rest == 0.0f);
  copter.place = kOther;
  copter.altitude = 25.5_m;
  copter.pass(260);
  CHECK(copter.last() == "-353620000 1491650000 25.5 6");
  CHECK(copter.said() == "");
  CHECK(copter.ends.empty());
}

TEST_CASE("an altitude is above the sea, above the ground, or above home as the sketch says") {
  Follower sea(ClientOnLine::kArduPilot);
  sea.follow(aboveSeaLevel(620.25_m));
  sea.pass(10);
  CHECK(sea.last() == "-353630000 1491652374 620.25 5");
  Follower ground(ClientOnLine::kArduPilot);
  ground.follow(aboveTerrain(-3_m));
  ground.pass(10);
  CHECK(ground.last() == "-353630000 1491652374 -3 11");
  Follower px4(ClientOnLine::kPx4);
  px4.follow(aboveSeaLevel(620.25_m));
  px4.pass(10);
  CHECK(px4.last() == "-353630000 1491652374 620.25 5");
}

TEST_CASE("PX4 gets a second of targets, then its mode, and each height above home as one above the sea") {
  Follower px4(ClientOnLine::kPx4);
  px4.inMission();
  px4.homeMm = 5000;
  px4.seaMm = 604000;
  px4.target.start(kPlace, 20_m);
  REQUIRE(px4.passUntil(176));
  CHECK(px4.said() == "L512 245 0 0 0 0 0 0, L512 242 0 0 0 0 0 0, L511 33 500000 0 0 0 0 0, L176 1 6 0 0 0 0 0");
  const std::vector<uint32_t> times = px4.times(0);
  REQUIRE(times.size() == 6);
  for (size_t i = 1; i < times.size(); ++i) CHECK((times[i] - times[i - 1]) / 2 == 100);
  CHECK(px4.nowMs() - times[0] >= 1000);
  CHECK(px4.nowMs() - times[0] <= 1030);
  CHECK(px4.last() == "-353630000 1491652374 619 5");
  CHECK((px4.end() == Status::Done));
  px4.homeMm = 6000;  // home has been set elsewhere
  px4.pass(800);
  CHECK(px4.last() == "-353630000 1491652374 618 5");
}

TEST_CASE("a rover is followed like a copter, and a plane not at all") {
  Follower rover(ClientOnLine::kArduPilot, 10);
  rover.follow();
  CHECK(rover.said() == "L511 33 500000 0 0 0 0 0, L176 1 15 0 0 0 0 0");
  rover.pass(10);
  CHECK(rover.last() == "-353630000 1491652374 20 6");
  Follower plane(ClientOnLine::kArduPilot, 1);
  plane.fly(kPlaneAuto);
  plane.target.start(kPlace, 20_m);
  CHECK((plane.end(1000) == Status::CommandUnsupported));
  plane.pass(2);
  CHECK(plane.ended(Status::CommandUnsupported));
  CHECK(plane.said() == "");
}

TEST_CASE("what is refused by goTo() is refused by start(), and told by update() too") {
  const struct {
    LatLon place;
    Altitude altitude;
    Status status;
  } kCases[] = {{{0_deg, 0_deg}, 20_m, Status::NeedsCoordinates},
                {kPlace, 10001_m, Status::BadAltitude},
                {kPlace, Altitude(20_m, CoordinateFrame::Mission), Status::BadFrame}};
  for (const auto& one : kCases) {
    Follower copter(ClientOnLine::kArduPilot);
    copter.inMission();
    copter.renews = false;
    copter.target.start(one.place, one.altitude);
    CHECK((copter.end(1000) == one.status));
    CHECK((copter.target.status() == one.status));  // before update() has told it
    copter.pass(2);
    CHECK(copter.ended(one.status));
    CHECK(copter.said() == "");
    CHECK_FALSE(copter.target.isFollowed());
  }
  Follower copter(ClientOnLine::kArduPilot);
  copter.fly(kLoiter);
  copter.target.start(kPlace, 20_m);
  CHECK((copter.end(1000) == Status::PilotHasIt));
  copter.pass(2);
  CHECK(copter.ended(Status::PilotHasIt));
  CHECK((copter.target.renew(kPlace, 20_m) == Status::PilotHasIt));
}

TEST_CASE("only one begins at a time") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.inMission();
  copter.steering.setSpeed(5_mps);
  CHECK((copter.target.start(kPlace, 20_m) == Status::Busy));
  CHECK((copter.target.status() == Status::Idle));
  REQUIRE((copter.end() == Status::Done));
  CHECK((copter.target.start(kPlace, 20_m) == Status::WaitingForAutopilot));
  CHECK((copter.target.start(kOther, 30_m) == Status::Busy));
  REQUIRE((copter.end() == Status::Done));
  CHECK((copter.target.start(kOther, 30_m) == Status::Busy));
  copter.pass(300);
  CHECK(copter.last() == "-353630000 1491652374 20 6");
}

TEST_CASE("a renewal with a number that cannot be meant does not count, and names its field") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.follow();
  copter.renews = false;
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
  copter.pass(205);
  CHECK(copter.last() == "-353620000 1491650000 21 6");
  CHECK((copter.target.renew(kPlace, 10001_m) == Status::BadAltitude));
  copter.pass(1000);
  CHECK((copter.target.renew(kPlace, 20_m) == Status::NotRenewed));
}

TEST_CASE("a copter whose target is not renewed for a second holds its position") {
  for (uint16_t timeoutMs : {0, 300}) {
    Follower copter(ClientOnLine::kArduPilot);
    if (timeoutMs != 0) copter.target.setTimeout(timeoutMs);
    copter.follow();
    const uint32_t limitMs = timeoutMs != 0 ? timeoutMs : 1000;
    copter.pass(1000);
    copter.renews = false;
    REQUIRE((copter.target.renew(kPlace, 20_m) == Status::Transferring));
    const uint32_t renewedMs = copter.nowMs();
    copter.said();
    while (copter.target.isFollowed()) copter.pass(1);
    CHECK(copter.nowMs() - renewedMs == limitMs + 2);
    CHECK((copter.target.status() == Status::Transferring));
    CHECK((copter.target.renew(kPlace, 20_m) == Status::NotRenewed));
    const uint32_t lastMs = copter.times(0).back();
    CHECK(lastMs - renewedMs <= limitMs + 2);
    CHECK((copter.end() == Status::Done));
    copter.pass(2);
    CHECK(copter.ended(Status::NotRenewed));
    CHECK(copter.said() == "I192 frame 6 -1 0 0 nan -353632621 1491652374 0");
    CHECK(copter.times(0).back() == lastMs);
    CHECK((copter.target.renew(kPlace, 20_m) == Status::NotRenewed));
    copter.pass(3000);
    CHECK(copter.ends.empty());
    CHECK(copter.steering.maySteer());
  }
}

TEST_CASE("stop() makes it hold its position, and that is done") {
  for (uint8_t firmware : kFirmwares) {
    Follower aircraft(firmware);
    aircraft.follow();
    aircraft.pass(1000);
    aircraft.said();
    aircraft.target.stop();
    CHECK((aircraft.target.renew(kPlace, 20_m) == Status::Cancelled));
    aircraft.pass(1);
    CHECK_FALSE(aircraft.target.isFollowed());
    CHECK((aircraft.target.renew(kPlace, 20_m) == Status::Done));
    CHECK((aircraft.end() == Status::Done));
    aircraft.pass(2);
    CHECK(aircraft.ended(Status::Done));
    CHECK((aircraft.target.renew(kPlace, 20_m) == Status::Done));
    const std::string words = aircraft.said();
    if (firmware == ClientOnLine::kPx4) {
      CHECK(words.find("L512 245 0 0 0 0 0 0") == 0);
      CHECK(words.find(", L192 -1 1 0 nan nan nan nan") == words.size() - 29);
    } else {
      CHECK(words == "I192 frame 6 -1 0 0 nan -353632621 1491652374 0");
    }
  }
}

TEST_CASE("a start() that is stopped, or not renewed, before the mode was ordered is given up") {
  for (uint8_t firmware : kFirmwares) {
    for (bool isStopped : {false, true}) {
      Follower aircraft(firmware);
      aircraft.inMission();
      aircraft.gives[511] = kUnheard;
      aircraft.renews = false;
      aircraft.target.start(kPlace, 20_m);
      aircraft.pass(500);
      CHECK(aircraft.client.isBusy());
      if (isStopped) aircraft.target.stop();
      aircraft.end(1000);
      aircraft.pass(2);
      CHECK(aircraft.ended(isStopped ? Status::Cancelled : Status::NotRenewed));
      CHECK(aircraft.tookMs <= (isStopped ? 5 : 505));
      CHECK(aircraft.messages().empty());
    }
  }
}

TEST_CASE("cancel() of a start() ends it, and nothing holds the aircraft") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.inMission();
  copter.target.start(kPlace, 20_m);
  REQUIRE(copter.passUntil(176));
  copter.client.cancel();
  copter.pass(3000);
  CHECK(copter.ended(Status::Cancelled));
  CHECK(copter.said() == "L511 33 500000 0 0 0 0 0, L176 1 4 0 0 0 0 0");
  CHECK(copter.messages().empty());
}

TEST_CASE("an aircraft that is not heard is not started") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.beatsBySecond = false;
  copter.client.setAutopilotTimeout(3);
  copter.target.start(kPlace, 20_m);
  CHECK((copter.end(5000) == Status::NoAutopilot));
  copter.pass(2);
  CHECK(copter.ended(Status::NoAutopilot));
}

TEST_CASE("a heartbeat with another mode, a failsafe, or no arms ends the following at once, and says who has it") {
  for (uint8_t firmware : kFirmwares) {
    const bool isPx4 = firmware == ClientOnLine::kPx4;
    for (int what = 0; what < 5; ++what) {
      CAPTURE(firmware);
      CAPTURE(what);
      Follower aircraft(firmware);
      aircraft.follow();
      aircraft.pass(1000);
      aircraft.said();
      Status expected = Status::PilotHasIt;
      uint32_t mode = isPx4 ? uint32_t{kPx4Position} : uint32_t{kLoiter};
      if (what == 1) {
        mode = isPx4 ? uint32_t{kPx4Rtl} : uint32_t{kRtl};
        expected = Status::FailsafeHasIt;
      }
      if (what == 2) {
        aircraft.isArmed = false;
        mode = aircraft.mode;
        expected = Status::NotArmed;
      }
      if (what == 3) {
        aircraft.state = kCritical;
        mode = aircraft.mode;
        expected = isPx4 ? Status::FailsafeHasIt : Status::Transferring;
      }
      if (what == 4) mode = isPx4 ? uint32_t{kPx4Mission} : uint32_t{kAuto};  // somebody goes on with the mission
      aircraft.show(mode);
      aircraft.pass(4);
      aircraft.sent.clear();
      if (expected == Status::Transferring) {
        CHECK(aircraft.target.isFollowed());
        continue;
      }
      CHECK(aircraft.ended(expected));
      CHECK_FALSE(aircraft.target.isFollowed());
      CHECK((aircraft.target.renew(kPlace, 20_m) == expected));
      aircraft.pass(3000);
      CHECK(aircraft.messages().empty());
      CHECK(aircraft.said() == "");
      CHECK(aircraft.ends.empty());
    }
  }
}

TEST_CASE("another order of the sketch ends the following, and a speed does not") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.follow();
  copter.pass(1000);
  copter.steering.setSpeed(5_mps);
  REQUIRE((copter.end() == Status::Done));
  CHECK(copter.target.isFollowed());
  copter.said();
  copter.steering.goTo(kOther, 30_m);
  copter.pass(2);
  CHECK_FALSE(copter.target.isFollowed());
  CHECK((copter.target.renew(kPlace, 20_m) == Status::Cancelled));
  CHECK((copter.end() == Status::Done));
  copter.pass(10);
  CHECK(copter.ended(Status::Cancelled));
  CHECK(copter.said() == "I192 frame 6 -1 0 0 nan -353620000 1491650000 30");
}

TEST_CASE("an order that leads into another mode ends with that mode, and one that fails is followed by a hold") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.follow();
  copter.steering.landNow();
  CHECK((copter.end() == Status::Done));
  copter.pass(10);
  CHECK(copter.ended(Status::Cancelled));
  Follower refused(ClientOnLine::kArduPilot);
  refused.follow();
  refused.pass(1000);
  refused.said();
  refused.gives[176] = 4;
  refused.steering.landNow();
  CHECK((refused.end() == Status::CommandFailed));
  CHECK((refused.end() == Status::Done));
  refused.pass(2);
  CHECK(refused.ended(Status::Cancelled));
  CHECK(refused.said() == "L176 1 9 0 0 0 0 0, I192 frame 6 -1 0 0 nan -353632621 1491652374 0");
}

TEST_CASE("loop() that has stood still for 0.6 s sends nothing until a new heartbeat shows who has the aircraft") {
  for (uint32_t stillMs : {599, 600}) {
    CAPTURE(stillMs);
    Follower copter(ClientOnLine::kArduPilot);
    copter.follow();
    copter.pass(1000);
    copter.beatsBySecond = copter.beatsWhenAsked = copter.hasPosition = false;
    copter.pass(10);
    copter.beat();  // heard when loop() goes on
    copter.asks = 0;
    copter.run(stillMs, stillMs);
    copter.target.renew(kPlace, 20_m);
    copter.sent.clear();
    copter.pass(150);
    CHECK(copter.messages().empty() == (stillMs == 600));
    CHECK(copter.asks == (stillMs == 600 ? 2 : 0));
    if (stillMs < 600) continue;
    copter.pass(100);
    copter.beat();
    copter.pass(150);
    CHECK_FALSE(copter.messages().empty());
    CHECK(copter.target.isFollowed());
  }
}

TEST_CASE("a position from before a standstill is not known any more") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.inMission();
  copter.homeMm = 20000;
  copter.here = kPlace;
  copter.steering.goTo(kPlace, 20_m);
  REQUIRE((copter.end() == Status::Done));
  copter.pass(600);
  REQUIRE(copter.steering.hasArrived());
  copter.hasPosition = false;
  copter.run(700, 700);
  copter.pass(1);
  CHECK_FALSE(copter.steering.hasArrived());
}

TEST_CASE("a loop() that stood still until its target was old makes the aircraft hold when that is heard again") {
  for (uint32_t stillMs : {1500, 7000}) {  // in the second, the autopilot counts as lost
    CAPTURE(stillMs);
    Follower copter(ClientOnLine::kArduPilot);
    copter.follow();
    copter.pass(1000);
    copter.beatsBySecond = copter.beatsWhenAsked = copter.hasPosition = copter.renews = false;
    copter.run(stillMs, stillMs);
    CHECK((copter.target.renew(kPlace, 20_m) == Status::NotRenewed));
    copter.said();
    copter.pass(2000);
    CHECK((copter.target.status() == Status::Transferring));
    CHECK_FALSE(copter.target.isFollowed());
    CHECK(copter.said() == "");
    copter.beatsBySecond = copter.beatsWhenAsked = copter.hasPosition = true;
    copter.pass(5000);
    CHECK(copter.ended(Status::NotRenewed));
    CHECK(copter.said().find("I192 frame 6 -1 0 0 nan -353632621 1491652374 0") != std::string::npos);
  }
  Follower lost(ClientOnLine::kArduPilot);
  lost.follow();
  lost.pass(1000);
  lost.beatsBySecond = lost.beatsWhenAsked = lost.hasPosition = lost.renews = false;
  lost.run(1500, 1500);
  lost.pass(4990);
  CHECK((lost.target.status() == Status::Transferring));
  lost.pass(20);
  CHECK(lost.ended(Status::NoAutopilot));
}

TEST_CASE("an autopilot that is silent while its target is renewed is lost after 5 s") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.follow();
  copter.pass(1000);
  copter.beatsBySecond = copter.beatsWhenAsked = copter.hasPosition = false;
  copter.pass(3500);
  CHECK(copter.target.isFollowed());
  copter.pass(2500);
  CHECK(copter.ended(Status::NoAutopilot));
}

TEST_CASE("the last target leaves before 0.6 s of silence, and a heartbeat is asked for at 0.3 s and each 0.1 s") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.follow();
  copter.pass(1000);
  copter.beatsBySecond = copter.beatsWhenAsked = copter.hasPosition = false;
  const uint32_t dueMs = copter.given(0).back() + 400;  // a target is due in this loop()
  for (; copter.nowMs() + 1 != dueMs;) copter.pass(1);
  copter.sent.clear();
  copter.beat();
  copter.pass(1000);
  CHECK(copter.given(dueMs).back() < 600);
  std::vector<uint32_t> asked;
  for (const SentFrame& frame : copter.sent) {
    if (frame.messageId == 76) asked.push_back(frame.atMs - dueMs);
  }
  REQUIRE(asked.size() >= 4);
  CHECK(asked[0] == 301);
  CHECK(asked[3] - asked[2] == 100);
}

TEST_CASE("where nothing is followed, no heartbeat is asked for") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.inMission();
  copter.beatsBySecond = false;
  copter.pass(2000);
  CHECK(copter.asks == 0);
}

TEST_CASE("a target that is half sent when it is no longer true is spoilt, and stays so") {
  for (int what = 0; what < 4; ++what) {
    CAPTURE(what);
    Follower copter(ClientOnLine::kArduPilot);
    copter.follow();
    copter.pass(1000);
    copter.hasPosition = false;
    const uint32_t dueMs = copter.given(0).back() + 400;
    for (; copter.nowMs() != dueMs;) copter.pass(1);
    copter.line.room = 20;
    copter.pass(3);
    copter.sent.clear();
    if (what == 0) copter.run(700, 700);
    if (what == 1 || what == 3) {
      copter.mode = kLoiter;
      if (what == 3) copter.target.stop();
      copter.beat();
    }
    if (what == 2) copter.target.stop();
    copter.pass(3);
    copter.line.room = MemoryStream::kAlwaysRoom;
    copter.pass(20);
    REQUIRE_FALSE(copter.timesOf(kTarget, 0).empty());
    CHECK_FALSE(Follower::isTarget(*std::find_if(copter.sent.begin(), copter.sent.end(),
                                                 [](const SentFrame& frame) { return frame.messageId == kTarget; })));
  }
}

TEST_CASE("an autopilot that is silent is asked for a heartbeat, and gets no target after 0.6 s") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.follow();
  copter.pass(3000);
  copter.beatsBySecond = copter.beatsWhenAsked = copter.hasPosition = false;
  copter.beat();
  copter.pass(1);
  const uint32_t heardMs = copter.nowMs();
  copter.forget();
  copter.pass(1500);
  const std::vector<uint32_t> targets = copter.times(heardMs);
  REQUIRE_FALSE(targets.empty());
  CHECK(targets.back() > 400);
  CHECK(targets.back() <= 602);
  std::vector<uint32_t> asked;
  for (const SentFrame& frame : copter.sent) {
    if (frame.messageId == 76) asked.push_back(frame.atMs - heardMs);
  }
  REQUIRE(asked.size() == 12);
  for (size_t i = 0; i < asked.size(); ++i) {
    CHECK(asked[i] >= 300 + 100 * i);
    CHECK(asked[i] <= 302 + 101 * i);
  }
  CHECK(copter.target.isFollowed());
  copter.beat();
  copter.pass(205);
  CHECK(copter.times(heardMs).size() > targets.size());
}

TEST_CASE("PX4's targets go on until its mode is HOLD, and name where it is") {
  Follower px4(ClientOnLine::kPx4);
  px4.follow(aboveSeaLevel(620_m));
  px4.pass(3000);
  px4.here = kOther;
  px4.seaMm = 600500;
  px4.pass(600);
  px4.gives[192] = kUnheard;
  px4.target.stop();
  px4.pass(1000);
  CHECK(px4.last() == "-353620000 1491650000 600.5 5");
  px4.here = kPlace;  // where it was when the hold began
  px4.pass(1000);
  CHECK(px4.last() == "-353620000 1491650000 600.5 5");
  px4.gives.clear();
  CHECK((px4.end() == Status::Done));
  px4.pass(5);
  CHECK(px4.ended(Status::Done));
  px4.sent.clear();
  px4.pass(1000);
  CHECK(px4.messages().empty());
}

TEST_CASE("a hold that is refused is told, and one that somebody else takes over, too") {
  Follower refused(ClientOnLine::kArduPilot);
  refused.follow();
  refused.pass(1000);
  refused.gives[192] = 4;
  refused.target.stop();
  CHECK((refused.end() == Status::CommandFailed));
  refused.pass(2);
  CHECK(refused.ended(Status::CommandFailed));
  Follower taken(ClientOnLine::kArduPilot);
  taken.follow();
  taken.pass(1000);
  taken.gives[192] = kUnheard;
  taken.target.stop();
  REQUIRE(taken.passUntil(192));
  taken.pass(500);
  taken.show(kLoiter);
  taken.pass(1000);
  CHECK(taken.ended(Status::PilotHasIt));
  Follower cancelled(ClientOnLine::kArduPilot);
  cancelled.follow();
  cancelled.pass(1000);
  cancelled.gives[192] = kUnheard;
  cancelled.target.stop();
  REQUIRE(cancelled.passUntil(192));
  cancelled.client.cancel();
  cancelled.pass(5);
  CHECK(cancelled.ended(Status::Cancelled));
}

TEST_CASE("a hold waits until the client is free, and the copter is told where to stay meanwhile") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.follow(aboveSeaLevel(620_m));
  copter.pass(3000);
  copter.client.allowWhileArmed(true);
  static const MissionItem kPlan[] = {waypoint(1_deg, 2_deg, 3_m)};
  copter.client.upload(inRam(kPlan));
  REQUIRE(copter.client.isBusy());
  copter.homeMm = 7000;
  copter.tellPosition();
  copter.pass(20);
  copter.target.stop();
  copter.said();
  copter.pass(1000);
  CHECK(copter.last() == "-353632621 1491652374 7 6");
  CHECK(copter.said() == "");
  copter.client.cancel();
  copter.ends.clear();
  CHECK((copter.end() == Status::Done));
  copter.pass(3);
  CHECK(copter.ended(Status::Done));
}

TEST_CASE("an end that was not told yet is not that of the next start()") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.inMission();
  copter.renews = false;
  copter.target.start({0_deg, 0_deg}, 20_m);
  REQUIRE((copter.end(1000) == Status::NeedsCoordinates));
  copter.renews = true;
  copter.target.start(kPlace, 20_m);
  copter.pass(10);
  CHECK(copter.ends.empty());
  CHECK((copter.end() == Status::Done));
}

TEST_CASE("a start() that was cancelled for another operation is cancelled") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.inMission();
  copter.target.start(kPlace, 20_m);
  REQUIRE(copter.passUntil(511));
  copter.client.cancel();
  copter.steering.setSpeed(5_mps);
  copter.pass(2);
  CHECK(copter.ended(Status::Cancelled));
}

TEST_CASE("a vehicle that does not say what it is is not followed") {
  Follower rover(ClientOnLine::kArduPilot, 10);
  rover.saysVehicle = false;
  rover.gives[3000] = kUnheard;
  rover.inMission();
  rover.target.start(kPlace, 20_m);
  CHECK((rover.end(20000) == Status::NoAnswer));
  CHECK((rover.target.status() == Status::NoAnswer));
}

TEST_CASE("a mode that start() has undone is set again") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.inMission();
  copter.target.start(kPlace, 20_m);
  copter.gives[176] = kUnheard;
  REQUIRE(copter.passUntil(176));
  copter.show(kLoiter);
  copter.pass(5);
  copter.said();
  copter.show(kGuided);
  CHECK(copter.passUntil(176, 50));
  CHECK(copter.said() == "L176 1 5 0 0 0 0 0");
  copter.show(kLoiter);
  copter.show(kLoiter);
  copter.pass(500);
  CHECK(copter.ended(Status::PilotHasIt));
}

TEST_CASE("an aircraft that is followed in the mode in which it was sent to a place has no place any more") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.inMission();
  copter.homeMm = 20000;
  copter.here = kPlace;
  copter.steering.goTo(kPlace, 20_m);
  REQUIRE((copter.end() == Status::Done));
  copter.pass(600);
  REQUIRE(copter.steering.hasArrived());
  copter.said();
  copter.target.start(kPlace, 20_m);
  REQUIRE((copter.end() == Status::Done));
  CHECK(copter.said() == "");
  CHECK_FALSE(copter.steering.hasArrived());
  copter.target.stop();
  copter.pass(1000);
  CHECK(copter.ended(Status::Done));
  CHECK(copter.said() == "I192 frame 6 -1 0 0 nan -353630000 1491652374 20");
}

TEST_CASE("PX4's mode is ordered again when it is not answered, and its targets then name where it is") {
  Follower px4(ClientOnLine::kPx4);
  px4.inMission();
  px4.altitude = aboveSeaLevel(620_m);
  px4.gives[176] = kUnheard;
  px4.target.start(kPlace, aboveSeaLevel(620_m));
  REQUIRE(px4.passUntil(176));
  REQUIRE(px4.passUntil(176, 1700));
  px4.renews = false;
  px4.pass(800);
  CHECK(px4.last() == "-353630000 1491652374 620 5");
  px4.pass(450);
  CHECK(px4.last() == "-353632621 1491652374 584 5");
}

TEST_CASE("PX4 that the sketch lands gets targets until its mode has changed") {
  Follower px4(ClientOnLine::kPx4);
  px4.follow(aboveSeaLevel(620_m));
  px4.pass(3000);
  px4.gives[176] = kUnheard;
  px4.steering.landNow();
  px4.pass(1000);
  px4.sent.clear();
  px4.pass(1000);
  CHECK(px4.messages().size() == 5);
  CHECK(px4.last() == "-353632621 1491652374 584 5");
}

TEST_CASE("a hold that does not know where the aircraft is aims when that is told") {
  Follower px4(ClientOnLine::kPx4);
  px4.follow(aboveSeaLevel(620_m));
  px4.pass(1000);
  px4.hasPosition = false;
  px4.pass(5000);
  px4.gives[512] = kUnheard;
  px4.target.stop();
  px4.pass(100);
  px4.sent.clear();
  px4.pass(500);
  CHECK(px4.messages().empty());
  px4.here = kOther;
  px4.tellPosition();
  px4.pass(300);
  CHECK(px4.last() == "-353620000 1491650000 584 5");
}

TEST_CASE("what loop() hears last decides: a stop() behind a pilot's heartbeat is the pilot's") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.follow();
  copter.pass(1000);
  copter.mode = kLoiter;
  copter.beat();
  copter.run(3);
  copter.target.stop();
  CHECK((copter.target.update() == Status::PilotHasIt));
}

TEST_CASE("it may begin again when it has ended") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.follow();
  copter.target.stop();
  REQUIRE((copter.end() == Status::Done));
  copter.pass(2);
  REQUIRE(copter.ended(Status::Done));
  copter.said();
  CHECK((copter.target.start(kOther, aboveSeaLevel(620_m)) == Status::WaitingForAutopilot));
  copter.place = kOther;
  copter.altitude = aboveSeaLevel(620_m);
  REQUIRE((copter.end() == Status::Done));
  CHECK(copter.target.isFollowed());
  copter.pass(10);
  CHECK(copter.last() == "-353620000 1491650000 620 5");
}

TEST_CASE("a MovingTarget in memory that was used before begins like any other") {
  for (int fill : {0, 0x55, 0xFF}) {
    CAPTURE(fill);
    alignas(16) static uint8_t memory[sizeof(Follower)];
    memset(memory, fill, sizeof(memory));
    Follower& copter = *new (memory) Follower(ClientOnLine::kArduPilot);
    CHECK((copter.target.status() == Status::Idle));
    CHECK_FALSE(copter.target.isFollowed());
    CHECK((copter.target.renew(kPlace, 20_m) == Status::Idle));
    copter.pass(2000);
    CHECK(copter.ends.empty());
    CHECK((copter.target.update() == Status::Idle));
    copter.follow();
    copter.pass(1000);
    CHECK(copter.messages().size() == 5);
    copter.~Follower();
  }
}

TEST_CASE("PX4's second of targets begins anew behind a gap of 0.6 s") {
  Follower px4(ClientOnLine::kPx4);
  px4.inMission();
  px4.altitude = aboveSeaLevel(620_m);
  px4.target.start(kPlace, aboveSeaLevel(620_m));
  for (int ms = 0; ms < 5000 && px4.messages().size() < 3; ++ms) px4.pass(1);
  const uint32_t sentMs = px4.given(0).back();
  REQUIRE(px4.nowMs() < sentMs + 10);
  px4.isStuck = true;
  const uint32_t updatedMs = px4.nowMs() - 1;
  while (px4.nowMs() != sentMs + 600) px4.pass(1);
  REQUIRE(px4.nowMs() - updatedMs < 600);
  px4.isStuck = false;
  REQUIRE(px4.passUntil(176));
  REQUIRE(px4.given(sentMs).size() > 3);
  CHECK(px4.given(sentMs)[3] == 600);
  CHECK(px4.nowMs() >= sentMs + 1600);
}

TEST_CASE("a hold aims where the aircraft was told to be within three seconds") {
  for (uint32_t ms : {2900, 4200}) {
    CAPTURE(ms);
    Follower copter(ClientOnLine::kArduPilot);
    copter.follow();
    copter.pass(3000);
    copter.client.allowWhileArmed(true);
    static const MissionItem kPlan[] = {waypoint(1_deg, 2_deg, 3_m)};
    copter.client.upload(inRam(kPlan));
    copter.hasPosition = false;
    copter.homeMm = 9000;
    copter.tellPosition();
    copter.pass(ms);
    copter.target.stop();
    copter.pass(3);
    copter.sent.clear();
    copter.pass(220);
    CHECK(copter.last() == (ms == 2900 ? "-353632621 1491652374 9 6" : ""));
  }
}

TEST_CASE("a hold that is blind for 5 s has no autopilot any more, to the millisecond") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.follow();
  copter.pass(1000);
  copter.beatsBySecond = copter.beatsWhenAsked = copter.hasPosition = copter.renews = false;
  copter.run(1500, 1500);
  const uint32_t blindMs = copter.nowMs();
  while (copter.nowMs() != blindMs + 5000) copter.pass(1);
  CHECK((copter.target.status() == Status::Transferring));
  CHECK(copter.ends.empty());
  copter.pass(1);
  CHECK(copter.ended(Status::NoAutopilot));
}

TEST_CASE("PX4's mode is due when the first target left 1000 ms ago: then a heartbeat is asked for") {
  Follower px4(ClientOnLine::kPx4);
  px4.inMission();
  px4.altitude = aboveSeaLevel(620_m);
  px4.target.start(kPlace, aboveSeaLevel(620_m));
  while (px4.messages().empty()) px4.pass(1);
  const uint32_t beganMs = px4.given(0)[0];
  px4.beatsBySecond = px4.beatsWhenAsked = false;
  while (px4.nowMs() != beganMs + 600) px4.pass(1);
  px4.beat();  // so none is asked for by the target: it has heard the autopilot
  while (px4.nowMs() != beganMs + 850) px4.pass(1);
  px4.tellLanded();
  px4.asks = 0;
  while (px4.nowMs() != beganMs + 999) px4.pass(1);
  CHECK(px4.asks == 0);
  px4.pass(1);
  CHECK(px4.asks == 1);
}

TEST_CASE("PX4's mode is not ordered when the last target left 600 ms ago") {
  for (uint32_t gapMs : {599, 600}) {  // it leaves in the update() behind the heartbeat
    CAPTURE(gapMs);
    Follower px4(ClientOnLine::kPx4);
    px4.inMission();
    px4.altitude = aboveSeaLevel(620_m);
    px4.target.start(kPlace, aboveSeaLevel(620_m));
    while (px4.messages().size() < 5) px4.pass(1);
    const uint32_t sentMs = px4.given(0).back();
    px4.beatsBySecond = px4.beatsWhenAsked = false;
    px4.isStuck = true;
    px4.said();
    while (px4.nowMs() != sentMs + gapMs - 2) px4.pass(1);
    CHECK(px4.said() == "");  // no heartbeat
    px4.beat();
    px4.pass(5);
    CHECK(px4.said() == (gapMs == 599 ? "L176 1 6 0 0 0 0 0" : ""));
  }
}

TEST_CASE("an answer to a heartbeat's request is none to the sketch's own request of a message") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.follow();
  copter.pass(21000);  // nobody expects answers to the beginning any more
  copter.beatsBySecond = copter.beatsWhenAsked = copter.hasPosition = false;
  copter.pass(20);
  copter.beat();
  copter.pass(250);
  copter.gives[512] = kUnheard;
  static const FlightCommand kOwn = flightCommand(512, 148);
  copter.client.send(kOwn);
  copter.asks = 0;
  for (int ms = 0; ms < 200 && copter.asks == 0; ++ms) copter.pass(1);
  CHECK(copter.asks == 1);
  CHECK(copter.client.isBusy());
  copter.Aircraft::ended = Status::Idle;
  copter.answer(512, 3);
  copter.pass(3);
  CHECK(copter.client.isBusy());
  copter.answer(512, 0);
  copter.pass(3);
  CHECK((copter.Aircraft::ended == Status::Done));
}

TEST_CASE("an order that asks for a heartbeat waits 100 ms behind the target's request, too") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.follow();
  copter.pass(1000);
  copter.beatsBySecond = copter.beatsWhenAsked = copter.hasPosition = false;
  copter.beat();
  copter.asks = 0;
  while (copter.asks == 0) copter.pass(1);
  copter.pass(50);
  copter.steering.landNow();
  copter.pass(60);
  CHECK(copter.asks == 3);  // one by the order, 50 ms between two by the target
  copter.sent.clear();
  copter.pass(1000);
  const std::vector<uint32_t> asked = copter.timesOf(76, 0);
  REQUIRE(asked.size() >= 10);
  // (The client's clock is the next millisecond's here.)
  for (size_t i = 1; i < asked.size(); ++i) CHECK((asked[i] - asked[i - 1] + 1) % 100 <= 2);
}

TEST_CASE("a target that is due when nothing was heard for 600 ms is not sent") {
  Follower copter(ClientOnLine::kArduPilot);
  copter.follow();
  copter.pass(1000);
  copter.beatsBySecond = copter.beatsWhenAsked = copter.hasPosition = false;
  copter.gives[2500] = kUnheard;
  const uint32_t dueMs = copter.given(0).back() + 400;
  while (copter.nowMs() + 1 != dueMs) copter.pass(1);
  copter.beat();
  copter.pass(290);
  copter.forget();
  copter.line.room = 0;  // so the requests for a heartbeat are in the way of no target
  static const FlightCommand kOwn = flightCommand(2500);
  copter.client.send(kOwn);
  copter.pass(20);
  copter.line.room = MemoryStream::kAlwaysRoom;
  copter.pass(500);
  REQUIRE(copter.given(dueMs).size() == 1);
  CHECK(copter.given(dueMs)[0] == 400);
  CHECK(copter.asks >= 4);
}
