// What an operation of PlanFiles leaves behind: the next one begins as if there had been none.
#include <doctest/doctest.h>

#include "FilePilot.h"

using namespace mavmission;

namespace {

constexpr MissionItem kPlan[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
                                 waypoint(-35.3642621_deg, 149.1662374_deg, 30_m), returnToLaunch()};
constexpr MissionItem kOther[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
                                  waypoint(-35.3642621_deg, 149.1662374_deg, 31_m), returnToLaunch()};
constexpr MissionItem kShort[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m)};
constexpr MissionItem kCorners[] = {fenceInside(-35.3632621_deg, 149.1652374_deg, 3),
                                    fenceInside(-35.3642621_deg, 149.1652374_deg, 3),
                                    fenceInside(-35.3642621_deg, 149.1662374_deg, 3)};

const char kReading[] = "open @MISSION/mission.dat, read 0+10, burst 10+38, close";

// Found, and with no file that could be open; it holds another plan.
struct Pilot : FilePilot {
  Pilot() : FilePilot(kArduPilot) {
    pass(4000);
    said();
    hold({::kOther[0], ::kOther[1], ::kOther[2], ::kOther[3]});
  }
  void arm() {
    baseMode = 128 | 1;
    beat();
    pass(10);
    client.allowWhileArmed(true);
  }
  void disarm() {
    baseMode = 0;
    beat();
    pass(10);
  }
  bool asksFor(uint16_t messageId, uint32_t limitMs = 5000) {
    sent.clear();
    return runByMs(messageId, limitMs);
  }
  // The file that was left open is closed, and nothing more is said.
  void settle() {
    pass(3000);
    said();
  }

 private:
  bool runByMs(uint16_t messageId, uint32_t limitMs) {
    for (; limitMs != 0; --limitMs) {
      pass(1);
      if (!timesOf(messageId, 0).empty()) return true;
    }
    return false;
  }
};

}  // namespace

TEST_CASE("a fence of up to three items goes by the mission protocol also behind an upload by file") {
  Pilot pilot;
  pilot.files.upload(inRam(kPlan));
  REQUIRE((pilot.end() == Status::Accepted));
  REQUIRE(pilot.files.isByFile());
  pilot.files.upload(inRam(kCorners), PlanType::Fence);
  CHECK_FALSE(pilot.files.isByFile());
  CHECK(pilot.asksFor(FilePilot::kCount));
  CHECK_FALSE(pilot.files.isByFile());
}

TEST_CASE("each operation goes by no file until it has asked for one") {
  Pilot pilot;
  pilot.files.upload(inRam(kPlan));
  REQUIRE((pilot.end() == Status::Accepted));
  REQUIRE(pilot.files.isByFile());
  pilot.files.upload(inRam(kOther));
  CHECK_FALSE(pilot.files.isByFile());
  REQUIRE((pilot.end() == Status::Accepted));
  REQUIRE(pilot.files.isByFile());
  pilot.files.verify(inRam(kOther));
  CHECK_FALSE(pilot.files.isByFile());
  REQUIRE((pilot.end() == Status::Verified));
  REQUIRE(pilot.files.isByFile());
  pilot.files.ensure(inRam(kOther));
  CHECK_FALSE(pilot.files.isByFile());
}

TEST_CASE("an upload behind an ensure() may change the plan of an armed autopilot, if that is allowed") {
  Pilot pilot;
  pilot.files.ensure(inRam(kPlan));
  REQUIRE((pilot.end() == Status::Accepted));
  pilot.arm();
  pilot.files.upload(inRam(kShort));
  CHECK(pilot.asksFor(FilePilot::kCount));
}

TEST_CASE("an upload behind one to an armed autopilot gets no header when it is armed again meanwhile") {
  Pilot pilot;
  pilot.arm();
  pilot.files.upload(inRam(kPlan));
  REQUIRE((pilot.end() == Status::Accepted));
  pilot.disarm();
  pilot.client.allowWhileArmed(false);
  pilot.said();
  pilot.files.upload(inRam(kOther));
  REQUIRE(pilot.passUntil("write 10"));
  pilot.baseMode = 128 | 1;
  pilot.beat();
  CHECK((pilot.end() == Status::Armed));
  CHECK(pilot.said() == "create @MISSION/mission.dat, write 10+190");
}

