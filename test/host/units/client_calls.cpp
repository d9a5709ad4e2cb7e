// What a sketch calls, and what calls it, whichever operation runs: the ends, the progress, cancel(), the ids, the
// time.
#include <doctest/doctest.h>
#include <string.h>

#include "ClientOnLine.h"
#include "PlanFrames.h"

using namespace mavmission;

namespace {

constexpr uint16_t kClearAll = 45, kCommandLong = 76;
constexpr uint8_t kAccepted = 0, kNoSpace = 4, kDenied = 14, kCancelled = 15;
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), changeSpeed(5_mps), returnToLaunch()};
const FlightCommand kCommand = flightCommand(2500);

typedef std::vector<Status> Ends;

struct Sketch : ClientOnLine {
  Ends told;
  int refused = 0;         // how many operations each end begins that are refused at once
  bool begins = false;     // whether the next end begins an upload
  bool cancels = false;    // whether it cancels that, or whatever runs
  bool cancelsOn = false;  // whether progress is cancelled
  Status updated = Status::Idle;

  explicit Sketch(uint8_t autopilot = kArduPilot, uint32_t startMs = 65000) : ClientOnLine(autopilot, startMs) {
    client.onEnd(onEnd, this);
    client.onProgress(onProgress, this);
    run(3000);
    sent.clear();
  }
  static void onEnd(void* context, Status status) {
    Sketch& sketch = *static_cast<Sketch*>(context);
    sketch.told.push_back(status);
    if (sketch.told.size() == 1) sketch.updated = sketch.client.update();
    const bool begins = sketch.begins;
    sketch.begins = false;
    if (sketch.refused > 0) {
      --sketch.refused;
      sketch.client.upload(inRam(kPlan), PlanType::All);
    }
    if (begins) sketch.client.upload(inRam(kPlan));
    if (sketch.cancels) sketch.client.cancel();
    sketch.cancels = false;
  }
  static void onProgress(void* context, uint16_t, uint16_t) {
    Sketch& sketch = *static_cast<Sketch*>(context);
    if (sketch.cancelsOn) sketch.client.cancel();
  }
  void clear() {
    client.clear();
    REQUIRE(runUntilSent(kClearAll, 3000));
    hear(ackParts(kAccepted));
    if (runUntilSent(kRequestList, 1)) hear(countParts(0));
  }
  // An upload up to its last item.
  void upload(uint16_t items = 4) {
    client.uploadWithoutReadback(inRam(kPlan));
    REQUIRE(runUntilSent(kCount, 3000));
    for (uint16_t item = 0; item < items; ++item) {
      hear(requestParts(item));
      REQUIRE(runUntilSent(kItemInt, 50));
    }
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

TEST_CASE("each end is told once, with its status, by the function that the sketch has given last") {
  Sketch sketch;
  sketch.clear();
  sketch.run(5);
  CHECK(sketch.told == Ends{Status::Cleared});
  CHECK(sketch.ends == Ends{Status::Cleared});
  CHECK((sketch.updated == Status::Busy));  // within an update()
  CHECK((sketch.client.upload(inRam(kPlan), PlanType::All) == Status::BadPlanType));
  CHECK(sketch.told == Ends{Status::Cleared, Status::BadPlanType});
  sketch.run(5);
  CHECK(sketch.ends == Ends{Status::Cleared, Status::BadPlanType});
  sketch.client.clear();
  sketch.client.cancel();
  CHECK((sketch.told.back() == Status::Cancelled));
  sketch.client.cancel();
  sketch.run(5);
  CHECK(sketch.told.size() == 3);
  CHECK(sketch.ends.size() == 3);
  sketch.client.onEnd(nullptr);
  sketch.clear();
  sketch.run(5);
  CHECK(sketch.told.size() == 3);
  CHECK(sketch.ends.size() == 4);
}

TEST_CASE("an operation that an end begins, and that ends at once, is told about by the next update()") {
  Sketch sketch;
  sketch.refused = 20;
  sketch.clear();
  while (sketch.ends.empty()) sketch.run(1);
  CHECK(sketch.ends == Ends{Status::Cleared});
  CHECK(sketch.told == Ends{Status::Cleared});
  CHECK(sketch.client.isBusy());
  for (size_t i = 1; i <= 20; ++i) {
    if (i % 2 == 0) sketch.hear(heartbeatParts(ClientOnLine::kArduPilot));
    sketch.run(1);
    CHECK(sketch.ends.size() == i + 1);
    CHECK(sketch.told.size() == i + 1);
    CHECK((sketch.told.back() == Status::BadPlanType));
    CHECK((sketch.ends.back() == Status::BadPlanType));
  }
  sketch.run(5);
  CHECK_FALSE(sketch.client.isBusy());
  CHECK(sketch.told.size() == 21);
  sketch.clear();
  sketch.run(5);
  CHECK((sketch.told.back() == Status::Cleared));
}

TEST_CASE("an operation that an end begins goes on, and is cancelled where that end wants it") {
  for (const bool cancels : {false, true}) {
    Sketch sketch;
    sketch.begins = true;
    sketch.cancels = cancels;
    sketch.clear();
    while (sketch.ends.empty()) sketch.run(1);
    CHECK(sketch.ends == Ends{Status::Cleared});
    CHECK(sketch.told == Ends{Status::Cleared});
    CHECK(sketch.client.isBusy());
    sketch.hear(heartbeatParts(ClientOnLine::kArduPilot));
    sketch.run(1);
    CHECK(sketch.client.isBusy() != cancels);
    CHECK(sketch.ends.size() == (cancels ? 2 : 1));
    CHECK(sketch.told.size() == (cancels ? 2 : 1));
    if (cancels) CHECK((sketch.told.back() == Status::Cancelled));
    if (cancels) CHECK((sketch.ends.back() == Status::Cancelled));
    sketch.client.cancel();
    sketch.run(3000);
    sketch.told.clear();
    sketch.clear();
    sketch.run(5);
    CHECK(sketch.told == Ends{Status::Cleared});
  }
}

TEST_CASE("cancel() in a callback takes effect at the end of that update(), unless the operation has ended by itself") {
  Sketch sketch;
  sketch.cancelsOn = true;
  sketch.upload(2);
  CHECK(sketch.client.isBusy());
  sketch.hear(requestParts(2));  // the first item is done
  sketch.run(1);
  CHECK(sketch.told == Ends{Status::Cancelled});
  CHECK(sketch.ends == Ends{Status::Cancelled});
  CHECK((sketch.client.aboard() == Aboard::Mixture));
  sketch.run(5);
  CHECK(sketch.acks() == std::vector<uint8_t>{kCancelled});

  Sketch other;
  other.upload();
  other.cancelsOn = true;  // at the last item, with which the operation ends
  other.cancels = true;    // and in that end: nothing runs
  other.hear(ackParts(kAccepted));
  other.run(5);
  CHECK(other.told == Ends{Status::Accepted});
  CHECK((other.client.status() == Status::Accepted));
  CHECK((other.client.aboard() == Aboard::OurPlan));
  other.clear();
  other.run(5);
  CHECK((other.told.back() == Status::Cleared));
}

TEST_CASE("what is cancelled is told to the autopilot with its type, as soon as that can be") {
  for (const PlanType type : {PlanType::Mission, PlanType::Fence, PlanType::Rally}) {
    for (const bool uploads : {true, false}) {
      const MissionItem fence[] = {fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m)};
      const MissionItem rally[] = {rallyPoint(-35.36_deg, 149.16_deg, 20_m)};
      const ItemSource plan = type == PlanType::Mission ? inRam(kPlan)
                              : type == PlanType::Fence ? inRam(fence)
                                                        : inRam(rally);
      Sketch sketch;
      if (uploads) {
        sketch.client.uploadWithoutReadback(plan, type);
      } else {
        sketch.client.verify(plan, type);
      }
      REQUIRE(sketch.runUntilSent(uploads ? ClientOnLine::kCount : ClientOnLine::kRequestList, 20));
      sketch.line.room = 0;
      sketch.run(1200);  // our heartbeat waits for room
      sketch.client.cancel();
      CHECK(sketch.told == Ends{Status::Cancelled});
      CHECK((sketch.client.aboard(type) == Aboard::NotKnown));
      sketch.beats = false;
      sketch.run(6000);
      sketch.line.room = sketch.line.kAlwaysRoom;
      sketch.run(500);
      CHECK(sketch.acks().empty());  // it is not heard: it would not hear us either
      sketch.beats = true;
      sketch.run(2000);
      REQUIRE(sketch.acks() == std::vector<uint8_t>{kCancelled});
      for (const SentFrame& frame : sketch.sent) {
        if (frame.messageId == ClientOnLine::kAck) CHECK(frame.payload[3] == static_cast<uint8_t>(type));
      }
    }
  }
}

TEST_CASE("what was cancelled before anything left is cancelled without a word, and what follows begins at once") {
  Sketch sketch;
  sketch.client.verify(inRam(kPlan));
  sketch.client.cancel();
  sketch.client.uploadWithoutReadback(inRam(kPlan));
  sketch.client.cancel();
  sketch.client.clear();
  CHECK(sketch.runUntilSent(kClearAll, 10));
  CHECK(sketch.acks().empty());
}

TEST_CASE("a command between does not shorten the wait for late answers to what was cancelled") {
  Sketch sketch;
  sketch.upload(2);
  sketch.client.cancel();
  sketch.client.send(kCommand);
  REQUIRE(sketch.runUntilSent(kCommandLong, 20));
  sketch.hear(commandAckParts(2500, 0));
  sketch.run(5);
  REQUIRE((sketch.told.back() == Status::Done));
  sketch.client.verify(inRam(kPlan));
  CHECK_FALSE(sketch.runUntilSent(ClientOnLine::kRequestList, 1400));
  CHECK(sketch.runUntilSent(ClientOnLine::kRequestList, 1000));
}

TEST_CASE("a command that is cancelled delays nothing of the mission protocol") {
  Sketch sketch;
  sketch.client.send(kCommand);
  REQUIRE(sketch.runUntilSent(kCommandLong, 20));
  sketch.client.cancel();
  sketch.client.clear();
  CHECK(sketch.runUntilSent(kClearAll, 10));
}

TEST_CASE("where answers take long, late ones are waited for longer") {
  Sketch sketch;
  sketch.client.verify(inRam(kPlan));
  REQUIRE(sketch.runUntilSent(ClientOnLine::kRequestList, 20));
  sketch.run(600);
  sketch.hear(countParts(7));
  sketch.run(5);
  REQUIRE((sketch.told.back() == Status::Differs));
  sketch.client.uploadWithoutReadback(inRam(kPlan));
  REQUIRE(sketch.runUntilSent(ClientOnLine::kCount, 4000));
  const uint32_t cancelledMs = sketch.nowMs();
  sketch.client.cancel();
  sketch.client.clear();
  REQUIRE(sketch.runUntilSent(kClearAll, 6000));
  CHECK(sketch.nowMs() - cancelledMs >= 2560);  // 6 turns of 512 ms, of which one has begun before
  CHECK(sketch.nowMs() - cancelledMs <= 3080);
}

TEST_CASE("behind a reset nothing is waited for but what it says, and then nothing any more") {
  for (const uint32_t afterMs : {10, 700, 9000}) {
    ClientOnLine desk(ClientOnLine::kArduPilot, 0);
    desk.client.setTargetIds(1, 1);
    desk.run(afterMs);
    desk.client.verify(inRam(kPlan));
    CHECK(desk.runUntilSent(ClientOnLine::kRequestList, 20));
    desk.hear(ackParts(kCancelled));
    desk.run(5);
    CHECK(desk.client.isBusy());
  }
  ClientOnLine desk(ClientOnLine::kArduPilot, 0);
  desk.client.setTargetIds(1, 1);
  desk.run(10010);
  desk.client.verify(inRam(kPlan));
  CHECK(desk.runUntilSent(ClientOnLine::kRequestList, 20));
  desk.hear(ackParts(kCancelled));
  desk.run(5);
  CHECK((desk.ended == Status::CancelledByAutopilot));
}

TEST_CASE("a new client has nothing to tell") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  CHECK((desk.client.status() == Status::Idle));
  CHECK((desk.client.failedItem() == MissionClient::kNoItem));
  CHECK(desk.client.lastResult() == 255);
  CHECK((desk.client.differingField() == ItemField::None));
  CHECK(desk.client.itemsDone() == 0);
  CHECK(desk.client.itemsTotal() == 0);
  for (const PlanType type : {PlanType::Mission, PlanType::Fence, PlanType::Rally, PlanType::All}) {
    CHECK((desk.client.aboard(type) == Aboard::NotKnown));
  }
  CHECK((desk.client.uploadAgain() == Status::SourceRefused));
  CHECK((desk.client.update() == Status::SourceRefused));
  CHECK((desk.client.update() == Status::Idle));
}

