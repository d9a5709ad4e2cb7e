// Commands by a whole client: what leaves, when it leaves again, and what each answer means.
#include <doctest/doctest.h>

#include "Conversation.h"
#include "SteeredAircraft.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = Conversation::kArduPilot, kPx4 = Conversation::kPx4;
const FlightCommand kVideo = flightCommand(2500, 1, 2, 3, 4, 5, 6, 7), kZoom = flightCommand(531, 1);
const FlightCommand kServo = flightCommand(183, 1, 1500), kStart = flightCommand(300);
const MissionItem kPlan[] = {anyCommandAt(kNavWaypoint, -35.3632621_deg, 149.1652374_deg, 20_m), returnToLaunch()};
const MissionItem kFence[] = {fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m)};

struct Ordering : Conversation {
  explicit Ordering(const FlightCommand& one = kZoom, uint8_t autopilot = kPx4, bool isArmed = false)
      : Conversation(autopilot, kPlan) {
    command = one;
    if (isArmed) plays("armed, 2 s");
  }
};

}  // namespace

TEST_CASE("each answer to a command has its status") {
  const struct {
    const char *answer, *end;
    uint8_t result;
  } kResults[] = {{"accepted", "Done", 0},
                  {"rejected", "CommandRejected", 1},
                  {"denied", "CommandDenied", 2},
                  {"unsupported", "CommandUnsupported", 3},
                  {"failed", "CommandFailed", 4},
                  {"cancelled", "CommandRefused", 6},
                  {"long only", "CommandLongOnly", 7},
                  {"frame", "CommandFrame", 9},
                  {"10", "NotInControl", 10},
                  {"11", "CommandRefused", 11},
                  {"12", "CommandRefused", 12},
                  {"255", "CommandRefused", 255}};
  for (const auto& one : kResults) {
    Ordering desk;
    const std::string answer = one.answer;
    CHECK(desk.plays("send, 10 ms | answer 2500 " + answer) == "LONG 531 1 |");  // about another command
    CHECK(desk.client.lastResult() == 255);
    CHECK(desk.plays("answer 531 " + answer) == "-> " + std::string(one.end) + " (NotKnown)");
    CHECK(desk.client.lastResult() == one.result);
  }
}

TEST_CASE("a command without a place is a COMMAND_LONG with all its parameters, and one with a place a COMMAND_INT") {
  CHECK(Ordering(kVideo).plays("send, 10 ms") == "LONG 2500 1 2 3 4 5 6 7");
  const FlightCommand placed = flightCommandAt(2500, -35.3632621_deg, 149.1652374_deg, 20_m, 1, 2, 3, 4);
  CHECK(Ordering(placed).plays("send, 10 ms | answer 2500 accepted") ==
        "INT 2500 frame 3 1 2 3 4 at -353632621 1491652374 20 | -> Done (NotKnown)");
}

TEST_CASE("what must not be carried out twice is sent once, and again only where the sketch wants that") {
  const auto ends = [](const FlightCommand& command, CommandRepeat repeat) {
    Conversation desk(kPx4);
    desk.client.send(command, repeat);
    return desk.plays("9 s");
  };
  const std::string servo = "LONG 183 1 1500", zoom = "LONG 531 1";
  const auto fiveOf = [](const std::string& one) {
    return one + ", " + one + " #1, " + one + " #2, " + one + " #3, " + one + " #4, -> NoAnswer (NotKnown)";
  };
  CHECK(ends(kServo, CommandRepeat::IfHarmless) == servo + ", -> Unconfirmed (NotKnown)");
  CHECK(ends(kServo, CommandRepeat::Always) == fiveOf(servo));
  CHECK(ends(kZoom, CommandRepeat::IfHarmless) == fiveOf(zoom));
  CHECK(ends(kZoom, CommandRepeat::Always) == fiveOf(zoom));
}

TEST_CASE("IN_PROGRESS is waited for, and the next answer counts") {
  Ordering desk;
  CHECK(desk.plays("send, 10 ms | answer 531 in progress, 4500 ms") == "LONG 531 1 |");
  CHECK(desk.client.lastResult() == 5);
  CHECK(desk.plays("answer 531 in progress, 4500 ms | answer 531 failed") == "| -> CommandFailed (NotKnown)");
  // Cancelled meanwhile it is answered later: the same one waits.
  CHECK(desk.plays("send, 1 s, answer 531 in progress, cancel, 5 ms | send, 4 s | until LONG 1500 ms") ==
        "LONG 531 1, -> Cancelled (NotKnown) | | LONG 531 1");
}

