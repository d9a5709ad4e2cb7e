// clear() by a whole client.
#include <doctest/doctest.h>

#include "ClientOnLine.h"
#include "PlanFrames.h"

using namespace mavmission;

namespace {

const uint16_t kClearAll = 45;
const uint8_t kAccepted = 0, kDenied = 14, kCancelled = 15;
const uint8_t kSafetyArmed = 128;  // in HEARTBEAT.base_mode
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m)};

FrameParts ackOf(PlanType type, uint8_t result) { return ackParts(result, 1, 191, static_cast<uint8_t>(type)); }

PlanType typeOf(const SentFrame& frame) { return static_cast<PlanType>(frame.payload[2]); }

struct Clearing : ClientOnLine {
  explicit Clearing(PlanType type, uint8_t autopilot = kArduPilot) : ClientOnLine(autopilot) {
    run(11000);  // what came before can be answered no more
    sent.clear();
    client.clear(type);
    REQUIRE(runUntilSent(kClearAll, 10));
  }
};

// An autopilot that is armed, or speaks MAVLink 1, is there.
void meet(ClientOnLine& desk, uint8_t baseMode, uint8_t version = 2) {
  desk.beats = false;
  for (int i = 0; i < 3; ++i) {
    FrameParts beat = heartbeatParts(ClientOnLine::kArduPilot, baseMode);
    beat.version = version;
    desk.hear(beat);
    desk.run(1000);
  }
}

}  // namespace

TEST_CASE("a plan of each type is cleared by itself, and nothing of that type is aboard then") {
  for (const PlanType type : {PlanType::Mission, PlanType::Fence, PlanType::Rally}) {
    Clearing desk(type);
    CHECK((typeOf(desk.sent.back()) == type));
    desk.hear(ackOf(type, kAccepted));
    desk.run(5);
    CHECK((desk.ended == Status::Cleared));
    CHECK(desk.client.lastResult() == kAccepted);
    for (const PlanType other : {PlanType::Mission, PlanType::Fence, PlanType::Rally}) {
      CHECK((desk.client.aboard(other) == (other == type ? Aboard::Nothing : Aboard::NotKnown)));
    }
    CHECK(desk.timesOf(kClearAll, 0).size() == 1);
  }
}

TEST_CASE("all plans are cleared one behind the other, and the first refusal is the end") {
  Clearing desk(PlanType::All);
  CHECK((typeOf(desk.sent.back()) == PlanType::Mission));
  desk.hear(ackOf(PlanType::Mission, kAccepted));
  REQUIRE(desk.runUntilSent(kClearAll, 10));
  CHECK((typeOf(desk.sent.back()) == PlanType::Fence));
  desk.hear(ackOf(PlanType::Fence, kDenied));
  desk.run(5);
  CHECK((desk.ended == Status::Denied));
  CHECK(desk.client.lastResult() == kDenied);
  CHECK((desk.client.aboard(PlanType::Mission) == Aboard::Nothing));
  CHECK((desk.client.aboard(PlanType::Fence) == Aboard::NotKnown));
}

TEST_CASE("what is aboard is not known from the first CLEAR_ALL on, until it is accepted or refused at once") {
  enum { Refused, RefusedLate, Silent, Cancelled };
  for (const int end : {Refused, RefusedLate, Silent, Cancelled}) {
    Clearing desk(PlanType::Mission);
    desk.hear(ackOf(PlanType::Mission, kAccepted));
    desk.run(5);
    REQUIRE((desk.client.aboard() == Aboard::Nothing));
    desk.run(11000);
    desk.sent.clear();
    desk.client.clear();
    REQUIRE(desk.runUntilSent(kClearAll, 10));
    CHECK((desk.client.aboard() == Aboard::NotKnown));
    if (end == RefusedLate) REQUIRE(desk.runUntilSent(kClearAll, 2000));
    if (end == Cancelled) desk.client.cancel();
    if (end <= RefusedLate) desk.hear(ackOf(PlanType::Mission, kDenied));
    desk.run(8000);
    CHECK((desk.ended == (end <= RefusedLate ? Status::Denied : end == Silent ? Status::NoAnswer : Status::Cancelled)));
    CHECK((desk.client.aboard() == (end == Refused ? Aboard::Nothing : Aboard::NotKnown)));
    CHECK(desk.timesOf(kClearAll, 0).size() == (end == Silent ? 5 : end == RefusedLate ? 2 : 1));
  }
}

TEST_CASE("all plans cleared, the second one refused or never answered: of the third one nothing has changed") {
  Clearing desk(PlanType::All);
  desk.hear(ackOf(PlanType::Mission, kAccepted));
  REQUIRE(desk.runUntilSent(kClearAll, 10));
  desk.run(8000);
  CHECK((desk.ended == Status::NoAnswer));
  CHECK((desk.client.aboard(PlanType::Mission) == Aboard::Nothing));
  CHECK((desk.client.aboard(PlanType::Fence) == Aboard::NotKnown));
}

