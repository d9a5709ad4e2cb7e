#include "mavmission/transfer/CommandTransfer.h"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef CommandTransfer::State State;

constexpr uint16_t kArm = 400, kMode = 176;
constexpr uint16_t kBeganMs = 65000;  // it wraps soon

// One that has been sent so many times, each when it was due, and the time of the last sending.
CommandTransfer sentTimes(uint8_t times, bool repeats, uint16_t& nowMs, uint16_t id = kMode) {
  CommandTransfer transfer = CommandTransfer();
  nowMs = kBeganMs;
  transfer.next(repeats, nowMs);
  for (uint8_t i = 0; i < times; ++i) {
    if (i != 0) nowMs = static_cast<uint16_t>(nowMs + CommandTransfer::kAnswerMs);
    CHECK((transfer.onTime(nowMs) == Status::Transferring));
    REQUIRE(transfer.isDue(id, nowMs));
    transfer.sent(id, nowMs);
  }
  return transfer;
}

uint16_t later(uint16_t nowMs, uint16_t ms) { return static_cast<uint16_t>(nowMs + ms); }

}  // namespace

TEST_CASE("a command is sent every 1500 ms, five times, and then has no answer") {
  uint16_t nowMs;
  CommandTransfer transfer = sentTimes(CommandTransfer::kTries, true, nowMs);
  CHECK(transfer.tries() == 5);
  CHECK((transfer.onTime(later(nowMs, CommandTransfer::kAnswerMs - 1)) == Status::Transferring));
  CHECK_FALSE(transfer.isDue(kMode, later(nowMs, CommandTransfer::kAnswerMs - 1)));
  CHECK((transfer.onTime(later(nowMs, CommandTransfer::kAnswerMs)) == Status::NoAnswer));
}

TEST_CASE("a command that must not happen twice is sent once, and is unconfirmed after five seconds") {
  uint16_t nowMs;
  CommandTransfer transfer = sentTimes(1, false, nowMs);
  CHECK((transfer.onTime(later(nowMs, CommandTransfer::kProgressMs - 1)) == Status::Transferring));
  CHECK((transfer.onTime(later(nowMs, CommandTransfer::kProgressMs)) == Status::Unconfirmed));
}

TEST_CASE("an answer is one to the command that was sent, and not before it was sent") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(true, kBeganMs);
  CHECK_FALSE(transfer.isAnswer(kMode));
  transfer.sent(kMode, kBeganMs);
  CHECK(transfer.isAnswer(kMode));
  CHECK_FALSE(transfer.isAnswer(kArm));
  transfer.next(true, kBeganMs);
  CHECK_FALSE(transfer.isAnswer(kMode));
}

TEST_CASE("a message is answered by no COMMAND_ACK") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(true, kBeganMs);
  transfer.sent(CommandTransfer::kNoCommand, kBeganMs);
  CHECK_FALSE(transfer.isAnswer(CommandTransfer::kNoCommand));
}

TEST_CASE("progress gives five seconds more, and then it is sent again") {
  uint16_t nowMs;
  CommandTransfer transfer = sentTimes(2, true, nowMs);
  nowMs = later(nowMs, 1000);
  transfer.onProgress(nowMs);
  CHECK((transfer.state() == State::InProgress));
  CHECK((transfer.onTime(later(nowMs, 4999)) == Status::Transferring));
  CHECK_FALSE(transfer.isDue(kMode, later(nowMs, 4999)));
  CHECK((transfer.onTime(later(nowMs, 5000)) == Status::Transferring));
  CHECK(transfer.isDue(kMode, later(nowMs, 5000)));
}

TEST_CASE("behind one that was sent twice the same waits for the second answer, and another does not") {
  for (uint8_t times = 1; times <= 3; ++times) {
    uint16_t nowMs;
    CommandTransfer transfer = sentTimes(times, true, nowMs);
    transfer.next(true, nowMs);
    const uint16_t restMs = static_cast<uint16_t>((times - 1) * CommandTransfer::kNextAnswerMs);
    CHECK(transfer.isDue(kArm, nowMs));
    CHECK(transfer.isDue(kMode, nowMs) == (times == 1));
    if (times > 1) CHECK_FALSE(transfer.isDue(kMode, later(nowMs, restMs - 1)));
    CHECK(transfer.isDue(kMode, later(nowMs, restMs)));
  }
}

TEST_CASE("the next operation waits for late answers to the last command too") {
  uint16_t nowMs;
  CommandTransfer last = sentTimes(2, true, nowMs);
  last.rest(nowMs);
  CommandTransfer transfer = CommandTransfer();
  transfer.beginBehind(last);
  CHECK_FALSE(transfer.isDue(kMode, later(nowMs, CommandTransfer::kNextAnswerMs - 1)));
  CHECK(transfer.isDue(kMode, later(nowMs, CommandTransfer::kNextAnswerMs)));
  CHECK(transfer.isDue(kArm, nowMs));
}

