// Commands by a whole client: what leaves, when it leaves again, and what each answer means.
#include <doctest/doctest.h>
#include <string.h>

#include "ClientOnLine.h"
#include "PlanFrames.h"

using namespace mavmission;

namespace {

constexpr uint16_t kCommandInt = 75, kCommandLong = 76;
constexpr uint16_t kVideo = 2500, kZoom = 531, kServo = 183, kArmId = 400, kStartId = 300, kSetInterval = 511;
constexpr uint16_t kRequestMessage = 512, kSetCurrentId = 224;
constexpr uint8_t kAccepted = 0, kUnsupported = 3, kFailed = 4, kInProgress = 5;
constexpr uint8_t kArmed = 128;  // in HEARTBEAT.base_mode
const FlightCommand kOne = flightCommand(kVideo, 1, 2, 3, 4, 5, 6, 7), kOther = flightCommand(kZoom, 1);
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), returnToLaunch()};

template <typename Value>
Value valueAt(const SentFrame& frame, size_t at) {
  Value value;
  memcpy(&value, &frame.payload[at], sizeof(value));
  return value;
}

struct Ordering : ClientOnLine {
  uint8_t kind, shown_ = 0;

  explicit Ordering(uint8_t autopilot = kPx4, uint8_t baseMode = 0) : ClientOnLine(autopilot), kind(autopilot) {
    beats = false;
    for (int second = 0; second < 3; ++second) beat(baseMode);
    sent.clear();
  }
  void beat(uint8_t baseMode = 0) {
    show(baseMode);
    run(1000);
  }
  void show(uint8_t baseMode) {
    shown_ = baseMode;
    hear(heartbeatParts(kind, baseMode));
  }
  // A second with a heartbeat each.
  void live(uint32_t ms) {
    beats = true;
    run(ms);
    beats = false;
  }
  void answer(uint16_t command, uint8_t result) {
    hear(commandAckParts(command, result));
    run(5);
  }
  // When commands with this id have left, without those that ask for a heartbeat.
  std::vector<uint32_t> times(uint16_t id, uint32_t from) const {
    std::vector<uint32_t> all;
    for (const SentFrame& frame : sent) {
      const bool isCommand = frame.messageId == kCommandLong || frame.messageId == kCommandInt;
      if (isCommand && valueAt<uint16_t>(frame, 28) == id) all.push_back(frame.atMs - from);
    }
    return all;
  }
  const SentFrame& last(uint16_t messageId) const {
    for (size_t i = sent.size(); i != 0; --i) {
      if (sent[i - 1].messageId == messageId) return sent[i - 1];
    }
    FAIL("no such frame has left");
    return sent.back();
  }
  bool leavesWithin(const FlightCommand& command, uint32_t ms) {
    sent.clear();
    ended = Status::Idle;
    client.send(command);
    return runUntilOrdered(command.id, ms);
  }
  // Until a command with this id leaves; a request for a heartbeat is answered with the one that was shown last.
  bool runUntilOrdered(uint16_t id, uint32_t limitMs) {
    const size_t before = times(id, 0).size();
    for (uint32_t at = 0; at < limitMs; ++at) {
      const size_t asked = times(kRequestMessage, 0).size();
      run(1);
      if (times(id, 0).size() != before) return true;
      if (times(kRequestMessage, 0).size() != asked) show(shown_);
    }
    return false;
  }
};

typedef std::vector<uint32_t> Times;

}  // namespace

