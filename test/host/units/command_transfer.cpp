#include "mavmission/transfer/CommandTransfer.h"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef CommandTransfer::State State;

constexpr uint16_t kBeganMs = 65000;  // it wraps soon

// One that has been sent so many times, each when it was due, and the time of the last sending.
CommandTransfer sentTimes(uint8_t times, bool repeats, uint16_t& nowMs) {
  CommandTransfer transfer = CommandTransfer();
  nowMs = kBeganMs;
  transfer.next(repeats);
  for (uint8_t i = 0; i < times; ++i) {
    if (i != 0) nowMs = static_cast<uint16_t>(nowMs + CommandTransfer::kAnswerMs);
    CHECK((transfer.onTime(0, nowMs) == Status::Transferring));
    REQUIRE(transfer.isDue());
    transfer.sent(nowMs);
  }
  return transfer;
}

uint16_t later(uint16_t nowMs, uint16_t ms) { return static_cast<uint16_t>(nowMs + ms); }

}  // namespace

TEST_CASE("a command is sent every 1500 ms, five times, and then has no answer") {
  uint16_t nowMs;
  CommandTransfer transfer = sentTimes(CommandTransfer::kTries, true, nowMs);
  CHECK(transfer.tries() == 5);
  CHECK((transfer.onTime(0, later(nowMs, CommandTransfer::kAnswerMs - 1)) == Status::Transferring));
  CHECK_FALSE(transfer.isDue());
  CHECK(transfer.waitMs() == +CommandTransfer::kAnswerMs);
  CHECK((transfer.onTime(0, later(nowMs, CommandTransfer::kAnswerMs)) == Status::NoAnswer));
}

TEST_CASE("a command that must not happen twice is sent once, and is unconfirmed after five seconds") {
  uint16_t nowMs;
  CommandTransfer transfer = sentTimes(1, false, nowMs);
  CHECK((transfer.onTime(0, later(nowMs, CommandTransfer::kProgressMs - 1)) == Status::Transferring));
  CHECK((transfer.onTime(0, later(nowMs, CommandTransfer::kProgressMs)) == Status::Unconfirmed));
}

TEST_CASE("progress gives five seconds more, and then it is sent again") {
  uint16_t nowMs;
  CommandTransfer transfer = sentTimes(2, true, nowMs);
  nowMs = later(nowMs, 1000);
  transfer.onProgress(nowMs);
  CHECK((transfer.state() == State::InProgress));
  CHECK((transfer.onTime(0, later(nowMs, 4999)) == Status::Transferring));
  CHECK_FALSE(transfer.isDue());
  CHECK((transfer.onTime(0, later(nowMs, 5000)) == Status::Transferring));
  CHECK(transfer.isDue());
}

TEST_CASE("behind silence the next one is due at once") {
  uint16_t nowMs;
  CommandTransfer transfer = sentTimes(CommandTransfer::kTries, true, nowMs);
  nowMs = later(nowMs, CommandTransfer::kAnswerMs);
  CHECK((transfer.onTime(0, nowMs) == Status::NoAnswer));
  CHECK(transfer.tries() == 0);
  transfer.next(true);
  CHECK(transfer.isDue());
}

TEST_CASE("what listens sends nothing, and is unconfirmed in the end") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(true);
  transfer.listen(7500, kBeganMs);
  CHECK_FALSE(transfer.isDue());
  CHECK((transfer.onTime(0, later(kBeganMs, 7499)) == Status::Transferring));
  CHECK((transfer.onTime(0, later(kBeganMs, 7500)) == Status::Unconfirmed));
}

TEST_CASE("behind a pause it is sent, with all its attempts") {
  uint16_t nowMs;
  CommandTransfer transfer = sentTimes(1, true, nowMs);
  transfer.next(true);
  transfer.pause(1000, nowMs);
  CHECK((transfer.onTime(0, later(nowMs, 999)) == Status::Transferring));
  CHECK_FALSE(transfer.isDue());
  nowMs = later(nowMs, 1000);
  CHECK((transfer.onTime(0, nowMs) == Status::Transferring));
  CHECK(transfer.isDue());
  CHECK(transfer.tries() == 0);
}

TEST_CASE("the times and attempts are those of the guide, and what is added to them") {
  CHECK(+CommandTransfer::kTries == 5);
  CHECK(+CommandTransfer::kAnswerMs == 1500);
  CHECK(+CommandTransfer::kProgressMs == 5000);
}

