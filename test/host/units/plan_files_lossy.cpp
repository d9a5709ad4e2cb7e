// A plan that is written as a file, and proven where the line loses or the file cannot be read.
#include <doctest/doctest.h>

#include "FilePilot.h"

using namespace mavmission;

namespace {

constexpr MissionItem kPlan[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
                                 waypoint(-35.3642621_deg, 149.1662374_deg, 30_m), returnToLaunch()};
constexpr MissionItem kOther[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
                                  waypoint(-35.3642621_deg, 149.1662374_deg, 31_m), returnToLaunch()};

// Found, and with no file that could be open.
struct Pilot : FilePilot {
  Pilot() : FilePilot(kArduPilot) {
    pass(4000);
    said();
  }
  void makeLossy(int frames = 100) {
    for (; frames != 0; --frames) {
      lose(3);
      beat();
      pass(5);
    }
  }
  bool isAsked(uint16_t messageId, uint32_t limitMs = 3000) {
    sent.clear();
    for (; limitMs != 0; --limitMs) {
      pass(1);
      if (!timesOf(messageId, 0).empty()) return true;
    }
    return false;
  }
  void tellCount(uint8_t count) { hear(FrameParts(44, {count, 0, 1, 191, 0}, 221)); }
  // The items one after the other, as each is asked for; this one with this height.
  void tellItems(size_t number = 0, float height = 0) {
    for (size_t i = 0; i < plans[0].size(); ++i) {
      if (!isAsked(kRequestInt)) return;
      mavlink_mission_item_int_t item = itemAboard(i);
      if (i == number && i != 0) item.z = height;
      item.target_system = 1;
      item.target_component = 191;
      Bytes bytes(sizeof(item));
      memcpy(bytes.data(), &item, sizeof(item));
      hear(FrameParts(73, bytes, 38));
    }
  }
  // All of the plan is asked for, and accepted.
  void takeUpload(uint8_t count) {
    for (uint8_t i = 0; i < count; ++i) {
      hear(requestParts(i));
      REQUIRE(isAsked(kItemInt, 500));
    }
    hear(ackParts(0));
  }
  // The plan is written, and asked for item by item.
  void writeAndAsk() {
    gives[kOpen] = kFail;
    files.upload(inRam(kPlan));
    REQUIRE(passUntil("close"));
    REQUIRE(isAsked(kRequestList));
    tellCount(5);
  }
};

}  // namespace

TEST_CASE(
    "where the line begins to lose while the file is read back, the same plan is accepted, another one uploaded") {
  for (bool isOther : {false, true}) {
    CAPTURE(isOther);
    Pilot pilot;
    pilot.gives[FilePilot::kRead] = FilePilot::kUnheard;
    pilot.files.upload(inRam(kPlan));
    REQUIRE(pilot.passUntil("read"));
    pilot.makeLossy();
    if (isOther) pilot.hold({kOther[0], kOther[1], kOther[2], kOther[3]});
    pilot.gives.clear();
    pilot.ended = Status::Idle;
    CHECK(pilot.isAsked(FilePilot::kCount) == isOther);
    CHECK(pilot.files.isByFile() == !isOther);
    CHECK((pilot.ended == (isOther ? Status::Idle : Status::Accepted)));
    CHECK(pilot.client.failedItem() == 0xFFFF);
    CHECK((pilot.client.differingField() == ItemField::None));
  }
}

TEST_CASE("a damaged plan is uploaded item by item within the operation, and read back in any case") {
  Pilot pilot;
  pilot.makeLossy();
  pilot.writeAndAsk();
  pilot.ends.clear();
  pilot.tellItems(3, 31);
  REQUIRE(pilot.isAsked(FilePilot::kCount, 1000));
  CHECK(pilot.ends.empty());
  CHECK(pilot.client.failedItem() == 0xFFFF);
  CHECK((pilot.client.differingField() == ItemField::None));
  pilot.takeUpload(5);
  REQUIRE(pilot.isAsked(FilePilot::kRequestList));
  pilot.tellCount(5);
  pilot.tellItems();
  pilot.pass(100);
  CHECK((pilot.ended == Status::Accepted));
  CHECK((pilot.client.aboard() == Aboard::OurPlan));
}

TEST_CASE("a plan behind one that was damaged is proven as any other") {
  Pilot pilot;
  pilot.makeLossy();
  pilot.writeAndAsk();
  pilot.tellItems(3, 31);
  REQUIRE(pilot.isAsked(FilePilot::kCount, 1000));
  pilot.client.cancel();
  pilot.pass(100);
  pilot.ends.clear();
  pilot.writeAndAsk();
  pilot.tellItems();
  pilot.pass(100);
  CHECK(pilot.files.isByFile());
  CHECK(pilot.ends == std::vector<Status>{Status::Accepted});
}

TEST_CASE("another plan that is read back item by item is known to be no mixture") {
  Pilot pilot;
  pilot.writeAndAsk();
  CHECK(pilot.client.lastResult() == 0);
  pilot.tellItems(3, 31);
  pilot.pass(100);
  CHECK((pilot.ended == Status::Differs));
  CHECK((pilot.client.aboard() == Aboard::NotKnown));
  CHECK(pilot.client.failedItem() == 2);
  CHECK((pilot.client.differingField() == ItemField::Height));
}