TEST_CASE("a command that takes too long ends as such, and its time begins when the autopilot is there") {
  Ordering desk;
  desk.client.setOperationTimeout(4);
  CHECK(desk.plays("send, 10 ms, 3900 ms | 200 ms") ==
        "LONG 531 1, LONG 531 1 #1, LONG 531 1 #2 | -> TookTooLong (NotKnown)");
  CHECK(desk.plays("send, 10 ms") == "LONG 531 1");
  Conversation later(kPx4, 65000, 0);
  later.client.setOperationTimeout(2);
  CHECK(later.plays("silence, send, 3500 ms | heartbeats, until LONG 4 s, 1400 ms") == "| LONG 2500");
  later.pass(500);
  CHECK(later.client.isBusy());
}

TEST_CASE("after a command that was repeated the same one waits for late answers, and another one does not") {
  const auto behind = [](const FlightCommand& next, const std::string& events) {
    Ordering desk;
    const std::string first = desk.plays("send, until LONG, until LONG 1600 ms, answer 531 accepted");
    if (first != "LONG 531 1, LONG 531 1 #1, -> Done (NotKnown)") return first;
    desk.command = next;
    return desk.plays(events);
  };
  CHECK(behind(kZoom, "send, 1500 ms, answer 531 failed | until LONG 200 ms") == "| LONG 531 1");
  // With an operation without commands between.
  CHECK(behind(kZoom, "verify, 5 ms, cancel, 100 ms | send, 1400 ms | until LONG 200 ms") ==
        "LIST, ACK cancelled, -> Cancelled (NotKnown) | | LONG 531 1");
  CHECK(behind(kZoom, "2 s | send, 10 ms") == "| LONG 531 1");       // they can come no more
  CHECK(behind(kZoom, "65036 ms | send, 10 ms") == "| LONG 531 1");  // when the clock has wrapped
  CHECK(behind(kVideo, "send, 10 ms") == "LONG 2500 1 2 3 4 5 6 7");
}

TEST_CASE("after a command that took long, and was repeated, the same one waits for late answers as well") {
  Ordering desk;
  desk.plays("send, until LONG, until LONG 1600 ms");
  for (int i = 0; i < 6; ++i) desk.plays("answer 531 in progress, 4 s");
  CHECK(desk.plays("answer 531 accepted | send, 1500 ms") == "-> Done (NotKnown) |");
}

TEST_CASE("what an operation without commands has left does not delay a command for longer than an answer takes") {
  const std::string before = "send, until LONG, until LONG 1600 ms, answer 531 accepted, verify, 5 ms, cancel, ";
  Ordering soon, later;
  soon.plays(before + "19900 ms");
  CHECK(soon.plays("send, 10 ms | until LONG 1600 ms") == "| LONG 531 1");
  later.plays(before + "20100 ms");
  CHECK(later.plays("send, 10 ms") == "LONG 531 1");
}

TEST_CASE("MISSION_START is not sent where it would arm, and any other command is") {
  for (const uint8_t autopilot : {kArduPilot, kPx4}) {
    for (const bool isArmed : {false, true}) {
      Ordering desk(kStart, autopilot, isArmed);
      const bool isRefused = autopilot == kPx4 && !isArmed;
      CHECK(desk.plays("send, 20 ms") == (isRefused ? "-> NotArmed (NotKnown)" : "LONG 300"));
      for (const Status status : desk.returned) CHECK((status != Status::Transferring || !isRefused));
      desk.command = kZoom;
      desk.plays("cancel, 5 ms");
      CHECK(desk.plays("send, 20 ms") == "LONG 531 1");
    }
  }
  // One that was sent to an armed PX4 is not repeated when a heartbeat shows it disarmed.
  CHECK(Ordering(kStart, kPx4, true).plays("send, 20 ms | disarmed, 50 ms") == "LONG 300 | -> NotArmed (NotKnown)");
}

TEST_CASE("what takes, arms or starts leaves, and leaves again, after a heartbeat that shows no reason against it") {
  for (const FlightCommand& one : {flightCommand(22), flightCommand(176, 1, 4), flightCommand(209, 1)}) {
    Ordering still(one, kArduPilot, true), desk(one, kArduPilot, true);
    still.beatsWhenAsked = false;
    still.client.send(one, CommandRepeat::Always);
    CHECK(still.plays("silence, 900 ms") == "BEAT? x9");
    desk.client.send(one, CommandRepeat::Always);
    desk.plays("until LONG 20 ms, until LONG 1600 ms");
    CHECK(desk.timesOf(76, 0).size() >= 2);
    CHECK(desk.plays("disarmed, 6020 ms") == "-> Unconfirmed (NotKnown)");  // somebody has disarmed it
  }
}