TEST_CASE(
    "of a cancelling and a refusal in one loop() update() returns the first, and the call has returned the other") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(3000);
  desk.client.upload(inRam(kPlan));
  desk.client.cancel();
  CHECK((desk.client.upload(inRam(kPlan), PlanType::All) == Status::BadPlanType));
  CHECK((desk.client.update() == Status::Cancelled));
  CHECK((desk.client.update() == Status::Idle));
}

namespace {

// Whoever hears the text begins an upload, and cancels it.
void onText(void* context, uint8_t, const char*) {
  MissionClient& client = *static_cast<MissionClient*>(context);
  client.upload(inRam(kPlan));
  client.cancel();
}

}  // namespace

TEST_CASE(
    "what is begun and cancelled behind an end in one update() is returned by the next, without onEnd() as well") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  MissionFollower follower(desk.client);
  follower.onText(onText, &desk.client);
  desk.run(3000);
  desk.client.clear();
  REQUIRE(desk.runUntilSent(kClearAll, 20));
  const Bytes text = {6, 'x'};
  desk.hear(ackParts(kAccepted));
  desk.hear(FrameParts(253, text, 83));
  for (int i = 0; i < 5 && desk.ends.empty(); ++i) desk.run(1);
  desk.run(5);
  CHECK(desk.ends == Ends{Status::Cleared, Status::Cancelled});
}

