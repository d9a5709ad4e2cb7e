// PlanFiles by a whole client: what is asked of ArduPilot's files, word by word, and what an operation ends with.
#include <doctest/doctest.h>

#include <initializer_list>

#include "FilePilot.h"

using namespace mavmission;

namespace {

constexpr MissionItem kPlan[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
                                 waypoint(-35.3642621_deg, 149.1662374_deg, 30_m), returnToLaunch()};
constexpr MissionItem kOther[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
                                  waypoint(-35.3642621_deg, 149.1662374_deg, 31_m), returnToLaunch()};
constexpr MissionItem kShort[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m)};
constexpr uint16_t kCount = 44, kRequestList = 43;

const char kWriting[] = "create @MISSION/mission.dat, write 10+190, write 0+10, close";
const char kReading[] = "open @MISSION/mission.dat, read 0+10, burst 10+38, close";
const std::string kBoth = std::string(kWriting) + ", " + kReading;

// Found, and with no file that could be open.
struct Pilot : FilePilot {
  explicit Pilot(uint8_t autopilot = kArduPilot) : FilePilot(autopilot) {
    pass(4000);
    said();
  }
  std::vector<MissionItem> items(const MissionItem* first, size_t number) const { return {first, first + number}; }
  void arm() {
    baseMode = 128 | 1;
    pass(1000);
    client.allowWhileArmed(true);
  }
  // Whether the operation has gone over to the mission protocol, which asks by this message.
  bool goesByItems(uint16_t messageId, uint32_t limitMs = 20000) {
    sent.clear();
    for (; limitMs != 0; limitMs -= 10) {
      pass(10);
      for (const SentFrame& frame : sent) {
        if (frame.messageId == messageId) return !files.isByFile();
      }
    }
    return false;
  }
};

struct Sink {
  std::vector<MissionItem> items;
  std::vector<uint16_t> numbers;
  size_t refusesAt = 1000;
  static bool write(void* context, uint16_t index, const MissionItem& item) {
    Sink& self = *static_cast<Sink*>(context);
    if (self.items.size() == self.refusesAt) return false;
    self.numbers.push_back(index);
    self.items.push_back(item);
    return true;
  }
};

}  // namespace

TEST_CASE("a plan is written as a file, its header last, and read back") {
  Pilot pilot;
  CHECK((pilot.files.upload(inRam(kPlan)) == Status::WaitingForAutopilot));
  CHECK_FALSE(pilot.files.isByFile());
  CHECK((pilot.end() == Status::Accepted));
  CHECK(pilot.said() == kBoth);
  CHECK(pilot.files.isByFile());
  CHECK((pilot.client.aboard() == Aboard::OurPlan));
  CHECK(pilot.client.itemsTotal() == 4);
  CHECK(pilot.client.itemsDone() == 4);
  CHECK(pilot.stored == 1);
  CHECK(pilot.header == Bytes{0x3D, 0x76, 0, 0, 0, 0, 0, 0, 5, 0});
  REQUIRE(pilot.plans[0].size() == 5);
  for (uint16_t i = 1; i < 5; ++i) {
    const mavlink_mission_item_int_t item = pilot.itemAboard(i);
    CHECK(uint16_t{item.seq} == i);
    CHECK(uint16_t{item.command} == uint16_t{kPlan[i - 1].command});
    CHECK(int32_t{item.x} == int32_t{kPlan[i - 1].x});
    CHECK(int32_t{item.y} == int32_t{kPlan[i - 1].y});
    CHECK(float{item.z} == float{kPlan[i - 1].z});
    CHECK(uint8_t{item.frame} == static_cast<uint8_t>(kPlan[i - 1].frame));
    CHECK(uint8_t{item.autocontinue} == 1);
    CHECK(uint8_t{item.target_system} == 1);
    CHECK(uint8_t{item.target_component} == 1);
    CHECK(uint8_t{item.mission_type} == 0);
  }
  pilot.pass(5000);
  CHECK(pilot.said() == "");
}

TEST_CASE("no frame ends with a zero that MAVLink 2 leaves out") {
  // The last item ends with a mission_type of 0, an autocontinue of 1.
  constexpr MissionItem kEnds[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), returnToLaunch()};
  for (size_t number = 1; number <= 3; ++number) {
    Pilot pilot;
    pilot.sent.clear();
    pilot.files.upload(inRam(kEnds, static_cast<uint32_t>(number)));
    CHECK((pilot.end() == Status::Accepted));
    size_t frames = 0;
    for (const SentFrame& frame : pilot.sent) {
      if (frame.messageId != 110) continue;
      ++frames;
      CHECK(frame.frame[9 + frame.frame[1]] != 0);
    }
    CHECK(frames == 8);
    CHECK(pilot.itemAboard(number).autocontinue == 1);
  }
}

TEST_CASE("the items that are written are told one write after the other, the last one when the plan is proven") {
  static MissionItem many[20];
  for (int i = 0; i < 20; ++i) many[i] = waypoint(Degrees::fromE7(100000 + i), Degrees::fromE7(200000 + i), 20_m);
  Pilot pilot;
  pilot.delayMs = 60;  // one write at a time
  pilot.files.upload(inRam(many));
  std::string done;
  uint16_t last = 0;
  for (int ms = 0; ms < 5000 && pilot.client.isBusy(); ++ms) {
    pilot.pass(1);
    if (pilot.client.itemsDone() != last) done += std::to_string(last = pilot.client.itemsDone()) + " ";
  }
  CHECK(done == "4 10 16 19 20 ");
  CHECK((pilot.ended == Status::Accepted));
  CHECK(pilot.client.itemsDone() == 20);
}