TEST_CASE("silence leaves nothing to wait for, and nothing that could be answered") {
  uint16_t nowMs;
  CommandTransfer transfer = sentTimes(CommandTransfer::kTries, true, nowMs);
  nowMs = later(nowMs, CommandTransfer::kAnswerMs);
  CHECK((transfer.onTime(nowMs) == Status::NoAnswer));
  CHECK(transfer.tries() == 0);
  CHECK_FALSE(transfer.isAnswer(kMode));
  transfer.next(true, nowMs);
  CHECK(transfer.isDue(kMode, nowMs));
}

TEST_CASE("what listens sends nothing, and is unconfirmed in the end") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(true, kBeganMs);
  transfer.listen(7500, kBeganMs);
  CHECK_FALSE(transfer.isDue(kMode, later(kBeganMs, 7499)));
  CHECK((transfer.onTime(later(kBeganMs, 7499)) == Status::Transferring));
  CHECK((transfer.onTime(later(kBeganMs, 7500)) == Status::Unconfirmed));
}

TEST_CASE("behind a pause it is sent, with all its attempts") {
  uint16_t nowMs;
  CommandTransfer transfer = sentTimes(1, true, nowMs);
  transfer.next(true, nowMs);
  transfer.pause(1000, nowMs);
  CHECK((transfer.onTime(later(nowMs, 999)) == Status::Transferring));
  CHECK_FALSE(transfer.isDue(kMode, later(nowMs, 999)));
  nowMs = later(nowMs, 1000);
  CHECK((transfer.onTime(nowMs) == Status::Transferring));
  CHECK(transfer.isDue(kMode, nowMs));
  CHECK(transfer.tries() == 0);
}

TEST_CASE("the times and attempts are those of the guide, and what is added to them") {
  CHECK(+CommandTransfer::kTries == 5);
  CHECK(+CommandTransfer::kAnswerMs == 1500);
  CHECK(+CommandTransfer::kProgressMs == 5000);
  CHECK(+CommandTransfer::kNextAnswerMs == 1600);
  CHECK(+CommandTransfer::kLateAnswersS == 20);
  CHECK(+CommandTransfer::kNoCommand == 0);
  // Late answers to all attempts, each behind a pause for progress, have come by then.
  CHECK(CommandTransfer::kLateAnswersS * 1000u >= CommandTransfer::kTries * CommandTransfer::kNextAnswerMs);
}

TEST_CASE("late answers are waited for from the first answer on, not from the last sending") {
  uint16_t nowMs;
  CommandTransfer transfer = sentTimes(2, true, nowMs);
  nowMs = later(nowMs, 700);
  transfer.next(true, nowMs);
  CHECK_FALSE(transfer.isDue(kMode, later(nowMs, 1599)));
  CHECK(transfer.isDue(kMode, later(nowMs, 1600)));
}

TEST_CASE("what must not happen twice is sent behind a pause, and is unconfirmed when progress falls silent") {
  uint16_t nowMs;
  CommandTransfer transfer = sentTimes(1, true, nowMs);
  transfer.next(false, nowMs);
  transfer.pause(1000, nowMs);
  CHECK((transfer.state() == State::Pausing));
  nowMs = later(nowMs, 1000);
  CHECK((transfer.onTime(nowMs) == Status::Transferring));
  REQUIRE(transfer.isDue(kMode, nowMs));
  transfer.sent(kMode, nowMs);
  nowMs = later(nowMs, 3000);
  transfer.onProgress(nowMs);
  CHECK((transfer.onTime(later(nowMs, 4999)) == Status::Transferring));
  CHECK((transfer.onTime(later(nowMs, 5000)) == Status::Unconfirmed));
}

TEST_CASE("whether a command may be sent again can be said before it is sent") {
  for (const bool repeats : {false, true}) {
    CommandTransfer transfer = CommandTransfer();
    transfer.next(!repeats, kBeganMs);
    transfer.setRepeats(repeats);
    transfer.sent(kMode, kBeganMs);
    CHECK((transfer.onTime(later(kBeganMs, 1499)) == Status::Transferring));
    CHECK((transfer.onTime(later(kBeganMs, 1500)) == Status::Transferring));
    CHECK((transfer.state() == (repeats ? State::Due : State::Sent)));
    if (!repeats) CHECK((transfer.onTime(later(kBeganMs, 5000)) == Status::Unconfirmed));
  }
}

