// ensure() by a whole client: what the look takes for an answer, how it ends, and what the upload behind it says.
#include <doctest/doctest.h>
#include <string.h>

#include <algorithm>

#include "ClientOnLine.h"
#include "PlanFrames.h"
#include "Px4Checksum.h"

using namespace mavmission;

namespace {

constexpr uint8_t kAccepted = 0, kError = 1, kNoSpace = 4, kDenied = 14, kCancelled = 15;
constexpr uint8_t kSafetyArmed = 128;  // in HEARTBEAT.base_mode
const MissionItem kPlan[] = {anyCommandAt(kNavWaypoint, -35.5_deg, 149.25_deg, 20_m), returnToLaunch()};

uint32_t checksum() { return px4Checksum(kPlan, 2); }

struct Looking : ClientOnLine {
  int progress = 0;
  const uint8_t kind;

  explicit Looking(uint8_t autopilot, uint32_t startMs = 65000, uint8_t baseMode = 0)
      : ClientOnLine(autopilot, startMs), kind(autopilot) {
    client.onProgress(note, this);
    beats = false;
    for (int second = 0; second < 3; ++second) {
      hear(heartbeatParts(autopilot, baseMode));
      run(1000);
    }
    beats = baseMode == 0;
  }
  static void note(void* context, uint16_t, uint16_t) { ++static_cast<Looking*>(context)->progress; }
  Looking& begin(Readback proof = Readback::InDoubt) {
    sent.clear();
    ended = Status::Idle;
    CHECK((client.ensure(inRam(kPlan), proof) == Status::WaitingForAutopilot));
    REQUIRE(runUntilSent(kRequestList, 3000));
    return *this;
  }
  void tell(const FrameParts& parts) {
    hear(parts);
    run(5);
  }
  void tellItems() {
    const uint16_t home = kind == kArduPilot ? 1 : 0;
    if (home != 0) tell(itemParts(0, homeItem()));
    for (uint16_t item = 0; item < 2; ++item) tell(itemParts(static_cast<uint16_t>(item + home), kPlan[item]));
  }
  std::vector<uint8_t> acks() const {
    std::vector<uint8_t> results;
    for (const SentFrame& frame : sent) {
      if (frame.messageId == kAck) results.push_back(frame.payload[2]);
    }
    return results;
  }
  size_t readInOne() {
    line.bring(Bytes(600, 0x11));
    const size_t before = line.bytesRead;
    run(1);
    return line.bytesRead - before;
  }
};

}  // namespace

TEST_CASE("PX4's checksum shows that the plan is aboard, and its reading is closed") {
  Looking desk(ClientOnLine::kPx4);
  for (int times = 0; times < 2; ++times) {
    desk.progress = 0;
    desk.begin();
    CHECK(desk.client.itemsTotal() == 2);
    desk.tell(countParts(2, PlanType::Mission, checksum()));
    CHECK((desk.ended == Status::AlreadyAboard));
    CHECK((desk.client.aboard() == Aboard::OurPlan));
    CHECK(desk.client.itemsDone() == 2);
    CHECK(desk.progress == 1);
    desk.run(5);
    CHECK(desk.acks() == std::vector<uint8_t>{kCancelled});
    CHECK(desk.timesOf(ClientOnLine::kRequestInt, 0).empty());
    CHECK(desk.timesOf(ClientOnLine::kCount, 0).empty());
  }
}

TEST_CASE("any other autopilot's plan is read, without progress, and its end is confirmed") {
  for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kOther}) {
    Looking desk(autopilot);
    desk.begin();
    desk.tell(countParts(autopilot == ClientOnLine::kArduPilot ? 3 : 2, PlanType::Mission, 0x12345678));
    CHECK(desk.progress == 0);
    desk.tellItems();
    CHECK((desk.ended == Status::AlreadyAboard));
    CHECK((desk.client.aboard() == Aboard::OurPlan));
    CHECK(desk.progress == 1);
    CHECK(desk.acks() == std::vector<uint8_t>{kAccepted});
    CHECK(desk.client.lastResult() == 255);
  }
}

TEST_CASE("no progress is told while items are read, and a cancel() is told to the autopilot") {
  Looking desk(ClientOnLine::kOther);
  desk.begin();
  desk.tell(countParts(2));
  desk.tell(itemParts(0, kPlan[0]));
  CHECK(desk.progress == 0);
  CHECK(desk.client.itemsDone() == 0);
  desk.client.cancel();
  desk.run(5);
  CHECK(desk.acks() == std::vector<uint8_t>{kCancelled});
}

