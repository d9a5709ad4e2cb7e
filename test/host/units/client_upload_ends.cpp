// How an upload ends by a whole client, and what it says about the plan that is aboard then.
#include <doctest/doctest.h>
#include <string.h>

#include "ClientOnLine.h"
#include "PlanFrames.h"

using namespace mavmission;

namespace {

constexpr uint8_t kAccepted = 0, kError = 1, kNoSpace = 4, kDenied = 14, kCancelled = 15;
constexpr uint8_t kSafetyArmed = 128;  // in HEARTBEAT.base_mode
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), changeSpeed(5_mps), returnToLaunch()};
const MissionItem kFence[] = {fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m)};

template <typename Value>
Value valueAt(const SentFrame& frame, size_t at) {
  Value value;
  memcpy(&value, &frame.payload[at], sizeof(value));
  return value;
}

typedef std::vector<std::pair<uint16_t, uint16_t>> Progress;

struct Uploading : ClientOnLine {
  Progress progress;
  PlanType type = PlanType::Mission;

  explicit Uploading(uint8_t autopilot, uint32_t startMs = 65000) : ClientOnLine(autopilot, startMs) {
    client.onProgress(note, this);
    run(3000);
  }
  static void note(void* context, uint16_t done, uint16_t total) {
    static_cast<Uploading*>(context)->progress.emplace_back(done, total);
  }
  void begin(const ItemSource& plan = inRam(kPlan), PlanType of = PlanType::Mission) {
    type = of;
    sent.clear();
    ended = Status::Idle;
    CHECK((client.uploadWithoutReadback(plan, of) == Status::WaitingForAutopilot));
    REQUIRE(runUntilSent(kCount, 3000));
  }
  void ask(uint16_t from, uint16_t to) {
    for (uint16_t item = from; item < to; ++item) {
      hear(requestParts(item, 1, 191, static_cast<uint8_t>(type)));
      REQUIRE(runUntilSent(kItemInt, 50));
      CHECK(valueAt<uint16_t>(sent.back(), 28) == item);
    }
  }
  void tell(uint8_t result, uint32_t opaqueId = 0) {
    hear(ackParts(result, 1, 191, static_cast<uint8_t>(type), opaqueId));
    run(5);
  }
  std::vector<uint8_t> acks() const {
    std::vector<uint8_t> results;
    for (const SentFrame& frame : sent) {
      if (frame.messageId == kAck) results.push_back(frame.payload[2]);
    }
    return results;
  }
};

}  // namespace

TEST_CASE("each item is sent as the plan has it, and the number of items before") {
  MissionItem plan[] = {anyCommandAt(kNavWaypoint, -35.3632621_deg, 149.1652374_deg, 20_m, 1, 0, 0, 90),
                        anyCommand(kDoDigicamControl, 1, 2, 3, 4, 5, 6, 7)};
  plan[0].current = 1;
  plan[1].autocontinue = 0;
  Uploading desk(ClientOnLine::kOther);
  // Behind other frames nothing of them is left over.
  for (int upload = 0; upload < 2; ++upload) {
    desk.begin(inRam(plan));
    const SentFrame count = desk.sent.back();
    CHECK(valueAt<uint16_t>(count, 0) == 2);
    CHECK(count.payload[2] == 1);
    CHECK(count.payload[3] == 1);
    for (size_t at = 4; at < 9; ++at) CHECK(count.payload[at] == 0);  // a mission, and no opaque_id
    for (uint16_t seq = 0; seq < 2; ++seq) {
      desk.ask(seq, static_cast<uint16_t>(seq + 1));
      const SentFrame frame = desk.sent.back();
      const MissionItem& item = plan[seq];
      CHECK(valueAt<float>(frame, 0) == item.param1);
      CHECK(valueAt<float>(frame, 4) == item.param2);
      CHECK(valueAt<float>(frame, 8) == item.param3);
      CHECK(valueAt<float>(frame, 12) == item.param4);
      CHECK(valueAt<int32_t>(frame, 16) == item.x);
      CHECK(valueAt<int32_t>(frame, 20) == item.y);
      CHECK(valueAt<float>(frame, 24) == item.z);
      CHECK(valueAt<uint16_t>(frame, 30) == item.command);
      CHECK(frame.payload[32] == 1);
      CHECK(frame.payload[33] == 1);
      CHECK(frame.payload[34] == static_cast<uint8_t>(item.frame));
      CHECK(frame.payload[35] == item.current);
      CHECK(frame.payload[36] == item.autocontinue);
      CHECK(frame.payload[37] == 0);
    }
    desk.tell(kNoSpace);
  }
}

