// A TelemetryPause beside a client: which messages it switches off and on again, and what each answer means for that.
#include "mavmission/telemetry/TelemetryPause.h"

#include <doctest/doctest.h>
#include <string.h>

#include <string>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint8_t kAccepted = MAV_RESULT_ACCEPTED, kBusy = MAV_RESULT_TEMPORARILY_REJECTED, kDenied = MAV_RESULT_DENIED,
                  kInProgress = MAV_RESULT_IN_PROGRESS, kNone = 255;
const PausableMessage kThree[] = {{30, 100}, {24, 0}, {33, 65535}};

struct Line : ClientOnLine {
  std::string asked;     // each command that has left: the message, its interval [us], and which attempt it is
  std::string times;     // and when [ms]
  uint32_t fromMs = 0;   // since when
  uint8_t says = kNone;  // how each command is answered, `delayMs` behind it
  uint32_t delayMs = 10;
  bool requests = false;  // the peer requests the items of an upload, one after the other
  uint32_t everyMs = 1000;

  explicit Line(uint8_t autopilot) : ClientOnLine(autopilot) {
    for (MissionItem& item : plan_) item = waypoint(-35.3632621_deg, 149.1652374_deg, 20_m);
  }

  void answer(uint8_t result, uint16_t command = MAV_CMD_SET_MESSAGE_INTERVAL, uint8_t component = 191) {
    const uint8_t low = static_cast<uint8_t>(command), high = static_cast<uint8_t>(command >> 8);
    hear(FrameParts(MAVLINK_MSG_ID_COMMAND_ACK, {low, high, result, 0, 0, 0, 0, 0, 1, component},
                    MAVLINK_MSG_ID_COMMAND_ACK_CRC));
  }
  void forget() {
    asked.clear();
    times.clear();
    fromMs = nowMs();
  }
  void beginUpload() {
    requests = true;
    item_ = 0;
    client.uploadWithoutReadback(inRam(plan_));
  }
  void endUpload() {
    requests = false;
    client.cancel();
  }

 protected:
  void turn() {
    if (dueMs_ != 0 && nowMs() == dueMs_) answer(says);
    if (requests && nowMs() % everyMs == 500) hear(requestParts(item_++));
    const size_t before = sent.size();
    run(1);
    for (size_t i = before; i < sent.size(); ++i) note(sent[i]);
  }
  void note(const SentFrame& frame) {
    mavlink_command_long_t command;
    memcpy(&command, frame.payload.data(), sizeof(command));
    if (frame.messageId != MAVLINK_MSG_ID_COMMAND_LONG || command.command != MAV_CMD_SET_MESSAGE_INTERVAL) return;
    const long id = static_cast<long>(command.param1), us = static_cast<long>(command.param2);
    asked += (asked.empty() ? "" : " ") + std::to_string(id) + ":" + std::to_string(us);
    if (command.confirmation != 0) asked += "/" + std::to_string(command.confirmation);
    times += (times.empty() ? "" : " ") + std::to_string(frame.atMs - fromMs);
    if (says != kNone) dueMs_ = nowMs() + delayMs;
  }

 private:
  MissionItem plan_[50];
  uint16_t item_ = 0;
  uint32_t dueMs_ = 0;
};

struct Desk : Line {
  TelemetryPause pause;

  explicit Desk(uint8_t autopilot = kArduPilot) : Line(autopilot), pause(client) {}
  template <uint8_t N>
  explicit Desk(const PausableMessage (&messages)[N]) : Line(kArduPilot), pause(client, messages) {}

  void pass(uint32_t ms) {
    for (; ms != 0; --ms) {
      pause.update();
      turn();
    }
  }
};

// One that has restored what there was to restore, and is asked by the peer for an item.
struct Quiet : Desk {
  Quiet() : Desk(kThree) {
    says = kAccepted;
    pass(3000);
    REQUIRE(pause.isIdle());
    forget();
  }
};

}  // namespace

TEST_CASE("every interval is restored once when an autopilot is heard, each behind the answer to the one before") {
  Desk desk(kThree);
  desk.beats = false;
  desk.pass(3000);
  CHECK(desk.asked.empty());
  CHECK_FALSE(desk.pause.isIdle());
  desk.beats = true;
  desk.says = kAccepted;
  desk.forget();
  desk.pass(5000);
  CHECK(desk.asked == "30:100000 24:0 33:65535000");
  CHECK(desk.times == "2 14 26");
  CHECK(desk.pause.isIdle());
  CHECK_FALSE(desk.pause.isPaused());
}