TEST_CASE("behind a download a look compares") {
  Looking desk(ClientOnLine::kOther);
  MissionItem array[4];
  desk.client.download(toRam(array));
  desk.run(5);
  desk.client.cancel();
  desk.run(3000);
  desk.begin();
  desk.tell(countParts(2));
  desk.tellItems();
  CHECK((desk.ended == Status::AlreadyAboard));
}

TEST_CASE("items that come as floats are looked at as well") {
  Looking desk(ClientOnLine::kOther);
  desk.begin();
  desk.tell(countParts(2));
  desk.tell(floatItemParts(0, kPlan[0], -35.5f, 149.25f));
  desk.tell(floatItemParts(1, kPlan[1], 0, 0));
  CHECK((desk.ended == Status::AlreadyAboard));
}

TEST_CASE("an armed autopilot with our plan is fine, and with another one it is left alone, whatever is allowed") {
  for (const bool isOurs : {true, false}) {
    for (const bool isAllowed : {true, false}) {
      Looking desk(ClientOnLine::kOther, 65000, kSafetyArmed);
      desk.client.allowWhileArmed(isAllowed);
      desk.begin();
      desk.tell(countParts(isOurs ? 2 : 3));
      if (isOurs) desk.tellItems();
      CHECK((desk.ended == (isOurs ? Status::AlreadyAboard : Status::Armed)));
      CHECK((desk.client.aboard() == (isOurs ? Aboard::OurPlan : Aboard::NotKnown)));
      desk.run(100);
      CHECK(desk.acks() == std::vector<uint8_t>{isOurs ? kAccepted : kCancelled});
      CHECK(desk.timesOf(ClientOnLine::kCount, 0).empty());
      if (!isOurs) CHECK((desk.client.differingField() == ItemField::Count));
    }
  }
}

TEST_CASE("an item that differs is named where the plan is not replaced") {
  Looking desk(ClientOnLine::kOther, 65000, kSafetyArmed);
  desk.begin();
  desk.tell(countParts(2));
  desk.tell(itemParts(0, kPlan[0]));
  desk.tell(itemParts(1, kPlan[0]));
  CHECK((desk.ended == Status::Armed));
  CHECK(desk.client.failedItem() == 1);
  CHECK((desk.client.differingField() == ItemField::Command));
}

TEST_CASE("a value that the autopilot does not keep ends the look before it is asked") {
  const MissionItem plan[] = {anyCommandAt(kNavWaypoint, -35_deg, 149_deg, 20_m, 2.5f)};
  Looking desk(ClientOnLine::kArduPilot);
  desk.client.ensure(inRam(plan));
  desk.run(100);
  CHECK((desk.ended == Status::NotKept));
  CHECK(desk.client.failedItem() == 0);
  CHECK(desk.timesOf(ClientOnLine::kRequestList, 0).empty());
}

namespace {

struct Source {
  int left;  // how often it can be read
  static bool read(void* context, uint16_t index, MissionItem& item) {
    item = kPlan[index];
    return static_cast<Source*>(context)->left-- > 0;
  }
};

}  // namespace

TEST_CASE("a source that fails while the look is prepared, or while items are compared, ends it") {
  for (int left = 0; left < 4; ++left) {  // checked, and then added up for PX4's checksum
    Source source = {left};
    Looking desk(ClientOnLine::kPx4);
    desk.client.ensure(fromFunction(Source::read, 2, &source));
    desk.run(100);
    CHECK((desk.ended == Status::SourceRefused));
    CHECK(desk.client.failedItem() == left % 2);
    CHECK(desk.timesOf(ClientOnLine::kRequestList, 0).empty());
  }
  Source source = {3};
  Looking desk(ClientOnLine::kOther);
  desk.client.ensure(fromFunction(Source::read, 2, &source));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 100));
  desk.tell(countParts(2));
  desk.tellItems();
  CHECK((desk.ended == Status::SourceRefused));
  CHECK(desk.client.failedItem() == 1);
  CHECK((desk.client.differingField() == ItemField::None));
  desk.run(20);
  CHECK(desk.timesOf(ClientOnLine::kCount, 0).empty());
}