TEST_CASE("each operation begins with nothing of the one before") {
  Sketch sketch;
  sketch.upload(3);
  sketch.hear(ackParts(kNoSpace));
  sketch.run(5);
  REQUIRE(sketch.client.failedItem() == 1);
  REQUIRE(sketch.client.itemsDone() == 1);
  MissionItem array[5];
  sketch.client.download(toRam(array));
  CHECK((sketch.client.failedItem() == MissionClient::kNoItem));
  CHECK(sketch.client.lastResult() == 255);
  CHECK(sketch.client.itemsDone() == 0);
  CHECK(sketch.client.itemsTotal() == 0);
  sketch.client.cancel();
  sketch.client.verify(inRam(kPlan));
  REQUIRE(sketch.runUntilSent(ClientOnLine::kRequestList, 3000));
  sketch.hear(countParts(7));
  sketch.run(5);
  REQUIRE((sketch.client.differingField() == ItemField::Count));
  sketch.client.clear();
  CHECK((sketch.client.differingField() == ItemField::None));
  CHECK(sketch.client.itemsTotal() == 0);
}

TEST_CASE("behind a read-back that was cancelled a download tells its progress") {
  Sketch sketch(ClientOnLine::kPx4);
  sketch.client.upload(inRam(kPlan, 1), Readback::Always);
  REQUIRE(sketch.runUntilSent(ClientOnLine::kCount, 20));
  sketch.hear(requestParts(0));
  REQUIRE(sketch.runUntilSent(ClientOnLine::kItemInt, 50));
  sketch.hear(ackParts(kAccepted));
  REQUIRE(sketch.runUntilSent(ClientOnLine::kRequestList, 20));
  sketch.sent.clear();
  sketch.client.cancel();
  sketch.run(5);
  CHECK(sketch.acks() == std::vector<uint8_t>{kCancelled});
  MissionItem array[5];
  sketch.client.download(toRam(array));
  REQUIRE(sketch.runUntilSent(ClientOnLine::kRequestList, 3000));
  sketch.hear(countParts(2));
  sketch.run(5);
  sketch.hear(itemParts(0, kPlan[0]));
  sketch.run(5);
  CHECK(sketch.client.itemsDone() == 1);
}

