// What a sketch calls, and what calls it, whichever operation runs: the ends, the progress, cancel(), the ids, the
// time.
#include <doctest/doctest.h>

#include "Conversation.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = Conversation::kArduPilot;
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), changeSpeed(5_mps), returnToLaunch()};
const MissionItem kFence[] = {fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m)};
const MissionItem kRally[] = {rallyPoint(-35.36_deg, 149.16_deg, 20_m)};

std::string text(const std::vector<Status>& ends) {
  std::string all;
  for (const Status end : ends) all += (all.empty() ? "" : ", ") + std::string(nameOf(end));
  return all;
}

// Its callbacks call the client.
struct Sketch : Conversation {
  int refused = 0;         // how many operations each end begins that are refused at once
  bool begins = false;     // whether the next end begins an upload
  bool cancels = false;    // whether it cancels that, or whatever runs
  bool cancelsOn = false;  // whether progress is cancelled
  Status updated = Status::Idle;

  explicit Sketch(uint8_t autopilot = kArduPilot) : Conversation(autopilot, kPlan) {
    client.onEnd(onEnd, this);
    client.onProgress(onProgress, this);
  }
  static void onEnd(void* context, Status status) {
    Sketch& sketch = *static_cast<Sketch*>(context);
    sketch.told.push_back(status);
    if (sketch.told.size() == 1) sketch.updated = sketch.client.update();
    const bool begins = sketch.begins;
    sketch.begins = false;
    if (sketch.refused-- > 0) sketch.client.upload(inRam(kPlan), PlanType::All);
    if (begins) sketch.client.upload(inRam(kPlan));
    if (sketch.cancels) sketch.client.cancel();
    sketch.cancels = false;
  }
  static void onProgress(void* context, uint16_t, uint16_t) {
    Sketch& sketch = *static_cast<Sketch*>(context);
    if (sketch.cancelsOn) sketch.client.cancel();
  }
  // The answers to a clear.
  void clear() {
    plays("clear, until CLEAR");
    hear(ackParts(0));
    if (runUntilSent(kRequestList, 1)) hear(countParts(0));
  }
  // The ends that update() has returned, and onEnd() was told.
  std::string both() const {
    return text(ends) == text(told) ? text(told) : "returned " + text(ends) + ", told " + text(told);
  }
};

// Whoever hears the text begins an upload, and cancels it.
void onText(void* context, uint8_t, const char*) {
  MissionClient& client = *static_cast<MissionClient*>(context);
  client.upload(inRam(kPlan));
  client.cancel();
}

bool readCounted(void* reads, uint16_t, MissionItem& item) {
  ++*static_cast<int*>(reads);
  item = kPlan[0];
  return true;
}

}  // namespace

TEST_CASE("each end is told once, with its status, by the function that the sketch has given last") {
  Sketch sketch;
  sketch.clear();
  sketch.pass(5);
  CHECK(sketch.both() == "Cleared");
  CHECK((sketch.updated == Status::Busy));  // within an update()
  CHECK((sketch.client.upload(inRam(kPlan), PlanType::All) == Status::BadPlanType));
  CHECK(text(sketch.told) == "Cleared, BadPlanType");
  sketch.pass(5);
  CHECK(sketch.both() == "Cleared, BadPlanType");
  sketch.plays("clear, cancel");
  CHECK((sketch.told.back() == Status::Cancelled));
  sketch.plays("cancel, 5 ms");
  CHECK(sketch.both() == "Cleared, BadPlanType, Cancelled");
  sketch.client.onEnd(nullptr);
  sketch.clear();
  sketch.pass(5);
  CHECK(sketch.both() == "returned Cleared, BadPlanType, Cancelled, Cleared, told Cleared, BadPlanType, Cancelled");
}

