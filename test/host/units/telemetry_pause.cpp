// A TelemetryPause beside a client: which messages it switches off and on again, and what each answer means for that.
#include "mavmission/telemetry/TelemetryPause.h"

#include <doctest/doctest.h>
#include <string>

#include "PlanFrames.h"
#include "Script.h"
#include "ToldClient.h"

using namespace mavmission;

namespace {

const PausableMessage kThree[] = {{30, 100}, {24, 0}, {33, 65535}};

struct Desk : ToldClient {
  TelemetryPause pause;

  explicit Desk(uint8_t autopilot = kArduPilot) : ToldClient(autopilot), pause(client) { fillPlan(); }
  template <uint8_t N>
  explicit Desk(const PausableMessage (&messages)[N]) : ToldClient(kArduPilot), pause(client, messages) {
    fillPlan();
  }

  // The commands that leave, each as "55 30:-1/1": 55 ms after the one before or the beginning of the script, message
  // 30, its interval in us, and which repeat it is; then "paused" or "idle". When this happens:
  // wait N: N ms pass; answers X, N ms: each command is answered so from now on
  // accepted, for others, to another: such an answer comes, to that command, for another component, to another command
  // upload: the client begins one, and an item is requested each second; end: it ends; own: the client's own command
  std::string plays(const std::string& script) {
    said_ = Transcript();
    spokeMs_ = nowMs();
    for (const Event& event : eventsOf(script)) happens(event);
    const std::string said = said_.text(), state = pause.isPaused() ? "paused" : pause.isIdle() ? "idle" : "";
    return said + (said.empty() || state.empty() ? "" : ", ") + state;
  }
  // The same without the times.
  std::string asks(const std::string& script) {
    hasTimes_ = false;
    const std::string said = plays(script);
    hasTimes_ = true;
    return said;
  }
  void pass(uint32_t ms) {
    for (; ms != 0; --ms) {
      pause.update();
      if (dueMs_ != 0 && nowMs() == dueMs_) answer(resultOf(answers_));
      if (isAsked_ && nowMs() % askEachMs == 500) hear(requestParts(item_++));
      if (isFollowed && nowMs() % 500 == 250) hear(messageParts("MISSION_CURRENT"));
      const size_t before = sent.size();
      run(1);
      for (size_t i = before; i < sent.size(); ++i) note(sent[i]);
    }
  }

  bool isFollowed = false;  // whether the peer tells its current item
  uint32_t askEachMs = 1000;

 private:
  MissionItem plan_[50];
  Transcript said_;
  uint32_t spokeMs_ = 0, dueMs_ = 0, delayMs_ = 10;
  bool hasTimes_ = true, isAsked_ = false;
  uint16_t item_ = 0;
  std::string answers_ = "nothing";

  void fillPlan() {
    for (MissionItem& item : plan_) item = waypoint(-35.3632621_deg, 149.1652374_deg, 20_m);
  }
  static uint8_t resultOf(const std::string& word) {
    if (word == "accepted") return MAV_RESULT_ACCEPTED;
    if (word == "busy") return MAV_RESULT_TEMPORARILY_REJECTED;
    if (word == "denied") return MAV_RESULT_DENIED;
    REQUIRE(word == "in progress");
    return MAV_RESULT_IN_PROGRESS;
  }
  void answer(uint8_t result) { hear(commandAckParts(MAV_CMD_SET_MESSAGE_INTERVAL, result)); }
  void happens(const Event& event) {
    if (event.is("wait")) {
      pass(event.number);
    } else if (event.known(event.first() == "answers")) {
      answers_ = event.what.substr(8);
      if (event.number != 0) delayMs_ = event.number;
    } else if (event.is("to another")) {
      hear(commandAckParts(MAV_CMD_REQUEST_MESSAGE, MAV_RESULT_ACCEPTED));
    } else if (event.is("for others")) {
      hear(messageParts("COMMAND_ACK command 511 target_system 1 target_component 192"));
    } else if (event.is("upload")) {
      isAsked_ = true;
      item_ = 0;
      client.uploadWithoutReadback(inRam(plan_));
    } else if (event.is("end")) {
      isAsked_ = false;
      client.cancel();
    } else if (event.is("own")) {
      client.setMessageInterval(99, 250000);
    } else {
      event.known(true);  // or it is none
      answer(resultOf(event.what));
    }
  }
  void note(const SentFrame& frame) {
    const auto command = messageIn<mavlink_command_long_t>(frame.payload);
    if (frame.messageId != MAVLINK_MSG_ID_COMMAND_LONG || command.command != MAV_CMD_SET_MESSAGE_INTERVAL) return;
    const long id = static_cast<long>(command.param1), us = static_cast<long>(command.param2);
    std::string asked = std::to_string(id) + ":" + std::to_string(us);
    if (command.confirmation != 0) asked += "/" + std::to_string(command.confirmation);
    said_.note(asked, hasTimes_ ? frame.atMs - spokeMs_ : 0);
    spokeMs_ = frame.atMs;
    if (answers_ != "nothing") dueMs_ = nowMs() + delayMs_;
  }
};

// One that has restored what there was to restore.
struct Quiet : Desk {
  Quiet() : Desk(kThree) { REQUIRE(asks("answers accepted, wait 3000") == "30:100000, 24:0, 33:65535000, idle"); }
};

// Messages 300 and so on, every 3 ms or switched off.
std::string of32(const char* interval, const char* state) {
  std::string text;
  for (int i = 0; i < 32; ++i) text += std::to_string(300 + i) + interval + ", ";
  return text + state;
}

}  // namespace