TEST_CASE("a long plan is announced with all its items, and an item of a fence is one of a fence") {
  Uploading desk(ClientOnLine::kPx4);
  const auto read = [](void*, uint16_t, MissionItem& item) {
    item = kPlan[0];
    return true;
  };
  desk.begin(fromFunction(read, 700));
  CHECK(valueAt<uint16_t>(desk.sent.back(), 0) == 700);
  desk.client.cancel();
  desk.run(5);
  desk.begin(inRam(kFence), PlanType::Fence);
  CHECK(desk.sent.back().payload[4] == 1);
  desk.ask(0, 1);
  CHECK(desk.sent.back().payload[37] == 1);
}

TEST_CASE("progress is told as the autopilot asks on, and the last item is done when all is accepted") {
  for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    const uint16_t home = autopilot == ClientOnLine::kArduPilot ? 1 : 0;
    Uploading desk(autopilot);
    desk.begin();
    CHECK(desk.client.itemsTotal() == 3);
    desk.ask(0, static_cast<uint16_t>(home + 1));
    CHECK(desk.progress.empty());
    desk.ask(static_cast<uint16_t>(home + 1), static_cast<uint16_t>(home + 2));
    CHECK(desk.client.itemsDone() == 1);
    desk.ask(static_cast<uint16_t>(home + 2), static_cast<uint16_t>(home + 3));
    CHECK(desk.progress == Progress{{1, 3}, {2, 3}});
    desk.hear(requestParts(static_cast<uint16_t>(home + 2)));  // once more
    desk.run(200);
    CHECK(desk.progress == Progress{{1, 3}, {2, 3}});
    desk.tell(kAccepted);
    CHECK((desk.ended == Status::Accepted));
    CHECK((desk.client.aboard() == Aboard::OurPlan));
    CHECK(desk.client.lastResult() == kAccepted);
    CHECK((desk.client.failedItem() == MissionClient::kNoItem));
    CHECK(desk.progress == Progress{{1, 3}, {2, 3}, {3, 3}});
    // In the next one it begins anew.
    desk.progress.clear();
    desk.begin();
    CHECK(desk.client.itemsDone() == 0);
    CHECK(desk.client.lastResult() == 255);
    desk.ask(0, static_cast<uint16_t>(home + 2));
    CHECK(desk.progress == Progress{{1, 3}});
  }
}