TEST_CASE("each request has a number of its own, and a repeat that of the request") {
  Pilot pilot;
  pilot.files.upload(inRam(kPlan));
  std::vector<uint16_t> numbers;
  const char* const kWords[] = {"create", "write 10", "write 0", "close", "open", "read", "burst"};
  for (const char* words : kWords) {
    REQUIRE(pilot.passUntil(words));
    numbers.push_back(pilot.sequence);
    CHECK(pilot.session == static_cast<uint8_t>((1 * 31) ^ 191 ^ 0x5A));
  }
  REQUIRE(pilot.passUntil("close"));
  for (size_t i = 1; i < 4; ++i) CHECK(numbers[i] == static_cast<uint16_t>(numbers[i - 1] + 1));
  CHECK(numbers[4] == static_cast<uint16_t>(numbers[3] + 2));  // one is left out between two operations
  CHECK(numbers[5] == static_cast<uint16_t>(numbers[4] + 1));
  CHECK(numbers[6] == static_cast<uint16_t>(numbers[5] + 1));
  CHECK(pilot.sequence == static_cast<uint16_t>(numbers[6] + 5 + 2 + 1));  // behind the pieces and the burst's end
  pilot.end();
  pilot.gives[FilePilot::kOpen] = FilePilot::kUnheard;
  pilot.files.verify(inRam(kPlan));
  REQUIRE(pilot.passUntil("open"));
  const uint16_t first = pilot.sequence;
  REQUIRE(pilot.passUntil("open"));
  CHECK(pilot.sequence == first);
  pilot.gives.clear();
  pilot.gives[FilePilot::kBurst] = FilePilot::kUnheard;
  REQUIRE(pilot.passUntil("burst"));
  const uint16_t burst = pilot.sequence;
  REQUIRE(pilot.passUntil("burst"));
  CHECK(pilot.sequence == static_cast<uint16_t>(burst + 5 + 2 + 1));  // a burst is given again with another number
}

TEST_CASE("the numbers begin elsewhere each time") {
  Pilot first;
  first.files.verify(inRam(kPlan));
  REQUIRE(first.passUntil("open"));
  FilePilot second;
  second.baseMode = 128 | 1;  // no file is looked for, so its numbers begin with the operation
  second.pass(4017);
  second.files.verify(inRam(kPlan));
  REQUIRE(second.passUntil("open"));
  CHECK(first.sequence != second.sequence);
  CHECK(first.session == second.session);
}

TEST_CASE("six items are one write, and the next ones leave before its answer") {
  static MissionItem many[20];
  for (int i = 0; i < 20; ++i) many[i] = waypoint(Degrees::fromE7(100000 + i), Degrees::fromE7(200000 + i), 20_m);
  Pilot pilot;
  pilot.files.upload(inRam(many));
  CHECK((pilot.end() == Status::Accepted));
  CHECK(pilot.said() ==
        "create @MISSION/mission.dat, write 10+228, write 238+228, write 466+228, write 694+114, write 0+10, close, "
        "open @MISSION/mission.dat, read 0+10, burst 10+38, close");
  CHECK(pilot.plans[0].size() == 21);
  CHECK(int32_t{pilot.itemAboard(20).x} == 100019);
}

TEST_CASE("fences and rally points have files of their own") {
  constexpr MissionItem kCorners[] = {
      fenceInside(-35.3632621_deg, 149.1652374_deg, 4), fenceInside(-35.3642621_deg, 149.1652374_deg, 4),
      fenceInside(-35.3642621_deg, 149.1662374_deg, 4), fenceInside(-35.3632621_deg, 149.1662374_deg, 4)};
  Pilot pilot;
  pilot.files.upload(inRam(kCorners), PlanType::Fence);
  CHECK((pilot.end() == Status::Accepted));
  CHECK(pilot.said() ==
        "create @MISSION/fence.dat, write 10+152, write 0+10, close, open @MISSION/fence.dat, read 0+10, burst 10+38, "
        "close");
  CHECK(pilot.plans[1].size() == 4);
  CHECK(uint8_t{pilot.itemAboard(0).mission_type} == 1);
  constexpr MissionItem kPoints[] = {rallyPoint(-35.3632621_deg, 149.1652374_deg, 20_m)};
  pilot.files.upload(inRam(kPoints), PlanType::Rally);
  CHECK((pilot.end() == Status::Accepted));
  CHECK(pilot.said() ==
        "create @MISSION/rally.dat, write 10+38, write 0+10, close, open @MISSION/rally.dat, read 0+10, read 10+38, "
        "close");
  CHECK(pilot.plans[2].size() == 1);
}

TEST_CASE("a fence of up to three items goes by the mission protocol") {
  constexpr MissionItem kCorners[] = {fenceInside(-35.3632621_deg, 149.1652374_deg, 3),
                                      fenceInside(-35.3642621_deg, 149.1652374_deg, 3),
                                      fenceInside(-35.3642621_deg, 149.1662374_deg, 3)};
  Pilot pilot;
  pilot.files.upload(inRam(kCorners), PlanType::Fence);
  CHECK(pilot.goesByItems(kCount));
  CHECK(pilot.said() == "");
  Pilot other;
  other.files.ensure(inRam(kCorners), PlanType::Fence);
  CHECK(other.goesByItems(kRequestList));
  CHECK(other.said() == "");
}

