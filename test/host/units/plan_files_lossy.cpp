// A plan that is written as a file, and proven where the line loses or the file cannot be read.
#include <doctest/doctest.h>

#include "FilePilot.h"

using namespace mavmission;

namespace {

constexpr uint8_t kOpen = FilePilot::kOpen, kRead = FilePilot::kRead;
constexpr int kFail = FilePilot::kFail, kUnheard = FilePilot::kUnheard;
const std::string kProven = kFileWritten + ", open mission, prove items";
// Item by item, and not looked for as a file.
const std::string kProvenLossy =
    "create mission, write 10+38, write 48+38, write 86+38, write 124+38, write 162+38, write 0+10, close, prove items";

// Found, and giving and taking items by the mission protocol too.
struct Pilot : FoundPilot {
  Pilot() { serving(); }
  // It gives no file to read, and another plan than it was given: an item that is higher, or more items.
  FilePilot& damages(uint16_t item, int more = 0) {
    damaged = item;
    tooMany = more;
    return answering(kOpen, kFail);
  }
};

}  // namespace

TEST_CASE("a plan that is proven item by item is accepted when it is the same; on a lossy link it is uploaded if not") {
  const struct {
    bool isLossy;
    uint16_t damaged;
    int more;
    const char* end;
    std::string words;
  } kCases[] = {
      {false, 0, 0, "Accepted by file, OurPlan: ", kProven},
      {true, 0, 0, "Accepted by file, OurPlan: ", kProvenLossy},
      {false, 3, 0, "Differs item 2 Height by file, NotKnown: ", kProven},
      {true, 3, 0, "Accepted, OurPlan: ", kProvenLossy + ", upload items, read items"},
      {false, 0, -1, "Differs Count by file, NotKnown: ", kProven},
      {true, 0, -1, "Accepted, OurPlan: ", kProvenLossy + ", upload items, read items"},
  };
  for (const auto& one : kCases) {
    CAPTURE(one.isLossy);
    CAPTURE(one.damaged);
    Pilot pilot;
    if (one.isLossy) pilot.losing();
    pilot.ends.clear();
    CHECK(pilot.damages(one.damaged, one.more).upload(kFourItems).how() == one.end + one.words);
    CHECK(pilot.ends == std::vector<Status>{pilot.ended});
    CHECK(pilot.stored == 1);
    CHECK(pilot.client.lastResult() == 0);
  }
  Pilot pilot;  // ensure() proves what it has written in the same way
  pilot.has(kOneHigher).ensure(kFourItems).until("create").answering(kOpen, kFail);
  CHECK(pilot.how() == "Accepted by file, OurPlan: " + kFileRead + ", " + kProven);
}

TEST_CASE("where the line begins to lose while the file is read back, the same plan is accepted, another uploaded") {
  for (bool isOther : {false, true}) {
    CAPTURE(isOther);
    Pilot pilot;
    pilot.servesItems = false;
    pilot.answering(kRead, kUnheard).upload(kFourItems).until("read").losing().said();
    if (isOther) pilot.has(kOneHigher);
    CHECK(pilot.answering().how() == (isOther ? "read 0+10, burst 10+38, close, upload items"
                                              : "Accepted by file, OurPlan: read 0+10, burst 10+38, close"));
    CHECK(pilot.files.isByFile() == !isOther);
    CHECK(pilot.client.failedItem() == 0xFFFF);
    CHECK((pilot.client.differingField() == ItemField::None));
  }
}

TEST_CASE("a plan after one that was damaged is proven as any other") {
  Pilot pilot;
  pilot.losing().said();
  pilot.damages(3).upload(kFourItems).until("upload items").cancel().says(100);
  pilot.ends.clear();
  CHECK(pilot.upload(kFourItems).how() == "Accepted by file, OurPlan: " + kProvenLossy);
  CHECK(pilot.ends == std::vector<Status>{Status::Accepted});
}

TEST_CASE("a plan that ensure() replaces is told item by item, and the field in which it differed is forgotten") {
  struct Told {
    static void tell(void* context, uint16_t done, uint16_t) {
      static_cast<std::vector<uint16_t>*>(context)->push_back(done);
    }
  };
  std::vector<uint16_t> told;
  Pilot pilot;
  pilot.client.onProgress(Told::tell, &told);
  CHECK(pilot.has(kOneHigher).ensure(kFourItems).how() ==
        "Accepted by file, OurPlan: " + kFileRead + ", " + kFileWrittenAndRead);
  CHECK(told == std::vector<uint16_t>{3, 4});
}

TEST_CASE("an autopilot that is armed while ensure() checks a long plan may have it aboard already") {
  const FilePilot::Plan many = manyWaypoints(300);
  Pilot pilot;
  REQUIRE(pilot.has(many).ensure(many).wait(20).said() == "");
  CHECK((pilot.armed(false).end() == Status::AlreadyAboard));
}

