// What the requests of PlanFiles are made of, byte by byte: their numbers, and what is written.
#include <doctest/doctest.h>

#include "FilePilot.h"

using namespace mavmission;

namespace {

constexpr MissionItem kPlan[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
                                 waypoint(-35.3642621_deg, 149.1662374_deg, 30_m), returnToLaunch()};

struct Pilot : FilePilot {
  Pilot() : FilePilot(kArduPilot) {
    pass(4000);
    said();
  }
};

std::vector<MissionItem> circles() {
  std::vector<MissionItem> many;
  for (int i = 0; i < 20; ++i) {
    many.push_back(loiterUnlimited(Degrees::fromE7(100000 + i), Degrees::fromE7(1491652374 + i), 20_m, 12_m));
  }
  return many;
}

ItemSource inRamOf(const std::vector<MissionItem>& items) {
  return inRam(items.data(), static_cast<uint32_t>(items.size()));
}

// The number of the first request of an autopilot that is armed: no file is looked for before.
uint16_t firstNumber(uint32_t afterMs) {
  FilePilot pilot;
  pilot.baseMode = 128 | 1;
  pilot.pass(4000);
  pilot.run(afterMs);
  pilot.pass(2000);
  pilot.files.verify(inRam(kPlan));
  REQUIRE(pilot.passUntil("open"));
  return pilot.sequence;
}

}  // namespace

TEST_CASE("the numbers begin elsewhere at any other time of the clock") {
  const uint16_t first = firstNumber(0);
  CHECK(firstNumber(1000) != first);
  CHECK(firstNumber(8192) != first);
  CHECK(firstNumber(32768) != first);
}

TEST_CASE("the session's number is none of those of ground stations, which are low") {
  const struct {
    uint8_t component, session;
  } kCases[] = {{0x45 ^ 5, 5 + 16}, {0x45 ^ 15, 15 + 16}, {0x45 ^ 16, 16}, {0x45 ^ 17, 17}};
  for (const auto& one : kCases) {
    FilePilot pilot;
    pilot.client.setSourceIds(1, one.component);
    REQUIRE(pilot.passUntil("write 0+10"));
    CHECK(pilot.session == one.session);
  }
}

TEST_CASE("behind the data of a request there are zeros") {
  Pilot pilot;
  pilot.sent.clear();
  pilot.files.upload(inRam(kPlan));
  REQUIRE((pilot.end() == Status::Accepted));
  pilot.files.verify(inRam(kPlan));
  REQUIRE((pilot.end() == Status::Verified));
  size_t requests = 0;
  for (const SentFrame& frame : pilot.sent) {
    if (frame.messageId != 110) continue;
    ++requests;
    const uint8_t opcode = frame.payload[6];
    const bool hasData = opcode == FilePilot::kOpen || opcode == FilePilot::kCreate || opcode == FilePilot::kWrite;
    const size_t used = 15u + (hasData ? frame.payload[7] : 0u);
    CHECK(Bytes(frame.payload.begin() + static_cast<long>(used), frame.payload.end()) ==
          Bytes(frame.payload.size() - used, 0));
  }
  CHECK(requests == 12);
}

TEST_CASE("no request has what an item before has left where a field is to be zero") {
  const std::vector<MissionItem> many = circles();
  Pilot pilot;
  pilot.files.upload(inRamOf(many));
  CHECK((pilot.end() == Status::Accepted));
  CHECK(pilot.said().find('!') == std::string::npos);
}

TEST_CASE("an item is written with its own autocontinue, and current, for the autopilot") {
  std::vector<MissionItem> many = circles();
  for (MissionItem& item : many) item.autocontinue = 0;
  many[3].current = 1;
  Pilot pilot;
  pilot.files.upload(inRamOf(many));
  REQUIRE((pilot.end() == Status::Accepted));
  for (size_t i = 1; i <= many.size(); ++i) {
    const mavlink_mission_item_int_t item = pilot.itemAboard(i);
    CHECK(uint8_t{item.autocontinue} == 0);
    CHECK(uint8_t{item.current} == (i == 4 ? 1 : 0));
    CHECK(uint8_t{item.target_system} == 1);
    CHECK(uint8_t{item.target_component} == 1);
  }
}