TEST_CASE("behind a look at the number of items that was cancelled, all of the plan is verified") {
  Pilot pilot;
  pilot.arm();
  pilot.files.upload(inRam(kPlan));
  REQUIRE(pilot.passUntil("open"));
  pilot.client.cancel();
  pilot.settle();
  pilot.files.verify(inRam(kPlan));
  CHECK((pilot.end() == Status::Differs));
  CHECK(pilot.said() == kReading);
}

TEST_CASE("behind a look that was cancelled, what cannot be read as a file is read item by item") {
  for (bool isEnsured : {false, true}) {
    Pilot pilot;
    if (isEnsured) {
      pilot.files.ensure(inRam(kPlan));
    } else {
      pilot.arm();
      pilot.files.upload(inRam(kPlan));
    }
    REQUIRE(pilot.passUntil("open"));
    pilot.client.cancel();
    pilot.settle();
    pilot.gives[FilePilot::kOpen] = FilePilot::kFail;
    pilot.files.verify(inRam(kPlan));
    CHECK(pilot.asksFor(FilePilot::kRequestList));
    CHECK_FALSE(pilot.files.isByFile());
  }
}

TEST_CASE("a plan that was proven is verified afterwards, and no more accepted") {
  Pilot pilot;
  pilot.files.upload(inRam(kPlan));
  REQUIRE((pilot.end() == Status::Accepted));
  pilot.files.verify(inRam(kPlan));
  CHECK((pilot.end() == Status::Verified));
}

TEST_CASE("a write that was on its way when its upload was cancelled is broken, though the next operation runs") {
  for (bool isNext : {false, true}) {
    CAPTURE(isNext);
    Pilot pilot;
    pilot.files.upload(inRam(kPlan));
    REQUIRE(pilot.passUntil("create"));
    pilot.sent.clear();
    pilot.line.room = 20;
    pilot.pass(8);
    REQUIRE(pilot.sent.empty());
    pilot.client.cancel();
    if (isNext) pilot.files.verify(inRam(kPlan));
    pilot.line.room = MemoryStream::kAlwaysRoom;
    pilot.pass(50);
    size_t broken = 0;
    for (const SentFrame& frame : pilot.sent) {
      if (frame.messageId != 110 || frame.frame[1] < 100) continue;
      // Nobody accepts it.
      Bytes payload(frame.frame.begin() + 10, frame.frame.end() - 2);
      FrameParts parts(110, payload, 84);
      parts.sequence = frame.frame[4];
      parts.systemId = frame.frame[5];
      parts.componentId = frame.frame[6];
      const Bytes good = packed(parts);
      REQUIRE(good.size() == frame.frame.size());
      CHECK(Bytes(good.begin(), good.end() - 2) == Bytes(frame.frame.begin(), frame.frame.end() - 2));
      CHECK(Bytes(good.end() - 2, good.end()) != Bytes(frame.frame.end() - 2, frame.frame.end()));
      CHECK(Bytes(payload.end() - 10, payload.end()) == Bytes(10, 0));
      ++broken;
    }
    CHECK(broken == 1);
  }
}

TEST_CASE("behind a plan that was there by file, an armed ArduPilot is asked for no file, for an empty plan either") {
  Pilot pilot;
  CHECK_FALSE(pilot.files.isByFile());
  pilot.files.ensure(inRam(kPlan));
  REQUIRE((pilot.end() == Status::Accepted));
  REQUIRE(pilot.files.isByFile());
  pilot.baseMode = 128 | 1;
  pilot.pass(3000);
  pilot.said();
  pilot.files.ensure(emptyPlan());
  pilot.end(4000);
  CHECK(pilot.said() == "");
  CHECK_FALSE(pilot.files.isByFile());
}