TEST_CASE("a late answer to a command that was sent twice is awaited, and none to another or behind the next") {
  uint16_t nowMs;
  CommandTransfer last = sentTimes(2, true, nowMs);
  CHECK_FALSE(last.awaitsLate(kMode, nowMs));  // it is under way
  last.rest(nowMs);
  CHECK(last.awaitsLate(kMode, later(nowMs, CommandTransfer::kNextAnswerMs - 1)));
  CHECK_FALSE(last.awaitsLate(kMode, later(nowMs, CommandTransfer::kNextAnswerMs)));
  CHECK_FALSE(last.awaitsLate(kArm, nowMs));
}

TEST_CASE("on a line that loses a command is sent again sooner, up to 100 attempts") {
  CommandTransfer transfer = CommandTransfer();
  uint16_t nowMs = kBeganMs;
  transfer.next(true, nowMs);
  for (int sent = 1; sent <= 100; ++sent) {
    REQUIRE(transfer.isDue(kMode, nowMs));
    transfer.sent(kMode, nowMs, 80);
    nowMs = later(nowMs, 79);
    CHECK((transfer.onTime(nowMs) == Status::Transferring));
    CHECK_FALSE(transfer.isDue(kMode, nowMs));
    nowMs = later(nowMs, 1);
    CHECK((transfer.onTime(nowMs) == (sent == 100 ? Status::NoAnswer : Status::Transferring)));
  }
}

TEST_CASE("on a line that loses a command that must not happen twice is sent once") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(false, kBeganMs);
  transfer.sent(kArm, kBeganMs, 80);
  CHECK((transfer.onTime(later(kBeganMs, CommandTransfer::kProgressMs - 1)) == Status::Transferring));
  CHECK_FALSE(transfer.isDue(kArm, later(kBeganMs, CommandTransfer::kProgressMs - 1)));
  CHECK((transfer.onTime(later(kBeganMs, CommandTransfer::kProgressMs)) == Status::Unconfirmed));
}

TEST_CASE("on a line that loses an accepted command is sent again after 1500 ms, up to 4 more times") {
  CommandTransfer transfer = CommandTransfer();
  uint16_t nowMs = kBeganMs;
  transfer.next(true, nowMs);
  for (int sent = 0; sent < 30; ++sent) transfer.sent(kMode, nowMs, 80);
  transfer.onAccepted();
  for (int sent = 1; sent <= 4; ++sent) {
    nowMs = later(nowMs, CommandTransfer::kAnswerMs - 1);
    CHECK((transfer.onTime(nowMs) == Status::Transferring));
    CHECK_FALSE(transfer.isDue(kMode, nowMs));
    nowMs = later(nowMs, 1);
    CHECK((transfer.onTime(nowMs) == (sent == 4 ? Status::NoAnswer : Status::Transferring)));
    transfer.sent(kMode, nowMs, CommandTransfer::kAnswerMs);
  }
}

TEST_CASE("on a line that loses the first attempt stays the first when it is accepted") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(true, kBeganMs);
  transfer.sent(kMode, kBeganMs, 80);
  transfer.onAccepted();
  CHECK(transfer.tries() == 1);
}

TEST_CASE("acceptance does not shorten the wait on a slow line") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(true, kBeganMs);
  transfer.sent(kMode, kBeganMs, 4000);
  transfer.onAccepted();
  CHECK((transfer.onTime(later(kBeganMs, 3999)) == Status::Transferring));
  CHECK_FALSE(transfer.isDue(kMode, later(kBeganMs, 3999)));
}

TEST_CASE("on a line that loses MISSION_SET_CURRENT is sent again as soon and as often as any command") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(true, kBeganMs);
  uint16_t nowMs = kBeganMs;
  for (int sent = 1; sent <= 100; ++sent) {
    CHECK(transfer.isDue(CommandTransfer::kNoCommand, nowMs));
    transfer.sent(CommandTransfer::kNoCommand, nowMs, 80);
    CHECK((transfer.onTime(later(nowMs, 79)) == Status::Transferring));
    CHECK_FALSE(transfer.isDue(CommandTransfer::kNoCommand, later(nowMs, 79)));
    nowMs = later(nowMs, 80);
    CHECK((transfer.onTime(nowMs) == (sent == 100 ? Status::NoAnswer : Status::Transferring)));
  }
}

TEST_CASE("late answers to many attempts on a line that loses are waited for as to five") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(true, kBeganMs);
  for (int sent = 0; sent < 100; ++sent) transfer.sent(kMode, kBeganMs, 80);
  transfer.next(true, kBeganMs);
  CHECK_FALSE(transfer.isDue(kMode, later(kBeganMs, 4 * CommandTransfer::kNextAnswerMs - 1)));
  CHECK(transfer.isDue(kMode, later(kBeganMs, 4 * CommandTransfer::kNextAnswerMs)));
}

// Heartbeats