TEST_CASE("arming by send() is not forced, and nothing else of a command is changed") {
  Ordering desk(flightCommand(400, 1, 21196, 3));
  CHECK(desk.plays("send, 20 ms | answer 400 accepted") == "LONG 400 1 0 3 | -> Done (NotKnown)");
  desk.command = flightCommand(2500, 1, 21196, 3);
  CHECK(desk.plays("send, 10 ms") == "LONG 2500 1 21196 3");
}

TEST_CASE("arm() and disarm() are done when a heartbeat shows it, which is asked for after the acceptance") {
  for (const bool arms : {true, false}) {
    Ordering desk(kZoom, kArduPilot, !arms);
    const std::string before = arms ? "disarmed" : "armed", after = arms ? "armed" : "disarmed";
    CHECK(desk.plays(arms ? "arm, until LONG 20 ms" : "disarm, until LONG 20 ms") ==
          (arms ? "LONG 400 1" : "LONG 400"));
    desk.plays("silence");
    desk.beatsWhenAsked = false;
    CHECK(desk.plays(before + ", 10 ms | answer 400 accepted, 5 ms") == "| BEAT?");
    CHECK(desk.plays(before + ", 85 ms | 20 ms") == "| BEAT?");  // from before
    CHECK(desk.plays(after) == "-> Done (NotKnown)");
    CHECK(desk.client.isArmed() == arms);
  }
}

TEST_CASE("a heartbeat that shows it is enough where the answer was lost, and is not before anything has left") {
  Ordering desk(kZoom, kArduPilot);
  CHECK(desk.plays("full, 300 ms, arm, 20 ms, armed, 20 ms") == "");
  CHECK(desk.client.isBusy());
  CHECK(desk.plays("free, until LONG 50 ms, armed") == "LONG 400 1, -> Done (NotKnown)");
}

TEST_CASE("arming that nobody answers, or that is accepted and never shown, leaves once on a line that loses nothing") {
  for (const std::string answer : {"", "answer 400 accepted, "}) {
    CHECK(Ordering(kZoom, kArduPilot).plays("arm, until LONG 20 ms, " + answer + "20 s") ==
          "LONG 400 1, -> Unconfirmed (NotKnown)");
  }
  CHECK(Ordering(kZoom, kArduPilot).plays("lost, arm, until LONG 1200 ms, until LONG 1 s") ==
        "LONG 400 1, LONG 400 1 #1");
}

TEST_CASE("arm() ends when somebody has disarmed the aircraft meanwhile, and a refusal of it is the status") {
  Ordering armed(kZoom, kArduPilot, true);
  armed.beatsWhenAsked = false;
  CHECK(armed.plays("arm, until BEAT? 20 ms, disarmed, 20 ms") == "BEAT?, -> NotArmed (NotKnown)");
  CHECK(Ordering(kZoom, kArduPilot).plays("arm, until LONG 20 ms, answer 400 failed") ==
        "LONG 400 1, -> CommandFailed (NotKnown)");
}

TEST_CASE("nothing leaves before a heartbeat that is new, and no order that has waited for its autopilot for 10 s") {
  Ordering desk, alone(kZoom, kArduPilot), several(kZoom, kArduPilot);
  desk.beatsBySecond = desk.beatsWhenAsked = false;
  desk.run(1500, 1500);  // loop() stands still
  CHECK(desk.plays("send, 20 ms | beat, 20 ms") == "BEAT? | LONG 531 1");
  CHECK(alone.plays("silence, 7 s, arm, 9 s | 2 s") == "| -> NoAutopilot (NotKnown)");
  several.plays("silence, 7 s");
  several.client.setTargetIds(0);
  several.plays("arm");
  FrameParts beat = heartbeatParts(kArduPilot);
  for (int i = 0; i < 24; ++i) {
    beat.systemId = static_cast<uint8_t>(1 + i % 2);
    several.line.bring(packed(beat));
    several.pass(500);
  }
  CHECK(several.told == std::vector<Status>{Status::SeveralAutopilots});
}

TEST_CASE("of an aircraft that a pilot has taken the motors are not started, and may be stopped") {
  steered::Aircraft copter(kArduPilot);
  copter.fly(steered::kGuided);
  copter.steering.requestControl();
  copter.pass(1000);
  copter.show(steered::kLoiter);
  REQUIRE((copter.client.takenBy() == Status::PilotHasIt));
  const FlightCommand arm = flightCommand(400, 1), stop = flightCommand(400, -0.f);
  copter.client.send(arm);
  CHECK((copter.end() == Status::PilotHasIt));
  copter.client.send(stop);
  CHECK((copter.end() == Status::Done));
}