TEST_CASE("behind an upload with back-offs the next operation has its whole time") {
  Sketch sketch;
  sketch.client.retryWhenBusy(60);
  sketch.client.setOperationTimeout(5);
  sketch.client.uploadWithoutReadback(inRam(kPlan));
  for (int i = 0; i < 3; ++i) {
    REQUIRE(sketch.runUntilSent(ClientOnLine::kCount, 9000));
    sketch.hear(ackParts(kDenied));
  }
  REQUIRE(sketch.runUntilSent(ClientOnLine::kCount, 9000));
  sketch.client.cancel();
  sketch.client.verify(inRam(kPlan));
  REQUIRE(sketch.runUntilSent(ClientOnLine::kRequestList, 3000));
  sketch.run(2000);
  CHECK(sketch.client.isBusy());
}

TEST_CASE("the limit of an operation is met to two milliseconds") {
  uint32_t soonest = 9999, latest = 0;
  for (uint32_t shift = 0; shift < 4; ++shift) {
    Sketch sketch;
    sketch.run(10 + shift);
    sketch.client.setOperationTimeout(3);
    sketch.client.verify(inRam(kPlan));
    sketch.run(1);
    const uint32_t beganMs = sketch.nowMs();
    while (sketch.client.isBusy()) sketch.run(1);
    CHECK((sketch.client.status() == Status::TookTooLong));
    const uint32_t took = sketch.nowMs() - beganMs;
    if (took < soonest) soonest = took;
    if (took > latest) latest = took;
    // The next one has its own time.
    sketch.client.verify(inRam(kPlan));
    REQUIRE(sketch.runUntilSent(ClientOnLine::kRequestList, 3000));
    sketch.run(1000);
    CHECK(sketch.client.isBusy());
  }
  CHECK(soonest == 3000);
  CHECK(latest <= 3001);
}