namespace {

// PX4 gives a takeoff the place of the next item that has one: the library looks for it in several steps.
bool readFarPlace(void*, uint16_t index, MissionItem& item) {
  item = index == 0 ? takeoff(20_m) : index == 12 ? kPlan[0] : changeSpeed(5_mps);
  return true;
}

}  // namespace

TEST_CASE("an item whose place has to be searched is compared when that is found") {
  Looking desk(ClientOnLine::kPx4);
  desk.client.ensure(fromFunction(readFarPlace, 13));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 200));
  desk.tell(countParts(13));  // without a checksum
  MissionItem aboard;
  readFarPlace(nullptr, 0, aboard);
  aboard.x = kPlan[0].x;
  aboard.y = kPlan[0].y;
  for (int i = 0; i < 50 && desk.sent.back().payload[0] == 0; ++i) desk.tell(itemParts(0, aboard));
  CHECK(desk.client.isBusy());
  CHECK(desk.sent.back().messageId == ClientOnLine::kRequestInt);
  CHECK(desk.sent.back().payload[0] == 1);
}

TEST_CASE("the look leaves behind an update() for each item") {
  for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kOther}) {
    Looking desk(autopilot);
    desk.run(10);
    desk.sent.clear();
    const uint32_t beganMs = desk.nowMs();
    desk.client.ensure(inRam(kPlan));
    desk.run(10);
    const uint32_t items = autopilot == ClientOnLine::kArduPilot ? 3 : 2;
    REQUIRE(desk.timesOf(ClientOnLine::kRequestList, beganMs).size() == 1);
    CHECK(desk.timesOf(ClientOnLine::kRequestList, beganMs)[0] == items + 2);
  }
}

TEST_CASE("a look that waited for the autopilot has its whole time") {
  ClientOnLine desk(ClientOnLine::kPx4);
  desk.client.setOperationTimeout(3);
  desk.beats = false;
  CHECK((desk.client.ensure(inRam(kPlan)) == Status::WaitingForAutopilot));
  CHECK((desk.client.status() == Status::WaitingForAutopilot));
  desk.run(5500);
  desk.beats = true;
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 4000));
  desk.run(2980);
  CHECK(desk.client.isBusy());
  desk.sent.clear();
  desk.run(1040);  // it is counted in whole seconds
  CHECK((desk.ended == Status::TookTooLong));
  REQUIRE(desk.timesOf(ClientOnLine::kAck, 0).size() == 1);
}

TEST_CASE("the time that is allowed for back-offs begins with the first refusal of the look") {
  Looking desk(ClientOnLine::kArduPilot);
  desk.client.retryWhenBusy(20);
  desk.begin();
  const uint32_t firstMs = desk.nowMs();
  for (int times = 0; times < 60 && desk.client.isBusy(); ++times) {
    desk.hear(ackParts(kDenied));
    desk.run(1000);
  }
  CHECK((desk.ended == Status::Denied));
  // Each look is believed to be denied 7.5 s after its beginning, and the pauses are 1 s and 2 s.
  const std::vector<uint32_t> times = desk.timesOf(ClientOnLine::kRequestList, firstMs);
  CHECK(times.size() == 15);
  CHECK(times.back() >= 23000);
  CHECK(times.back() <= 25000);
}

TEST_CASE("a look is taken up at the second at which the back-off ends, whether anything is heard or not") {
  Looking desk(ClientOnLine::kArduPilot);
  desk.client.retryWhenBusy(60);
  desk.begin();
  desk.hear(ackParts(kDenied));
  for (int i = 0; i < 9000 && desk.client.status() != Status::BackingOff; ++i) desk.run(1);
  REQUIRE((desk.client.status() == Status::BackingOff));
  desk.beats = false;
  const uint32_t pausedMs = desk.nowMs();
  desk.sent.clear();
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 2500));
  CHECK(desk.nowMs() - pausedMs >= 1000);
  // What was sent again may still be answered.
  CHECK(desk.nowMs() - pausedMs <= 1700);
  // It begins anew, with the autopilot and the check of the plan.
  const std::vector<Status> expected = {Status::BackingOff, Status::WaitingForAutopilot, Status::Checking,
                                        Status::Transferring};
  REQUIRE(desk.returned.size() >= expected.size());
  CHECK(std::equal(expected.rbegin(), expected.rend(), desk.returned.rbegin()));
}