TEST_CASE("a guarded command leaves right behind a heartbeat, and each attempt behind another one") {
  CommandTransfer transfer = CommandTransfer();
  uint16_t nowMs = kBeganMs;
  transfer.next(true, nowMs);
  CHECK_FALSE(transfer.lacksHeartbeat(nowMs));
  transfer.guard();
  CHECK(transfer.lacksHeartbeat(nowMs));
  transfer.onHeartbeat(nowMs);
  CHECK_FALSE(transfer.lacksHeartbeat(later(nowMs, 19)));
  CHECK(transfer.lacksHeartbeat(later(nowMs, 20)));
  transfer.onHeartbeat(nowMs);
  CHECK_FALSE(transfer.mayBeUnderWay(nowMs));
  transfer.sent(kMode, nowMs, 80);
  CHECK(transfer.lacksHeartbeat(nowMs));
  CHECK(transfer.mayBeUnderWay(later(nowMs, 380)));
  CHECK_FALSE(transfer.mayBeUnderWay(later(nowMs, 416)));
  CHECK((transfer.onTime(later(nowMs, 399)) == Status::Transferring));  // not before it has arrived
  CHECK((transfer.state() == State::Sent));
  CHECK((transfer.onTime(later(nowMs, 400)) == Status::Transferring));
  CHECK((transfer.state() == State::Due));
  CHECK(transfer.lacksHeartbeat(later(nowMs, 400)));
}

TEST_CASE("what has left stays under way behind the next command, and not for ever") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(true, kBeganMs);
  transfer.guard();
  transfer.onHeartbeat(kBeganMs);
  transfer.sent(kMode, kBeganMs);
  transfer.next(true, kBeganMs);
  CHECK_FALSE(transfer.lacksHeartbeat(kBeganMs));
  CHECK(transfer.mayBeUnderWay(later(kBeganMs, 100)));
  transfer.onHeartbeat(later(kBeganMs, 1000));
  for (uint16_t ms = 1000; ms < 9000; ms = static_cast<uint16_t>(ms + 100)) {
    CHECK_FALSE(transfer.mayBeUnderWay(later(kBeganMs, ms)));
  }
}

TEST_CASE("a heartbeat is asked for at once, or later, and again until it comes") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(true, kBeganMs);
  CHECK_FALSE(transfer.isAskDue(kBeganMs, 100));
  transfer.onHeartbeat(kBeganMs);
  transfer.ask();
  CHECK(transfer.isAskDue(kBeganMs, 100));
  transfer.asked(kBeganMs);
  transfer.ask();
  CHECK_FALSE(transfer.isAskDue(later(kBeganMs, 99), 100));
  CHECK(transfer.isAskDue(later(kBeganMs, 100), 100));
  transfer.onHeartbeat(later(kBeganMs, 100));
  CHECK_FALSE(transfer.isAskDue(later(kBeganMs, 300), 100));
  transfer.askLater();
  CHECK_FALSE(transfer.isAskDue(later(kBeganMs, 199), 100));
  CHECK(transfer.isAskDue(later(kBeganMs, 200), 100));
  transfer.next(true, kBeganMs);
  CHECK_FALSE(transfer.isAskDue(later(kBeganMs, 200), 100));
}

TEST_CASE("an autopilot whose heartbeat does not come is given up after 75 requests") {
  CommandTransfer transfer = CommandTransfer();
  uint16_t nowMs = kBeganMs;
  transfer.next(true, nowMs);
  transfer.guard();
  for (int n = 0; n < 75; ++n) {
    transfer.ask();
    CHECK((transfer.onTime(nowMs) == Status::Transferring));
    transfer.asked(nowMs);
    nowMs = later(nowMs, 100);
  }
  CommandTransfer heard = transfer;
  CHECK((transfer.onTime(nowMs) == Status::NoAnswer));
  CHECK(transfer.tries() == 0);
  heard.onHeartbeat(nowMs);
  heard.ask();
  CHECK((heard.onTime(later(nowMs, 100)) == Status::Transferring));
}

TEST_CASE("the answer to a request for a heartbeat is not taken for one to another request") {
  constexpr uint16_t kRequest = CommandTransfer::kRequestMessage;
  CommandTransfer last = CommandTransfer();
  last.next(true, kBeganMs);
  last.ask();
  last.asked(kBeganMs);
  CHECK_FALSE(last.isAnswerToAsking(kMode, kBeganMs));
  CommandTransfer transfer = CommandTransfer();
  transfer.beginBehind(last);
  transfer.sent(kRequest, kBeganMs);
  CHECK(transfer.isAnswerToAsking(kRequest, kBeganMs));
  CHECK_FALSE(transfer.isAnswerToAsking(kRequest, kBeganMs));
  transfer.asked(kBeganMs);
  CHECK_FALSE(transfer.isAnswerToAsking(kRequest, later(kBeganMs, 1500)));  // it was lost
}
