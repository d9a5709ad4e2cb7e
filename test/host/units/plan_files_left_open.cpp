// A file of a plan that may be open: how it is closed, beside whatever runs, without storing a plan.
#include <doctest/doctest.h>

#include "FilePilot.h"

using namespace mavmission;

namespace {

constexpr MissionItem kPlan[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
                                 waypoint(-35.3642621_deg, 149.1662374_deg, 30_m), returnToLaunch()};
constexpr uint8_t kArmed = 128 | 1;

struct Pilot : FilePilot {
  Pilot() : FilePilot(kArduPilot) { hold({kPlan[0], kPlan[1], kPlan[2], kPlan[3]}); }
  // Found, and with no file that could be open.
  void settle() {
    pass(4000);
    said();
  }
  void ignore(uint8_t opcode) { gives[opcode] = kUnheard; }
};

}  // namespace

TEST_CASE("the file of an opening that was not answered is closed though the autopilot is armed by now") {
  Pilot pilot;
  pilot.settle();
  pilot.ignore(FilePilot::kOpen);
  pilot.files.verify(inRam(kPlan));
  REQUIRE(pilot.passUntil("open"));
  pilot.client.cancel();
  pilot.baseMode = kArmed;
  pilot.said();
  pilot.pass(3000);
  CHECK(pilot.said() == "close");
}

TEST_CASE("a plan that is complete in its file is spoilt though the autopilot is armed by now") {
  Pilot pilot;
  pilot.settle();
  pilot.files.upload(inRam(kPlan));
  REQUIRE(pilot.passUntil("write 0+10"));
  pilot.client.cancel();
  pilot.baseMode = kArmed;
  pilot.pass(100);
  pilot.said();
  pilot.sent.clear();
  pilot.pass(4000);
  CHECK(pilot.said() == "write 0+10, close");
  CHECK(pilot.stored == 0);
  // The header is all zero.
  for (const SentFrame& frame : pilot.sent) {
    if (frame.messageId != 110) continue;
    CHECK(Bytes(frame.payload.begin() + 15, frame.payload.end()) == Bytes(frame.payload.size() - 15, 0));
  }
}

TEST_CASE("what is closed behind a reset has the session's own number") {
  Pilot pilot;
  REQUIRE(pilot.passUntil("write 0+10"));
  CHECK(pilot.session == static_cast<uint8_t>((1 * 31) ^ 191 ^ 0x5A));
}

TEST_CASE("an answer to another session, or to another component, closes nothing") {
  Pilot pilot;
  pilot.settle();
  pilot.files.verify(inRam(kPlan));
  REQUIRE(pilot.passUntil("read"));
  pilot.client.cancel();
  pilot.ignore(FilePilot::kTerminate);
  REQUIRE(pilot.passUntil("close"));
  const uint16_t number = static_cast<uint16_t>(pilot.sequence + 1);
  pilot.reply(number, static_cast<uint8_t>(pilot.session + 1), 128, FilePilot::kTerminate, 0, {});
  pilot.hear(FrameParts(110,
                        {0, 1, 192, static_cast<uint8_t>(number), static_cast<uint8_t>(number >> 8), pilot.session, 128,
                         0, FilePilot::kTerminate, 0, 0, 0, 0, 0, 0, 1},
                        84));
  CHECK(pilot.passUntil("close", 1500));
  pilot.reply(static_cast<uint16_t>(pilot.sequence + 1), pilot.session, 128, FilePilot::kTerminate, 0, {});
  CHECK_FALSE(pilot.passUntil("close", 3000));
}

TEST_CASE("where no file was open behind a reset, the next one has no header that could be spoilt") {
  for (int error : {int{FilePilot::kInvalidSession}, int{FilePilot::kFileNotFound}}) {
    Pilot pilot;
    pilot.gives[FilePilot::kWrite] = error;
    pilot.settle();
    pilot.ignore(FilePilot::kCreate);
    pilot.files.upload(inRam(kPlan));
    REQUIRE(pilot.passUntil("create"));
    pilot.client.cancel();
    pilot.said();
    pilot.pass(3000);
    CHECK(pilot.said() == "close");
  }
}

TEST_CASE("a file that was opened before any other could be closed has no header") {
  Pilot pilot;
  pilot.baseMode = kArmed;
  pilot.settle();
  pilot.files.verify(inRam(kPlan));
  REQUIRE(pilot.passUntil("read"));
  pilot.client.cancel();
  pilot.said();
  pilot.pass(3000);
  CHECK(pilot.said() == "close");
}