TEST_CASE("an autopilot that fell silent during the back-off of a look is waited for first") {
  Looking desk(ClientOnLine::kOther);
  desk.client.retryWhenBusy(60);
  desk.begin();
  desk.tell(countParts(2));
  for (int i = 0; i < 4; ++i) {  // 1, 2, 4 and 8 s
    desk.tell(ackParts(kDenied));
    REQUIRE((desk.client.status() == Status::BackingOff));
    if (i == 3) break;
    REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 9000));
    desk.tell(countParts(2));
  }
  desk.beats = false;
  desk.sent.clear();
  desk.run(10000);
  CHECK((desk.client.status() == Status::WaitingForAutopilot));
  CHECK(desk.timesOf(ClientOnLine::kRequestList, 0).empty());
}

TEST_CASE("while a plan is looked at an update() takes half as many bytes, and the whole again behind that") {
  Looking looking(ClientOnLine::kOther), replacing(ClientOnLine::kOther),
      ended(ClientOnLine::kOther, 65000, kSafetyArmed);
  looking.begin();
  looking.run(5);
  const size_t half = looking.readInOne();
  CHECK(half > 16);
  CHECK(half <= MAVMISSION_BYTES_PER_UPDATE / 2);
  replacing.begin();
  replacing.run(5);
  replacing.hear(countParts(7));
  replacing.run(1);
  CHECK(replacing.readInOne() > MAVMISSION_BYTES_PER_UPDATE / 2);
  ended.begin();
  ended.tell(countParts(7));
  REQUIRE((ended.ended == Status::Armed));
  CHECK(ended.readInOne() > MAVMISSION_BYTES_PER_UPDATE / 2);
}

TEST_CASE("while items are looked at an error may be about what was before, and no other refusal is") {
  for (const uint8_t result : {kError, kDenied, kCancelled}) {
    for (const uint32_t startMs : {0, 65000}) {
      Looking desk(ClientOnLine::kOther, startMs);
      desk.begin();
      desk.tell(countParts(2));
      desk.tell(ackParts(result));
      const bool goesOn = result == kError;
      CHECK(desk.client.isBusy() == goesOn);
      CHECK((desk.ended == (goesOn ? Status::Idle : fromMissionResult(result))));
    }
  }
}

TEST_CASE(
    "behind a reset a denial of the look begins it anew when its attempts are used up, for as long as that may be "
    "ours") {
  ClientOnLine desk(ClientOnLine::kArduPilot, 0);
  desk.client.setTargetIds(1, 1);
  desk.run(10);
  desk.client.ensure(inRam(kPlan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 20));
  const uint32_t firstMs = desk.nowMs();
  desk.hear(ackParts(kDenied));
  desk.run(8000);
  CHECK(desk.client.isBusy());
  CHECK(desk.client.lastResult() == 255);  // of the look that is under way
  desk.run(9000);
  CHECK((desk.ended == Status::NoAnswer));
  CHECK(desk.timesOf(ClientOnLine::kRequestList, firstMs).size() == 10);
}

TEST_CASE("the reading is closed in the frame that is free, before the upload begins") {
  Looking desk(ClientOnLine::kOther);
  desk.begin();
  desk.line.room = 0;
  desk.run(1200);  // our heartbeat waits for room
  desk.sent.clear();
  desk.tell(countParts(7));
  desk.run(20);
  desk.line.room = desk.line.kAlwaysRoom;
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 600));
  REQUIRE(desk.sent.size() >= 3);
  CHECK(desk.sent[0].messageId == 0);
  CHECK(desk.sent[0].payload[6] == 0);   // HEARTBEAT.base_mode
  CHECK(desk.sent[0].payload[4] == 18);  // MAV_TYPE_ONBOARD_CONTROLLER
  CHECK(desk.acks() == std::vector<uint8_t>{kCancelled});
}

TEST_CASE("what was said of the look is forgotten in the upload behind it") {
  Looking desk(ClientOnLine::kArduPilot);
  desk.begin();
  desk.tell(ackParts(kDenied));
  CHECK(desk.client.lastResult() == kDenied);
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 2000));
  desk.hear(countParts(7));
  CHECK_FALSE(desk.runUntilSent(ClientOnLine::kCount, 1500));  // the first MISSION_REQUEST_LIST may still be denied
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 200));
  CHECK(desk.client.lastResult() == 255);
  CHECK((desk.client.differingField() == ItemField::None));
  desk.hear(requestParts(0));
  REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
  desk.hear(requestParts(1));
  desk.run(10);
  desk.hear(requestParts(2));
  desk.run(10);
  CHECK(desk.client.itemsDone() == 1);
  CHECK(desk.progress == 1);
}