TEST_CASE(
    "behind another operation an acceptance is proven by the number of items, and CLEAR_ALL sent again if need be") {
  Clearing desk(PlanType::Mission);
  desk.hear(ackOf(PlanType::Mission, kAccepted));
  desk.run(3000);
  desk.client.clear();
  REQUIRE(desk.runUntilSent(kClearAll, 10));
  desk.hear(countParts(0));  // nobody has asked yet
  desk.hear(ackOf(PlanType::Mission, kAccepted));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 10));
  CHECK((desk.client.aboard() == Aboard::NotKnown));
  desk.hear(ackOf(PlanType::Mission, kDenied));  // of something before
  desk.hear(countParts(0, PlanType::Fence));
  desk.hear(countParts(5));
  REQUIRE(desk.runUntilSent(kClearAll, 10));
  CHECK(desk.sent[desk.sent.size() - 2].messageId == ClientOnLine::kAck);  // so that PX4 does not wait for us
  desk.hear(ackOf(PlanType::Mission, kAccepted));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 10));
  desk.hear(countParts(1));  // ArduPilot's home
  desk.run(5);
  CHECK((desk.ended == Status::Cleared));
  CHECK((desk.client.aboard() == Aboard::Nothing));
}

TEST_CASE("no CLEAR_ALL is sent to an autopilot that has been armed meanwhile") {
  Clearing desk(PlanType::All);
  desk.beats = false;
  FrameParts beat = heartbeatParts(ClientOnLine::kArduPilot, kSafetyArmed);
  desk.hear(beat);
  desk.hear(ackOf(PlanType::Mission, kAccepted));
  desk.run(100);
  CHECK((desk.ended == Status::Armed));
  CHECK(desk.timesOf(kClearAll, 0).size() == 1);
}

TEST_CASE("a clear on a stream that takes no more bytes ends with its time limit") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(11000);
  desk.client.setOperationTimeout(60);
  desk.line.room = 0;
  desk.line.takes = 0;
  desk.client.clear();
  desk.run(59000);
  CHECK(desk.client.isBusy());
  desk.run(2000);
  CHECK((desk.ended == Status::TookTooLong));
}

TEST_CASE("neither the answer to another type nor another message ends a clear") {
  Clearing desk(PlanType::Fence);
  desk.hear(ackOf(PlanType::Mission, kAccepted));
  desk.hear(ackOf(PlanType::Rally, kDenied));
  desk.hear(FrameParts(44, {0, 0, 1, 191, 1}, 221));  // MISSION_COUNT of no fence
  desk.run(5);
  CHECK(desk.client.isBusy());
  CHECK(desk.client.lastResult() == 255);
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("what comes before MISSION_CLEAR_ALL has left is no answer to it") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.client.clear();
  desk.run(500);
  desk.hear(ackOf(PlanType::Mission, kAccepted));  // the autopilot is not settled yet
  desk.run(5);
  CHECK((desk.client.status() == Status::WaitingForAutopilot));
  desk.run(11000);
  CHECK((desk.ended == Status::NoAnswer));
  desk.line.room = 0;
  desk.ended = Status::Idle;
  desk.run(2100);  // its repeats can be answered no more
  desk.client.clear();
  desk.run(20);
  desk.hear(ackOf(PlanType::Mission, kDenied));
  desk.run(5);
  CHECK((desk.client.status() == Status::Transferring));
}

TEST_CASE("the plans of an armed autopilot are cleared only where the sketch allows it") {
  for (const bool isAllowed : {false, true}) {
    ClientOnLine desk(ClientOnLine::kArduPilot);
    meet(desk, kSafetyArmed);
    desk.client.allowWhileArmed(isAllowed);
    desk.sent.clear();
    desk.client.clear();
    desk.run(2000);
    CHECK(desk.timesOf(kClearAll, 0).empty() != isAllowed);
    CHECK((desk.client.status() == (isAllowed ? Status::Transferring : Status::Armed)));
  }
}

TEST_CASE("MAVLink 1 carries missions alone, and that is said first") {
  for (const uint8_t baseMode : {uint8_t{0}, kSafetyArmed}) {
    for (const PlanType type : {PlanType::Mission, PlanType::Fence, PlanType::All}) {
      ClientOnLine desk(ClientOnLine::kArduPilot);
      meet(desk, baseMode, 1);
      desk.sent.clear();
      desk.client.clear(type);
      desk.run(2000);
      const bool isMission = type == PlanType::Mission;
      CHECK(desk.timesOf(kClearAll, 0).empty() != (isMission && baseMode == 0));
      const Status expected = !isMission ? Status::NeedsMavlink2 : baseMode != 0 ? Status::Armed : Status::Transferring;
      CHECK((desk.client.status() == expected));
    }
  }
}