TEST_CASE("what a refusal leaves aboard depends on the autopilot, the type, and how far the upload was") {
  const uint8_t kArduPilot = ClientOnLine::kArduPilot, kPx4 = ClientOnLine::kPx4, kOther = ClientOnLine::kOther;
  const struct {
    uint8_t autopilot;
    PlanType type;
    uint16_t asked;
    uint8_t result;
    Aboard aboard;
    uint16_t failed;
  } kCases[] = {
      {kArduPilot, PlanType::Mission, 0, kNoSpace, Aboard::AsBefore, 0xFFFF},
      {kArduPilot, PlanType::Mission, 0, kError, Aboard::AsBefore, 0xFFFF},
      {kArduPilot, PlanType::Mission, 1, kNoSpace, Aboard::Mixture, 0xFFFF},  // home
      {kArduPilot, PlanType::Mission, 2, kNoSpace, Aboard::Mixture, 0},
      {kArduPilot, PlanType::Mission, 3, kError, Aboard::Mixture, 1},
      {kArduPilot, PlanType::Mission, 4, kNoSpace, Aboard::Mixture, 2},
      {kArduPilot, PlanType::Mission, 4, kError, Aboard::NotKnown, 2},
      {kArduPilot, PlanType::Rally, 0, kNoSpace, Aboard::AsBefore, 0xFFFF},
      {kArduPilot, PlanType::Rally, 1, kNoSpace, Aboard::NotKnown, 0},
      {kPx4, PlanType::Mission, 0, kNoSpace, Aboard::AsBefore, 0xFFFF},
      {kPx4, PlanType::Mission, 1, kNoSpace, Aboard::AsBefore, 0},
      {kPx4, PlanType::Mission, 3, kNoSpace, Aboard::AsBefore, 2},
      {kOther, PlanType::Mission, 0, kDenied, Aboard::AsBefore, 0xFFFF},
      {kOther, PlanType::Mission, 1, kDenied, Aboard::NotKnown, 0},
      {kOther, PlanType::Mission, 3, kNoSpace, Aboard::NotKnown, 2},
  };
  const MissionItem rally[] = {rallyPoint(-35.36_deg, 149.16_deg, 20_m), rallyPoint(-35.37_deg, 149.16_deg, 20_m)};
  for (const auto& one : kCases) {
    CAPTURE(static_cast<int>(one.autopilot));
    CAPTURE(one.asked);
    CAPTURE(static_cast<int>(one.result));
    Uploading desk(one.autopilot);
    desk.begin(one.type == PlanType::Mission ? inRam(kPlan) : inRam(rally), one.type);
    desk.ask(0, one.asked);
    desk.tell(one.result);
    CHECK((desk.ended == fromMissionResult(one.result)));
    CHECK(desk.client.lastResult() == one.result);
    CHECK((desk.client.aboard(one.type) == one.aboard));
    CHECK(desk.client.failedItem() == one.failed);
    desk.run(50);
    CHECK(desk.acks().empty());
  }
}

TEST_CASE("what silence leaves aboard, and the autopilot is told that we have given up") {
  const uint8_t kArduPilot = ClientOnLine::kArduPilot, kPx4 = ClientOnLine::kPx4, kOther = ClientOnLine::kOther;
  const struct {
    uint8_t autopilot;
    uint16_t asked;
    Status status;
    Aboard aboard;
    uint16_t failed;
  } kCases[] = {
      {kArduPilot, 0, Status::NoAnswer, Aboard::NotKnown, 0xFFFF},
      {kArduPilot, 1, Status::TimedOut, Aboard::Mixture, 0xFFFF},
      {kArduPilot, 3, Status::TimedOut, Aboard::Mixture, 1},
      {kArduPilot, 4, Status::Unconfirmed, Aboard::NotKnown, 0xFFFF},
      {kPx4, 0, Status::NoAnswer, Aboard::AsBefore, 0xFFFF},
      {kPx4, 2, Status::TimedOut, Aboard::AsBefore, 1},
      {kPx4, 3, Status::Unconfirmed, Aboard::NotKnown, 0xFFFF},
      {kOther, 0, Status::NoAnswer, Aboard::NotKnown, 0xFFFF},
      {kOther, 2, Status::TimedOut, Aboard::NotKnown, 1},
  };
  for (const auto& one : kCases) {
    CAPTURE(static_cast<int>(one.autopilot));
    CAPTURE(one.asked);
    Uploading desk(one.autopilot);
    desk.begin();
    desk.ask(0, one.asked);
    desk.run(9100);
    CHECK((desk.ended == one.status));
    CHECK((desk.client.aboard() == one.aboard));
    CHECK(desk.client.failedItem() == one.failed);
    CHECK(desk.client.lastResult() == 255);
    const bool isTold = one.status != Status::Unconfirmed;
    CHECK(desk.acks() == std::vector<uint8_t>(isTold ? 1 : 0, kCancelled));
  }
}

