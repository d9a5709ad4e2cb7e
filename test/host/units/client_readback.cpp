// What follows the end of an upload by a whole client: when the plan is read back, and what that proves.
#include <doctest/doctest.h>

#include "ClientOnLine.h"
#include "PlanFrames.h"
#include "Px4Checksum.h"

using namespace mavmission;

namespace {

constexpr uint8_t kAccepted = 0, kError = 1, kNoSpace = 4, kDenied = 14, kCancelled = 15;
constexpr uint16_t kClearAll = 45;
const MissionItem kPlan[] = {anyCommandAt(kNavWaypoint, -35.3632621_deg, 149.1652374_deg, 20_m), returnToLaunch()};

struct Proving : ClientOnLine {
  const uint16_t items;  // on the wire
  PlanType type = PlanType::Mission;

  explicit Proving(uint8_t autopilot, uint32_t startMs = 65000)
      : ClientOnLine(autopilot, startMs), items(autopilot == kArduPilot ? 3 : 2) {
    run(3000);
  }
  void begin(Readback proof = Readback::InDoubt) {
    sent.clear();
    ended = Status::Idle;
    client.upload(inRam(kPlan), proof);
    REQUIRE(runUntilSent(kCount, 4000));
  }
  void ask(uint16_t to) {
    for (uint16_t item = 0; item < to; ++item) {
      hear(requestParts(item));
      REQUIRE(runUntilSent(kItemInt, 50));
    }
  }
  void tell(const FrameParts& parts) {
    hear(parts);
    run(5);
  }
  MissionItem itemAt(uint16_t seq) const {
    if (items == 3 && seq == 0) return homeItem();
    return kPlan[items == 3 ? seq - 1 : seq];
  }
  void tellItems() {
    for (uint16_t seq = 0; seq < items; ++seq) tell(itemParts(seq, itemAt(seq)));
  }
  // A frame is lost, or broken, on the line.
  void lose() {
    Bytes frame = packed(heartbeatParts(kArduPilot));
    frame[12] = static_cast<uint8_t>(frame[12] ^ 1);
    line.bring(frame);
    run(60);
  }
  std::vector<uint8_t> acks() const {
    std::vector<uint8_t> results;
    for (const SentFrame& frame : sent) {
      if (frame.messageId == kAck) results.push_back(frame.payload[2]);
    }
    return results;
  }
  bool isRead() const { return !timesOf(kRequestList, 0).empty(); }
  // Whether the next operation waits for late answers.
  bool leavesDoubt() {
    client.clear();
    return !runUntilSent(kClearAll, 1000);
  }
};

}  // namespace

TEST_CASE("with Readback::Always an accepted plan is read back, and only then is it aboard and done") {
  for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    Proving desk(autopilot);
    desk.begin(Readback::Always);
    desk.ask(desk.items);
    CHECK(desk.client.itemsDone() == 1);
    desk.tell(ackParts(kAccepted));
    CHECK(desk.client.isBusy());
    REQUIRE(desk.isRead());
    CHECK((desk.client.aboard() == Aboard::NotKnown));
    desk.tell(countParts(desk.items));
    for (uint16_t seq = 0; seq < desk.items; ++seq) {
      CHECK(desk.client.itemsDone() == 1);
      CHECK(desk.client.isBusy());
      desk.tell(itemParts(seq, desk.itemAt(seq)));
    }
    CHECK((desk.ended == Status::Accepted));
    CHECK((desk.client.aboard() == Aboard::OurPlan));
    CHECK(desk.client.itemsDone() == 2);
    CHECK(desk.client.lastResult() == kAccepted);
    CHECK(desk.acks() == std::vector<uint8_t>{kAccepted});
    CHECK_FALSE(desk.leavesDoubt());
  }
}

TEST_CASE("where the acceptance proves the plan nothing is read back") {
  for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    for (const uint32_t startMs : {0, 65000}) {
      Proving desk(autopilot, startMs);
      desk.begin();
      desk.ask(desk.items);
      desk.tell(ackParts(kAccepted));
      CHECK((desk.ended == Status::Accepted));
      CHECK_FALSE(desk.isRead());
      CHECK_FALSE(desk.leavesDoubt());
    }
  }
}