TEST_CASE("each answer to a command has its status") {
  const struct {
    uint8_t result;
    Status status;
  } kResults[] = {{0, Status::Done},
                  {1, Status::CommandRejected},
                  {2, Status::CommandDenied},
                  {3, Status::CommandUnsupported},
                  {4, Status::CommandFailed},
                  {6, Status::CommandRefused},
                  {7, Status::CommandLongOnly},
                  {9, Status::CommandFrame},
                  {10, Status::NotInControl},
                  {11, Status::CommandRefused},
                  {12, Status::CommandRefused},
                  {255, Status::CommandRefused}};
  for (const auto& one : kResults) {
    Ordering desk;
    REQUIRE(desk.leavesWithin(kOther, 10));
    desk.answer(kVideo, one.result);  // about another command
    CHECK(desk.client.isBusy());
    CHECK(desk.client.lastResult() == 255);
    desk.answer(kZoom, one.result);
    CHECK((desk.ended == one.status));
    CHECK(desk.client.lastResult() == one.result);
    CHECK(desk.times(kZoom, 0).size() == 1);
  }
}

TEST_CASE("a command without a place is a COMMAND_LONG with all its parameters") {
  Ordering desk;
  REQUIRE(desk.leavesWithin(kOne, 10));
  const SentFrame frame = desk.last(kCommandLong);
  for (size_t i = 0; i < 7; ++i) CHECK(valueAt<float>(frame, 4 * i) == static_cast<float>(i + 1));
  CHECK(valueAt<uint16_t>(frame, 28) == kVideo);
  CHECK(frame.payload[30] == 1);
  CHECK(frame.payload[31] == 1);
  CHECK(frame.payload[32] == 0);
}

TEST_CASE("a command with a place is a COMMAND_INT") {
  const FlightCommand command = flightCommandAt(kVideo, -35.3632621_deg, 149.1652374_deg, 20_m, 1, 2, 3, 4);
  Ordering desk;
  REQUIRE(desk.leavesWithin(command, 10));
  const SentFrame frame = desk.last(kCommandInt);
  for (size_t i = 0; i < 4; ++i) CHECK(valueAt<float>(frame, 4 * i) == static_cast<float>(i + 1));
  CHECK(valueAt<int32_t>(frame, 16) == -353632621);
  CHECK(valueAt<int32_t>(frame, 20) == 1491652374);
  CHECK(valueAt<float>(frame, 24) == 20);
  CHECK(valueAt<uint16_t>(frame, 28) == kVideo);
  CHECK(frame.payload[32] == static_cast<uint8_t>(CoordinateFrame::GlobalRelative));
  CHECK(frame.payload[33] == 0);
  CHECK(frame.payload[34] == 0);
  desk.answer(kVideo, kAccepted);
  CHECK((desk.ended == Status::Done));
}

TEST_CASE("a command that is not answered leaves every 1.5 s, five times, and says how often") {
  Ordering desk;
  REQUIRE(desk.leavesWithin(kOne, 10));
  const uint32_t firstMs = desk.nowMs();
  desk.live(7400);
  CHECK(desk.client.isBusy());
  desk.live(200);
  CHECK((desk.ended == Status::NoAnswer));
  CHECK(desk.times(kVideo, firstMs) == Times{0, 1500, 3000, 4500, 6000});
  uint8_t confirmation = 0;
  for (const SentFrame& frame : desk.sent) {
    if (frame.messageId == kCommandLong) CHECK(frame.payload[32] == confirmation++);
  }
  // It has been given up: the same may leave again at once.
  CHECK(desk.leavesWithin(kOne, 10));
}

TEST_CASE("what must not be carried out twice is sent once, and again only where the sketch wants that") {
  const FlightCommand servo = flightCommand(kServo, 1, 1500);
  const struct {
    const FlightCommand& command;
    CommandRepeat repeat;
    size_t times;
    Status end;
  } kCases[] = {{servo, CommandRepeat::IfHarmless, 1, Status::Unconfirmed},
                {servo, CommandRepeat::Always, 5, Status::NoAnswer},
                {kOne, CommandRepeat::IfHarmless, 5, Status::NoAnswer},
                {kOne, CommandRepeat::Always, 5, Status::NoAnswer}};
  for (const auto& one : kCases) {
    Ordering desk;
    desk.client.send(one.command, one.repeat);
    desk.live(9000);
    CHECK(desk.times(one.command.id, 0).size() == one.times);
    CHECK((desk.ended == one.end));
  }
}