TEST_CASE("an empty plan that nobody answers may have cleared the plan, and one that is refused has not") {
  for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    Uploading silent(autopilot), refused(autopilot), accepted(autopilot);
    silent.begin(emptyPlan());
    silent.run(8000);
    CHECK((silent.ended == Status::NoAnswer));
    CHECK((silent.client.aboard() == Aboard::NotKnown));
    refused.begin(emptyPlan());
    refused.tell(kNoSpace);
    CHECK((refused.ended == Status::NoSpace));
    CHECK((refused.client.aboard() == Aboard::AsBefore));
    accepted.begin(emptyPlan());
    CHECK(valueAt<uint16_t>(accepted.sent.back(), 0) == 0);
    accepted.tell(kAccepted);
    CHECK((accepted.ended == Status::Accepted));
    CHECK((accepted.client.aboard() == Aboard::OurPlan));
  }
}

TEST_CASE("a plan of one item that nobody confirms leaves a PX4 with one of the two") {
  Uploading desk(ClientOnLine::kPx4);
  desk.begin(inRam(kPlan, 1));
  desk.run(8000);
  CHECK((desk.ended == Status::NoAnswer));
  CHECK((desk.client.aboard() == Aboard::AsBefore));
}

TEST_CASE("an acceptance before all items were asked for, or with another checksum, is none") {
  Uploading early(ClientOnLine::kPx4), other(ClientOnLine::kPx4), without(ClientOnLine::kPx4);
  early.begin();
  early.ask(0, 2);
  early.tell(kAccepted);
  CHECK((early.ended == Status::AcceptedEarly));
  CHECK((early.client.aboard() == Aboard::NotKnown));
  CHECK(early.client.failedItem() == 1);
  other.begin();
  other.ask(0, 3);
  other.tell(kAccepted, 0x12345678);
  CHECK((other.ended == Status::OtherPlanAboard));
  CHECK((other.client.aboard() == Aboard::NotKnown));
  without.begin();
  without.ask(0, 3);
  without.tell(kAccepted);
  CHECK((without.ended == Status::Accepted));
}

TEST_CASE("an ArduPilot that asks as no ArduPilot does is not believed") {
  Uploading desk(ClientOnLine::kArduPilot);
  desk.begin();
  for (uint16_t item = 0; item < 4; ++item) {
    FrameParts parts = requestParts(item);
    parts.sequence = static_cast<uint8_t>(100 + item);
    desk.line.bring(packed(parts));  // MISSION_REQUEST_INT
    REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
  }
  desk.tell(kAccepted);
  CHECK((desk.ended == Status::Unconfirmed));
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("an upload that takes too long ends as such, and leaves what a silent autopilot leaves") {
  Uploading desk(ClientOnLine::kArduPilot);
  desk.client.setOperationTimeout(3);
  desk.begin();
  desk.ask(0, 2);
  desk.run(2000);
  CHECK(desk.client.isBusy());
  desk.run(1000);
  CHECK((desk.ended == Status::TookTooLong));
  CHECK((desk.client.aboard() == Aboard::Mixture));
  CHECK((desk.client.failedItem() == MissionClient::kNoItem));
  CHECK(desk.acks() == std::vector<uint8_t>{kCancelled});
  // The next one has its own time.
  desk.run(3000);
  desk.begin();
  desk.ask(0, 2);
  desk.run(2000);
  CHECK(desk.client.isBusy());
}

TEST_CASE("an upload that is refused here says so at once, and the running one goes on") {
  Uploading desk(ClientOnLine::kPx4);
  CHECK((desk.client.uploadAgain() == Status::SourceRefused));
  CHECK((desk.client.uploadWithoutReadback(inRam(kPlan), PlanType::All) == Status::BadPlanType));
  CHECK((desk.client.status() == Status::BadPlanType));
  CHECK((desk.client.uploadWithoutReadback(inRam(kPlan, 65536)) == Status::TooManyItems));
  CHECK((desk.client.uploadAgain() == Status::TooManyItems));
  desk.begin();
  CHECK((desk.client.uploadWithoutReadback(inRam(kPlan)) == Status::Busy));
  CHECK((desk.client.uploadAgain() == Status::Busy));
  CHECK((desk.client.status() == Status::Transferring));
}

TEST_CASE("65535 items are the most, home included") {
  const auto read = [](void*, uint16_t, MissionItem& item) {
    item = kPlan[0];
    return true;
  };
  for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    Uploading desk(autopilot);
    CHECK((desk.client.uploadWithoutReadback(fromFunction(read, 65535)) == Status::WaitingForAutopilot));
    desk.run(50);
    CHECK((desk.client.status() == (autopilot == ClientOnLine::kPx4 ? Status::Checking : Status::TooManyItems)));
    desk.client.cancel();
    desk.run(5);
    CHECK((desk.client.uploadWithoutReadback(fromFunction(read, 65534)) == Status::WaitingForAutopilot));
    desk.run(50);
    CHECK((desk.client.status() == Status::Checking));
  }
}