TEST_CASE("the field that a look has found to differ is forgotten when the plan is replaced") {
  Pilot pilot;
  pilot.hold({kOther[0], kOther[1], kOther[2], kOther[3]});
  pilot.files.ensure(inRam(kPlan));
  REQUIRE((pilot.end() == Status::Accepted));
  CHECK((pilot.client.differingField() == ItemField::None));
  CHECK(pilot.client.failedItem() == 0xFFFF);
}

TEST_CASE("a plan that ensure() replaces is told item by item") {
  struct Told {
    static void tell(void* context, uint16_t done, uint16_t) {
      static_cast<std::vector<uint16_t>*>(context)->push_back(done);
    }
  };
  std::vector<uint16_t> told;
  Pilot pilot;
  pilot.hold({kOther[0], kOther[1], kOther[2], kOther[3]});
  pilot.client.onProgress(Told::tell, &told);
  pilot.files.ensure(inRam(kPlan));
  REQUIRE((pilot.end() == Status::Accepted));
  CHECK(told == std::vector<uint16_t>{3, 4});
}

TEST_CASE("an autopilot that is armed while ensure() checks a long plan may have it aboard already") {
  static MissionItem many[300];
  for (int i = 0; i < 300; ++i) many[i] = waypoint(Degrees::fromE7(100000 + i), Degrees::fromE7(200000 + i), 20_m);
  Pilot pilot;
  pilot.hold(std::vector<MissionItem>(many + 0, many + 300));
  pilot.files.ensure(inRam(many));
  pilot.pass(20);
  REQUIRE(pilot.said() == "");
  pilot.baseMode = 128 | 1;
  pilot.beat();
  CHECK((pilot.end() == Status::AlreadyAboard));
}

TEST_CASE("on a lossy link, another number of items of a plan of one item leads to an upload item by item") {
  Pilot pilot;
  pilot.makeLossy();
  pilot.gives[FilePilot::kOpen] = FilePilot::kFail;
  pilot.files.upload(inRam(kPlan, 1));
  REQUIRE(pilot.passUntil("close"));
  REQUIRE(pilot.isAsked(FilePilot::kRequestList));
  pilot.tellCount(4);
  CHECK(pilot.isAsked(FilePilot::kCount, 1000));
}

TEST_CASE("what is no number of items is not taken for another one") {
  Pilot pilot;
  pilot.makeLossy();
  pilot.gives[FilePilot::kOpen] = FilePilot::kFail;
  pilot.files.upload(inRam(kPlan));
  REQUIRE(pilot.passUntil("close"));
  REQUIRE(pilot.isAsked(FilePilot::kRequestList));
  pilot.reply(5, 1, 128, FilePilot::kRead, 0, {});  // where a MISSION_COUNT has its type, there is a 0
  CHECK_FALSE(pilot.isAsked(FilePilot::kCount, 50));
  pilot.tellCount(5);
  CHECK(pilot.isAsked(FilePilot::kRequestInt, 50));
}

TEST_CASE("a damaged plan is read back in any case: also if the line has lost nothing for long") {
  Pilot pilot;
  pilot.makeLossy();
  pilot.writeAndAsk();
  pilot.tellItems(3, 31);
  REQUIRE(pilot.isAsked(FilePilot::kCount, 1000));
  for (uint8_t item = 0; item < 5; ++item) {
    pilot.hear(requestParts(item));
    REQUIRE(pilot.isAsked(FilePilot::kItemInt, 500));
    pilot.pass(3000);
  }
  pilot.hear(ackParts(0));
  CHECK(pilot.isAsked(FilePilot::kRequestList));
}

TEST_CASE("an upload that a damaged plan leads to reads as many bytes in an update() as any other") {
  size_t most[3] = {};
  for (size_t i = 0; i < 3; ++i) {
    Pilot pilot;
    if (i == 2) pilot.gives[FilePilot::kRead] = FilePilot::kUnheard;
    if (i != 0) {
      pilot.gives[FilePilot::kRead] = FilePilot::kUnheard;
      pilot.files.upload(inRam(kPlan));
      REQUIRE(pilot.passUntil("read"));
    }
    if (i == 2) {
      pilot.makeLossy();
      pilot.hold({kOther[0], kOther[1], kOther[2], kOther[3]});
      pilot.gives.clear();
      REQUIRE(pilot.isAsked(FilePilot::kCount));
    }
    pilot.pass(3);
    for (int frames = 0; frames < 50; ++frames) pilot.line.bring(telemetry());
    const size_t before = pilot.line.bytesRead;
    pilot.run(1);
    most[i] = pilot.line.bytesRead - before;
  }
  CHECK(most[1] < most[0]);  // time is kept free for a comparison
  CHECK(most[2] == most[0]);
}

