// What few uploads need, by a whole client: a part of a plan, and items as MISSION_ITEM.
#include <doctest/doctest.h>

#include "ClientOnLine.h"

using namespace mavmission;

namespace {

const uint16_t kPartialList = 38, kItem = 39, kClearAll = 45;
const uint8_t kAccepted = 0, kUnsupported = 3, kNoSpace = 4;
const MissionItem kPlan[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
                             changeSpeed(MetresPerSecond(5)), returnToLaunch()};

uint16_t wordAt(const SentFrame& frame, size_t at) {
  return static_cast<uint16_t>(frame.payload[at] | frame.payload[at + 1] << 8);
}

float floatAt(const SentFrame& frame, size_t at) {
  float value;
  memcpy(&value, &frame.payload[at], sizeof(value));
  return value;
}

}  // namespace

TEST_CASE("a part of a plan is announced by its first and its last item, and these items go out") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(11000);
  CHECK((desk.client.uploadPartial(inRam(kPlan), 1, 2) == Status::WaitingForAutopilot));
  CHECK((desk.client.uploadPartial(inRam(kPlan), 1, 2) == Status::Busy));
  REQUIRE(desk.runUntilSent(kPartialList, 100));
  CHECK(wordAt(desk.sent.back(), 0) == 2);  // behind home
  CHECK(wordAt(desk.sent.back(), 2) == 3);
  for (const uint16_t item : {2, 3}) {
    desk.hear(requestParts(item));
    REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
    CHECK(wordAt(desk.sent.back(), 28) == item);
  }
  desk.hear(ackParts(kAccepted));
  desk.run(5);
  CHECK((desk.ended == Status::Accepted));
  CHECK(desk.timesOf(ClientOnLine::kCount, 0).empty());
  // The same plan again goes as a whole only where it is given as a whole.
  desk.client.upload(inRam(kPlan));
  CHECK(desk.runUntilSent(ClientOnLine::kCount, 3000));
}

TEST_CASE("a part that is not within its plan is refused, and there is no plan for uploadAgain() then") {
  const struct {
    uint16_t first, count;
    bool isGood;
  } kParts[] = {{0, 0, false}, {4, 1, false}, {3, 2, false}, {0, 5, false}, {3, 1, true}, {0, 4, true}};
  for (const auto& part : kParts) {
    ClientOnLine desk(ClientOnLine::kArduPilot);
    desk.run(11000);
    const Status status = desk.client.uploadPartial(inRam(kPlan), part.first, part.count);
    CHECK((status == (part.isGood ? Status::WaitingForAutopilot : Status::BadRange)));
    CHECK(desk.runUntilSent(kPartialList, 100) == part.isGood);
    desk.client.cancel();
    const Status again = desk.client.uploadAgain();
    CHECK((again == (part.isGood ? Status::WaitingForAutopilot : Status::SourceRefused)));
  }
}

TEST_CASE("uploadAgain() uploads the whole plan, behind a part, a download of another type and a clear, too") {
  MissionItem fence[1];
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(11000);
  desk.client.uploadPartial(inRam(kPlan), 1, 2);
  REQUIRE(desk.runUntilSent(kPartialList, 100));
  desk.client.cancel();
  desk.client.download(toRam(fence), PlanType::Fence);
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  desk.client.cancel();
  desk.client.clear(PlanType::All);
  REQUIRE(desk.runUntilSent(kClearAll, 3000));
  desk.client.cancel();
  desk.sent.clear();
  desk.client.uploadAgain();
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 3000));
  CHECK(wordAt(desk.sent.back(), 0) == 5);  // behind home
  CHECK(desk.sent.back().payload[4] == static_cast<uint8_t>(PlanType::Mission));
  CHECK(desk.timesOf(kPartialList, 0).empty());
}

TEST_CASE("PX4 takes whole plans only") {
  ClientOnLine desk(ClientOnLine::kPx4);
  desk.run(11000);
  desk.client.uploadPartial(inRam(kPlan), 1, 2);
  desk.run(100);
  CHECK((desk.ended == Status::WholePlansOnly));
  CHECK(desk.timesOf(kPartialList, 0).empty());
}