TEST_CASE("a plan with an item that cannot be right, or is not kept, is not begun") {
  const MissionItem bad[] = {kPlan[0], waypoint(91_deg, 0_deg, 20_m)};
  const MissionItem notKept[] = {kPlan[0], kPlan[1], anyCommandAt(kNavWaypoint, -35_deg, 149_deg, 20_m, 2.5f)};
  Uploading desk(ClientOnLine::kArduPilot);
  desk.sent.clear();
  desk.client.uploadWithoutReadback(inRam(bad));
  desk.run(50);
  CHECK((desk.ended == Status::BadLatitude));
  CHECK(desk.client.failedItem() == 1);
  CHECK((desk.client.differingField() == ItemField::None));
  desk.client.uploadWithoutReadback(inRam(notKept));
  desk.run(50);
  CHECK((desk.ended == Status::NotKept));
  CHECK(desk.client.failedItem() == 2);
  CHECK((desk.client.differingField() == ItemField::Param1));
  CHECK(desk.timesOf(ClientOnLine::kCount, 0).empty());
  desk.begin();
  CHECK((desk.client.failedItem() == MissionClient::kNoItem));
  CHECK((desk.client.differingField() == ItemField::None));
}

TEST_CASE("what was said of an operation is forgotten when the next one is refused at once") {
  const MissionItem notKept[] = {kPlan[0], anyCommandAt(kNavWaypoint, -35_deg, 149_deg, 20_m, 2.5f)};
  Uploading desk(ClientOnLine::kArduPilot);
  desk.client.uploadWithoutReadback(inRam(notKept));
  desk.run(50);
  REQUIRE(desk.client.failedItem() == 1);
  desk.client.uploadWithoutReadback(inRam(kPlan), PlanType::All);
  CHECK((desk.client.failedItem() == MissionClient::kNoItem));
  CHECK((desk.client.differingField() == ItemField::None));
  CHECK(desk.client.itemsTotal() == 0);
}

namespace {

// PX4 gives a takeoff the place of the next item that has one: the library looks for it in several steps.
bool readFarPlace(void* reads, uint16_t index, MissionItem& item) {
  ++*static_cast<int*>(reads);
  item = index == 0 ? takeoff(20_m) : index == 12 ? kPlan[0] : changeSpeed(5_mps);
  return true;
}

}  // namespace