TEST_CASE("without a list of the sketch's own it is ArduPilot's, or PX4's, which is that of others, too") {
  const struct {
    uint8_t autopilot;
    const char* asked;
  } kLists[] = {
      {ClientOnLine::kArduPilot,
       "65:0 24:0 147:0 1:0 27:0 163:0 30:0 33:0 178:0 116:0 62:0 129:0 193:0 136:0 241:0 74:0 29:0 137:0 36:0 32:0"},
      {ClientOnLine::kPx4, "30:0 31:0 24:0 33:0 74:0 85:0 83:0 12901:0 1:0 36:0 141:0 32:0 12904:0 8:0 242:0"},
      {ClientOnLine::kOther, "30:0 31:0 24:0 33:0 74:0 85:0 83:0 12901:0 1:0 36:0 141:0 32:0 12904:0 8:0 242:0"},
  };
  for (const auto& list : kLists) {
    Desk desk(list.autopilot);
    desk.says = kAccepted;
    desk.pass(5000);
    CHECK(desk.asked == list.asked);
    CHECK(desk.pause.isIdle());
  }
}

TEST_CASE("messages that a transfer or a command needs are never switched off, nor on") {
  const PausableMessage kNeeded[] = {{0, 1},  {51, 1}, {73, 1}, {75, 1}, {76, 1}, {77, 1},  {253, 1},
                                     {38, 1}, {39, 1}, {40, 1}, {41, 1}, {42, 1}, {43, 1},  {44, 1},
                                     {45, 1}, {46, 1}, {47, 1}, {37, 1}, {36, 2}, {48, 2},  {50, 2},
                                     {52, 2}, {72, 2}, {74, 2}, {78, 2}, {1, 2},  {252, 2}, {254, 2}};
  Desk desk(kNeeded);
  desk.says = kAccepted;
  desk.pass(3000);
  CHECK(desk.asked == "36:2000 48:2000 50:2000 52:2000 72:2000 74:2000 78:2000 1:2000 252:2000 254:2000");
  CHECK(desk.pause.isIdle());
  desk.forget();
  desk.beginUpload();
  desk.pass(3000);
  CHECK(desk.asked == "36:-1 48:-1 50:-1 52:-1 72:-1 74:-1 78:-1 1:-1 252:-1 254:-1");
  CHECK(desk.pause.isPaused());
  const PausableMessage kAllNeeded[] = {{0, 1}, {47, 1}};
  Desk none(kAllNeeded);
  none.pass(3000);
  CHECK(none.asked.empty());
  CHECK(none.pause.isIdle());
}

TEST_CASE("a list may have 32 messages") {
  PausableMessage messages[32];
  std::string on, off;
  for (uint8_t i = 0; i < 32; ++i) {
    messages[i] = PausableMessage{static_cast<uint16_t>(300 + i), 3};
    on += (i == 0 ? "" : " ") + std::to_string(300 + i) + ":3000";
    off += (i == 0 ? "" : " ") + std::to_string(300 + i) + ":-1";
  }
  Desk desk(messages);
  desk.says = kAccepted;
  desk.pass(3000);
  CHECK(desk.asked == on);
  CHECK(desk.pause.isIdle());
  desk.forget();
  desk.beginUpload();
  desk.pass(3000);
  CHECK(desk.asked == off);
  CHECK(desk.pause.isPaused());
  desk.forget();
  desk.endUpload();
  desk.pass(3000);
  CHECK(desk.asked == on);
}

TEST_CASE("while the items of a plan are transferred the messages are off, and then they are on again") {
  Quiet desk;
  desk.beginUpload();
  desk.pass(58);
  CHECK_FALSE(desk.pause.isPaused());
  CHECK_FALSE(desk.pause.isIdle());
  desk.pass(3000);
  CHECK(desk.asked == "30:-1 24:-1 33:-1");
  CHECK(desk.pause.isPaused());
  CHECK_FALSE(desk.pause.isIdle());
  desk.forget();
  desk.endUpload();
  desk.pass(2);
  CHECK_FALSE(desk.pause.isPaused());
  desk.pass(5000);
  CHECK(desk.asked == "30:100000 24:0 33:65535000");
  CHECK(desk.pause.isIdle());
}

TEST_CASE("what has no items is no transfer: a command, or the clearing of a plan") {
  Quiet desk;
  desk.client.arm();
  desk.pass(3000);
  REQUIRE((desk.client.status() == Status::Transferring));
  desk.client.cancel();
  desk.pass(2000);
  desk.client.clear();
  desk.pass(3000);
  REQUIRE((desk.client.status() == Status::Transferring));
  CHECK(desk.asked.empty());
  CHECK(desk.pause.isIdle());
  CHECK_FALSE(desk.pause.isPaused());
}