TEST_CASE("on a lossy link, the repeats in a read-back do not wait for what the longer items of before took") {
  Proving desk(ClientOnLine::kArduPilot);
  desk.begin(Readback::Always);
  desk.ask(3);
  desk.line.room = 60;  // the stream is busy with the last item
  desk.run(40);
  desk.line.room = desk.line.kAlwaysRoom;
  desk.lose();
  desk.hear(ackParts(kAccepted));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 50));
  const uint32_t firstMs = desk.nowMs();
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 1000));
  CHECK(desk.nowMs() - firstMs <= 60);
}

TEST_CASE(
    "an empty plan that is accepted behind a reset, or behind another operation, is proven by how many items are "
    "aboard") {
  for (const uint32_t startMs : {0, 65000}) {
    for (const bool isAboard : {false, true}) {
      Proving desk(ClientOnLine::kPx4, startMs);
      if (startMs != 0) {
        desk.client.clear();
        desk.run(5);
        desk.client.cancel();
      }
      desk.client.upload(emptyPlan());
      REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 3000));
      desk.tell(ackParts(kAccepted));
      REQUIRE(desk.isRead());
      desk.tell(countParts(isAboard ? 2 : 0));
      CHECK((desk.ended == (isAboard ? Status::Differs : Status::Accepted)));
      CHECK((desk.client.aboard() == (isAboard ? Aboard::NotKnown : Aboard::OurPlan)));
    }
  }
}

TEST_CASE("an upload that nobody confirms is read back, and what follows waits for late answers") {
  Proving desk(ClientOnLine::kArduPilot);
  desk.begin();
  desk.ask(3);
  desk.sent.clear();
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 9100));
  desk.tell(countParts(3));
  desk.tellItems();
  CHECK((desk.ended == Status::Accepted));
  CHECK((desk.client.aboard() == Aboard::OurPlan));
  // The next one waits, and nothing that comes behind its COUNT is from before.
  desk.client.upload(inRam(kPlan));
  CHECK_FALSE(desk.runUntilSent(ClientOnLine::kCount, 1000));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 2000));
  desk.tell(ackParts(kCancelled));
  CHECK((desk.ended == Status::CancelledByAutopilot));
}

TEST_CASE("while a plan is read back it is not known what is aboard, also where ours was") {
  Proving desk(ClientOnLine::kArduPilot);
  desk.begin();
  desk.ask(3);
  desk.tell(ackParts(kAccepted));
  REQUIRE((desk.client.aboard() == Aboard::OurPlan));
  desk.begin(Readback::Always);
  CHECK((desk.client.aboard() == Aboard::NotKnown));
  desk.ask(3);
  desk.tell(ackParts(kAccepted));
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("in a read-back a height, and what it counts from, must be those of the plan") {
  for (const bool isReference : {true, false}) {
    for (const uint8_t autopilot : {ClientOnLine::kPx4, ClientOnLine::kOther}) {
      Proving desk(autopilot);
      desk.begin(Readback::Always);
      desk.ask(2);
      desk.tell(ackParts(kAccepted));
      desk.tell(countParts(2));
      MissionItem item = kPlan[0];
      if (isReference) item.frame = CoordinateFrame::Global;
      if (!isReference) item.z = 21;
      desk.tell(itemParts(0, item));
      CHECK((desk.ended == Status::Differs));
      CHECK((desk.client.differingField() == (isReference ? ItemField::Reference : ItemField::Height)));
    }
  }
}

TEST_CASE("on a lossy link, an acceptance is checked, unless PX4 has named the checksum with it") {
  for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    Proving desk(autopilot);
    desk.lose();
    desk.begin();
    desk.ask(desk.items);
    desk.tell(ackParts(kAccepted));
    CHECK(desk.isRead());
    CHECK((desk.ended == Status::Idle));
    desk.tell(countParts(desk.items));
    desk.tellItems();
    CHECK((desk.ended == Status::Accepted));
    desk.run(11000);
    desk.client.cancel();
    // When nothing has been lost for some time it is enough.
    desk.begin();
    desk.ask(desk.items);
    desk.tell(ackParts(kAccepted));
    CHECK((desk.ended == Status::Accepted));
    CHECK_FALSE(desk.isRead());
  }
  Proving named(ClientOnLine::kPx4);
  named.lose();
  named.begin();
  named.ask(named.items);
  named.tell(ackParts(kAccepted, 1, 191, 0, px4Checksum(kPlan, 2)));
  CHECK((named.ended == Status::Accepted));
  CHECK_FALSE(named.isRead());
}