TEST_CASE("every interval is restored once when an autopilot is heard, each after the answer to the one before") {
  Desk desk(kThree);
  desk.beats = false;
  CHECK(desk.plays("wait 3000") == "");
  desk.beats = true;
  CHECK(desk.plays("answers accepted, wait 5000") == "2 30:100000, 12 24:0, 12 33:65535000, idle");
}

TEST_CASE("without a list of the sketch's own it is ArduPilot's, or PX4's, which is that of others, too") {
  const char* const kPx4s =
      "30:0, 31:0, 24:0, 33:0, 74:0, 85:0, 83:0, 12901:0, 1:0, 36:0, 141:0, 32:0, 12904:0, 8:0, 242:0, idle";
  CHECK(Desk(ClientOnLine::kArduPilot).asks("answers accepted, wait 5000") ==
        "65:0, 24:0, 147:0, 1:0, 27:0, 163:0, 30:0, 33:0, 178:0, 116:0, 62:0, 129:0, 193:0, 136:0, 241:0, 74:0, 29:0, "
        "137:0, 36:0, 32:0, idle");
  CHECK(Desk(ClientOnLine::kPx4).asks("answers accepted, wait 5000") == kPx4s);
  CHECK(Desk(ClientOnLine::kOther).asks("answers accepted, wait 5000") == kPx4s);
}

TEST_CASE("messages that a transfer or a command needs are never switched off, nor on") {
  const PausableMessage kNeeded[] = {{0, 1},  {51, 1}, {73, 1}, {75, 1}, {76, 1}, {77, 1},  {253, 1},
                                     {38, 1}, {39, 1}, {40, 1}, {41, 1}, {42, 1}, {43, 1},  {44, 1},
                                     {45, 1}, {46, 1}, {47, 1}, {37, 1}, {36, 2}, {48, 2},  {50, 2},
                                     {52, 2}, {72, 2}, {74, 2}, {78, 2}, {1, 2},  {252, 2}, {254, 2}};
  Desk desk(kNeeded);
  CHECK(desk.asks("answers accepted, wait 3000") ==
        "36:2000, 48:2000, 50:2000, 52:2000, 72:2000, 74:2000, 78:2000, 1:2000, 252:2000, 254:2000, idle");
  CHECK(desk.asks("upload, wait 3000") ==
        "36:-1, 48:-1, 50:-1, 52:-1, 72:-1, 74:-1, 78:-1, 1:-1, 252:-1, 254:-1, paused");
  const PausableMessage kAllNeeded[] = {{0, 1}, {47, 1}};
  CHECK(Desk(kAllNeeded).plays("wait 3000") == "idle");
}

TEST_CASE("a list may have 32 messages") {
  PausableMessage messages[32];
  for (uint8_t i = 0; i < 32; ++i) messages[i] = PausableMessage{static_cast<uint16_t>(300 + i), 3};
  Desk desk(messages);
  CHECK(desk.asks("answers accepted, wait 3000") == of32(":3000", "idle"));
  CHECK(desk.asks("upload, wait 3000") == of32(":-1", "paused"));
  CHECK(desk.asks("end, wait 3000") == of32(":3000", "idle"));
}