TEST_CASE("what must not happen twice is sent behind a pause, and is unconfirmed when progress falls silent") {
  uint16_t nowMs;
  CommandTransfer transfer = sentTimes(1, true, nowMs);
  transfer.next(false);
  transfer.pause(1000, nowMs);
  CHECK((transfer.state() == State::Pausing));
  nowMs = later(nowMs, 1000);
  CHECK((transfer.onTime(0, nowMs) == Status::Transferring));
  REQUIRE(transfer.isDue());
  transfer.sent(nowMs);
  nowMs = later(nowMs, 3000);
  transfer.onProgress(nowMs);
  CHECK((transfer.onTime(0, later(nowMs, 4999)) == Status::Transferring));
  CHECK((transfer.onTime(0, later(nowMs, 5000)) == Status::Unconfirmed));
}

TEST_CASE("whether a command may be sent again can be said before it is sent") {
  for (const bool repeats : {false, true}) {
    CommandTransfer transfer = CommandTransfer();
    transfer.next(!repeats);
    transfer.setRepeats(repeats);
    transfer.sent(kBeganMs);
    CHECK((transfer.onTime(0, later(kBeganMs, 1499)) == Status::Transferring));
    CHECK((transfer.onTime(0, later(kBeganMs, 1500)) == Status::Transferring));
    CHECK((transfer.state() == (repeats ? State::Due : State::Sent)));
    if (!repeats) CHECK((transfer.onTime(0, later(kBeganMs, 5000)) == Status::Unconfirmed));
  }
}

TEST_CASE("on a lossy link a command is sent again sooner, up to 100 attempts") {
  CommandTransfer transfer = CommandTransfer();
  uint16_t nowMs = kBeganMs;
  transfer.next(true);
  for (int sent = 1; sent <= 100; ++sent) {
    REQUIRE(transfer.isDue());
    transfer.sent(nowMs, 80);
    nowMs = later(nowMs, 79);
    CHECK((transfer.onTime(0, nowMs) == Status::Transferring));
    CHECK_FALSE(transfer.isDue());
    nowMs = later(nowMs, 1);
    CHECK((transfer.onTime(0, nowMs) == (sent == 100 ? Status::NoAnswer : Status::Transferring)));
  }
}

TEST_CASE("on a lossy link a command that must not happen twice is sent once") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(false);
  transfer.sent(kBeganMs, 80);
  CHECK((transfer.onTime(0, later(kBeganMs, CommandTransfer::kProgressMs - 1)) == Status::Transferring));
  CHECK_FALSE(transfer.isDue());
  CHECK((transfer.onTime(0, later(kBeganMs, CommandTransfer::kProgressMs)) == Status::Unconfirmed));
}

TEST_CASE("on a lossy link an accepted command is sent again after 1500 ms, up to 4 more times") {
  CommandTransfer transfer = CommandTransfer();
  uint16_t nowMs = kBeganMs;
  transfer.next(true);
  for (int sent = 0; sent < 30; ++sent) transfer.sent(nowMs, 80);
  transfer.onAccepted(true);
  for (int sent = 1; sent <= 4; ++sent) {
    nowMs = later(nowMs, CommandTransfer::kAnswerMs - 1);
    CHECK((transfer.onTime(0, nowMs) == Status::Transferring));
    CHECK_FALSE(transfer.isDue());
    nowMs = later(nowMs, 1);
    CHECK((transfer.onTime(0, nowMs) == (sent == 4 ? Status::NoAnswer : Status::Transferring)));
    transfer.sent(nowMs, CommandTransfer::kAnswerMs);
  }
}

TEST_CASE("on a lossy link the first attempt stays the first when it is accepted") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(true);
  transfer.sent(kBeganMs, 80);
  transfer.onAccepted(true);
  CHECK(transfer.tries() == 1);
}