TEST_CASE("a transfer that ends early restores what was switched off so far, and nothing else") {
  Quiet desk;
  desk.delayMs = 1000;
  desk.beginUpload();
  desk.pass(1500);
  CHECK(desk.asked == "30:-1 24:-1");
  desk.endUpload();
  desk.pass(10000);
  CHECK(desk.asked == "30:-1 24:-1 30:100000 24:0");
  CHECK(desk.pause.isIdle());
}

TEST_CASE("a transfer that begins while intervals are restored switches all messages off") {
  Desk desk(kThree);
  desk.says = kAccepted;
  desk.delayMs = 1000;
  desk.pass(1500);
  CHECK(desk.asked == "30:100000 24:0");
  desk.beginUpload();
  desk.pass(5000);
  CHECK(desk.asked == "30:100000 24:0 30:-1 24:-1 33:-1");
  desk.endUpload();
  desk.pass(5000);
  CHECK(desk.asked == "30:100000 24:0 30:-1 24:-1 33:-1 30:100000 24:0 33:65535000");
}

TEST_CASE("a command without an answer is repeated every 1.5 s, 5 times, before the next message's") {
  Quiet desk;
  desk.says = kNone;
  desk.beginUpload();
  desk.pass(9000);
  CHECK(desk.asked == "30:-1 30:-1/1 30:-1/2 30:-1/3 30:-1/4 24:-1");
  CHECK(desk.times == "55 1555 3055 4555 6055 7555");
  CHECK_FALSE(desk.pause.isPaused());
  desk.pass(20000);
  CHECK(desk.pause.isPaused());  // nobody has said that they are off; no more can be done
}

TEST_CASE("an interval is restored until that is confirmed, one message behind the other, again and again") {
  Desk desk(kThree);
  desk.pass(3 * 7500 + 1600);
  CHECK(desk.asked ==
        "30:100000 30:100000/1 30:100000/2 30:100000/3 30:100000/4 24:0 24:0/1 24:0/2 24:0/3 24:0/4 "
        "33:65535000 33:65535000/1 33:65535000/2 33:65535000/3 33:65535000/4 30:100000 30:100000/1");
  CHECK_FALSE(desk.pause.isIdle());
  desk.forget();
  desk.answer(kAccepted);
  desk.pass(1490);
  CHECK(desk.asked.empty());  // the first attempt may be answered as well
  desk.pass(100);
  CHECK(desk.asked == "24:0");
  desk.says = kAccepted;
  desk.answer(kAccepted);
  desk.pass(3000);
  CHECK(desk.asked == "24:0 33:65535000");
  CHECK(desk.pause.isIdle());
}

TEST_CASE("late answers do not confirm another message's command") {
  Desk desk(kThree);
  desk.pass(2000);
  REQUIRE(desk.asked == "30:100000 30:100000/1");
  desk.forget();
  desk.answer(kAccepted);
  desk.pass(700);
  desk.answer(kAccepted);  // the second one of the two
  desk.pass(700);
  CHECK(desk.asked.empty());
  desk.pass(200);
  CHECK(desk.asked == "24:0");
  CHECK(desk.times == "1502");
  desk.pass(10000);
  CHECK(desk.asked.substr(0, 31) == "24:0 24:0/1 24:0/2 24:0/3 24:0/");
}

TEST_CASE("a refusal to restore ends it: the autopilot has no such message. One to switch off does, too") {
  Desk desk(kThree);
  desk.says = kDenied;
  desk.pass(3000);
  CHECK(desk.asked == "30:100000 24:0 33:65535000");
  CHECK(desk.pause.isIdle());
  desk.forget();
  desk.beginUpload();
  desk.pass(3000);
  CHECK(desk.asked == "30:-1 24:-1 33:-1");
  CHECK(desk.pause.isPaused());
}

TEST_CASE("an autopilot that is busy is asked again when 1.5 s have passed since the command") {
  Desk desk(kThree);
  desk.says = kBusy;
  desk.pass(1000 - desk.nowMs() % 1000 + 4000);
  CHECK(desk.asked.substr(0, 32) == "30:100000 30:100000/1 30:100000/");
  CHECK(desk.times.size() > 10);
  const size_t first = std::stoul(desk.times), second = std::stoul(desk.times.substr(desk.times.find(' ')));
  CHECK(second - first == 1500);
}