TEST_CASE("behind a plan that was stored, the file of its proof has no header") {
  Pilot pilot;
  pilot.settle();
  pilot.ignore(FilePilot::kOpen);
  pilot.files.upload(inRam(kPlan));
  REQUIRE(pilot.passUntil("open"));
  pilot.client.cancel();
  pilot.said();
  pilot.pass(3000);
  CHECK(pilot.said() == "close");
  CHECK(pilot.stored == 1);
}

TEST_CASE("a file that was open behind a reset is closed until that is answered, and it is not spoilt again") {
  Pilot pilot;
  pilot.ignore(FilePilot::kTerminate);
  REQUIRE(pilot.passUntil("write 0+10"));
  pilot.said();
  pilot.pass(10000);
  CHECK(pilot.said() == "close, close, close, close, close, close, close, close, close, close");
}

TEST_CASE("behind a reset nobody answers: what an operation may have opened meanwhile is closed without being spoilt") {
  Pilot pilot;
  pilot.ignore(FilePilot::kWrite);
  pilot.ignore(FilePilot::kTerminate);
  pilot.ignore(FilePilot::kOpen);
  REQUIRE(pilot.passUntil("write 0+10"));
  pilot.files.verify(inRam(kPlan));
  REQUIRE(pilot.passUntil("open"));
  pilot.client.cancel();
  pilot.said();
  pilot.pass(20000);
  CHECK(pilot.said() == "write 0+10, write 0+10, write 0+10, write 0+10, close, close, close, close, close");
}

TEST_CASE("no file is closed while an operation has it open") {
  Pilot pilot;
  pilot.settle();
  pilot.ignore(FilePilot::kBurst);
  pilot.files.verify(inRam(kPlan));
  REQUIRE(pilot.passUntil("read"));
  pilot.gives.clear();
  pilot.once[FilePilot::kBurst] = FilePilot::kUnheard;
  pilot.beat();
  pilot.beat();
  CHECK((pilot.end() == Status::Verified));
  CHECK(pilot.said() == "open @MISSION/mission.dat, read 0+10, burst 10+38, burst 10+38, close");
  pilot.files.upload(inRam(kPlan));
  REQUIRE(pilot.passUntil("open"));
  pilot.pass(8);
  pilot.said();
  pilot.once[FilePilot::kBurst] = FilePilot::kUnheard;
  pilot.beat();
  pilot.pass(2);
  pilot.beat();
  CHECK((pilot.end() == Status::Accepted));
  const std::string said = pilot.said();
  CHECK(said.find("close") == said.rfind("close"));
}

TEST_CASE("where the header was refused, since somebody else has the file, there is none that could be spoilt") {
  Pilot pilot;
  pilot.settle();
  pilot.files.upload(inRam(kPlan));
  REQUIRE(pilot.passUntil("write 10"));
  pilot.once[FilePilot::kWrite] = FilePilot::kInvalidSession;
  REQUIRE(pilot.passUntil("write 0+10"));
  pilot.pass(50);
  pilot.client.cancel();
  pilot.ignore(FilePilot::kOpen);
  pilot.files.verify(inRam(kPlan));
  REQUIRE(pilot.passUntil("open"));
  pilot.client.cancel();
  pilot.said();
  pilot.pass(3000);
  CHECK(pilot.said() == "close");
}

TEST_CASE("a file that was left open is not closed while ensure() checks its plan") {
  static MissionItem many[300];
  for (int i = 0; i < 300; ++i) many[i] = waypoint(Degrees::fromE7(100000 + i), Degrees::fromE7(200000 + i), 20_m);
  Pilot pilot;
  pilot.settle();
  pilot.files.verify(inRam(kPlan));
  REQUIRE(pilot.passUntil("read"));
  pilot.client.cancel();
  pilot.said();
  pilot.files.ensure(inRam(many));
  for (int ms = 0; ms < 5000 && pilot.client.status() != Status::Checking; ++ms) pilot.pass(1);
  pilot.beat();
  pilot.pass(20);
  CHECK(pilot.said() == "");
  CHECK((pilot.client.status() == Status::Checking));
}

TEST_CASE(
    "a file that a late copy of its opening has opened again may hold the plan: it is spoilt before it is closed") {
  Pilot pilot;
  pilot.settle();
  pilot.files.upload(inRam(kPlan));
  REQUIRE(pilot.passUntil("create"));
  const uint16_t opening = pilot.sequence;
  REQUIRE(pilot.passUntil("write 0+10"));
  pilot.client.cancel();
  pilot.pass(4000);
  pilot.said();
  pilot.reply(static_cast<uint16_t>(opening + 1), pilot.session, 128, FilePilot::kCreate, 0, {});
  pilot.pass(4000);
  CHECK(pilot.said() == "write 0+10, close");
}