TEST_CASE("an autopilot that may be old, and refuses the first item as unsupported, gets all items as floats") {
  ClientOnLine desk(ClientOnLine::kOther);
  desk.run(11000);
  desk.client.useMissionItemFallback();
  desk.client.uploadWithoutReadback(inRam(kPlan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 100));
  desk.hear(requestParts(0));
  REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
  desk.hear(ackParts(kUnsupported));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 100));
  desk.hear(requestParts(0));
  REQUIRE(desk.runUntilSent(kItem, 50));
  desk.hear(requestParts(1));
  REQUIRE(desk.runUntilSent(kItem, 50));
  CHECK(wordAt(desk.sent.back(), 28) == 1);
  CHECK(floatAt(desk.sent.back(), 16) == doctest::Approx(-35.3632621f));
  CHECK(floatAt(desk.sent.back(), 20) == doctest::Approx(149.1652374f));
  CHECK(floatAt(desk.sent.back(), 24) == 20);
  // Refused as floats too: that is the end.
  desk.hear(ackParts(kUnsupported));
  desk.run(5);
  CHECK((desk.ended == Status::Unsupported));
  // And from now on floats are what it gets at once.
  desk.client.uploadAgain();
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 3000));
  desk.hear(requestParts(0));
  CHECK(desk.runUntilSent(kItem, 50));
}

TEST_CASE("no other refusal, no later one, none of an ArduPilot or a PX4, and none unasked begins with floats") {
  const struct {
    uint8_t autopilot, result;
    uint16_t items;
    bool isAsked;
  } kRefusals[] = {{ClientOnLine::kOther, kNoSpace, 1, true},         {ClientOnLine::kOther, kUnsupported, 1, false},
                   {ClientOnLine::kOther, kUnsupported, 2, true},     {ClientOnLine::kOther, kUnsupported, 0, true},
                   {ClientOnLine::kArduPilot, kUnsupported, 1, true}, {ClientOnLine::kPx4, kUnsupported, 1, true}};
  for (const auto& refusal : kRefusals) {
    ClientOnLine desk(refusal.autopilot);
    desk.run(11000);
    if (refusal.isAsked) desk.client.useMissionItemFallback();
    desk.client.uploadWithoutReadback(inRam(kPlan));
    REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 100));
    for (uint16_t item = 0; item < refusal.items; ++item) {
      desk.hear(requestParts(item));
      REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
    }
    desk.hear(ackParts(refusal.result));
    desk.run(50);
    CHECK((desk.ended == (refusal.result == kNoSpace ? Status::NoSpace : Status::Unsupported)));
    CHECK(desk.timesOf(ClientOnLine::kCount, 0).size() == 1);
  }
}

TEST_CASE(
    "where floats are wanted from the beginning there is no MISSION_ITEM_INT, and parameters stay what they are") {
  const MissionItem plan[] = {jump(0, 3)};
  for (const uint8_t autopilot : {ClientOnLine::kOther, ClientOnLine::kPx4}) {
    ClientOnLine desk(autopilot);
    desk.run(11000);
    desk.client.useMissionItemFallback(true);
    desk.client.uploadWithoutReadback(inRam(plan));
    REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 100));
    desk.hear(requestParts(0));
    REQUIRE(desk.runUntilSent(kItem, 50));
    CHECK(floatAt(desk.sent.back(), 4) == 3);
    CHECK(desk.timesOf(ClientOnLine::kItemInt, 0).empty());
    // PX4's checksum is that of its integers: a wrong one proves nothing here.
    desk.hear(ackParts(kAccepted, 1, 191, 0, 0x12345678));
    desk.run(5);
    CHECK((desk.ended == Status::Accepted));
  }
}

TEST_CASE("a plan that is refused when it begins anew as floats may have changed what was aboard before") {
  ClientOnLine desk(ClientOnLine::kOther);
  desk.run(11000);
  desk.client.useMissionItemFallback();
  desk.client.uploadWithoutReadback(inRam(kPlan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 100));
  desk.hear(requestParts(0));
  REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
  desk.hear(ackParts(kUnsupported));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 100));
  desk.hear(ackParts(kNoSpace));
  desk.run(5);
  CHECK((desk.ended == Status::NoSpace));
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("as floats, coordinates are degrees, and parameters the numbers that they are") {
  const MissionItem plan[] = {anyCommand(kDoDigicamControl, 0, 0, 0, 0, 7, -3), waypoint(45_deg, 180_deg, 20_m)};
  ClientOnLine desk(ClientOnLine::kOther);
  desk.run(11000);
  desk.client.useMissionItemFallback(true);
  desk.client.uploadWithoutReadback(inRam(plan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 100));
  desk.hear(requestParts(0));
  REQUIRE(desk.runUntilSent(kItem, 50));
  CHECK(floatAt(desk.sent.back(), 16) == 7);
  CHECK(floatAt(desk.sent.back(), 20) == -3);
  desk.hear(requestParts(1));
  REQUIRE(desk.runUntilSent(kItem, 50));
  CHECK(floatAt(desk.sent.back(), 16) == 45);
  CHECK(floatAt(desk.sent.back(), 20) == 180);
}