TEST_CASE("an interval is restored until that is confirmed, one message after the other, again and again") {
  Desk desk(kThree);
  CHECK(desk.asks("wait 24100") ==
        "30:100000, 30:100000/1, 30:100000/2, 30:100000/3, 30:100000/4, 24:0, 24:0/1, 24:0/2, 24:0/3, 24:0/4, "
        "33:65535000, 33:65535000/1, 33:65535000/2, 33:65535000/3, 33:65535000/4, 30:100000, 30:100000/1");
  CHECK(desk.asks("accepted, wait 1490") == "");  // the first attempt may be answered as well
  CHECK(desk.asks("wait 100") == "24:0");
  CHECK(desk.asks("answers accepted, accepted, wait 3000") == "33:65535000, idle");
}

TEST_CASE("late answers do not confirm another message's command") {
  Desk desk(kThree);
  REQUIRE(desk.asks("wait 2000") == "30:100000, 30:100000/1");
  // The second answer is that of the two.
  CHECK(desk.plays("accepted, wait 700, accepted, wait 900") == "1502 24:0");
  CHECK(desk.asks("wait 10000") == "24:0/1, 24:0/2, 24:0/3, 24:0/4, 33:65535000, 33:65535000/1");
}

TEST_CASE("a refusal to restore ends it: the autopilot has no such message. One to switch off does, too") {
  Desk desk(kThree);
  CHECK(desk.asks("answers denied, wait 3000") == "30:100000, 24:0, 33:65535000, idle");
  CHECK(desk.asks("upload, wait 3000") == "30:-1, 24:-1, 33:-1, paused");
}

TEST_CASE("an autopilot that is busy is asked again when 1.5 s have passed since the command") {
  CHECK(Desk(kThree).plays("answers busy, wait 4000") == "2 30:100000, 1500 30:100000/1, 1500 30:100000/2");
}

TEST_CASE("IN_PROGRESS gives the autopilot 1.5 s more, and no answer of its own") {
  Quiet desk;
  CHECK(desk.plays("answers in progress 1000, upload, wait 2600") == "55 30:-1, 2502 30:-1/1");
  CHECK(desk.asks("answers accepted, wait 10000") == "24:-1, 33:-1, paused");
}

TEST_CASE("answers for others, or to other commands, are none") {
  Quiet desk;
  CHECK(desk.asks("answers nothing, upload, wait 100, to another, for others, wait 100") == "30:-1");
  CHECK(desk.asks("accepted, wait 10") == "24:-1");
}

TEST_CASE("a message whose second command was answered last is restored 1.5 s later: another answer may come") {
  const PausableMessage kOne[] = {{30, 100}};
  Desk desk(kOne);
  REQUIRE(desk.asks("wait 2000") == "30:100000, 30:100000/1");
  CHECK(desk.plays("accepted, wait 1490") == "");
  CHECK(desk.plays("wait 20") == "idle");
  CHECK(desk.plays("wait 5000") == "idle");
}

TEST_CASE("what follows a command that nobody has answered counts its attempts anew") {
  Quiet desk;
  REQUIRE(desk.asks("answers nothing, upload, wait 2000") == "30:-1, 30:-1/1");
  CHECK(desk.asks("end, wait 8000") == "30:100000, 30:100000/1, 30:100000/2, 30:100000/3, 30:100000/4");
}

TEST_CASE("a command that was answered does not delay the client's own") {
  Quiet desk;
  desk.plays("upload, wait 3000, end");
  while (!desk.pause.isIdle()) desk.pass(1);
  CHECK(desk.asks("own, wait 20") == "99:250000, idle");
}

TEST_CASE("a command that nobody has answered delays no other listener's, when 16 bits of milliseconds have passed") {
  Desk desk(kThree);
  MissionFollower follower(desk.client);
  desk.isFollowed = true;
  desk.askEachMs = 2000;
  desk.plays("answers accepted, wait 3000, answers nothing, upload");
  while (!desk.pause.isPaused()) desk.pass(1);
  desk.pass(61500);  // the last command has left 1.5 s before
  desk.pass(1000 - desk.nowMs() % 1000);
  desk.isFollowed = false;
  CHECK(desk.plays("wait 3500") == "2002 42:1000000, paused");
}