TEST_CASE("IN_PROGRESS gives the autopilot 1.5 s more, and no answer of its own") {
  Quiet desk;
  desk.says = kInProgress;
  desk.delayMs = 1000;
  desk.beginUpload();
  desk.pass(2400);
  CHECK(desk.asked == "30:-1");
  desk.pass(200);
  CHECK(desk.asked == "30:-1 30:-1/1");
  CHECK(desk.times == "55 2557");
  desk.says = kAccepted;
  desk.pass(10000);
  CHECK(desk.pause.isPaused());
}

TEST_CASE("answers for others, or to other commands, are none") {
  Quiet desk;
  desk.says = kNone;
  desk.beginUpload();
  desk.pass(100);
  desk.answer(kAccepted, MAV_CMD_REQUEST_MESSAGE);
  desk.answer(kAccepted, MAV_CMD_SET_MESSAGE_INTERVAL, 192);
  desk.pass(100);
  CHECK(desk.asked == "30:-1");
  desk.answer(kAccepted);
  desk.pass(10);
  CHECK(desk.asked == "30:-1 24:-1");
}

TEST_CASE("nothing leaves without room to send") {
  Quiet desk;
  desk.beginUpload();
  desk.line.room = 0;
  desk.pass(50);
  CHECK(desk.asked.empty());
}

TEST_CASE("an answer to the client's own setMessageInterval() is not taken for one to the pause") {
  Desk desk(kThree);
  desk.pass(500);
  REQUIRE(desk.asked == "30:100000");
  desk.client.setMessageInterval(99, 250000);
  desk.pass(1400);
  REQUIRE(desk.asked == "30:100000 99:250000");
  desk.says = kAccepted;
  desk.answer(kAccepted);
  desk.pass(5);
  CHECK((desk.ended == Status::Done));
  desk.pass(10000);
  CHECK(desk.asked == "30:100000 99:250000 30:100000/1 24:0 33:65535000");
  CHECK(desk.pause.isIdle());
}

TEST_CASE("a message whose second command was answered last is restored 1.5 s later: another answer may come") {
  const PausableMessage kOne[] = {{30, 100}};
  Desk desk(kOne);
  desk.pass(2000);
  REQUIRE(desk.asked == "30:100000 30:100000/1");
  desk.answer(kAccepted);
  desk.pass(1490);
  CHECK_FALSE(desk.pause.isIdle());
  desk.pass(20);
  CHECK(desk.pause.isIdle());
  desk.pass(5000);
  CHECK(desk.pause.isIdle());
  CHECK(desk.asked == "30:100000 30:100000/1");
}

TEST_CASE("what follows a command that nobody has answered counts its attempts anew") {
  Quiet desk;
  desk.says = kNone;
  desk.beginUpload();
  desk.pass(2000);
  REQUIRE(desk.asked == "30:-1 30:-1/1");
  desk.endUpload();
  desk.pass(8000);
  CHECK(desk.asked == "30:-1 30:-1/1 30:100000 30:100000/1 30:100000/2 30:100000/3 30:100000/4");
}

TEST_CASE("a command that was answered does not delay the client's own") {
  Quiet desk;
  desk.beginUpload();
  desk.pass(3000);
  desk.endUpload();
  while (!desk.pause.isIdle()) desk.pass(1);
  desk.forget();
  desk.client.setMessageInterval(99, 250000);
  desk.pass(20);
  CHECK(desk.asked == "99:250000");
}

TEST_CASE("a command that nobody has answered delays no other listener's, when 16 bits of milliseconds have passed") {
  struct Followed : Line {
    TelemetryPause pause;
    MissionFollower follower;
    Followed() : Line(kArduPilot), pause(client, kThree), follower(client) {}
    void pass(uint32_t ms, bool isFollowed) {
      for (; ms != 0; --ms) {
        if (isFollowed && nowMs() % 500 == 250) hear(FrameParts(MAVLINK_MSG_ID_MISSION_CURRENT, Bytes(6, 0), 28));
        pause.update();
        turn();
      }
    }
  } desk;
  desk.says = kAccepted;
  desk.pass(3000, true);
  desk.says = kNone;
  desk.everyMs = 2000;
  desk.beginUpload();
  while (!desk.pause.isPaused()) desk.pass(1, true);
  desk.forget();
  desk.pass(61500, true);  // the last command has left 1.5 s before
  desk.pass(1000 - desk.nowMs() % 1000, true);
  desk.forget();
  desk.pass(3500, false);
  CHECK(desk.asked == "42:1000000");
  CHECK(desk.times == "2002");
}