TEST_CASE("what is aboard is verified, found, and found to be another plan") {
  Pilot pilot;
  pilot.hold(pilot.items(kPlan, 4));
  pilot.files.verify(inRam(kPlan));
  CHECK((pilot.end() == Status::Verified));
  CHECK(pilot.said() == kReading);
  CHECK((pilot.client.aboard() == Aboard::OurPlan));
  CHECK(pilot.files.isByFile());
  pilot.files.ensure(inRam(kPlan));
  CHECK((pilot.end() == Status::AlreadyAboard));
  CHECK(pilot.said() == kReading);
  CHECK((pilot.client.aboard() == Aboard::OurPlan));
  pilot.files.verify(inRam(kOther));
  CHECK((pilot.end() == Status::Differs));
  CHECK(pilot.said() == kReading);
  CHECK(pilot.client.failedItem() == 2);
  CHECK((pilot.client.differingField() == ItemField::Height));
  CHECK((pilot.client.aboard() == Aboard::NotKnown));
  pilot.files.ensure(inRam(kOther));
  for (int ms = 0; ms < 20000 && pilot.client.aboard() == Aboard::OurPlan; ++ms) pilot.run(1);
  CHECK(pilot.client.isBusy());
  CHECK((pilot.client.aboard() == Aboard::NotKnown));
  CHECK((pilot.end() == Status::Accepted));
  CHECK(pilot.said() == std::string(kReading) + ", " + kBoth);
  CHECK((pilot.client.aboard() == Aboard::OurPlan));
  CHECK(pilot.client.failedItem() == 0xFFFF);
  CHECK(pilot.stored == 1);
  pilot.files.verify(inRam(kShort));
  CHECK((pilot.end() == Status::Differs));
  CHECK((pilot.client.differingField() == ItemField::Count));
  CHECK(pilot.said() == "open @MISSION/mission.dat, read 0+10, close");
}

TEST_CASE("a plan is downloaded as a file, home apart") {
  Pilot pilot;
  pilot.hold(pilot.items(kPlan, 4));
  Sink sink;
  pilot.files.download(toFunction(Sink::write, &sink));
  CHECK((pilot.end() == Status::Downloaded));
  CHECK(pilot.said() == kReading);
  REQUIRE(sink.items.size() == 5);
  CHECK(sink.numbers == std::vector<uint16_t>{kHomeIndex, 0, 1, 2, 3});
  CHECK(int32_t{sink.items[3].x} == -353642621);
  CHECK(float{sink.items[3].z} == 30.0f);
  CHECK((sink.items[3].frame == CoordinateFrame::GlobalRelative));
  CHECK(sink.items[3].autocontinue == 1);
  CHECK(sink.items[3].current == 0);
  CHECK(pilot.client.itemsDone() == 4);
  Sink full;
  full.refusesAt = 2;
  pilot.files.download(toFunction(Sink::write, &full));
  CHECK((pilot.end() == Status::SinkFull));
  CHECK(pilot.said() == kReading);
  Sink few;
  pilot.files.download(toFunction(Sink::write, &few, 3));
  CHECK((pilot.end() == Status::SinkFull));
  CHECK(few.items.empty());
  CHECK(pilot.said() == "open @MISSION/mission.dat, read 0+10, close");
}

TEST_CASE("x, y and z of an item whose command has none of them are left over from another one: they are 0") {
  Pilot pilot;
  pilot.hold(pilot.items(kPlan, 4));
  MissionItem left = kPlan[3];
  left.x = 5;
  left.y = 6;
  left.z = 7;
  pilot.plans[0][4] = pilot.bytesOf(left, 4);
  pilot.files.verify(inRam(kPlan));
  CHECK((pilot.end() == Status::Verified));
  Sink sink;
  pilot.files.download(toFunction(Sink::write, &sink));
  CHECK((pilot.end() == Status::Downloaded));
  REQUIRE(sink.items.size() == 5);
  CHECK(int32_t{sink.items[4].x} == 0);
  CHECK(int32_t{sink.items[4].y} == 0);
  CHECK(float{sink.items[4].z} == 0.0f);
}

TEST_CASE("an item that a burst has lost is read by itself") {
  static MissionItem many[20];
  for (int i = 0; i < 20; ++i) many[i] = waypoint(Degrees::fromE7(100000 + i), Degrees::fromE7(200000 + i), 20_m);
  Pilot pilot;
  pilot.hold(pilot.items(many, 20));
  pilot.lostItem = 7;
  pilot.files.verify(inRam(many));
  CHECK((pilot.end() == Status::Verified));
  CHECK(pilot.said() == "open @MISSION/mission.dat, read 0+10, burst 10+38, read 276+38, close");
}

TEST_CASE("PX4, a sink that is not always ready, and an autopilot of MAVLink 1 get the mission protocol") {
  Pilot px4(ClientOnLine::kPx4);
  px4.files.upload(inRam(kPlan));
  CHECK(px4.goesByItems(kCount));
  Pilot verified(ClientOnLine::kPx4);
  verified.files.verify(inRam(kPlan));
  CHECK(verified.goesByItems(kRequestList));
  Pilot ensured(ClientOnLine::kPx4);
  ensured.files.ensure(inRam(kPlan));
  CHECK(ensured.goesByItems(kRequestList));
  for (Pilot* pilot : {&px4, &verified, &ensured}) CHECK(pilot->said() == "");
  Pilot waiting;
  Sink sink;
  ItemSink slow = toFunction(Sink::write, &sink);
  slow.isReady = [](void*) { return true; };
  waiting.files.download(slow);
  CHECK(waiting.goesByItems(kRequestList));
  CHECK(waiting.said() == "");
}