TEST_CASE("behind a reset PX4's acceptance of an item that was repeated is checked") {
  for (const uint32_t startMs : {0, 65000}) {
    Proving desk(ClientOnLine::kPx4, startMs);
    desk.begin();
    desk.ask(2);
    REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 2000));
    desk.tell(ackParts(kAccepted));
    CHECK(desk.isRead() == (startMs == 0));
    CHECK((desk.ended == (startMs == 0 ? Status::Idle : Status::Accepted)));
  }
}

TEST_CASE("an error behind the last item may be none, which the plan that is aboard shows") {
  Proving ours(ClientOnLine::kArduPilot), other(ClientOnLine::kArduPilot), px4(ClientOnLine::kPx4);
  ours.begin();
  ours.ask(3);
  ours.tell(ackParts(kError));
  REQUIRE(ours.isRead());
  ours.tell(countParts(3));
  ours.tellItems();
  CHECK((ours.ended == Status::Accepted));
  CHECK(ours.leavesDoubt());

  other.begin();
  other.ask(3);
  other.tell(ackParts(kError));
  other.tell(countParts(2));
  CHECK((other.ended == Status::Error));
  CHECK(other.client.failedItem() == 1);  // the last one was refused
  CHECK((other.client.aboard() == Aboard::Mixture));

  px4.begin();
  px4.ask(2);
  px4.tell(ackParts(kError));  // to a COUNT that came again, perhaps
  CHECK(px4.client.isBusy());
  CHECK_FALSE(px4.isRead());
  REQUIRE(px4.runUntilSent(ClientOnLine::kItemInt, 2000));
  px4.tell(ackParts(kAccepted));
  REQUIRE(px4.isRead());
  px4.tell(countParts(1));
  CHECK((px4.ended == Status::Differs));
}

TEST_CASE("an error before the last item, and any other refusal, is what it is") {
  Proving early(ClientOnLine::kArduPilot), late(ClientOnLine::kArduPilot);
  early.begin(Readback::Always);
  early.ask(2);
  early.tell(ackParts(kError));
  CHECK((early.ended == Status::Error));
  late.begin(Readback::Always);
  late.ask(3);
  late.tell(ackParts(kNoSpace));
  CHECK((late.ended == Status::NoSpace));
  CHECK_FALSE(early.isRead());
  CHECK_FALSE(late.isRead());
}

TEST_CASE("an upload without a read-back stays unconfirmed, whatever else the sketch has chosen") {
  for (const bool retries : {false, true}) {
    Proving desk(ClientOnLine::kArduPilot);
    if (retries) {
      desk.client.retryWhenBusy(60);
    } else {
      desk.client.useMissionItemFallback();
    }
    desk.client.upload(inRam(kPlan), Readback::Always);  // this upload's proof is forgotten
    desk.client.cancel();
    desk.run(3000);
    desk.ended = Status::Idle;
    desk.sent.clear();
    desk.client.uploadWithoutReadback(inRam(kPlan));
    REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 3000));
    desk.ask(3);
    desk.run(9100);
    CHECK((desk.ended == Status::Unconfirmed));
    CHECK_FALSE(desk.isRead());
  }
}

TEST_CASE(
    "another plan in the read-back: a mixture only where nothing was accepted, and only of an ArduPilot's mission") {
  const struct {
    uint8_t autopilot;
    bool isAccepted;
    Aboard aboard;
  } kCases[] = {{ClientOnLine::kArduPilot, true, Aboard::NotKnown},
                {ClientOnLine::kArduPilot, false, Aboard::Mixture},
                {ClientOnLine::kPx4, true, Aboard::NotKnown},
                {ClientOnLine::kPx4, false, Aboard::NotKnown},
                {ClientOnLine::kOther, false, Aboard::NotKnown}};
  for (const auto& one : kCases) {
    Proving desk(one.autopilot);
    desk.begin(Readback::Always);
    desk.ask(desk.items);
    if (one.isAccepted) desk.hear(ackParts(kAccepted));
    REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 9100));
    desk.tell(countParts(desk.items));
    const uint16_t last = static_cast<uint16_t>(desk.items - 1);
    for (uint16_t seq = 0; seq < last; ++seq) desk.tell(itemParts(seq, desk.itemAt(seq)));
    MissionItem item = desk.itemAt(last);
    item.command = kNavLand;
    desk.tell(itemParts(last, item));
    CHECK((desk.ended == Status::Differs));
    CHECK(desk.client.failedItem() == 1);
    CHECK((desk.client.differingField() == ItemField::Command));
    CHECK((desk.client.aboard() == one.aboard));
    CHECK(desk.client.itemsDone() == 1);
    desk.run(5);
    CHECK(desk.acks() == std::vector<uint8_t>{kCancelled});
  }
}