TEST_CASE("an operation that an end begins, and that ends at once, is told about by the next update()") {
  Sketch sketch;
  sketch.refused = 20;
  sketch.clear();
  while (sketch.ends.empty()) sketch.pass(1);
  std::string expected = "Cleared";
  CHECK(sketch.both() == expected);
  CHECK(sketch.client.isBusy());
  for (size_t i = 1; i <= 20; ++i) {
    if (i % 2 == 0) sketch.hear(heartbeatParts(kArduPilot));
    sketch.pass(1);
    expected += ", BadPlanType";
    CHECK(sketch.both() == expected);
  }
  sketch.pass(5);
  CHECK_FALSE(sketch.client.isBusy());
  sketch.clear();
  sketch.pass(5);
  CHECK(sketch.both() == expected + ", Cleared");
}

TEST_CASE("an operation that an end begins goes on, and is cancelled where that end wants it") {
  for (const bool cancels : {false, true}) {
    Sketch sketch;
    sketch.begins = true;
    sketch.cancels = cancels;
    sketch.clear();
    while (sketch.ends.empty()) sketch.pass(1);
    CHECK(sketch.both() == "Cleared");
    CHECK(sketch.client.isBusy());
    sketch.hear(heartbeatParts(kArduPilot));
    sketch.pass(1);
    CHECK(sketch.client.isBusy() != cancels);
    CHECK(sketch.both() == (cancels ? "Cleared, Cancelled" : "Cleared"));
    sketch.plays("cancel, 3 s");
    sketch.told.clear();
    sketch.clear();
    sketch.pass(5);
    CHECK(text(sketch.told) == "Cleared");
  }
}

TEST_CASE("cancel() in a callback takes effect at the end of that update(), unless the operation has ended by itself") {
  Sketch sketch, other;
  sketch.cancelsOn = true;
  sketch.plays("upload unread, until COUNT, asks 0-1");
  CHECK(sketch.client.isBusy());
  CHECK(sketch.plays("asks 2, 5 ms") == "-> Cancelled (Mixture), ACK cancelled, no ITEM 2");  // the first item is done
  CHECK(sketch.both() == "Cancelled");

  other.plays("upload unread, until COUNT, asks all");
  other.cancelsOn = true;  // at the last item, with which the operation ends
  other.cancels = true;    // and in that end: nothing runs
  CHECK(other.plays("accepted") == "-> Accepted (OurPlan)");
  CHECK((other.client.status() == Status::Accepted));
  other.clear();
  other.pass(5);
  CHECK(other.both() == "Accepted, Cleared");
}

TEST_CASE("what is cancelled is told to the autopilot with its type, as soon as that can be") {
  const struct {
    PlanType type;
    ItemSource plan;
    const char* of;
  } kPlans[] = {{PlanType::Mission, inRam(kPlan, 3), ""},
                {PlanType::Fence, inRam(kFence, 1), " of fence"},
                {PlanType::Rally, inRam(kRally, 1), " of rally"}};
  for (const auto& one : kPlans) {
    for (const std::string call : {"upload unread", "verify"}) {
      Conversation desk(kArduPilot);
      desk.isAbout(one.plan, one.type).plays(call + ", 20 ms, full, cancel");
      CHECK(text(desk.told) == "Cancelled");
      CHECK((desk.client.aboard(one.type) == Aboard::NotKnown));
      // While it is not heard it would not hear us either.
      CHECK(desk.plays("silence, 6 s | free, 500 ms | heartbeats, 2 s") ==
            "-> Cancelled (NotKnown) | | ACK cancelled" + std::string(one.of));
    }
  }
}

TEST_CASE("a command between does not shorten the wait for late answers to what was cancelled, and delays nothing") {
  Conversation desk(kArduPilot, kPlan), other(kArduPilot, kPlan);
  desk.plays("upload unread, until COUNT, asks 0-1, cancel");
  CHECK(desk.plays("send, until LONG 20 ms, answer 2500 accepted | verify, 1400 ms | until LIST 1 s") ==
        "ACK cancelled, -> Cancelled (Mixture), LONG 2500, -> Done (Mixture) | | LIST");
  CHECK(other.plays("send, until LONG 20 ms, cancel, clear, 10 ms") == "LONG 2500, -> Cancelled (NotKnown), CLEAR");
}