TEST_CASE("a fence's clear stays one when the autopilot's heartbeats turn to MAVLink 1") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(2500);
  desk.client.clear(PlanType::Fence);
  desk.run(600);
  desk.beats = false;
  desk.sent.clear();
  for (int beat = 0; beat < 6; ++beat) {
    FrameParts parts = heartbeatParts(ClientOnLine::kArduPilot);
    parts.version = 1;
    desk.hear(parts);
    desk.run(1000);
  }
  CHECK(desk.timesOf(kClearAll, 0).size() > 1);
  for (const SentFrame& frame : desk.sent) {
    if (frame.messageId != kClearAll) continue;
    CHECK(frame.payload[2] == 1);
    CHECK(frame.frame[0] == 0xFD);
  }
}

TEST_CASE("behind a transfer that was left open a clear waits for the answers to that") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(11000);
  desk.client.uploadWithoutReadback(inRam(kPlan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 100));
  desk.hear(requestParts(0));
  REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
  const uint32_t cancelledMs = desk.nowMs();
  desk.client.cancel();
  desk.client.clear();
  REQUIRE(desk.runUntilSent(kClearAll, 4000));
  CHECK(desk.nowMs() - cancelledMs > 1500);
  desk.hear(ackOf(PlanType::Mission, kCancelled));  // ArduPilot gives the upload up
  desk.run(5);
  CHECK(desk.client.isBusy());
  // When nothing is open it is the answer.
  desk.run(9000);
  desk.hear(ackOf(PlanType::Mission, kCancelled));
  desk.run(5);
  CHECK_FALSE(desk.client.isBusy());
}

TEST_CASE("behind a reset a clear waits for answers to what was before, and is then repeated as any other") {
  ClientOnLine desk(ClientOnLine::kArduPilot, 0);
  desk.client.setTargetIds(1, 1);
  desk.run(10);
  desk.client.clear();
  desk.run(8000);
  CHECK(desk.timesOf(kClearAll, 0) == std::vector<uint32_t>{1500, 3000, 4500, 6000, 7500});
  desk.hear(ackOf(PlanType::Mission, kDenied));
  desk.run(5);
  CHECK((desk.ended == Status::Denied));
}

TEST_CASE("a clear leaves in the update() that follows, and is a message of its target and type alone") {
  Clearing desk(PlanType::Fence);
  desk.hear(ackOf(PlanType::Fence, kAccepted));
  desk.run(1100);
  desk.sent.clear();
  desk.client.clear(PlanType::Rally);
  desk.run(1);
  REQUIRE(desk.timesOf(kClearAll, 0).size() == 1);
  CHECK(desk.sent.back().payload[0] == 1);
  CHECK(desk.sent.back().payload[1] == 1);
  CHECK(desk.sent.back().payload[2] == static_cast<uint8_t>(PlanType::Rally));
}

TEST_CASE("behind a reading that has ended a clear waits until a copy of its last message has come") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(11000);
  desk.client.verify(inRam(kPlan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 10));
  desk.hear(FrameParts(44, {5, 0, 1, 191, 0}, 221));
  desk.run(5);
  REQUIRE((desk.ended == Status::Differs));
  desk.client.clear();
  CHECK_FALSE(desk.runUntilSent(kClearAll, 390));
  CHECK(desk.runUntilSent(kClearAll, 100));
}

TEST_CASE("what follows a clear that was repeated waits for the other answer, and what follows another one does not") {
  for (const bool repeats : {false, true}) {
    Clearing desk(PlanType::Mission);
    if (repeats) REQUIRE(desk.runUntilSent(kClearAll, 1600));
    desk.hear(ackOf(PlanType::Mission, kAccepted));
    desk.run(5);
    REQUIRE((desk.ended == Status::Cleared));
    desk.client.clear();
    CHECK(desk.runUntilSent(kClearAll, 1000) != repeats);
  }
}

TEST_CASE("a clear that is cancelled is cancelled without a word, and the next one waits for its answer") {
  Clearing desk(PlanType::Mission);
  desk.sent.clear();
  desk.client.cancel();
  CHECK((desk.client.status() == Status::Cancelled));
  desk.client.clear();
  CHECK((desk.client.clear() == Status::Busy));
  desk.run(1500);
  CHECK(desk.timesOf(ClientOnLine::kAck, 0).empty());
  CHECK(desk.timesOf(kClearAll, 0).empty());
  CHECK(desk.runUntilSent(kClearAll, 1500));
}