TEST_CASE("rally points that are others in the read-back are no mixture") {
  const MissionItem rally[] = {rallyPoint(-35.36_deg, 149.16_deg, 20_m)};
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(3000);
  desk.client.upload(inRam(rally), PlanType::Rally);
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 3000));
  desk.hear(requestParts(0, 1, 191, 2));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 10000));
  desk.hear(countParts(0, PlanType::Rally));
  desk.run(5);
  CHECK((desk.ended == Status::Differs));
  CHECK((desk.client.aboard(PlanType::Rally) == Aboard::NotKnown));
}

TEST_CASE("an autopilot that does not let itself be read back leaves the upload unconfirmed") {
  Proving silent(ClientOnLine::kArduPilot), denied(ClientOnLine::kArduPilot), late(ClientOnLine::kArduPilot);
  silent.begin(Readback::Always);
  silent.ask(3);
  silent.tell(ackParts(kAccepted));
  silent.run(8000);
  CHECK(silent.timesOf(ClientOnLine::kRequestList, 0).size() == 5);
  CHECK((silent.ended == Status::Unconfirmed));
  CHECK((silent.client.aboard() == Aboard::NotKnown));
  CHECK(silent.client.lastResult() == kAccepted);
  // It may still hold the upload open, and is asked again.
  denied.begin(Readback::Always);
  denied.ask(3);
  denied.tell(ackParts(kAccepted));
  for (const uint8_t result : {kDenied, kError, kCancelled}) denied.tell(ackParts(result));
  CHECK(denied.client.isBusy());
  REQUIRE(denied.runUntilSent(ClientOnLine::kRequestList, 2000));
  denied.tell(countParts(3));
  denied.tellItems();
  CHECK((denied.ended == Status::Accepted));
  // While items are read a denial may be due to a copy of our COUNT; the fifth is the end.
  late.begin(Readback::Always);
  late.ask(3);
  late.tell(ackParts(kAccepted));
  for (int readings = 0; readings < 5; ++readings) {
    if (readings != 0) REQUIRE(late.runUntilSent(ClientOnLine::kRequestList, 410));
    late.hear(countParts(3));
    REQUIRE(late.runUntilSent(ClientOnLine::kRequestInt, 410));
    CHECK(late.client.isBusy());
    late.tell(ackParts(kDenied));
  }
  CHECK((late.ended == Status::Unconfirmed));
  CHECK(late.client.lastResult() == kDenied);
  CHECK((late.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("an error while items are compared begins the reading anew, and each request then waits for copies") {
  for (const bool isProof : {true, false}) {
    Proving desk(ClientOnLine::kPx4);
    if (isProof) {
      desk.begin(Readback::Always);
      desk.ask(2);
      desk.tell(ackParts(kAccepted));
    } else {
      desk.client.verify(inRam(kPlan));
      desk.run(5);
    }
    desk.tell(countParts(2));
    desk.tell(itemParts(0, kPlan[0]));
    desk.hear(ackParts(kError));
    CHECK_FALSE(desk.runUntilSent(ClientOnLine::kRequestList, 390));
    REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 20));
    desk.hear(countParts(2));
    for (uint16_t item = 0; item < 2; ++item) {
      CHECK_FALSE(desk.runUntilSent(ClientOnLine::kRequestInt, 390));
      REQUIRE(desk.runUntilSent(ClientOnLine::kRequestInt, 20));
      desk.hear(itemParts(item, kPlan[item]));
    }
    desk.run(410);
    CHECK((desk.ended == (isProof ? Status::Accepted : Status::Verified)));
  }
}

TEST_CASE("PX4's checksum of its plan proves an upload in doubt without its items, and the reading is closed") {
  Proving desk(ClientOnLine::kPx4);
  desk.begin();
  desk.ask(2);
  desk.run(9100);
  REQUIRE(desk.isRead());
  desk.tell(countParts(2, PlanType::Mission, px4Checksum(kPlan, 2)));
  CHECK((desk.ended == Status::Accepted));
  CHECK((desk.client.aboard() == Aboard::OurPlan));
  CHECK(desk.timesOf(ClientOnLine::kRequestInt, 0).empty());
  CHECK(desk.acks() == std::vector<uint8_t>{kAccepted});
}

TEST_CASE("items that come as floats prove nothing") {
  Proving desk(ClientOnLine::kPx4);
  desk.client.verify(inRam(kPlan));  // it takes the late answers
  desk.run(5);
  desk.client.cancel();
  desk.run(3000);
  desk.begin(Readback::Always);
  desk.ask(2);
  desk.tell(ackParts(kAccepted));
  desk.tell(countParts(2));
  desk.tell(floatItemParts(0, kPlan[0], -35.3632621f, 149.1652374f));
  desk.tell(itemParts(0, kPlan[0]));
  desk.tell(floatItemParts(1, kPlan[1], 0, 0));
  CHECK(desk.client.isBusy());
  desk.tell(itemParts(1, kPlan[1]));
  CHECK((desk.ended == Status::Accepted));
}

TEST_CASE("a server whose ways are not known begins anew on a lossy link, when it has given the upload up") {
  const struct {
    uint8_t autopilot;
    bool isLossy;
    uint8_t result;
    bool goesOn;
  } kCases[] = {{ClientOnLine::kOther, true, kCancelled, true},
                {ClientOnLine::kOther, false, kCancelled, false},
                {ClientOnLine::kOther, true, kDenied, false},
                {ClientOnLine::kArduPilot, true, kCancelled, false},
                {ClientOnLine::kPx4, true, kCancelled, false}};
  for (const auto& one : kCases) {
    Proving desk(one.autopilot);
    if (one.isLossy) desk.lose();
    desk.begin();
    desk.ask(1);
    desk.sent.clear();
    desk.tell(ackParts(one.result));
    CHECK(desk.client.isBusy() == one.goesOn);
    CHECK(desk.timesOf(ClientOnLine::kCount, 0).empty() != one.goesOn);
    if (!one.goesOn) {
      CHECK((desk.ended == fromMissionResult(one.result)));
      continue;
    }
    // What is cancelled now may be what was before.
    desk.sent.clear();
    desk.tell(ackParts(kCancelled));
    CHECK(desk.client.isBusy());
    CHECK(desk.timesOf(ClientOnLine::kCount, 0).empty());
    desk.ask(2);
    CHECK((desk.client.status() == Status::Transferring));
  }
}

TEST_CASE("an upload that has begun anew, and is refused then, may have changed what was aboard before") {
  for (bool backsOff : {false, true}) {
    Proving desk(ClientOnLine::kOther);
    if (backsOff) desk.client.retryWhenBusy(2);
    desk.lose();
    desk.begin();
    desk.ask(1);
    desk.sent.clear();
    desk.tell(ackParts(kCancelled));
    REQUIRE(desk.timesOf(ClientOnLine::kCount, 0).size() == 1);
    desk.tell(ackParts(kDenied));
    if (backsOff) {
      CHECK((desk.client.status() == Status::BackingOff));
      REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 3000));
      desk.tell(ackParts(kDenied));
    }
    CHECK((desk.ended == Status::Denied));
    CHECK((desk.client.aboard() == Aboard::NotKnown));
  }
}

TEST_CASE("a server whose ways are not known, and that falls silent, is tried again on a lossy link") {
  for (const bool isLossy : {false, true}) {
    Proving desk(ClientOnLine::kOther);
    desk.begin();
    desk.ask(1);
    desk.sent.clear();
    for (int second = 0; second < 9; ++second) {
      if (isLossy) desk.lose();
      desk.run(1000);
    }
    CHECK(desk.client.isBusy() == isLossy);
    CHECK(desk.timesOf(ClientOnLine::kCount, 0).empty() != isLossy);
    if (!isLossy) CHECK((desk.ended == Status::TimedOut));
  }
}

TEST_CASE("a server whose ways are not known is read back, though it has accepted") {
  Proving desk(ClientOnLine::kOther);
  desk.begin();
  desk.ask(2);
  desk.tell(ackParts(kAccepted));
  REQUIRE(desk.isRead());
  desk.tell(countParts(2));
  desk.tellItems();
  CHECK((desk.ended == Status::Accepted));
}