TEST_CASE("another number of items of a plan of one item is another one, and what is no number of items is none") {
  const FilePilot::Plan one = {kFourItems[0]};
  Pilot pilot;
  pilot.losing().said();
  CHECK(pilot.damages(0, 2).upload(one).how() ==
        "Accepted, OurPlan: create mission, write 10+38, write 48+38, write 0+10, close, prove items, upload items, "
        "read items");
  Pilot other;
  other.servesItems = false;
  other.losing().answering(kOpen, kFail).upload(kFourItems).until("prove items").said();
  other.reply(5, 1, 128, kRead, 0, {});  // where a MISSION_COUNT has its type, there is a 0
  CHECK(other.says(50).find("upload") == std::string::npos);
  other.hear(countParts(5));
  CHECK(other.passUntilSent(FilePilot::kRequestInt, 50));
}

TEST_CASE("a damaged plan is read back in any case: also if the line has lost nothing for long") {
  Pilot pilot;
  pilot.losing().said();
  pilot.takenAs = FilePilot::kSilent;
  pilot.damages(3).upload(kFourItems).until("upload items");
  for (uint8_t item = 0; item < 5; ++item) {
    pilot.hear(requestParts(item));
    REQUIRE(pilot.passUntilSent(FilePilot::kItemInt, 500));
    pilot.pass(3000);
  }
  pilot.hear(ackParts(0));
  CHECK(pilot.passUntil("read items"));
}

TEST_CASE("an upload that a damaged plan leads to reads as many bytes in an update() as any other") {
  size_t most[3] = {};
  for (size_t i = 0; i < 3; ++i) {
    Pilot pilot;
    pilot.servesItems = false;
    if (i != 0) pilot.answering(kRead, kUnheard).upload(kFourItems).until("read");
    if (i == 2) pilot.losing().has(kOneHigher).answering().until("upload items");
    pilot.pass(3);
    for (int frames = 0; frames < 50; ++frames) pilot.line.bring(telemetry());
    const size_t before = pilot.line.bytesRead;
    pilot.run(1);
    most[i] = pilot.line.bytesRead - before;
  }
  CHECK(most[1] < most[0]);  // time is kept free for a comparison
  CHECK(most[2] == most[0]);
}

TEST_CASE("an error after an earlier upload, in doubt whether it was a refusal, says nothing about the next one") {
  Pilot pilot;
  pilot.takenAs = 1;
  pilot.has({kOneHigher[0], kOneHigher[1]}).client.upload(FilePilot::sourceOf(kOneHigher));
  CHECK(pilot.how() == "Error item 3 Count, Mixture: upload items, read items");
  CHECK(pilot.damages(3).upload(kFourItems).how() == "Differs item 2 Height by file, NotKnown: " + kProven);
}

TEST_CASE("after a plan that was proven, nothing of an earlier transfer is waited for") {
  Pilot pilot;
  pilot.client.upload(FilePilot::sourceOf(kOneHigher));
  REQUIRE(pilot.passUntilSent(FilePilot::kItemInt));
  pilot.servesItems = false;
  pilot.cancel().wait(10).upload(kFourItems);
  REQUIRE((pilot.end() == Status::Accepted));
  pilot.verify(kFourItems).client.cancel();
  pilot.client.verify(FilePilot::sourceOf(kFourItems));
  REQUIRE(pilot.passUntilSent(FilePilot::kRequestList));
  pilot.hear(ackParts(1));  // not an answer to what was cancelled
  pilot.pass(5);
  CHECK_FALSE(pilot.client.isBusy());
}

TEST_CASE("a plan that was written as a file has no name, and not that of the plan before") {
  Pilot pilot;
  MissionFollower follower(pilot.client);
  pilot.nameOfPlan = 77;
  pilot.client.upload(FilePilot::sourceOf(kOneHigher));
  REQUIRE((pilot.end() == Status::Accepted));
  REQUIRE((pilot.upload(kFourItems).end() == Status::Accepted));
  for (int i = 0; i < 4; ++i) {
    pilot.hear(FrameParts(42, {0, 0, 4, 0, 3, 1, 88, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}, 28));
    pilot.pass(1000);
  }
  CHECK((pilot.client.aboard() == Aboard::OurPlan));
}

TEST_CASE("items with places in floats are read where no file is, and prove no upload") {
  const FilePilot::Plan one = {waypoint(-35.5_deg, 149.5_deg, 20_m)};
  Pilot pilot;
  pilot.servesItems = false;
  pilot.answering(kOpen, kFail);
  // Home and a waypoint, by MISSION_ITEM.
  const auto tellFloats = [&pilot, &one]() {
    pilot.hear(countParts(2));
    for (uint16_t i = 0; i < 2 && pilot.passUntilSent(FilePilot::kRequestInt, 100); ++i) {
      pilot.hear(floatItemParts(i, i == 0 ? homeItem() : one[0], -35.5f, 149.5f));
    }
    pilot.pass(100);
  };
  for (int i = 0; i < 2; ++i) {
    CAPTURE(i);
    CHECK(pilot.download().how() == "open mission, read items");
    tellFloats();
    CHECK((pilot.ended == Status::Downloaded));
    REQUIRE(pilot.taken.size() == 2);
    for (const auto& taken : pilot.taken) CHECK(int32_t{taken.item.x} == -355000000);
    pilot.upload(one).until("prove items");
    tellFloats();
    CHECK(pilot.client.isBusy());
    pilot.cancel().says(3000);
  }
}