TEST_CASE("where answers take long, late ones are waited for longer") {
  Conversation desk(kArduPilot, kPlan);
  CHECK(desk.plays("verify, until LIST, 600 ms, count 7, upload unread, until COUNT 4 s") ==
        "LIST, -> Differs in Count (NotKnown), ACK cancelled, COUNT 4");
  // 6 turns of 512 ms, of which one has begun before.
  CHECK(desk.plays("cancel, clear, 2559 ms | until CLEAR 521 ms") == "ACK cancelled, -> Cancelled (NotKnown) | CLEAR");
}

TEST_CASE("after a reset nothing is waited for but what it says, and then nothing any more") {
  for (const uint32_t afterMs : {10, 700, 9000, 10010}) {
    Conversation desk(kArduPilot, 0, 0);
    desk.isAbout(inRam(kPlan)).client.setTargetIds(1, 1);
    desk.pass(afterMs);
    CHECK(desk.plays("verify, until LIST 20 ms, cancelled") ==
          (afterMs < 10000 ? std::string("LIST") : "LIST, -> CancelledByAutopilot (NotKnown), ACK cancelled"));
  }
}

TEST_CASE("a new client has nothing to tell") {
  ClientOnLine desk(kArduPilot);
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

TEST_CASE("what is begun and cancelled after an end in one update() is returned by the next, beside onEnd()") {
  Conversation desk(kArduPilot);
  MissionFollower follower(desk.client);
  follower.onText(onText, &desk.client);
  desk.client.onEnd(nullptr);
  desk.plays("clear, until CLEAR");
  desk.hear(ackParts(0));
  desk.hear(FrameParts(253, {6, 'x'}, 83));
  CHECK(desk.plays("10 ms") == "-> Cleared (Nothing), -> Cancelled (Nothing)");
}

TEST_CASE("each operation begins with nothing of the one before") {
  Conversation desk(kArduPilot, kPlan);
  desk.plays("upload unread, until COUNT, asks 0-2, no space");
  REQUIRE(desk.client.failedItem() == 1);
  REQUIRE(desk.client.itemsDone() == 1);
  desk.plays("download");
  CHECK((desk.client.failedItem() == MissionClient::kNoItem));
  CHECK(desk.client.lastResult() == 255);
  CHECK(desk.client.itemsDone() == 0);
  CHECK(desk.client.itemsTotal() == 0);
  desk.plays("cancel, verify, until LIST, count 7");
  REQUIRE((desk.client.differingField() == ItemField::Count));
  desk.plays("clear");
  CHECK((desk.client.differingField() == ItemField::None));
  CHECK(desk.client.itemsTotal() == 0);
}

TEST_CASE("the limit of an operation is met to two milliseconds") {
  uint32_t soonest = 9999, latest = 0;
  for (uint32_t shift = 0; shift < 4; ++shift) {
    Conversation desk(kArduPilot, kPlan);
    desk.client.setOperationTimeout(3);
    desk.pass(10 + shift);
    desk.plays("verify, 1 ms");
    const uint32_t beganMs = desk.nowMs();
    desk.plays("until -> TookTooLong");
    soonest = std::min(soonest, desk.nowMs() - beganMs);
    latest = std::max(latest, desk.nowMs() - beganMs);
    // The next one has its own time.
    desk.plays("verify, until LIST 3 s, 1 s");
    CHECK(desk.client.isBusy());
  }
  CHECK(soonest == 3000);
  CHECK(latest <= 3001);
}

TEST_CASE("an autopilot that does not come, or several of them, end the wait when the sketch wants it") {
  for (const bool areTwo : {false, true}) {
    Conversation desk(kArduPilot);
    desk.plays("silence, 7 s");
    desk.client.setAutopilotTimeout(4);
    if (areTwo) desk.client.setTargetIds(0);  // it searches anew
    desk.plays("clear");
    const uint32_t beganMs = desk.nowMs();
    while (desk.client.isBusy() && desk.nowMs() - beganMs < 9000) {
      FrameParts beat = heartbeatParts(kArduPilot);
      beat.systemId = static_cast<uint8_t>(1 + desk.nowMs() / 500 % 2);
      if (areTwo && desk.nowMs() % 500 == 0) desk.line.bring(packed(beat));
      desk.pass(1);
    }
    CHECK(text(desk.told) == (areTwo ? "SeveralAutopilots" : "NoAutopilot"));
    CHECK(desk.nowMs() - beganMs >= 4000);
    CHECK(desk.nowMs() - beganMs <= 4002);
  }
  Conversation desk(kArduPilot);
  desk.plays("silence, 7 s, clear, 60 s");
  CHECK((desk.client.status() == Status::WaitingForAutopilot));  // no limit
}

TEST_CASE("what runs ends when the sketch names another autopilot, in the middle of a frame, too") {
  Conversation reading(kArduPilot, kPlan), checking(kArduPilot, kPlan), sending(kArduPilot, kPlan);
  reading.plays("verify, until LIST");
  reading.client.setTargetIds(2, 1);
  CHECK(reading.plays("5 ms") == "-> NoAutopilot (NotKnown)");
  checking.plays("full, upload unread, 20 ms");
  checking.client.setTargetIds(2, 1);
  CHECK(checking.plays("5 ms") == "-> NoAutopilot (NotKnown)");
  sending.pass(100);
  sending.line.room = sending.line.takes = 4;
  sending.plays("clear, 1 ms");
  sending.client.setTargetIds(2, 1);
  sending.line.takes = 1000000;
  CHECK(sending.plays("free, 100 ms") == "-> NoAutopilot (NotKnown)");
}

TEST_CASE("our ids are those that the sketch has set, and so is the autopilot that it talks to") {
  ClientOnLine ours(kArduPilot);
  ours.client.setSourceIds(42, 99);
  ours.run(3);
  REQUIRE(!ours.sent.empty());
  const Bytes& frame = ours.sent.front().frame;
  const bool isV2 = frame[0] == 0xFD;
  CHECK(frame[isV2 ? 5 : 3] == 42);
  CHECK(frame[isV2 ? 6 : 4] == 99);

  Conversation same(kArduPilot, 65000, 0);
  same.client.setSourceIds(1, 1);
  CHECK(same.plays("3 s, clear, 20 ms") == "-> SameIdsAsAutopilot (NotKnown)");

  Conversation desk(kArduPilot, 65000, 0);
  desk.client.setTargetIds(2, 7);
  desk.pass(3000);
  CHECK_FALSE(desk.client.hasAutopilot());
  FrameParts beat = heartbeatParts(kArduPilot);
  beat.systemId = 2;
  beat.componentId = 7;
  desk.line.bring(packed(beat));
  desk.pass(20);
  CHECK(desk.client.hasAutopilot());
  CHECK(desk.client.autopilotSystemId() == 2);
  CHECK(desk.plays("clear, until CLEAR 20 ms") == "CLEAR to 2/7");
}

TEST_CASE("an update() takes what it may from the line, and a frame for us counts for more than its bytes") {
  Conversation desk(kArduPilot);
  desk.pass(10);
  CHECK(desk.readInOne(Bytes(600, 0x11)) == MAVMISSION_BYTES_PER_UPDATE);
  Bytes beats;
  FrameParts beat = heartbeatParts(kArduPilot);
  for (beat.sequence = 100; beat.sequence < 110; ++beat.sequence) beats = beats + packed(beat);
  const size_t ofBeats = desk.readInOne(beats);
  CHECK(ofBeats > MAVMISSION_BYTES_PER_UPDATE / 4);
  CHECK(ofBeats < MAVMISSION_BYTES_PER_UPDATE);
}

TEST_CASE(
    "an update() that has read many bytes leaves the check of an item to the next one, which reads half as many") {
  int reads = 0;
  Conversation desk(kArduPilot);
  desk.pass(10);
  desk.client.uploadWithoutReadback(fromFunction(readCounted, 500, &reads));
  desk.pass(2);
  const int before = reads;
  desk.line.bring(Bytes(6000, 0x11));
  const size_t bytes = desk.line.bytesRead;
  desk.pass(20);
  CHECK(reads - before == 10);
  CHECK(desk.line.bytesRead - bytes == 10 * (MAVMISSION_BYTES_PER_UPDATE + MAVMISSION_BYTES_PER_UPDATE / 2));
}