TEST_CASE("on a lossy link an order that is accepted each time is given up behind the 16th, a question never") {
  for (bool isQuestion : {false, true}) {
    CommandTransfer transfer = CommandTransfer();
    for (int command = 0; command < 2; ++command) {  // and the next one is counted anew
      transfer.next(true);
      uint16_t nowMs = kBeganMs;
      for (int accepted = 1; accepted <= 16; ++accepted) {
        transfer.sent(nowMs, 80);
        transfer.onAccepted(isQuestion);
        nowMs = later(nowMs, CommandTransfer::kAnswerMs - 2);
        CHECK((transfer.onTime(0, nowMs) == Status::Transferring));
        CHECK_FALSE(transfer.isDue());
        nowMs = later(nowMs, 2);
        const bool isLast = accepted == 16 && !isQuestion;
        CHECK((transfer.onTime(0, nowMs) == (isLast ? Status::NoAnswer : Status::Transferring)));
      }
    }
  }
}

TEST_CASE("acceptance does not shorten the wait on a slow line") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(true);
  transfer.sent(kBeganMs, 4000);
  transfer.onAccepted(true);
  CHECK((transfer.onTime(0, later(kBeganMs, 3999)) == Status::Transferring));
  CHECK_FALSE(transfer.isDue());
}

TEST_CASE("on a lossy link MISSION_SET_CURRENT is sent again as soon and as often as any command") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(true);
  uint16_t nowMs = kBeganMs;
  for (int sent = 1; sent <= 100; ++sent) {
    CHECK(transfer.isDue());
    transfer.sent(nowMs, 80);
    CHECK((transfer.onTime(0, later(nowMs, 79)) == Status::Transferring));
    CHECK_FALSE(transfer.isDue());
    nowMs = later(nowMs, 80);
    CHECK((transfer.onTime(0, nowMs) == (sent == 100 ? Status::NoAnswer : Status::Transferring)));
  }
}

// Heartbeats

TEST_CASE("a guarded command leaves right behind a heartbeat, and each attempt behind another one") {
  CommandTransfer transfer = CommandTransfer();
  uint16_t nowMs = kBeganMs;
  transfer.next(true);
  CHECK_FALSE(transfer.lacksHeartbeat(nowMs));
  transfer.guard();
  CHECK(transfer.lacksHeartbeat(nowMs));
  transfer.onHeartbeat(nowMs);
  CHECK_FALSE(transfer.lacksHeartbeat(later(nowMs, 19)));
  CHECK(transfer.lacksHeartbeat(later(nowMs, 20)));
  transfer.onHeartbeat(nowMs);
  CHECK_FALSE(transfer.mayBeUnderWay(nowMs));
  transfer.sent(nowMs, 80);
  CHECK(transfer.lacksHeartbeat(nowMs));
  CHECK(transfer.mayBeUnderWay(later(nowMs, 380)));
  CHECK_FALSE(transfer.mayBeUnderWay(later(nowMs, 416)));
  CHECK((transfer.onTime(0, later(nowMs, 399)) == Status::Transferring));  // not before it has arrived
  CHECK((transfer.state() == State::Sent));
  CHECK((transfer.onTime(0, later(nowMs, 400)) == Status::Transferring));
  CHECK((transfer.state() == State::Due));
  CHECK(transfer.lacksHeartbeat(later(nowMs, 400)));
}

TEST_CASE("what has left stays under way behind the next command, and not for ever") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(true);
  transfer.guard();
  transfer.onHeartbeat(kBeganMs);
  transfer.sent(kBeganMs);
  transfer.next(true);
  CHECK_FALSE(transfer.lacksHeartbeat(kBeganMs));
  CHECK(transfer.mayBeUnderWay(later(kBeganMs, 100)));
  transfer.look(false, false, later(kBeganMs, 1000));  // whether a heartbeat comes or not
  for (uint16_t ms = 1000; ms < 9000; ms = static_cast<uint16_t>(ms + 100)) {
    CHECK_FALSE(transfer.mayBeUnderWay(later(kBeganMs, ms)));
  }
}

TEST_CASE("behind a standstill what has left is under way to whatever was sent before, and no longer") {
  for (uint32_t standstillMs : {300u, 700u, 4096u, 65536u}) {
    CAPTURE(standstillMs);
    CommandTransfer transfer = CommandTransfer();
    transfer.next(true);
    transfer.guard();
    transfer.onHeartbeat(kBeganMs);
    transfer.sent(kBeganMs);
    const uint16_t behind = static_cast<uint16_t>(kBeganMs + standstillMs);
    transfer.look(true, standstillMs >= 600, behind);
    CHECK(transfer.mayBeUnderWay(behind));
    transfer.look(false, false, later(behind, 1));
    CHECK(transfer.mayBeUnderWay(later(behind, 1)) == (standstillMs < 400));
  }
}