TEST_CASE("IN_PROGRESS is waited for, and the next answer counts") {
  Ordering desk;
  REQUIRE(desk.leavesWithin(kOne, 10));
  desk.answer(kVideo, kInProgress);
  CHECK(desk.client.lastResult() == kInProgress);
  desk.live(4500);
  CHECK(desk.times(kVideo, 0).size() == 1);
  desk.answer(kVideo, kInProgress);
  desk.live(4500);
  CHECK(desk.times(kVideo, 0).size() == 1);
  desk.answer(kVideo, kFailed);
  CHECK((desk.ended == Status::CommandFailed));
}

TEST_CASE("a command that is in progress when the sketch cancels it is answered later: the same one waits") {
  Ordering desk;
  REQUIRE(desk.leavesWithin(kOne, 10));
  desk.live(1000);
  desk.answer(kVideo, kInProgress);
  desk.client.cancel();
  desk.run(5);
  desk.beats = true;
  CHECK_FALSE(desk.leavesWithin(kOne, 4000));
  CHECK(desk.runUntilSent(kCommandLong, 1500));
}

TEST_CASE("a command that takes too long ends as such") {
  Ordering desk;
  desk.client.setOperationTimeout(4);
  REQUIRE(desk.leavesWithin(kOne, 10));
  desk.live(3900);
  CHECK(desk.client.isBusy());
  desk.live(200);
  CHECK((desk.ended == Status::TookTooLong));
  // It has been given up: the same may leave again at once.
  CHECK(desk.leavesWithin(kOne, 10));
}

TEST_CASE("behind a command that took long, and was repeated, the same one waits for late answers as well") {
  Ordering desk;
  REQUIRE(desk.leavesWithin(kOne, 10));
  REQUIRE(desk.runUntilSent(kCommandLong, 1600));
  for (int i = 0; i < 6; ++i) {
    desk.answer(kVideo, kInProgress);
    desk.live(4000);
  }
  desk.answer(kVideo, kAccepted);
  REQUIRE((desk.ended == Status::Done));
  CHECK_FALSE(desk.leavesWithin(kOne, 1500));
}

TEST_CASE("the time of a command begins when the autopilot is there") {
  ClientOnLine desk(ClientOnLine::kPx4);
  desk.client.setOperationTimeout(2);
  desk.beats = false;
  desk.client.send(kOne);
  desk.run(3500);
  desk.beats = true;
  REQUIRE(desk.runUntilSent(kCommandLong, 4000));
  desk.run(1900);
  CHECK(desk.client.isBusy());
}

TEST_CASE("behind a command that was repeated the same one waits for late answers, and another one does not") {
  Ordering desk;
  REQUIRE(desk.leavesWithin(kOne, 10));
  REQUIRE(desk.runUntilSent(kCommandLong, 1600));
  desk.answer(kVideo, kAccepted);
  REQUIRE((desk.ended == Status::Done));
  SUBCASE("the same") {
    CHECK_FALSE(desk.leavesWithin(kOne, 1500));
    desk.answer(kVideo, kFailed);  // late
    CHECK(desk.client.isBusy());
    CHECK(desk.runUntilSent(kCommandLong, 200));
  }
  SUBCASE("the same, with an operation without commands between") {
    desk.client.verify(inRam(kPlan));
    desk.run(5);
    desk.client.cancel();
    desk.run(100);
    CHECK_FALSE(desk.leavesWithin(kOne, 1400));
    CHECK(desk.runUntilSent(kCommandLong, 200));
  }
  SUBCASE("the same, when they can come no more") {
    desk.live(2000);
    CHECK(desk.leavesWithin(kOne, 10));
  }
  SUBCASE("the same, when the clock has wrapped") {
    desk.live(65536 - 500);
    CHECK(desk.leavesWithin(kOne, 10));
  }
  SUBCASE("another one") { CHECK(desk.leavesWithin(kOther, 10)); }
}

