// A file of a plan that may be open: how it is closed, beside whatever runs, without storing a plan.
#include <doctest/doctest.h>

#include "FilePilot.h"

using namespace mavmission;

namespace {

constexpr int kSilent = FilePilot::kUnheard;
constexpr uint8_t kOpen = FilePilot::kOpen, kBurst = FilePilot::kBurst;
constexpr uint8_t kCreate = FilePilot::kCreate, kWrite = FilePilot::kWrite, kClose = FilePilot::kTerminate;

// Found or after a reset, with our plan aboard.
struct Pilot : FilePilot {
  explicit Pilot(bool isFound = true) {
    has(kFourItems);
    if (isFound) settle();
  }
};

}  // namespace

TEST_CASE(
    "what was left open is closed though the autopilot is armed by now, and a complete plan is withdrawn before") {
  // It may be open by an opening that was not answered.
  CHECK(Pilot().answering(kOpen, kSilent).verify(kFourItems).until("open").cancel().armed(false).says(3000) == "close");
  Pilot pilot;
  pilot.upload(kFourItems).until("write 0+10").cancel().armed(false).sent.clear();
  CHECK(pilot.says(4000) == "write 0+10, close");
  CHECK(pilot.stored == 0);
  for (const SentFrame& frame : pilot.sent) {  // the header is all zero
    if (frame.messageId != 110) continue;
    CHECK(Bytes(frame.payload.begin() + 15, frame.payload.end()) == Bytes(frame.payload.size() - 15, 0));
  }
}

TEST_CASE("an answer to another session, or to another component, closes nothing") {
  Pilot pilot;
  pilot.verify(kFourItems).until("read").cancel().answering(kClose, kSilent).until("close");
  const uint16_t number = static_cast<uint16_t>(pilot.sequence + 1);
  const uint8_t low = static_cast<uint8_t>(number), high = static_cast<uint8_t>(number >> 8);
  pilot.reply(number, static_cast<uint8_t>(pilot.session + 1), 128, kClose, 0, {});
  pilot.hear(FrameParts(110, {0, 1, 192, low, high, pilot.session, 128, 0, kClose, 0, 0, 0, 0, 0, 0, 1}, 84));
  CHECK(pilot.passUntil("close", 1500));
  pilot.reply(static_cast<uint16_t>(pilot.sequence + 1), pilot.session, 128, kClose, 0, {});
  CHECK(pilot.says(3000) == "");
}

TEST_CASE("a file without a header that could be withdrawn is only closed") {
  // No file was open after a reset.
  for (int error : {int{FilePilot::kInvalidSession}, int{FilePilot::kFileNotFound}}) {
    Pilot pilot(false);
    pilot.answering(kWrite, error).settle().answering(kCreate, kSilent).upload(kFourItems).until("create").cancel();
    CHECK(pilot.says(3000) == "close");
  }
  // It was opened before any other could be closed.
  Pilot armed(false);
  armed.baseMode = 128 | 1;
  CHECK(armed.settle().verify(kFourItems).until("read").cancel().says(3000) == "close");
  // It was the proof of a plan that was stored.
  Pilot proof;
  CHECK(proof.answering(kOpen, kSilent).upload(kFourItems).until("open").cancel().says(3000) == "close");
  CHECK(proof.stored == 1);
  // The header was refused, since somebody else has the file.
  Pilot refused;
  refused.upload(kFourItems).until("write 10").once[kWrite] = FilePilot::kInvalidSession;
  refused.until("write 0+10").wait(50).cancel().answering(kOpen, kSilent).verify(kFourItems).until("open").cancel();
  CHECK(refused.says(3000) == "close");
}

TEST_CASE("what is closed after a reset has the session's own number, is withdrawn once, and closed until answered") {
  Pilot pilot(false);
  pilot.answering(kClose, kSilent).until("write 0+10");
  CHECK(pilot.session == static_cast<uint8_t>((1 * 31) ^ 191 ^ 0x5A));
  CHECK(pilot.says(10000) == "close, close, close, close, close, close, close, close, close, close");
  // Nobody answers: what an operation may have opened meanwhile is closed without being withdrawn.
  Pilot silent(false);
  silent.answering(kWrite, kSilent).answering(kClose, kSilent).answering(kOpen, kSilent).until("write 0+10");
  CHECK(silent.verify(kFourItems).until("open").cancel().says(20000) ==
        "write 0+10, write 0+10, write 0+10, write 0+10, close, close, close, close, close");
}

TEST_CASE("no file is closed while an operation has it open") {
  Pilot pilot;
  pilot.answering(kBurst, kSilent).verify(kFourItems).until("read").answering().once[kBurst] = kSilent;
  pilot.beat();
  pilot.beat();
  CHECK(pilot.how() == "Verified by file, OurPlan: open mission, read 0+10, burst 10+38, burst 10+38, close");
  pilot.upload(kFourItems).until("open").wait(8).said();
  pilot.once[kBurst] = kSilent;
  pilot.beat();
  pilot.pass(2);
  pilot.beat();
  CHECK(pilot.how() == "Accepted by file, OurPlan: burst 10+38, burst 10+38, close");
}

TEST_CASE("a file that was left open is not closed while ensure() checks its plan") {
  const FilePilot::Plan many = manyWaypoints(300);
  Pilot pilot;
  pilot.verify(kFourItems).until("read").cancel().said();
  pilot.ensure(many);
  for (int ms = 0; ms < 5000 && pilot.client.status() != Status::Checking; ++ms) pilot.pass(1);
  pilot.beat();
  pilot.pass(20);
  CHECK(pilot.said() == "");
  CHECK((pilot.client.status() == Status::Checking));
}

TEST_CASE("a file that a late copy of its opening has opened again may hold the plan: it is withdrawn, and closed") {
  Pilot pilot;
  pilot.upload(kFourItems).until("create");
  const uint16_t opening = pilot.sequence;
  pilot.until("write 0+10").cancel().pass(4000);
  pilot.reply(static_cast<uint16_t>(opening + 1), pilot.session, 128, kCreate, 0, {});
  CHECK(pilot.says(4000) == "write 0+10, close");
}