TEST_CASE("a message's interval is set with its number and the microseconds") {
  const auto set = [](uint16_t message, int32_t us) {
    Conversation desk(kPx4);
    CHECK((desk.client.setMessageInterval(message, us) == Status::WaitingForAutopilot));
    return desk.plays("10 ms, answer 511 accepted");
  };
  CHECK(set(30, 100000) == "LONG 511 30 100000, -> Done (NotKnown)");
  CHECK(set(340, -1) == "LONG 511 340 -1, -> Done (NotKnown)");
  CHECK(set(65535, 0) == "LONG 511 65535, -> Done (NotKnown)");
}

TEST_CASE("a second command is refused, and the running one keeps all that it is about") {
  Ordering desk(kVideo, kPx4, true);
  const auto refuseAll = [&] {
    CHECK((desk.client.send(kZoom) == Status::Busy));
    CHECK((desk.client.arm() == Status::Busy));
    CHECK((desk.client.setMode(FlightMode::Hold) == Status::Busy));
    CHECK((desk.client.setCustomMode(7) == Status::Busy));
    CHECK((desk.client.setCurrentItem(9) == Status::Busy));
    CHECK((desk.client.setMessageInterval(9, 9) == Status::Busy));
    CHECK((desk.client.start(9) == Status::Busy));
    CHECK((desk.client.startMission() == Status::Busy));
  };
  desk.client.setCurrentItem(3);
  refuseAll();
  CHECK(desk.plays("10 ms") == "LONG 224 3");
  refuseAll();
  CHECK(desk.plays("answer 224 accepted") == "-> Done (NotKnown)");
  desk.client.setMessageInterval(30, 1000);
  refuseAll();
  CHECK(desk.plays("10 ms | answer 511 accepted") == "LONG 511 30 1000 | -> Done (NotKnown)");
  desk.plays("send");
  refuseAll();
  CHECK(desk.plays("10 ms") == "LONG 2500 1 2 3 4 5 6 7");
}

TEST_CASE("an item is made current by the autopilot's number, if the plan that is aboard has it") {
  for (const uint8_t autopilot : {kArduPilot, kPx4}) {
    const auto order = [&](uint16_t item) { return "LONG 224 " + std::to_string(item + (autopilot == kArduPilot)); };
    Ordering desk(kZoom, autopilot);
    // Nothing is known of the plan.
    desk.client.setCurrentItem(7);
    CHECK(desk.plays("10 ms") == order(7));
    CHECK(desk.plays("answer 224 failed") == "-> CommandFailed (NotKnown)");
    desk.client.setCurrentItem(MissionClient::kNoItem);
    CHECK(desk.plays("20 ms") == "-> NoSuchItem (NotKnown)");
    desk.plays("verify, until LIST, count, items");
    desk.client.setCurrentItem(2);
    CHECK(desk.plays("20 ms") == "-> NoSuchItem at 2 (OurPlan)");
    desk.client.setCurrentItem(1);
    CHECK(desk.plays("10 ms") == order(1));
    CHECK(desk.plays("answer 224 accepted") == "-> Done (OurPlan)");
    // A fence was looked at since: its number of items says nothing.
    desk.isAbout(inRam(kFence), PlanType::Fence).plays("verify, until LIST, cancel, 5 ms");
    desk.client.setCurrentItem(2);
    CHECK(desk.plays("10 ms") == order(2));
  }
}

TEST_CASE(
    "an item that the autopilot refuses to make current is not tried by the older message, unless it is unknown") {
  for (const std::string answer : {"rejected", "denied", "failed", "unsupported"}) {
    Ordering desk;
    desk.client.setCurrentItem(0);
    desk.plays("10 ms, answer 224 " + answer);
    CHECK(desk.timesOf(41, 0).empty() == (answer != "unsupported"));
    CHECK(desk.client.isBusy() == (answer == "unsupported"));
  }
}

TEST_CASE("MISSION_CURRENT is no answer to the command, and the older message is repeated until it comes") {
  Ordering desk;
  desk.client.setCurrentItem(2);
  CHECK(desk.plays("10 ms | current 2 of 6") == "LONG 224 2 |");
  // Our heartbeat waits for room, and so does what follows: the message has not left.
  CHECK(desk.plays("full, answer 224 unsupported, current 2 of 6") == "");
  CHECK(desk.plays("free, until CURRENT 20 ms, clock, 3100 ms | current 1 of 6 | current 2 of 6") ==
        "CURRENT 2 @0 1500 3000 | | -> Done (NotKnown) @3106");
}