TEST_CASE("behind a command that was answered at once the same one leaves at once") {
  Ordering desk;
  REQUIRE(desk.leavesWithin(kOne, 10));
  desk.answer(kVideo, kAccepted);
  CHECK(desk.leavesWithin(kOne, 10));
  desk.answer(kVideo, kAccepted);
  CHECK((desk.ended == Status::Done));
}

TEST_CASE("behind a command that was cancelled the same one waits for its answer") {
  Ordering desk;
  REQUIRE(desk.leavesWithin(kOne, 10));
  desk.client.cancel();
  desk.run(5);
  CHECK_FALSE(desk.leavesWithin(kOne, 1400));
  CHECK(desk.runUntilSent(kCommandLong, 200));
}

TEST_CASE("what an operation without commands has left does not delay a command for longer than an answer takes") {
  for (const uint32_t pauseMs : {19900, 20100}) {
    Ordering desk;
    REQUIRE(desk.leavesWithin(kOne, 10));
    REQUIRE(desk.runUntilSent(kCommandLong, 1600));
    desk.answer(kVideo, kAccepted);
    desk.client.verify(inRam(kPlan));
    desk.run(5);
    desk.client.cancel();
    desk.live(pauseMs);
    CHECK(desk.leavesWithin(kOne, 10) == (pauseMs > 20000));
    if (pauseMs < 20000) CHECK(desk.runUntilSent(kCommandLong, 1600));
  }
}

TEST_CASE("MISSION_START is not sent where it would arm, and any other command is") {
  const FlightCommand start = flightCommand(kStartId);
  for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    for (const uint8_t baseMode : {uint8_t{0}, kArmed}) {
      Ordering desk(autopilot, baseMode);
      const bool isRefused = autopilot == ClientOnLine::kPx4 && baseMode == 0;
      CHECK(desk.leavesWithin(start, 20) != isRefused);
      CHECK((desk.client.status() == (isRefused ? Status::NotArmed : Status::Transferring)));
      for (const Status status : desk.returned) CHECK((status != Status::Transferring || !isRefused));
      desk.client.cancel();
      desk.run(5);
      CHECK(desk.leavesWithin(kOther, 20));
    }
  }
}

TEST_CASE("MISSION_START that was sent to an armed PX4 is not repeated when a heartbeat shows it disarmed") {
  const FlightCommand start = flightCommand(kStartId);
  Ordering desk(ClientOnLine::kPx4, kArmed);
  REQUIRE(desk.leavesWithin(start, 20));
  desk.show(0);
  desk.run(50);
  CHECK((desk.ended == Status::NotArmed));
  CHECK(desk.times(kStartId, 0).size() == 1);
}

TEST_CASE("what takes, arms or starts leaves, and leaves again, behind a heartbeat that shows no reason against it") {
  const FlightCommand takeoff = flightCommand(22), guided = flightCommand(176, 1, 4), motor = flightCommand(209, 1);
  for (const FlightCommand* const one : {&takeoff, &guided, &motor}) {
    Ordering still(ClientOnLine::kArduPilot, kArmed);  // no heartbeat answers
    still.client.send(*one, CommandRepeat::Always);
    still.run(900);
    CHECK(still.times(one->id, 0).empty());
    CHECK(still.times(kRequestMessage, 0).size() > 5);
    Ordering desk(ClientOnLine::kArduPilot, kArmed);
    desk.client.send(*one, CommandRepeat::Always);
    REQUIRE(desk.runUntilOrdered(one->id, 20));
    REQUIRE(desk.runUntilOrdered(one->id, 1600));
    desk.show(0);  // somebody has disarmed it
    desk.run(20);
    CHECK_FALSE(desk.runUntilOrdered(one->id, 6000));
    CHECK((desk.client.status() == Status::Unconfirmed));
  }
}

