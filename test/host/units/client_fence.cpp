// Short fences by a whole client: ArduPilot accepts one, and may wipe it behind the acceptance.
#include <doctest/doctest.h>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

const uint8_t kFence = static_cast<uint8_t>(PlanType::Fence);
const MissionItem kCircles[] = {
    fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m), fenceInsideCircle(-35.36_deg, 149.17_deg, 100_m),
    fenceInsideCircle(-35.37_deg, 149.16_deg, 100_m), fenceInsideCircle(-35.37_deg, 149.17_deg, 100_m)};

FrameParts countParts(uint16_t items, uint8_t type = kFence) {
  return FrameParts(44, {static_cast<uint8_t>(items), static_cast<uint8_t>(items >> 8), 1, 191, type}, 221);
}

// The fence of so many circles is asked for, sent and accepted.
void accept(ClientOnLine& desk, uint16_t items) {
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 3000));
  for (uint16_t item = 0; item < items; ++item) {
    desk.hear(requestParts(item, 1, 191, kFence));
    REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
  }
  desk.hear(ackParts(0, 1, 191, kFence));
  desk.run(5);
}

struct Fencing : ClientOnLine {
  explicit Fencing(uint16_t items, uint8_t autopilot = kArduPilot) : ClientOnLine(autopilot) {
    run(11000);  // what came before can be answered no more
    client.upload(inRam(kCircles, items), PlanType::Fence);
    accept(*this, items);
  }

  // As the autopilot gives them back.
  void tellItems(uint16_t items) {
    for (uint16_t seq = 0; seq < items; ++seq) {
      mavlink_mission_item_int_t message = mavlink_mission_item_int_t();
      const MissionItem& item = kCircles[seq];
      message.param1 = item.param1;
      message.param2 = item.param2;
      message.x = item.x;
      message.y = item.y;
      message.seq = seq;
      message.command = item.command;
      message.target_system = 1;
      message.target_component = 191;
      message.frame = static_cast<uint8_t>(item.frame);
      message.autocontinue = item.autocontinue;
      message.mission_type = kFence;
      const uint8_t* begin = reinterpret_cast<const uint8_t*>(&message);
      hear(FrameParts(73, Bytes(begin, begin + sizeof(message)), 38));
      run(5);
    }
  }
};

}  // namespace

TEST_CASE("a fence of up to three items is read back a second after its acceptance, and a longer one is not") {
  for (uint16_t items = 1; items <= 4; ++items) {
    Fencing desk(items);
    if (items == 4) {
      CHECK((desk.ended == Status::Accepted));
      continue;
    }
    CHECK((desk.client.aboard(PlanType::Fence) == Aboard::NotKnown));
    const uint32_t acceptedMs = desk.nowMs();
    desk.sent.clear();
    REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 2000));
    CHECK(desk.nowMs() - acceptedMs >= 990);
    CHECK(desk.sent.back().payload[2] == kFence);
    CHECK(desk.timesOf(ClientOnLine::kAck, 0).empty());
    desk.hear(countParts(items));
    desk.run(5);
    desk.tellItems(items);
    CHECK((desk.ended == Status::Accepted));
    CHECK((desk.client.aboard(PlanType::Fence) == Aboard::OurPlan));
  }
}

TEST_CASE("a short fence settles for a second, in its second upload too, whether anything is heard or not") {
  Fencing desk(2);
  desk.beats = false;
  desk.sent.clear();
  uint32_t acceptedMs = desk.nowMs() - 5;
  desk.run(1100);
  const std::vector<uint32_t> first = desk.timesOf(ClientOnLine::kRequestList, acceptedMs);
  REQUIRE(first.size() == 1);
  CHECK(first[0] >= 1000);
  CHECK(first[0] <= 1005);
  desk.hear(countParts(0));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 20));
  desk.beats = true;
  desk.run(1200);
  for (uint16_t item = 0; item < 2; ++item) {
    desk.hear(requestParts(item, 1, 191, kFence));
    REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
  }
  desk.sent.clear();
  desk.beats = false;
  desk.hear(ackParts(0, 1, 191, kFence));
  acceptedMs = desk.nowMs();
  desk.run(1100);
  const std::vector<uint32_t> second = desk.timesOf(ClientOnLine::kRequestList, acceptedMs);
  REQUIRE(second.size() == 1);
  CHECK(second[0] >= 1000);
  CHECK(second[0] <= 1005);
}

TEST_CASE("a fence that is no short one, and other plans, are read back at once where that is asked for") {
  for (const PlanType type : {PlanType::Fence, PlanType::Rally}) {
    const MissionItem rally[] = {rallyPoint(-35.36_deg, 149.16_deg, 20_m)};
    const uint16_t items = type == PlanType::Fence ? 4 : 1;
    ClientOnLine desk(ClientOnLine::kArduPilot);
    desk.run(3000);
    desk.client.upload(type == PlanType::Fence ? inRam(kCircles) : inRam(rally), type, Readback::Always);
    REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 3000));
    for (uint16_t item = 0; item < items; ++item) {
      desk.hear(requestParts(item, 1, 191, static_cast<uint8_t>(type)));
      REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
    }
    desk.hear(ackParts(0, 1, 191, static_cast<uint8_t>(type)));
    CHECK(desk.runUntilSent(ClientOnLine::kRequestList, 20));
  }
}