TEST_CASE("an error behind an earlier upload, in doubt whether it was a refusal, says nothing about the next one") {
  Pilot pilot;
  pilot.client.upload(inRam(kOther));
  REQUIRE(pilot.isAsked(FilePilot::kCount));
  for (uint8_t i = 0; i < 5; ++i) {
    pilot.hear(requestParts(i));
    REQUIRE(pilot.isAsked(FilePilot::kItemInt, 500));
  }
  pilot.hear(ackParts(1));
  REQUIRE(pilot.isAsked(FilePilot::kRequestList));
  pilot.tellCount(3);
  pilot.pass(100);
  REQUIRE((pilot.ended == Status::Error));
  pilot.writeAndAsk();
  pilot.tellItems(3, 31);
  pilot.pass(100);
  CHECK((pilot.ended == Status::Differs));
}

TEST_CASE("behind a plan that was proven, nothing of an earlier transfer is waited for") {
  Pilot pilot;
  pilot.client.upload(inRam(kOther));
  REQUIRE(pilot.isAsked(FilePilot::kCount));
  pilot.hear(requestParts(0));
  REQUIRE(pilot.isAsked(FilePilot::kItemInt));
  pilot.client.cancel();
  pilot.pass(10);
  pilot.files.upload(inRam(kPlan));
  REQUIRE((pilot.end() == Status::Accepted));
  pilot.client.verify(inRam(kPlan));
  REQUIRE(pilot.isAsked(FilePilot::kRequestList));
  pilot.hear(ackParts(1));  // not an answer to what was cancelled
  pilot.pass(5);
  CHECK_FALSE(pilot.client.isBusy());
}

TEST_CASE("a plan that was written as a file has no name, and not that of the plan before") {
  Pilot pilot;
  MissionFollower follower(pilot.client);
  pilot.client.upload(inRam(kOther));
  REQUIRE(pilot.isAsked(FilePilot::kCount));
  for (uint8_t i = 0; i < 5; ++i) {
    pilot.hear(requestParts(i));
    REQUIRE(pilot.isAsked(FilePilot::kItemInt, 500));
  }
  pilot.hear(ackParts(0, 1, 191, 0, 77));
  pilot.pass(50);
  REQUIRE((pilot.ended == Status::Accepted));
  pilot.files.upload(inRam(kPlan));
  REQUIRE((pilot.end() == Status::Accepted));
  for (int i = 0; i < 4; ++i) {
    pilot.hear(FrameParts(42, {0, 0, 4, 0, 3, 1, 88, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}, 28));
    pilot.pass(1000);
  }
  CHECK((pilot.client.aboard() == Aboard::OurPlan));
}

TEST_CASE("an item whose place is looked for in more than one update() is compared when it is found") {
  std::vector<MissionItem> plan(1, takeoff(20_m));
  for (int i = 0; i < 30; ++i) plan.push_back(returnToLaunch());
  plan.push_back(kPlan[1]);
  Pilot pilot;
  pilot.files.upload(inRam(plan.data(), static_cast<uint32_t>(plan.size())));
  CHECK((pilot.end() == Status::Accepted));
  CHECK(pilot.client.failedItem() == 0xFFFF);
  CHECK(pilot.files.isByFile());
}

namespace {

// A plan of one waypoint and home, by MISSION_ITEM.
void tellFloats(Pilot& pilot) {
  pilot.tellCount(2);
  for (uint8_t i = 0; i < 2; ++i) {
    if (!pilot.isAsked(FilePilot::kRequestInt, 100)) return;
    mavlink_mission_item_t item = mavlink_mission_item_t();
    item.x = -35.5f;
    item.y = 149.5f;
    item.z = 20;
    item.seq = i;
    item.command = 16;
    item.frame = i == 0 ? 0 : 3;
    item.target_system = 1;
    item.target_component = 191;
    item.autocontinue = 1;
    Bytes bytes(sizeof(item));
    memcpy(bytes.data(), &item, sizeof(item));
    pilot.hear(FrameParts(39, bytes, 254));
  }
  pilot.pass(100);
}

}  // namespace

TEST_CASE("items with places in floats are read where no file is, and prove no upload") {
  struct Sink {
    static bool write(void* context, uint16_t, const MissionItem& item) {
      static_cast<std::vector<int32_t>*>(context)->push_back(item.x);
      return true;
    }
  };
  Pilot pilot;
  pilot.gives[FilePilot::kOpen] = FilePilot::kFail;
  for (int i = 0; i < 2; ++i) {
    CAPTURE(i);
    std::vector<int32_t> taken;
    pilot.files.download(toFunction(Sink::write, &taken));
    REQUIRE(pilot.isAsked(FilePilot::kRequestList));
    tellFloats(pilot);
    CHECK((pilot.ended == Status::Downloaded));
    CHECK(taken == std::vector<int32_t>{-355000000, -355000000});
    pilot.files.upload(inRam(kPlan + 1, 1));
    REQUIRE(pilot.passUntil("close"));
    REQUIRE(pilot.isAsked(FilePilot::kRequestList));
    pilot.sent.clear();
    tellFloats(pilot);
    CHECK(pilot.client.isBusy());
    pilot.client.cancel();
    pilot.pass(3000);
  }
}