TEST_CASE("arming by send() is not forced, and nothing else of a command is changed") {
  Ordering desk;
  const FlightCommand forced = flightCommand(kArmId, 1, 21196, 3), other = flightCommand(kVideo, 1, 21196, 3);
  REQUIRE(desk.leavesWithin(forced, 20));
  CHECK(valueAt<float>(desk.last(kCommandLong), 0) == 1);
  CHECK(valueAt<float>(desk.last(kCommandLong), 4) == 0);
  CHECK(valueAt<float>(desk.last(kCommandLong), 8) == 3);
  desk.answer(kArmId, kAccepted);
  CHECK((desk.ended == Status::Done));
  REQUIRE(desk.leavesWithin(other, 10));
  CHECK(valueAt<float>(desk.last(kCommandLong), 4) == 21196);
}

TEST_CASE("arm() and disarm() are done when a heartbeat shows it, which is asked for behind the acceptance") {
  for (const bool arms : {true, false}) {
    const uint8_t before = arms ? 0 : kArmed, after = arms ? kArmed : 0;
    Ordering desk(ClientOnLine::kArduPilot, before);
    if (arms) {
      desk.client.arm();
    } else {
      desk.client.disarm();
    }
    REQUIRE(desk.runUntilOrdered(kArmId, 20));
    const SentFrame order = desk.last(kCommandLong);
    desk.sent.clear();
    CHECK(valueAt<float>(order, 0) == (arms ? 1 : 0));
    CHECK(valueAt<float>(order, 4) == 0);
    desk.show(before);
    desk.run(10);
    CHECK(desk.times(kRequestMessage, 0).empty());
    desk.hear(commandAckParts(kArmId, kAccepted));
    REQUIRE(desk.runUntilSent(kCommandLong, 10));
    const SentFrame question = desk.last(kCommandLong);
    CHECK(valueAt<uint16_t>(question, 28) == kRequestMessage);
    CHECK(valueAt<float>(question, 0) == 0);
    CHECK(question.payload[32] == 0);
    CHECK(desk.client.isBusy());
    desk.show(before);  // from before
    desk.run(90);
    CHECK(desk.client.isBusy());
    CHECK(desk.times(kRequestMessage, 0).size() == 1);
    desk.run(20);
    CHECK(desk.times(kRequestMessage, 0).size() == 2);
    desk.show(after);
    desk.run(5);
    CHECK((desk.ended == Status::Done));
    CHECK(desk.client.isArmed() == arms);
    CHECK(desk.times(kArmId, 0).empty());
  }
}

TEST_CASE("a heartbeat that shows it is enough where the answer was lost, and is not before anything has left") {
  Ordering desk(ClientOnLine::kArduPilot);
  desk.line.room = 0;
  desk.run(1500);
  desk.client.arm();
  desk.run(20);
  desk.show(kArmed);
  desk.run(20);
  CHECK(desk.client.isBusy());
  desk.line.room = desk.line.kAlwaysRoom;
  REQUIRE(desk.runUntilOrdered(kArmId, 50));
  desk.show(kArmed);
  desk.run(5);
  CHECK((desk.ended == Status::Done));
}

TEST_CASE("arming that nobody answers, or that is accepted and never shown, leaves once on a line that loses nothing") {
  for (const bool isAccepted : {true, false}) {
    Ordering desk(ClientOnLine::kArduPilot);
    desk.client.arm();
    REQUIRE(desk.runUntilOrdered(kArmId, 20));
    if (isAccepted) desk.answer(kArmId, kAccepted);
    for (int second = 0; second < 20 && desk.client.isBusy(); ++second) desk.beat(0);
    CHECK((desk.ended == Status::Unconfirmed));
    CHECK(desk.times(kArmId, 0).size() == 1);
  }
  Ordering lossy(ClientOnLine::kArduPilot);
  lossy.lose(1);
  lossy.client.arm();
  REQUIRE(lossy.runUntilOrdered(kArmId, 1200));
  CHECK(lossy.runUntilOrdered(kArmId, 1000));
}