TEST_CASE("the first item of a write that is not answered is the one that has failed") {
  const std::vector<MissionItem> many = circles();
  Pilot pilot;
  pilot.delayMs = 60;  // one write at a time
  pilot.files.upload(inRamOf(many));
  REQUIRE(pilot.passUntil("write 10+228"));
  REQUIRE(pilot.passUntil("write 238"));
  pilot.gives[FilePilot::kWrite] = FilePilot::kUnheard;
  CHECK((pilot.end() == Status::TimedOut));
  CHECK(pilot.client.failedItem() == 11);
  CHECK((pilot.client.aboard() == Aboard::AsBefore));
}

TEST_CASE("the items begin to leave in the update() that makes them") {
  Pilot pilot;
  pilot.files.upload(inRam(kPlan));
  REQUIRE(pilot.passUntil("create"));
  pilot.line.writes = 0;
  uint32_t ms = 0;
  for (; ms < 50 && pilot.line.writes == 0; ++ms) pilot.pass(1);
  CHECK(ms == 7);  // the answer comes behind 5
}

TEST_CASE("progress is told of items of the plan alone, and while a plan for an armed autopilot is written, too") {
  const std::vector<MissionItem> many = circles();
  struct Told {
    static void tell(void* context, uint16_t done, uint16_t total) {
      static_cast<std::vector<uint16_t>*>(context)->push_back(done);
      CHECK(total == 20);
    }
  };
  for (bool isArmed : {false, true}) {
    CAPTURE(isArmed);
    std::vector<uint16_t> told;
    Pilot pilot;
    if (isArmed) {
      pilot.hold(many);
      pilot.client.allowWhileArmed(true);
      pilot.baseMode = 128 | 1;
      pilot.pass(1000);
    }
    pilot.delayMs = 60;  // one write at a time
    pilot.client.onProgress(Told::tell, &told);
    pilot.files.upload(inRamOf(many));
    REQUIRE((pilot.end() == Status::Accepted));
    CHECK(told == std::vector<uint16_t>{4, 10, 16, 19, 20});
    pilot.delayMs = 5;
    told.clear();
    pilot.files.verify(inRamOf(many));
    CHECK(pilot.client.itemsTotal() == 20);
    REQUIRE((pilot.end() == Status::Verified));
    REQUIRE(told.size() >= 20);
    for (size_t i = 0; i < 20; ++i) CHECK(told[i] == i + 1);
  }
}

TEST_CASE("a plan that has too many items is not verified at all") {
  Pilot pilot;
  CHECK((pilot.files.verify(inRam(kPlan, 70000)) == Status::TooManyItems));
  CHECK_FALSE(pilot.client.isBusy());
  CHECK(pilot.said() == "");
}

TEST_CASE("a request waits until another frame has left") {
  Pilot pilot;
  pilot.sent.clear();
  REQUIRE(pilot.runUntilSent(0, 3000));  // our heartbeat, each second
  pilot.gives[FilePilot::kCreate] = FilePilot::kUnheard;
  pilot.pass(700);
  pilot.files.upload(inRam(kPlan));
  REQUIRE(pilot.passUntil("create", 250));
  pilot.line.room = 3;
  pilot.line.writes = 0;
  while (pilot.line.writes == 0) pilot.pass(1);
  pilot.said();
  pilot.sent.clear();
  pilot.reply(static_cast<uint16_t>(pilot.sequence + 1), pilot.session, 128, FilePilot::kCreate, 0, {});
  pilot.pass(20);
  pilot.line.room = MemoryStream::kAlwaysRoom;
  CHECK(pilot.passUntil("write 10+190", 50));
  REQUIRE(pilot.sent.size() >= 2);
  CHECK(pilot.sent[0].messageId == 0);
  const Bytes& beat = pilot.sent[0].frame;
  FrameParts parts(0, Bytes(beat.begin() + 10, beat.end() - 2), 50);
  parts.sequence = beat[4];
  parts.systemId = beat[5];
  parts.componentId = beat[6];
  CHECK(packed(parts) == beat);
}
