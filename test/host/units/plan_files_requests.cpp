// What the requests of PlanFiles are made of, byte by byte: their numbers, and what is written.
#include <doctest/doctest.h>

#include "FilePilot.h"

using namespace mavmission;

namespace {

typedef FoundPilot Pilot;

FilePilot::Plan circles() {
  FilePilot::Plan many;
  for (int i = 0; i < 20; ++i) {
    many.push_back(loiterUnlimited(Degrees::fromE7(100000 + i), Degrees::fromE7(1491652374 + i), 20_m, 12_m));
  }
  return many;
}

// The number of the first request of an autopilot that is armed: no file is looked for before.
uint16_t firstNumber(uint32_t afterMs) {
  FilePilot pilot;
  pilot.baseMode = 128 | 1;
  pilot.wait(4000).run(afterMs);
  REQUIRE(pilot.wait(2000).verify(kFourItems).passUntil("open"));
  return pilot.sequence;
}

// What progress was told: so many items are done.
struct Told {
  std::vector<uint16_t> done;
  explicit Told(MissionClient& client) { client.onProgress(tell, this); }
  static void tell(void* told, uint16_t done, uint16_t total) {
    static_cast<Told*>(told)->done.push_back(done);
    CHECK(total == 20);
  }
};

}  // namespace

TEST_CASE("the numbers begin elsewhere at any other time of the clock") {
  const uint16_t first = firstNumber(0);
  for (uint32_t ms : {1000, 8192, 32768}) CHECK(firstNumber(ms) != first);
}

TEST_CASE("the session's number is none of those of ground stations, which are low") {
  const struct {
    uint8_t component, session;
  } kCases[] = {{0x45 ^ 5, 5 + 16}, {0x45 ^ 15, 15 + 16}, {0x45 ^ 16, 16}, {0x45 ^ 17, 17}};
  for (const auto& one : kCases) {
    FilePilot pilot;
    pilot.client.setSourceIds(1, one.component);
    CHECK(pilot.until("write 0+10").session == one.session);
  }
}

TEST_CASE("after the data of a request there are zeros") {
  Pilot pilot;
  pilot.sent.clear();
  pilot.upload(kFourItems).how();
  pilot.verify(kFourItems).how();
  CHECK(pilot.timesOf(110, 0).size() == 12);
  for (const SentFrame& frame : pilot.sent) {
    if (frame.messageId != 110) continue;
    const uint8_t opcode = frame.payload[6];
    const bool hasData = opcode == FilePilot::kOpen || opcode == FilePilot::kCreate || opcode == FilePilot::kWrite;
    const size_t used = 15u + (hasData ? frame.payload[7] : 0u);
    CHECK(Bytes(frame.payload.begin() + static_cast<long>(used), frame.payload.end()) ==
          Bytes(frame.payload.size() - used, 0));
  }
}

TEST_CASE("an item is written with its own autocontinue, and current, and no request has what one before has left") {
  FilePilot::Plan many = circles();
  for (MissionItem& item : many) item.autocontinue = 0;
  many[3].current = 1;
  Pilot pilot;
  CHECK(pilot.upload(many).how() ==
        "Accepted by file, OurPlan: create mission, write 10+228, write 238+228, write 466+228, write 694+114, "
        "write 0+10, close, open mission, read 0+10, burst 10+38, close");
  for (uint16_t i = 1; i <= many.size(); ++i) CHECK(pilot.plans[0][i] == pilot.bytesOf(many[i - 1u], i));
}

TEST_CASE("the first item of a write that is not answered is the one that has failed") {
  const FilePilot::Plan many = circles();
  Pilot pilot;
  pilot.delayMs = 60;  // one write at a time
  pilot.upload(many).until("write 10+228").until("write 238").said();
  CHECK(pilot.answering(FilePilot::kWrite, FilePilot::kUnheard).how().substr(0, 33) ==
        "TimedOut item 11 by file, AsBefor");
}

TEST_CASE("progress is told of items of the plan alone, and while a plan for an armed autopilot is written, too") {
  const FilePilot::Plan many = circles();
  for (bool isArmed : {false, true}) {
    CAPTURE(isArmed);
    Pilot pilot;
    if (isArmed) pilot.has(many).armed().pass(1000);
    Told told(pilot.client);
    pilot.delayMs = 60;  // one write at a time
    REQUIRE((pilot.upload(many).end() == Status::Accepted));
    CHECK(told.done == std::vector<uint16_t>{4, 10, 16, 19, 20});
    pilot.delayMs = 5;
    told.done.clear();
    CHECK(pilot.verify(many).client.itemsTotal() == 20);
    REQUIRE((pilot.end() == Status::Verified));
    REQUIRE(told.done.size() >= 20);
    for (size_t i = 0; i < 20; ++i) CHECK(told.done[i] == i + 1);
  }
}

TEST_CASE("a plan that has too many items is not verified at all") {
  Pilot pilot;
  CHECK((pilot.files.verify(inRam(kFourItems.data(), 70000)) == Status::TooManyItems));
  CHECK_FALSE(pilot.client.isBusy());
  CHECK(pilot.said() == "");
}

TEST_CASE("a request waits until another frame has left") {
  Pilot pilot;
  REQUIRE(pilot.runUntilSent(0, 3000));  // our heartbeat, every second
  pilot.answering(FilePilot::kCreate, FilePilot::kUnheard).wait(700).upload(kFourItems);
  REQUIRE(pilot.passUntil("create", 250));
  pilot.line.room = 3;
  pilot.line.writes = 0;
  while (pilot.line.writes == 0) pilot.pass(1);
  pilot.sent.clear();
  pilot.reply(static_cast<uint16_t>(pilot.sequence + 1), pilot.session, 128, FilePilot::kCreate, 0, {});
  pilot.wait(20).line.room = MemoryStream::kAlwaysRoom;
  CHECK(pilot.passUntil("write 10+190", 50));
  REQUIRE(pilot.sent.size() >= 2);
  CHECK(pilot.sent[0].messageId == 0);
  CHECK(AnsweringPeer::packedAgain(pilot.sent[0], 50) == pilot.sent[0].frame);
}