TEST_CASE("arm() ends when somebody has disarmed the aircraft meanwhile") {
  Ordering desk(ClientOnLine::kArduPilot, kArmed);
  desk.client.arm();
  REQUIRE(desk.runUntilSent(kCommandLong, 20));
  desk.show(0);
  desk.run(20);
  CHECK((desk.ended == Status::NotArmed));
  CHECK(desk.times(kArmId, 0).empty());
}

TEST_CASE("a refusal of arming is the status") {
  Ordering desk(ClientOnLine::kArduPilot);
  desk.client.arm();
  REQUIRE(desk.runUntilOrdered(kArmId, 20));
  desk.answer(kArmId, kFailed);
  CHECK((desk.ended == Status::CommandFailed));
}

TEST_CASE("a message's interval is set with its number and the microseconds") {
  const struct {
    uint16_t message;
    int32_t us;
  } kIntervals[] = {{30, 100000}, {340, -1}, {65535, 0}};
  for (const auto& one : kIntervals) {
    Ordering desk;
    CHECK((desk.client.setMessageInterval(one.message, one.us) == Status::WaitingForAutopilot));
    REQUIRE(desk.runUntilSent(kCommandLong, 10));
    CHECK(valueAt<uint16_t>(desk.last(kCommandLong), 28) == kSetInterval);
    CHECK(valueAt<float>(desk.last(kCommandLong), 0) == one.message);
    CHECK(valueAt<float>(desk.last(kCommandLong), 4) == static_cast<float>(one.us));
    desk.answer(kSetInterval, kAccepted);
    CHECK((desk.ended == Status::Done));
  }
}

TEST_CASE("a second command is refused, and the running one keeps all that it is about") {
  Ordering desk(ClientOnLine::kPx4, kArmed);
  desk.client.setCurrentItem(3);
  const auto refuseAll = [&] {
    CHECK((desk.client.send(kOther) == Status::Busy));
    CHECK((desk.client.arm() == Status::Busy));
    CHECK((desk.client.setMode(FlightMode::Hold) == Status::Busy));
    CHECK((desk.client.setCustomMode(7) == Status::Busy));
    CHECK((desk.client.setCurrentItem(9) == Status::Busy));
    CHECK((desk.client.setMessageInterval(9, 9) == Status::Busy));
    CHECK((desk.client.start(9) == Status::Busy));
    CHECK((desk.client.startMission() == Status::Busy));
  };
  refuseAll();
  REQUIRE(desk.runUntilSent(kCommandLong, 10));
  CHECK(valueAt<float>(desk.last(kCommandLong), 0) == 3);
  refuseAll();
  desk.answer(kSetCurrentId, kAccepted);
  desk.client.setMessageInterval(30, 1000);
  refuseAll();
  REQUIRE(desk.runUntilSent(kCommandLong, 10));
  CHECK(valueAt<float>(desk.last(kCommandLong), 0) == 30);
  CHECK(valueAt<float>(desk.last(kCommandLong), 4) == 1000);
  desk.answer(kSetInterval, kAccepted);
  desk.sent.clear();
  desk.client.send(kOne);
  refuseAll();
  REQUIRE(desk.runUntilSent(kCommandLong, 10));
  CHECK(valueAt<uint16_t>(desk.last(kCommandLong), 28) == kVideo);
}

namespace {

// The plan, or a fence behind it, is aboard.
void accept(Ordering& desk, PlanType type = PlanType::Mission) {
  const MissionItem fence[] = {fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m)};
  desk.beats = true;
  desk.client.verify(type == PlanType::Mission ? inRam(kPlan) : inRam(fence), type);
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  if (type == PlanType::Fence) return desk.client.cancel();
  const uint16_t home = desk.kind == ClientOnLine::kArduPilot ? 1 : 0;
  desk.hear(countParts(static_cast<uint16_t>(2 + home)));
  desk.run(5);
  if (home != 0) desk.hear(itemParts(0, homeItem()));
  desk.run(5);
  for (uint16_t item = 0; item < 2; ++item) {
    MissionItem given = kPlan[item];
    if (home != 0 && given.param4 != given.param4) given.param4 = 0;
    desk.hear(itemParts(static_cast<uint16_t>(item + home), given));
    desk.run(5);
  }
  REQUIRE((desk.client.aboard() == Aboard::OurPlan));
}

}  // namespace