TEST_CASE("a plan is checked item by item, one in an update(), and a place that is far away is found") {
  int reads = 0;
  Uploading desk(ClientOnLine::kPx4);
  desk.client.uploadWithoutReadback(fromFunction(readFarPlace, 13, &reads));
  for (int update = 0; desk.timesOf(ClientOnLine::kCount, 0).empty(); ++update) {
    const int before = reads;
    desk.run(1);
    CHECK(reads - before <= 3);  // the item, one where its place may be, and the item again
    REQUIRE(update < 100);
  }
  CHECK(reads >= 26);
  desk.hear(requestParts(0));
  REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 100));
  CHECK(valueAt<int32_t>(desk.sent.back(), 16) == kPlan[0].x);
  CHECK(valueAt<int32_t>(desk.sent.back(), 20) == kPlan[0].y);
}

TEST_CASE("an update() checks one item") {
  int reads = 0;
  Uploading desk(ClientOnLine::kArduPilot);
  const auto read = [](void* counted, uint16_t, MissionItem& item) {
    ++*static_cast<int*>(counted);
    item = kPlan[0];
    return true;
  };
  desk.client.uploadWithoutReadback(fromFunction(read, 200, &reads));
  desk.run(20);
  CHECK(reads > 15);
  CHECK(reads <= 20 * MAVMISSION_ITEMS_PER_UPDATE);
}

TEST_CASE("an autopilot that is another one while the plan is checked gets the plan as it wants it") {
  ClientOnLine desk(ClientOnLine::kPx4);
  const auto read = [](void*, uint16_t, MissionItem& item) {
    item = kPlan[0];
    return true;
  };
  desk.run(3000);
  desk.client.uploadWithoutReadback(fromFunction(read, 300));
  desk.run(100);
  REQUIRE((desk.client.status() == Status::Checking));
  for (int i = 0; i < 2; ++i) desk.hear(heartbeatParts(ClientOnLine::kArduPilot));
  desk.beats = false;
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 1000));
  CHECK(valueAt<uint16_t>(desk.sent.back(), 0) == 301);
}

TEST_CASE("a plan that is refused when an item is to be sent ends there, and the autopilot is told") {
  static bool isThere;
  isThere = true;
  const auto read = [](void*, uint16_t index, MissionItem& item) {
    item = kPlan[index];
    return isThere;
  };
  Uploading desk(ClientOnLine::kOther);
  desk.begin(fromFunction(read, 3));
  desk.ask(0, 1);
  desk.run(20);  // the next one is packed already
  isThere = false;
  desk.ask(1, 2);
  desk.run(20);
  CHECK((desk.ended == Status::SourceRefused));
  CHECK(desk.client.failedItem() == 2);
  CHECK((desk.client.aboard() == Aboard::NotKnown));
  CHECK(desk.acks() == std::vector<uint8_t>{kCancelled});
}

TEST_CASE("an armed autopilot is left alone unless the sketch allows it, and MAVLink 1 carries missions alone") {
  for (const bool isAllowed : {false, true}) {
    ClientOnLine desk(ClientOnLine::kPx4);
    desk.beats = false;
    for (int i = 0; i < 3; ++i) {
      desk.hear(heartbeatParts(ClientOnLine::kPx4, kSafetyArmed));
      desk.run(1000);
    }
    desk.client.allowWhileArmed(isAllowed);
    desk.client.uploadWithoutReadback(inRam(kPlan));
    CHECK(desk.runUntilSent(ClientOnLine::kCount, 100) == isAllowed);
    CHECK((desk.client.status() == (isAllowed ? Status::Transferring : Status::Armed)));
  }
  for (const PlanType type : {PlanType::Mission, PlanType::Fence}) {
    ClientOnLine desk(ClientOnLine::kPx4);
    desk.client.setMavlinkVersion(MavlinkVersion::Version1);
    desk.run(3000);
    desk.client.uploadWithoutReadback(type == PlanType::Fence ? inRam(kFence) : inRam(kPlan), type);
    CHECK(desk.runUntilSent(ClientOnLine::kCount, 100) == (type == PlanType::Mission));
    CHECK((desk.client.status() == (type == PlanType::Mission ? Status::Transferring : Status::NeedsMavlink2)));
  }
}

