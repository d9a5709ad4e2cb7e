// What an operation of PlanFiles leaves: the next one begins as if there had been none.
#include <doctest/doctest.h>

#include "FilePilot.h"

using namespace mavmission;

namespace {

// Found, with another plan aboard.
struct Pilot : FoundPilot {
  Pilot() { has(kOneHigher); }
};

}  // namespace

TEST_CASE("each operation goes by no file until it has asked for one, and some do not ask at all") {
  Pilot pilot;
  CHECK_FALSE(pilot.files.isByFile());
  CHECK(pilot.upload(kFourItems).how() == "Accepted by file, OurPlan: " + kFileWrittenAndRead);
  CHECK_FALSE(pilot.upload(kOneHigher).files.isByFile());
  CHECK(pilot.how() == "Accepted by file, OurPlan: " + kFileWrittenAndRead);
  CHECK_FALSE(pilot.verify(kOneHigher).files.isByFile());
  CHECK(pilot.how() == "Verified by file, OurPlan: " + kFileRead);  // and no more accepted
  CHECK_FALSE(pilot.ensure(kOneHigher).files.isByFile());
  CHECK(pilot.how() == "AlreadyAboard by file, OurPlan: " + kFileRead);
  CHECK_FALSE(pilot.upload(kThreeCorners, PlanType::Fence).files.isByFile());
  CHECK(pilot.how() == "upload items");
  // An armed ArduPilot is asked for no file, for an empty plan either.
  Pilot armed;
  armed.ensure(kFourItems).how();
  armed.armed(false).says(3000);
  armed.files.ensure(emptyPlan());
  CHECK(armed.how() == "read items");
}

TEST_CASE("an upload after an ensure() may change the plan of an armed autopilot, if that is allowed") {
  Pilot pilot;
  pilot.ensure(kFourItems).how();
  CHECK(pilot.armed().wait(10).upload(kTwoItems).how() == "open mission, read 0+10, close, upload items");
}

TEST_CASE("an upload after one to an armed autopilot gets no header when it is armed again meanwhile") {
  Pilot pilot;
  CHECK(pilot.armed().wait(10).upload(kFourItems).how().substr(0, 8) == "Accepted");
  pilot.baseMode = 0;
  pilot.beat();
  pilot.wait(10).client.allowWhileArmed(false);
  CHECK(pilot.upload(kOneHigher).until("write 10").armed(false).how() ==
        "Armed by file, AsBefore: create mission, write 10+190");
}

TEST_CASE("after a look that was cancelled, all of the plan is verified, and item by item where there is no file") {
  Pilot counting;
  counting.armed().wait(10).upload(kFourItems).until("open").cancel().says(3000);
  CHECK(counting.verify(kFourItems).how() == "Differs item 2 Height by file, NotKnown: " + kFileRead);
  for (bool isEnsured : {false, true}) {
    Pilot pilot;
    (isEnsured ? pilot.ensure(kFourItems) : pilot.armed().wait(10).upload(kFourItems)).until("open").cancel();
    pilot.says(3000);
    CHECK(pilot.answering(FilePilot::kOpen, FilePilot::kFail).verify(kFourItems).how() == "open mission, read items");
  }
}

TEST_CASE("a write that was on its way when its upload was cancelled is broken, though the next operation runs") {
  for (bool isNext : {false, true}) {
    CAPTURE(isNext);
    Pilot pilot;
    pilot.upload(kFourItems).until("create").sent.clear();
    pilot.line.room = 20;
    pilot.pass(8);
    REQUIRE(pilot.sent.empty());
    pilot.cancel();
    if (isNext) pilot.verify(kFourItems);
    pilot.line.room = MemoryStream::kAlwaysRoom;
    pilot.pass(50);
    size_t broken = 0;
    for (const SentFrame& frame : pilot.sent) {
      if (frame.messageId != 110 || frame.frame[1] < 100) continue;
      // Nobody accepts it.
      const Bytes good = AnsweringPeer::packedAgain(frame, 84);
      REQUIRE(good.size() == frame.frame.size());
      CHECK(Bytes(good.begin(), good.end() - 2) == Bytes(frame.frame.begin(), frame.frame.end() - 2));
      CHECK(Bytes(good.end() - 2, good.end()) != Bytes(frame.frame.end() - 2, frame.frame.end()));
      CHECK(Bytes(good.end() - 12, good.end() - 2) == Bytes(10, 0));
      ++broken;
    }
    CHECK(broken == 1);
  }
}
