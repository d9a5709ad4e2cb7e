#include "mavmission/transfer/CommandTransfer.h"

#include <doctest/doctest.h>

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

TEST_CASE("silence leaves nothing to wait for") {
  uint16_t nowMs;
  CommandTransfer transfer = sentTimes(CommandTransfer::kTries, true, nowMs);
  nowMs = later(nowMs, CommandTransfer::kAnswerMs);
  CHECK((transfer.onTime(nowMs) == Status::NoAnswer));
  transfer.rest(nowMs);
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