TEST_CASE("an autopilot that does not come, or several of them, end the wait when the sketch wants it") {
  for (const bool areTwo : {false, true}) {
    Sketch sketch;
    sketch.beats = false;
    sketch.run(7000);
    sketch.client.setAutopilotTimeout(4);
    if (areTwo) sketch.client.setTargetIds(0);  // it searches anew
    sketch.client.clear();
    const uint32_t beganMs = sketch.nowMs();
    while (sketch.client.isBusy() && sketch.nowMs() - beganMs < 9000) {
      if (areTwo && sketch.nowMs() % 500 == 0) {
        FrameParts beat = heartbeatParts(ClientOnLine::kArduPilot);
        beat.systemId = static_cast<uint8_t>(1 + sketch.nowMs() / 500 % 2);
        sketch.line.bring(packed(beat));
      }
      sketch.run(1);
    }
    CHECK((sketch.told.back() == (areTwo ? Status::SeveralAutopilots : Status::NoAutopilot)));
    CHECK(sketch.nowMs() - beganMs >= 4000);
    CHECK(sketch.nowMs() - beganMs <= 4002);
  }
  Sketch sketch;
  sketch.beats = false;
  sketch.run(7000);
  sketch.client.clear();
  sketch.run(60000);
  CHECK((sketch.client.status() == Status::WaitingForAutopilot));  // no limit
}