TEST_CASE("an autopilot that is lost while the plan is checked is waited for, and the check begins anew") {
  Uploading desk(ClientOnLine::kPx4);
  desk.line.room = 0;
  desk.run(2000);
  desk.client.uploadWithoutReadback(inRam(kPlan));
  desk.run(100);
  CHECK((desk.client.status() == Status::Checking));
  desk.beats = false;
  desk.run(6000);
  CHECK((desk.client.status() == Status::WaitingForAutopilot));
  desk.line.room = desk.line.kAlwaysRoom;
  desk.run(1000);
  CHECK((desk.client.status() == Status::WaitingForAutopilot));
  desk.beats = true;
  CHECK(desk.runUntilSent(ClientOnLine::kCount, 3000));
}

TEST_CASE("behind a reset a refusal of COUNT may answer what was before: it is believed in the end") {
  for (const uint32_t startMs : {0, 65000}) {
    Uploading desk(ClientOnLine::kArduPilot, startMs);
    desk.begin();
    desk.tell(kCancelled);
    CHECK(desk.client.isBusy() == (startMs == 0));
    desk.run(8000);
    CHECK((desk.ended == Status::CancelledByAutopilot));
    CHECK((desk.client.aboard() == (startMs == 0 ? Aboard::NotKnown : Aboard::AsBefore)));
  }
}

TEST_CASE("behind an upload that ended well, or with a refusal, nothing is waited for, and behind another one it is") {
  for (const uint8_t end : {kAccepted, kNoSpace, kCancelled}) {
    for (const bool isUnconfirmed : {false, true}) {
      Uploading desk(ClientOnLine::kArduPilot, 0);
      desk.begin();
      desk.ask(0, 4);
      if (isUnconfirmed) {
        desk.run(9100);
        REQUIRE((desk.ended == Status::Unconfirmed));
      } else {
        desk.tell(end);
        REQUIRE((desk.ended == fromMissionResult(end)));
      }
      desk.ended = Status::Idle;
      desk.client.uploadWithoutReadback(inRam(kPlan));
      CHECK(desk.runUntilSent(ClientOnLine::kCount, 1000) != isUnconfirmed);
      if (isUnconfirmed) REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 3000));
      desk.tell(kCancelled);  // ArduPilot gives up what was left open
      CHECK(desk.client.isBusy() == isUnconfirmed);
    }
  }
}

TEST_CASE("behind an upload that was given up the next one waits, and is not ended by ArduPilot's giving up") {
  Uploading desk(ClientOnLine::kArduPilot);
  desk.begin();
  desk.ask(0, 2);
  desk.run(9000);
  REQUIRE((desk.ended == Status::TimedOut));
  desk.client.uploadWithoutReadback(inRam(kPlan));
  CHECK_FALSE(desk.runUntilSent(ClientOnLine::kCount, 1000));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 3000));
  desk.tell(kCancelled);
  CHECK(desk.client.isBusy());
}

TEST_CASE("an item leaves in the update() in which it is asked for") {
  for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kOther}) {
    Uploading desk(autopilot);
    desk.begin();
    const uint16_t items = autopilot == ClientOnLine::kArduPilot ? 4 : 3;
    desk.ask(0, 1);
    for (uint16_t item = 1; item < items; ++item) {
      desk.run(20);
      desk.hear(requestParts(item));
      desk.run(1);
      CHECK(desk.sent.back().messageId == ClientOnLine::kItemInt);
    }
  }
}

TEST_CASE("PX4, busy with something older of ours, is told that it is over") {
  Uploading desk(ClientOnLine::kPx4);
  desk.begin();
  desk.hear(ackParts(kError));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 100));
  REQUIRE(desk.sent.size() >= 2);
  CHECK(desk.sent[desk.sent.size() - 2].messageId == ClientOnLine::kAck);
  CHECK(desk.acks() == std::vector<uint8_t>{kCancelled});
}