TEST_CASE(
    "while a short fence settles it is not known what is aboard, and a cancel() says nothing, the second time too") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(3000);
  desk.client.clear(PlanType::Fence);
  REQUIRE(desk.runUntilSent(45, 100));
  desk.hear(ackParts(0, 1, 191, kFence));
  desk.run(5);
  REQUIRE((desk.client.aboard(PlanType::Fence) == Aboard::Nothing));
  desk.client.upload(inRam(kCircles, 2), PlanType::Fence);
  accept(desk, 2);
  CHECK((desk.client.aboard(PlanType::Fence) == Aboard::NotKnown));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 2000));
  desk.hear(countParts(0));
  accept(desk, 2);
  CHECK((desk.client.aboard(PlanType::Fence) == Aboard::NotKnown));
  desk.run(300);
  desk.sent.clear();
  desk.client.cancel();
  desk.run(5);
  CHECK((desk.client.status() == Status::Cancelled));
  CHECK(desk.timesOf(ClientOnLine::kAck, 0).empty());
}

TEST_CASE("an empty fence and a short plan of another type are not doubted") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(11000);
  desk.client.upload(emptyPlan(), PlanType::Fence);
  accept(desk, 0);
  CHECK((desk.ended == Status::Accepted));
  desk.ended = Status::Idle;
  const MissionItem rally[] = {rallyPoint(-35.36_deg, 149.16_deg, 20_m)};
  desk.client.upload(inRam(rally), PlanType::Rally);
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 3000));
  desk.hear(requestParts(0, 1, 191, static_cast<uint8_t>(PlanType::Rally)));
  REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
  desk.hear(ackParts(0, 1, 191, static_cast<uint8_t>(PlanType::Rally)));
  desk.run(5);
  CHECK((desk.ended == Status::Accepted));
}

TEST_CASE("a short fence that was wiped is uploaded once more, and no third time") {
  Fencing desk(2);
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 2000));
  desk.sent.clear();
  desk.hear(countParts(0));
  accept(desk, 2);
  const uint32_t acceptedMs = desk.nowMs();
  CHECK(desk.client.isBusy());
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 2000));
  CHECK(desk.nowMs() - acceptedMs >= 990);
  desk.sent.clear();
  desk.hear(countParts(0));
  desk.run(100);
  CHECK((desk.ended == Status::Differs));
  CHECK((desk.client.differingField() == ItemField::Count));
  CHECK(desk.timesOf(ClientOnLine::kCount, 0).empty());
  // The next upload has its two tries again.
  desk.ended = Status::Idle;
  desk.client.uploadAgain();
  accept(desk, 2);
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 2000));
  desk.sent.clear();
  desk.hear(countParts(0));
  CHECK(desk.runUntilSent(ClientOnLine::kCount, 100));
}

TEST_CASE("a short fence that was wiped, and is refused then, is not what was aboard before") {
  Fencing desk(2);
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 2000));
  desk.hear(countParts(0));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 100));
  desk.hear(ackParts(4, 1, 191, kFence));  // no space
  desk.run(5);
  CHECK((desk.ended == Status::NoSpace));
  CHECK((desk.client.aboard(PlanType::Fence) == Aboard::NotKnown));
}

TEST_CASE(
    "a short fence that was wiped is not sent again to an autopilot that is armed by now, unless that is allowed") {
  for (bool isAllowed : {false, true}) {
    Fencing desk(2);
    desk.client.allowWhileArmed(isAllowed);
    REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 2000));
    desk.beats = false;
    desk.hear(heartbeatParts(ClientOnLine::kArduPilot, 128));
    desk.hear(countParts(0));
    CHECK(desk.runUntilSent(ClientOnLine::kCount, 100) == isAllowed);
    CHECK((desk.client.status() == (isAllowed ? Status::Transferring : Status::Armed)));
    CHECK((desk.client.aboard(PlanType::Fence) == Aboard::NotKnown));
  }
}

TEST_CASE("what is not the number of the fence's items does not begin its second upload") {
  Fencing desk(2);
  desk.hear(countParts(0));  // before it was asked for
  desk.run(100);
  CHECK(desk.client.isBusy());
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 2000));
  desk.sent.clear();
  desk.hear(countParts(0, 0));  // of a mission
  desk.hear(ackParts(0, 1, 191, kFence));
  desk.run(5);
  CHECK(desk.timesOf(ClientOnLine::kCount, 0).empty());
  desk.hear(countParts(2));
  desk.run(5);
  desk.hear(countParts(0));  // late
  desk.run(5);
  CHECK(desk.timesOf(ClientOnLine::kCount, 0).empty());
  desk.tellItems(2);
  CHECK((desk.ended == Status::Accepted));
}

TEST_CASE("where short fences are not wiped, a fence that is gone is another plan") {
  Fencing desk(2, ClientOnLine::kPx4);
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 2000));
  desk.sent.clear();
  desk.hear(countParts(0));
  desk.run(100);
  CHECK((desk.ended == Status::Differs));
  CHECK(desk.timesOf(ClientOnLine::kCount, 0).empty());
}

TEST_CASE("a short fence that is cancelled while it settles is cancelled without a word, and in its reading with one") {
  for (const bool reads : {false, true}) {
    Fencing desk(2);
    if (reads) REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 2000));
    desk.sent.clear();
    desk.client.cancel();
    desk.run(5);
    CHECK((desk.client.status() == Status::Cancelled));
    CHECK(desk.timesOf(ClientOnLine::kAck, 0).size() == (reads ? 1 : 0));
  }
}