TEST_CASE("a command that the library does not know goes by the mission protocol, and so do more than 650 items") {
  const MissionItem unknown[] = {takeoff(20_m), anyCommandAt(31234, 1_deg, 2_deg, 20_m)};
  Pilot pilot;
  pilot.files.upload(inRam(unknown));
  CHECK(pilot.goesByItems(kCount));
  Pilot ensured;
  ensured.files.ensure(inRam(unknown));
  CHECK(ensured.goesByItems(kRequestList));
  static MissionItem many[650];
  for (int i = 0; i < 650; ++i) many[i] = waypoint(Degrees::fromE7(100000 + i), Degrees::fromE7(200000 + i), 20_m);
  Pilot full;
  full.files.upload(inRam(many));  // and home
  CHECK(full.goesByItems(kCount));
  Pilot most;
  most.files.upload(inRam(many, 649));
  CHECK(most.passUntil("create", 20000));
}

TEST_CASE("a refusal of the first request leads to the mission protocol, and so does twelve times no answer") {
  for (int error : {int{FilePilot::kFail}, int{FilePilot::kInvalidSession}, int{FilePilot::kFileNotFound}}) {
    Pilot pilot;
    pilot.gives[FilePilot::kCreate] = error;
    pilot.files.upload(inRam(kPlan));
    CHECK(pilot.goesByItems(kCount));
    CHECK(pilot.said() == "create @MISSION/mission.dat");
    Pilot verified;
    verified.gives[FilePilot::kOpen] = error;
    verified.files.verify(inRam(kPlan));
    CHECK(verified.goesByItems(kRequestList));
    CHECK(verified.said() == "open @MISSION/mission.dat");
    Pilot ensured;
    ensured.gives[FilePilot::kOpen] = error;
    ensured.files.ensure(inRam(kPlan));
    CHECK(ensured.goesByItems(kRequestList));
  }
  Pilot silent;
  silent.gives[FilePilot::kCreate] = FilePilot::kUnheard;
  silent.files.upload(inRam(kPlan));
  REQUIRE(silent.passUntil("create"));
  const uint32_t firstMs = silent.nowMs();
  CHECK(silent.goesByItems(kCount));
  CHECK(silent.nowMs() - firstMs >= 7200);
  CHECK(silent.nowMs() - firstMs <= 7250);
}

TEST_CASE("a refusal of what follows leads to the mission protocol too: somebody else has the file") {
  for (uint8_t opcode : {FilePilot::kWrite, FilePilot::kTerminate}) {
    Pilot pilot;
    pilot.gives[opcode] = FilePilot::kInvalidSession;
    pilot.files.upload(inRam(kPlan));
    CHECK(pilot.goesByItems(kCount));
    CHECK((pilot.client.aboard() == Aboard::NotKnown));
  }
  for (uint8_t opcode : {FilePilot::kRead, FilePilot::kBurst}) {
    Pilot pilot;
    pilot.hold(pilot.items(kPlan, 4));
    pilot.gives[opcode] = FilePilot::kInvalidSession;
    pilot.files.verify(inRam(kPlan));
    CHECK(pilot.goesByItems(kRequestList));
  }
}

TEST_CASE("a file that falls silent ends the operation, and what is aboard is what was before") {
  Pilot writing;
  writing.gives[FilePilot::kWrite] = FilePilot::kUnheard;
  writing.files.upload(inRam(kPlan));
  CHECK((writing.end() == Status::TimedOut));
  CHECK((writing.client.aboard() == Aboard::AsBefore));
  CHECK(writing.client.failedItem() == 0xFFFF);  // it was home
  CHECK(writing.stored == 0);
  Pilot closing;
  closing.gives[FilePilot::kTerminate] = FilePilot::kUnheard;
  closing.files.upload(inRam(kPlan));
  CHECK((closing.end() == Status::Unconfirmed));
  CHECK((closing.client.aboard() == Aboard::NotKnown));
  for (uint8_t opcode : {FilePilot::kRead, FilePilot::kBurst}) {
    Pilot reading;
    reading.hold(reading.items(kPlan, 4));
    reading.gives[opcode] = FilePilot::kUnheard;
    reading.files.verify(inRam(kPlan));
    CHECK((reading.end() == Status::TimedOut));
    Pilot proving;
    proving.gives[opcode] = FilePilot::kUnheard;
    proving.files.upload(inRam(kPlan));
    CHECK((proving.end() == Status::Unconfirmed));
    CHECK((proving.client.aboard() == Aboard::NotKnown));
  }
}

TEST_CASE("an answer to the closing of what was read is not waited for long") {
  Pilot pilot;
  pilot.hold(pilot.items(kPlan, 4));
  pilot.gives[FilePilot::kTerminate] = FilePilot::kUnheard;
  pilot.files.verify(inRam(kPlan));
  CHECK((pilot.end() == Status::Verified));
  CHECK(pilot.tookMs < 400);
}