TEST_CASE("a sketch that has the autopilot's own ids is told so") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.client.setSourceIds(1, 1);
  desk.run(3000);
  desk.client.clear();
  desk.run(20);
  CHECK((desk.ended == Status::SameIdsAsAutopilot));
  CHECK(desk.timesOf(kClearAll, 0).empty());
}

TEST_CASE("our ids are those that the sketch has set, and so is the autopilot that it talks to") {
  setMillis(65000);
  MemoryStream line;
  MissionClient client(line);
  client.setSourceIds(42, 99);
  client.update();
  setMillis(65002);
  client.update();
  const Bytes ours = line.takeWritten();
  REQUIRE(ours.size() > 6);
  const bool isV2 = ours[0] == 0xFD;
  CHECK(ours[isV2 ? 5 : 3] == 42);
  CHECK(ours[isV2 ? 6 : 4] == 99);

  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.client.setTargetIds(2, 7);
  desk.run(3000);
  CHECK_FALSE(desk.client.hasAutopilot());
  FrameParts beat = heartbeatParts(ClientOnLine::kArduPilot);
  beat.systemId = 2;
  beat.componentId = 7;
  desk.line.bring(packed(beat));
  desk.run(20);
  CHECK(desk.client.hasAutopilot());
  CHECK(desk.client.autopilotSystemId() == 2);
  desk.client.clear();
  REQUIRE(desk.runUntilSent(kClearAll, 20));
  CHECK(desk.sent.back().payload[0] == 2);
  CHECK(desk.sent.back().payload[1] == 7);
}

TEST_CASE("an update() takes what it may from the line, and a frame for us counts for more than its bytes") {
  Sketch sketch;
  const auto readInOne = [&](const Bytes& bytes) {
    sketch.line.bring(bytes);
    const size_t before = sketch.line.bytesRead;
    sketch.run(1);
    const size_t read = sketch.line.bytesRead - before;
    sketch.run(60);
    return read;
  };
  sketch.run(10);
  CHECK(readInOne(Bytes(600, 0x11)) == MAVMISSION_BYTES_PER_UPDATE);
  Bytes beats;
  for (uint8_t i = 0; i < 10; ++i) {
    FrameParts beat = heartbeatParts(ClientOnLine::kArduPilot);
    beat.sequence = static_cast<uint8_t>(100 + i);
    beats = beats + packed(beat);
  }
  const size_t ofBeats = readInOne(beats);
  CHECK(ofBeats > MAVMISSION_BYTES_PER_UPDATE / 4);
  CHECK(ofBeats < MAVMISSION_BYTES_PER_UPDATE);
}

namespace {

bool readCounted(void* reads, uint16_t, MissionItem& item) {
  ++*static_cast<int*>(reads);
  item = kPlan[0];
  return true;
}

}  // namespace

TEST_CASE(
    "an update() that has read many bytes leaves the check of an item to the next one, which reads half as many") {
  int reads = 0;
  Sketch sketch;
  sketch.run(10);
  sketch.client.uploadWithoutReadback(fromFunction(readCounted, 500, &reads));
  sketch.run(2);
  const int before = reads;
  sketch.line.bring(Bytes(6000, 0x11));
  const size_t bytes = sketch.line.bytesRead;
  sketch.run(20);
  CHECK(reads - before == 10);
  CHECK(sketch.line.bytesRead - bytes == 10 * (MAVMISSION_BYTES_PER_UPDATE + MAVMISSION_BYTES_PER_UPDATE / 2));
}