TEST_CASE("an item is made current by the autopilot's number, if the plan that is aboard has it") {
  for (const uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    const uint16_t home = autopilot == ClientOnLine::kArduPilot ? 1 : 0;
    Ordering desk(autopilot);
    // Nothing is known of the plan.
    desk.client.setCurrentItem(7);
    REQUIRE(desk.runUntilSent(kCommandLong, 10));
    CHECK(valueAt<uint16_t>(desk.last(kCommandLong), 28) == kSetCurrentId);
    CHECK(valueAt<float>(desk.last(kCommandLong), 0) == 7 + home);
    desk.answer(kSetCurrentId, kFailed);
    CHECK((desk.ended == Status::CommandFailed));
    CHECK((desk.client.failedItem() == MissionClient::kNoItem));
    desk.client.setCurrentItem(MissionClient::kNoItem);
    desk.run(20);
    CHECK((desk.ended == Status::NoSuchItem));
    accept(desk);
    desk.ended = Status::Idle;
    desk.sent.clear();
    desk.client.setCurrentItem(2);
    desk.run(20);
    CHECK((desk.ended == Status::NoSuchItem));
    CHECK(desk.client.failedItem() == 2);
    CHECK(desk.times(kSetCurrentId, 0).empty());
    desk.client.setCurrentItem(1);
    REQUIRE(desk.runUntilSent(kCommandLong, 10));
    CHECK(valueAt<float>(desk.last(kCommandLong), 0) == 1 + home);
    desk.answer(kSetCurrentId, kAccepted);
    CHECK((desk.ended == Status::Done));
    // A fence was looked at since: its number of items says nothing.
    accept(desk, PlanType::Fence);
    desk.sent.clear();
    desk.client.setCurrentItem(2);
    CHECK(desk.runUntilSent(kCommandLong, 10));
  }
}

TEST_CASE(
    "an item that the autopilot refuses to make current is not tried by the older message, unless it is unknown") {
  for (const uint8_t result : {uint8_t{1}, uint8_t{2}, kUnsupported, kFailed}) {
    Ordering desk;
    desk.client.setCurrentItem(0);
    REQUIRE(desk.runUntilSent(kCommandLong, 10));
    desk.answer(kSetCurrentId, result);
    CHECK(desk.timesOf(41, 0).empty() == (result != kUnsupported));
    CHECK(desk.client.isBusy() == (result == kUnsupported));
  }
}

TEST_CASE("MISSION_CURRENT is no answer to the command, and the older message is repeated until it comes") {
  Ordering desk;
  desk.client.setCurrentItem(2);
  REQUIRE(desk.runUntilSent(kCommandLong, 10));
  const FrameParts current(42, {2, 0, 6, 0, 3}, 28), wrong(42, {1, 0, 6, 0, 3}, 28);
  desk.hear(current);
  desk.run(5);
  CHECK(desk.client.isBusy());
  desk.line.room = 0;
  desk.run(1200);  // our heartbeat waits for room, and so does what follows
  desk.answer(kSetCurrentId, kUnsupported);
  desk.hear(current);  // the message has not left
  desk.run(5);
  CHECK(desk.client.isBusy());
  desk.line.room = desk.line.kAlwaysRoom;
  REQUIRE(desk.runUntilSent(41, 20));
  const uint32_t firstMs = desk.nowMs();
  desk.live(3100);
  CHECK(desk.timesOf(41, firstMs) == Times{0, 1500, 3000});
  desk.hear(wrong);
  desk.run(5);
  CHECK(desk.client.isBusy());
  desk.hear(current);
  desk.run(5);
  CHECK((desk.ended == Status::Done));
}