TEST_CASE("another plan that is read back is one that differs") {
  Pilot pilot;
  pilot.files.upload(inRam(kPlan));
  REQUIRE(pilot.passUntil("open"));
  pilot.hold(pilot.items(kOther, 4));
  CHECK((pilot.end() == Status::Differs));
  CHECK(pilot.client.failedItem() == 2);
  CHECK((pilot.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("an armed ArduPilot is asked how many items it has, and gets no file that is shorter") {
  Pilot pilot;
  pilot.hold(pilot.items(kOther, 4));
  pilot.arm();
  pilot.files.upload(inRam(kPlan));
  CHECK((pilot.end() == Status::Accepted));
  CHECK(pilot.said() == "open @MISSION/mission.dat, read 0+10, close, " + kBoth);
  Pilot shorter;
  shorter.hold(shorter.items(kOther, 4));
  shorter.arm();
  shorter.files.upload(inRam(kShort));
  CHECK(shorter.goesByItems(kCount));
  CHECK(shorter.said() == "open @MISSION/mission.dat, read 0+10, close");
  Pilot unknown;
  unknown.gives[FilePilot::kOpen] = FilePilot::kFileNotFound;
  unknown.arm();
  unknown.files.upload(inRam(kPlan));
  CHECK(unknown.goesByItems(kCount));
  Pilot refused;
  refused.baseMode = 128 | 1;
  refused.pass(1000);
  refused.files.upload(inRam(kPlan));
  CHECK((refused.end() == Status::Armed));
  CHECK(refused.said() == "");
}

TEST_CASE("ArduPilot that is armed while its plan is written gets no header, and no plan unless that is allowed") {
  for (bool isAllowed : {false, true}) {
    Pilot pilot;
    pilot.client.allowWhileArmed(isAllowed);
    pilot.files.upload(inRam(kPlan));
    REQUIRE(pilot.passUntil("write 10"));
    pilot.baseMode = 128 | 1;
    pilot.beat();
    if (isAllowed) {
      CHECK(pilot.goesByItems(kCount));
    } else {
      CHECK((pilot.end() == Status::Armed));
      CHECK((pilot.client.aboard() == Aboard::AsBefore));
    }
    CHECK(pilot.said() == "create @MISSION/mission.dat, write 10+190");
  }
}

TEST_CASE("an armed ArduPilot keeps its plan from ensure(), which looks at it by the mission protocol") {
  Pilot pilot;
  pilot.arm();
  pilot.files.ensure(inRam(kPlan));
  CHECK(pilot.goesByItems(kRequestList));
  CHECK(pilot.said() == "");
  Pilot during;
  during.hold(during.items(kOther, 4));
  during.client.allowWhileArmed(true);
  during.files.ensure(inRam(kPlan));
  REQUIRE(during.passUntil("burst"));
  during.baseMode = 128 | 1;
  during.beat();
  CHECK((during.end() == Status::Armed));
  CHECK(during.stored == 0);
  Pilot writing;
  writing.hold(writing.items(kOther, 4));
  writing.client.allowWhileArmed(true);
  writing.files.ensure(inRam(kPlan));
  REQUIRE(writing.passUntil("write 10"));
  writing.baseMode = 128 | 1;
  writing.beat();
  CHECK((writing.end() == Status::Armed));
  Pilot refusing;
  refusing.hold(refusing.items(kOther, 4));
  refusing.client.allowWhileArmed(true);
  refusing.gives[FilePilot::kWrite] = FilePilot::kInvalidSession;
  refusing.files.ensure(inRam(kPlan));
  REQUIRE(refusing.passUntil("write 10"));
  refusing.baseMode = 128 | 1;
  refusing.beat();
  CHECK((refusing.end() == Status::Armed));
}

TEST_CASE("a file that may have been left open before a reset is made unusable, and closed, and then left alone") {
  FilePilot pilot;
  pilot.pass(6000);
  CHECK(pilot.said() == "write 0+10, close");
  FilePilot silent;
  silent.gives[FilePilot::kWrite] = silent.gives[FilePilot::kTerminate] = FilePilot::kUnheard;
  silent.pass(20000);
  CHECK(silent.said() == "write 0+10, write 0+10, write 0+10, write 0+10, write 0+10");
  FilePilot armed;
  armed.baseMode = 128 | 1;
  armed.pass(6000);
  CHECK(armed.said() == "");
  FilePilot px4(ClientOnLine::kPx4);
  px4.pass(6000);
  CHECK(px4.said() == "");
  for (int error : {int{FilePilot::kInvalidSession}, int{FilePilot::kFileNotFound}}) {
    FilePilot none;
    none.gives[FilePilot::kWrite] = error;
    none.pass(6000);
    CHECK(none.said() == "write 0+10");
  }
  FilePilot failing;  // it is open for reading
  failing.gives[FilePilot::kWrite] = FilePilot::kFail;
  failing.pass(6000);
  CHECK(failing.said() == "write 0+10, close");
}

TEST_CASE("a file that an operation has left open is closed with a heartbeat, until that is answered") {
  Pilot pilot;
  pilot.files.upload(inRam(kPlan));
  REQUIRE(pilot.passUntil("write 10"));
  pilot.client.cancel();
  pilot.gives[FilePilot::kTerminate] = FilePilot::kUnheard;
  pilot.pass(100);
  pilot.said();
  pilot.pass(10000);
  CHECK(pilot.said() == "close, close, close, close, close, close, close, close, close, close");
  pilot.gives.clear();
  pilot.pass(3000);
  CHECK(pilot.said() == "close");
  CHECK(pilot.stored == 0);
}

TEST_CASE("a file that was left open by an operation whose autopilot was armed meanwhile is closed all the same") {
  Pilot pilot;
  pilot.files.upload(inRam(kPlan));
  REQUIRE(pilot.passUntil("write 10"));
  pilot.client.cancel();
  pilot.baseMode = 128 | 1;
  pilot.pass(100);
  pilot.said();
  pilot.pass(3000);
  CHECK(pilot.said() == "close");
}

TEST_CASE("an opening that is not answered may have been carried out: it is closed, five times at most") {
  Pilot pilot;
  pilot.gives[FilePilot::kCreate] = FilePilot::kUnheard;
  pilot.gives[FilePilot::kTerminate] = FilePilot::kUnheard;
  pilot.files.upload(inRam(kPlan));
  REQUIRE(pilot.passUntil("create"));
  pilot.client.cancel();
  pilot.said();
  pilot.pass(12000);
  CHECK(pilot.said() == "close, close, close, close, close");
}

TEST_CASE("a plan that was complete in its file when its upload was cancelled is not stored by the closing") {
  Pilot pilot;
  pilot.files.upload(inRam(kPlan));
  REQUIRE(pilot.passUntil("write 0+10"));
  pilot.client.cancel();
  CHECK((pilot.client.aboard() == Aboard::NotKnown));
  pilot.pass(100);
  pilot.said();
  pilot.pass(5000);
  CHECK(pilot.said() == "write 0+10, close");
  CHECK(pilot.stored == 0);
}

TEST_CASE("a cancelled upload sends nothing more of a write that has begun") {
  Pilot pilot;
  pilot.files.upload(inRam(kPlan));
  REQUIRE(pilot.passUntil("create"));
  pilot.line.room = 20;
  pilot.pass(20);
  pilot.client.cancel();
  pilot.pass(20);
  pilot.line.room = MemoryStream::kAlwaysRoom;
  pilot.pass(200);
  CHECK((pilot.ended == Status::Cancelled));
  CHECK((pilot.client.aboard() == Aboard::AsBefore));
}

TEST_CASE("a source that gives no item ends the upload, and names that item") {
  struct Source {
    static bool read(void* context, uint16_t index, MissionItem& item) {
      uint16_t& reads = *static_cast<uint16_t*>(context);
      if (index == 2 && ++reads > 1) return false;
      item = kPlan[index];
      return true;
    }
  };
  uint16_t reads = 0;
  Pilot pilot;
  pilot.files.upload(fromFunction(Source::read, 4, &reads));
  CHECK((pilot.end() == Status::SourceRefused));
  CHECK(pilot.client.failedItem() == 2);
  CHECK((pilot.client.aboard() == Aboard::AsBefore));
  CHECK(pilot.said() == "create @MISSION/mission.dat");
}

TEST_CASE("an operation is refused while another one runs, and a plan that cannot be meant at once") {
  Pilot pilot;
  pilot.files.verify(inRam(kPlan));
  CHECK((pilot.files.verify(inRam(kPlan)) == Status::Busy));
  CHECK((pilot.files.upload(inRam(kPlan)) == Status::Busy));
  CHECK((pilot.files.ensure(inRam(kPlan)) == Status::Busy));
  Sink sink;
  CHECK((pilot.files.download(toFunction(Sink::write, &sink)) == Status::Busy));
  pilot.end();
  MissionItem wrong[] = {takeoff(20_m), waypoint(91_deg, 0_deg, 20_m)};
  pilot.said();
  pilot.files.upload(inRam(wrong));
  CHECK((pilot.end() == Status::BadLatitude));
  CHECK(pilot.client.failedItem() == 1);
  pilot.files.ensure(inRam(wrong));
  CHECK((pilot.end() == Status::BadLatitude));
  CHECK(pilot.said() == "");
}

TEST_CASE("an operation ends with its time") {
  Pilot pilot;
  pilot.client.setOperationTimeout(3);
  pilot.gives[FilePilot::kWrite] = FilePilot::kUnheard;
  pilot.files.upload(inRam(kPlan));
  CHECK((pilot.end() == Status::TookTooLong));
  CHECK(pilot.tookMs < 5000);
  Pilot reading;
  reading.hold(reading.items(kPlan, 4));
  reading.client.setOperationTimeout(1);
  reading.gives[FilePilot::kOpen] = FilePilot::kUnheard;
  reading.files.verify(inRam(kPlan));
  CHECK((reading.end() == Status::TookTooLong));
  CHECK(reading.tookMs < 3000);
}

TEST_CASE("answers with another session, to other components, or to older requests are none") {
  Pilot pilot;
  pilot.gives[FilePilot::kOpen] = FilePilot::kUnheard;
  pilot.hold(pilot.items(kPlan, 4));
  pilot.files.verify(inRam(kPlan));
  REQUIRE(pilot.passUntil("open"));
  const uint16_t number = static_cast<uint16_t>(pilot.sequence + 1);
  pilot.reply(number, static_cast<uint8_t>(pilot.session + 1), 128, FilePilot::kOpen, 0, {0, 0, 0, 0});
  pilot.reply(static_cast<uint16_t>(number - 2), pilot.session, 128, FilePilot::kOpen, 0, {0, 0, 0, 0});
  pilot.reply(static_cast<uint16_t>(number - 3), pilot.session, 129, FilePilot::kOpen, 0, {10});
  pilot.pass(300);
  CHECK(pilot.said() == "open @MISSION/mission.dat");
  pilot.reply(number, pilot.session, 128, FilePilot::kOpen, 0, {0, 0, 0, 0});
  CHECK(pilot.passUntil("read", 50));
}

TEST_CASE("a header of another file, or of another plan, is none") {
  const Bytes kHeaders[] = {
      {0x3E, 0x76, 0, 0, 0, 0, 0, 0, 5, 0}, {0x3D, 0x77, 0, 0, 0, 0, 0, 0, 5, 0}, {0x3D, 0x76, 1, 0, 0, 0, 0, 0, 5, 0}};
  for (const Bytes& header : kHeaders) {
    Pilot pilot;
    pilot.hold(pilot.items(kPlan, 4));
    pilot.gives[FilePilot::kRead] = FilePilot::kUnheard;
    pilot.files.verify(inRam(kPlan));
    REQUIRE(pilot.passUntil("read"));
    pilot.reply(static_cast<uint16_t>(pilot.sequence + 1), pilot.session, 128, FilePilot::kRead, 0, header);
    pilot.said();
    pilot.pass(200);
    CHECK(pilot.said() == "");
    CHECK(pilot.passUntil("read 0+10", 300));
  }
}

TEST_CASE("a piece that is no item, or none of the file, is not taken") {
  Pilot pilot;
  pilot.hold(pilot.items(kPlan, 4));
  pilot.gives[FilePilot::kBurst] = FilePilot::kUnheard;
  pilot.files.verify(inRam(kPlan));
  REQUIRE(pilot.passUntil("burst"));
  const uint16_t number = static_cast<uint16_t>(pilot.sequence + 1);
  const Bytes& first = pilot.plans[0][1];  // would be another item
  pilot.reply(number, pilot.session, 128, FilePilot::kBurst, 11, first);
  pilot.reply(number, pilot.session, 128, FilePilot::kBurst, 10 + 38 * 65536u, first);
  pilot.reply(number, pilot.session, 128, FilePilot::kBurst, 10, Bytes(first.begin(), first.begin() + 37));
  pilot.pass(20);
  CHECK(pilot.client.itemsDone() == 0);
  for (uint32_t i = 0; i < 5; ++i) {
    pilot.reply(static_cast<uint16_t>(number + i), pilot.session, 128, FilePilot::kBurst, 10 + 38 * i,
                pilot.plans[0][i]);
  }
  CHECK((pilot.end(200) == Status::Verified));
}

namespace {

// What the mission protocol asks for first when it has been told how many items there are.
int firstAsked(Pilot& pilot, uint16_t count) {
  pilot.sent.clear();
  if (!pilot.goesByItems(kRequestList)) return -1;
  pilot.hear(FrameParts(44, {static_cast<uint8_t>(count), 0, 1, 191, 0}, 221));
  for (int ms = 0; ms < 200; ++ms) {
    pilot.pass(1);
    for (const SentFrame& frame : pilot.sent) {
      const bool isRequest = frame.messageId == 40 || frame.messageId == 51;
      if (isRequest) return frame.payload[0] | frame.payload[1] << 8;
    }
  }
  return -2;
}

}  // namespace

TEST_CASE("where the file is lost in the middle, a download goes on by items, and a comparison begins anew") {
  for (bool isCompared : {false, true}) {
    Pilot pilot;
    pilot.hold(pilot.items(kPlan, 4));
    pilot.gives[FilePilot::kBurst] = FilePilot::kUnheard;
    Sink sink;
    if (isCompared) {
      pilot.files.verify(inRam(kPlan));
    } else {
      pilot.files.download(toFunction(Sink::write, &sink));
    }
    REQUIRE(pilot.passUntil("burst"));
    for (uint16_t i = 0; i < 3; ++i) {
      pilot.reply(static_cast<uint16_t>(pilot.sequence + 1 + i), pilot.session, 128, FilePilot::kBurst, 10u + 38u * i,
                  pilot.plans[0][i]);
      pilot.pass(5);
    }
    pilot.refuse(static_cast<uint16_t>(pilot.sequence + 4), FilePilot::kBurst, FilePilot::kInvalidSession);
    CHECK(firstAsked(pilot, 5) == (isCompared ? 0 : 3));
  }
}

TEST_CASE("an autopilot without files is asked for all items, and so is one that does not answer twelve times") {
  Pilot px4(ClientOnLine::kPx4);
  Sink sink;
  px4.files.download(toFunction(Sink::write, &sink));
  CHECK(firstAsked(px4, 4) == 0);
  Pilot silent;
  silent.gives[FilePilot::kOpen] = FilePilot::kUnheard;
  silent.files.download(toFunction(Sink::write, &sink));
  CHECK(firstAsked(silent, 5) == 0);
  CHECK_FALSE(silent.files.isByFile());
}

TEST_CASE("a late refusal of an opening whose repeat was taken, and one of the closing, change nothing") {
  Pilot pilot;
  pilot.hold(pilot.items(kPlan, 4));
  pilot.once[FilePilot::kOpen] = FilePilot::kUnheard;
  pilot.gives[FilePilot::kTerminate] = FilePilot::kFail;
  pilot.gives[FilePilot::kBurst] = FilePilot::kUnheard;
  pilot.files.verify(inRam(kPlan));
  REQUIRE(pilot.passUntil("burst"));
  pilot.refuse(static_cast<uint16_t>(pilot.sequence - 1), FilePilot::kOpen, FilePilot::kFail);
  pilot.pass(20);
  CHECK(pilot.files.isByFile());
  pilot.gives[FilePilot::kBurst] = 0;
  CHECK((pilot.end() == Status::Verified));
  CHECK(pilot.files.isByFile());
}

TEST_CASE("what an item has of its own in a file is given, and whether it is the current one is not") {
  Pilot pilot;
  MissionItem item = kPlan[1];
  item.current = 1;
  item.autocontinue = 0;
  pilot.hold(pilot.items(kPlan, 4));
  pilot.plans[0][2] = pilot.bytesOf(item, 2);
  Sink sink;
  pilot.files.download(toFunction(Sink::write, &sink));
  REQUIRE((pilot.end() == Status::Downloaded));
  CHECK(sink.items[2].current == 0);
  CHECK(sink.items[2].autocontinue == 0);
  CHECK(uint16_t{sink.items[2].command} == 16);
}

TEST_CASE("a download leaves what is known of the plan aboard as it was") {
  Pilot pilot;
  pilot.files.upload(inRam(kPlan));
  REQUIRE((pilot.end() == Status::Accepted));
  Sink sink;
  pilot.files.download(toFunction(Sink::write, &sink));
  REQUIRE((pilot.end() == Status::Downloaded));
  CHECK((pilot.client.aboard() == Aboard::OurPlan));
}

TEST_CASE("a reading that has taken too long ends when its file is closed") {
  Pilot pilot;
  pilot.hold(pilot.items(kPlan, 4));
  pilot.client.setOperationTimeout(1);
  pilot.gives[FilePilot::kBurst] = FilePilot::kUnheard;
  pilot.files.verify(inRam(kPlan));
  REQUIRE(pilot.passUntil("close"));
  CHECK((pilot.end() == Status::TookTooLong));
  CHECK(pilot.tookMs < 20);
}

TEST_CASE("our own plan that is not aboard any more is not known to be there") {
  Pilot pilot;
  const ItemSource plan = inRam(kPlan);
  pilot.files.upload(plan);
  REQUIRE((pilot.end() == Status::Accepted));
  pilot.hold(pilot.items(kOther, 4));
  pilot.files.verify(plan);
  CHECK((pilot.end() == Status::Differs));
  CHECK((pilot.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("on a link of MAVLink 1 no file is asked for, and there are no fences") {
  FilePilot pilot;
  pilot.version = 1;
  pilot.pass(4000);
  Sink sink;
  pilot.files.download(toFunction(Sink::write, &sink), PlanType::Fence);
  CHECK((pilot.end() == Status::NeedsMavlink2));
  pilot.pass(2000);
  CHECK((pilot.client.status() == Status::NeedsMavlink2));
  pilot.files.download(toFunction(Sink::write, &sink));
  CHECK(pilot.passUntil("open", 50) == false);
  CHECK_FALSE(pilot.files.isByFile());
  CHECK(pilot.timesOf(kRequestList, 0).size() == 1);
  CHECK(pilot.said() == "");
}

namespace {

// An upload whose file was closed, and which is proven item by item: the line loses, or the file cannot be read.
struct Proven : Pilot {
  explicit Proven(bool isLossy) {
    for (int i = 0; isLossy && i < 100; ++i) {
      lose(3);
      beat();
      pass(20);
    }
    gives[kOpen] = kFail;
    said();
    files.upload(inRam(kPlan));
    REQUIRE(passUntil("close"));
    REQUIRE(isAsked(kRequestList));
    CHECK(stored == 1);
  }
  bool isAsked(uint16_t messageId, uint32_t limitMs = 3000) {
    sent.clear();
    for (; limitMs != 0; --limitMs) {
      pass(1);
      for (const SentFrame& frame : sent) {
        if (frame.messageId == messageId) return true;
      }
    }
    return false;
  }
  void tellCount(uint8_t count) { hear(FrameParts(44, {count, 0, 1, 191, 0}, 221)); }
  // The items one after the other, as each is asked for; the last one with this height.
  void tellItems(float lastHeight) {
    for (size_t i = 0; i < 5; ++i) {
      if (!isAsked(51)) return;
      mavlink_mission_item_int_t item = itemAboard(i);
      if (i == 3) item.z = lastHeight;
      item.target_system = 1;
      item.target_component = 191;
      Bytes bytes(sizeof(item));
      memcpy(bytes.data(), &item, sizeof(item));
      hear(FrameParts(73, bytes, 38));
    }
  }
};

}  // namespace

TEST_CASE("a plan that is proven item by item is accepted when all items are the same") {
  for (bool isLossy : {false, true}) {
    CAPTURE(isLossy);
    Proven pilot(isLossy);
    pilot.tellCount(5);
    pilot.tellItems(30);
    pilot.pass(100);
    CHECK((pilot.ended == Status::Accepted));
    CHECK((pilot.client.aboard() == Aboard::OurPlan));
    CHECK(pilot.files.isByFile());
  }
}

TEST_CASE("an item that is another one differs, and on a lossy link the plan is uploaded item by item") {
  for (bool isLossy : {false, true}) {
    CAPTURE(isLossy);
    Proven pilot(isLossy);
    pilot.tellCount(5);
    pilot.tellItems(31);
    const bool isUploaded = pilot.isAsked(kCount, 1000);
    CHECK(isUploaded == isLossy);
    CHECK(pilot.client.isBusy() == isLossy);
    CHECK(pilot.files.isByFile() == !isLossy);
    if (!isLossy) CHECK((pilot.ended == Status::Differs));
  }
}

TEST_CASE("another number of items differs, and on a lossy link the plan is uploaded item by item") {
  for (bool isLossy : {false, true}) {
    CAPTURE(isLossy);
    Proven pilot(isLossy);
    pilot.tellCount(4);
    const bool isUploaded = pilot.isAsked(kCount, 1000);
    CHECK(isUploaded == isLossy);
    CHECK(pilot.files.isByFile() == !isLossy);
    if (!isLossy) CHECK((pilot.ended == Status::Differs));
  }
}

TEST_CASE("what was known of the plan aboard is not known of the next one that is ensured") {
  Pilot pilot;
  pilot.files.upload(inRam(kPlan));
  REQUIRE((pilot.end() == Status::Accepted));
  REQUIRE((pilot.client.aboard() == Aboard::OurPlan));
  pilot.files.ensure(inRam(kOther));
  CHECK((pilot.client.aboard() == Aboard::OurPlan));  // until it is looked for
  REQUIRE(pilot.passUntil("open"));
  CHECK((pilot.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("what ensure() has written is proven item by item where its file cannot be read") {
  Pilot pilot;
  pilot.hold(pilot.items(kOther, 4));
  pilot.files.ensure(inRam(kPlan));
  REQUIRE(pilot.passUntil("create"));
  pilot.gives[FilePilot::kOpen] = FilePilot::kFail;
  REQUIRE(pilot.passUntil("open"));
  pilot.sent.clear();
  pilot.pass(1000);
  CHECK(pilot.client.isBusy());
  CHECK_FALSE(pilot.timesOf(kRequestList, 0).empty());
}