TEST_CASE("behind a look PX4 may still be busy with it") {
  for (const bool isAboard : {false, true}) {
    Looking desk(ClientOnLine::kPx4, 30000);
    desk.begin();
    desk.tell(countParts(2, PlanType::Mission, isAboard ? checksum() : 1));
    if (isAboard) {
      REQUIRE((desk.ended == Status::AlreadyAboard));
      desk.ended = Status::Idle;
      desk.client.uploadWithoutReadback(inRam(kPlan));
    }
    if (isAboard) REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 2000));
    desk.hear(ackParts(kError));
    REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 2000));
    desk.hear(ackParts(kError));
    desk.run(20);
    CHECK((desk.ended == Status::Idle));
  }
}

TEST_CASE("behind a look whose upload was denied PX4 may still be busy with the look") {
  Looking desk(ClientOnLine::kPx4, 30000);
  desk.begin();
  desk.tell(countParts(2, PlanType::Mission, 1));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 600));
  desk.tell(ackParts(kDenied));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 2000));
  desk.tell(ackParts(kDenied));
  REQUIRE((desk.ended == Status::Denied));
  desk.ended = Status::Idle;
  desk.client.uploadWithoutReadback(inRam(kPlan));
  for (int i = 0; i < 2; ++i) {
    REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 4000));
    desk.hear(ackParts(kError));
  }
  desk.run(20);
  CHECK((desk.ended == Status::Idle));
}

TEST_CASE("a short fence that settles behind a look is cancelled without a word") {
  const MissionItem fence[] = {fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m)};
  Looking desk(ClientOnLine::kArduPilot);
  desk.client.ensure(inRam(fence), PlanType::Fence);
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 100));
  desk.hear(countParts(0, PlanType::Fence));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 600));
  desk.hear(requestParts(0, 1, 191, 1));
  REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
  desk.tell(ackParts(kAccepted, 1, 191, 1));
  desk.run(300);
  desk.sent.clear();
  desk.client.cancel();
  desk.run(20);
  CHECK((desk.client.status() == Status::Cancelled));
  CHECK(desk.acks().empty());
}

TEST_CASE(
    "a refusal of the upload behind a look says what that leaves, and one that may be about the look says nothing") {
  const struct {
    uint16_t asked;
    uint8_t result;
    Aboard aboard;
  } kCases[] = {{0, kNoSpace, Aboard::AsBefore},
                {0, kError, Aboard::NotKnown},
                {2, kDenied, Aboard::Mixture},
                {2, kNoSpace, Aboard::Mixture}};
  for (const auto& one : kCases) {
    Looking desk(ClientOnLine::kArduPilot);
    desk.begin();
    desk.hear(countParts(7));
    REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 600));
    for (uint16_t item = 0; item < one.asked; ++item) {
      desk.hear(requestParts(item));
      REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
    }
    desk.tell(ackParts(one.result));
    CHECK((desk.ended == fromMissionResult(one.result)));
    CHECK((desk.client.aboard() == one.aboard));
  }
}

TEST_CASE("the read-back behind a look takes no COUNT that comes before it has asked") {
  Looking desk(ClientOnLine::kArduPilot);
  desk.begin(Readback::Always);
  desk.hear(countParts(7));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 600));
  for (uint16_t item = 0; item < 3; ++item) {
    desk.hear(requestParts(item));
    REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
  }
  desk.sent.clear();
  desk.line.room = 0;
  desk.run(1200);  // our heartbeat waits for room
  desk.hear(ackParts(kAccepted));
  desk.run(5);
  desk.tell(countParts(3));
  desk.line.room = desk.line.kAlwaysRoom;
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 50));
  desk.tell(countParts(3, PlanType::Fence));
  desk.tell(countParts(7));  // the look's, once more
  CHECK(desk.client.isBusy());
  desk.tell(countParts(3));
  desk.tellItems();
  CHECK((desk.ended == Status::Accepted));
  CHECK(desk.timesOf(ClientOnLine::kRequestList, 0).size() == 1);
}