TEST_CASE("a heartbeat is asked for at once, or later, and again until it comes") {
  CommandTransfer transfer = CommandTransfer();
  transfer.next(true);
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
  transfer.next(true);
  CHECK_FALSE(transfer.isAskDue(later(kBeganMs, 200), 100));
}

TEST_CASE("an autopilot whose heartbeat does not come is given up after 75 requests") {
  CommandTransfer transfer = CommandTransfer();
  uint16_t nowMs = kBeganMs;
  transfer.next(true);
  transfer.guard();
  for (uint8_t n = 0; n < 75; ++n) {
    transfer.ask();
    CHECK((transfer.onTime(n, nowMs) == Status::Transferring));
    transfer.asked(nowMs);
    nowMs = later(nowMs, 100);
  }
  CommandTransfer heard = transfer;
  CHECK((transfer.onTime(75, later(nowMs, static_cast<uint16_t>(-1))) == Status::Transferring));
  CHECK((transfer.onTime(75, nowMs) == Status::NoAnswer));
  CHECK(transfer.tries() == 0);
  heard.onHeartbeat(nowMs);
  heard.ask();
  CHECK((heard.onTime(74, later(nowMs, 100)) == Status::Transferring));
}

TEST_CASE(
    "a mode is set again behind each heartbeat, and as often as it can while that is fresh where bytes are lost") {
  for (uint16_t answerMs : {uint16_t{CommandTransfer::kAnswerMs}, uint16_t{50}}) {
    const bool isLossy = answerMs < CommandTransfer::kAnswerMs;
    CommandTransfer transfer = CommandTransfer();
    transfer.onHeartbeat(kBeganMs);
    transfer.restore();
    CHECK(transfer.isRestoring());
    CHECK(transfer.isUrgent());
    CHECK(transfer.isDue());
    CHECK_FALSE(transfer.lacksHeartbeat(kBeganMs));
    transfer.sent(kBeganMs, answerMs);
    CHECK(transfer.isDue());
    CHECK(transfer.mayBeUnderWay(kBeganMs));
    CHECK(transfer.lacksHeartbeat(later(kBeganMs, 19)) == !isLossy);
    CHECK(transfer.lacksHeartbeat(later(kBeganMs, 20)));
    transfer.onProgress(kBeganMs);
    CHECK(transfer.isDue());
    transfer.onHeartbeat(later(kBeganMs, 100));
    CHECK_FALSE(transfer.lacksHeartbeat(later(kBeganMs, 100)));
    transfer.next(true);
    CHECK_FALSE(transfer.isRestoring());
    CHECK_FALSE(transfer.isUrgent());
  }
}

TEST_CASE("a mode that is set again in vain is given up after 40 times, also behind an order that was accepted") {
  for (bool isAccepted : {false, true}) {
    CAPTURE(isAccepted);
    CommandTransfer transfer = CommandTransfer();
    transfer.next(true);
    transfer.sent(kBeganMs, 50);
    if (isAccepted) transfer.onAccepted(false);
    transfer.restore();
    for (uint8_t n = 0; n < 40; ++n) {
      CHECK((transfer.onTime(0, later(kBeganMs, 5000)) == Status::Transferring));
      transfer.sent(kBeganMs, 50);
      CHECK(transfer.tries() == n + 1);
      if (isAccepted) transfer.onAccepted(false);
    }
    CHECK((transfer.onTime(0, kBeganMs) == Status::NoAnswer));
    CHECK(transfer.tries() == 0);
  }
}

TEST_CASE("an order that is in doubt does not leave again, and a heartbeat is asked for up to 125 times") {
  uint16_t nowMs;
  CommandTransfer transfer = sentTimes(1, true, nowMs);
  transfer.onHeartbeat(nowMs);
  transfer.doubt();
  CHECK(transfer.isUrgent());
  CHECK_FALSE(transfer.isRestoring());
  CHECK_FALSE(transfer.isDue());
  CHECK_FALSE(transfer.isAskDue(later(nowMs, 49), 50));
  CHECK(transfer.isAskDue(later(nowMs, 50), 50));
  nowMs = later(nowMs, 2000);
  CHECK((transfer.onTime(124, nowMs) == Status::Transferring));
  CHECK_FALSE(transfer.isDue());
  CHECK((transfer.onTime(125, nowMs) == Status::NoAnswer));
}
