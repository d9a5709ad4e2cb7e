#include "mavmission/transfer/CommandLog.h"

#include <doctest/doctest.h>

#include <initializer_list>

#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef CommandLog::Before Before;
constexpr uint16_t kArm = 400, kMode = 176;
constexpr uint16_t kInterval = CommandLog::kSetMessageInterval, kRequest = CommandLog::kRequestMessage;
constexpr uint16_t kBeganMs = 65000;  // it wraps soon
constexpr uint8_t kSequence = 7;

uint16_t later(uint16_t nowMs, uint32_t ms) { return static_cast<uint16_t>(nowMs + ms); }

// One whose operation has sent this command so many times at once, and has been answered.
CommandLog answered(uint16_t id, uint8_t times, uint16_t nowMs = kBeganMs) {
  CommandLog log = CommandLog();
  for (uint8_t i = 0; i < times; ++i) {
    REQUIRE(log.maySend(id, nowMs));
    log.sent(id, CommandLog::kAnswerMs, nowMs);
  }
  CHECK(log.isAnswer(id, kSequence, nowMs));
  log.ended(times, nowMs);
  return log;
}

}  // namespace

TEST_CASE("the ids and times are MAVLink's, and those of the guide") {
  CHECK(+CommandLog::kSetMessageInterval == MAV_CMD_SET_MESSAGE_INTERVAL);
  CHECK(+CommandLog::kRequestMessage == MAV_CMD_REQUEST_MESSAGE);
  CHECK(+CommandLog::kNoCommand == 0);
  CHECK(+CommandLog::kNextAnswerMs == 1600);
  CHECK(+CommandLog::kLateAnswersS == 20);
  // Late answers to all attempts, each behind a pause for progress, have come by then.
  CHECK(CommandLog::kLateAnswersS * 1000u >= CommandLog::kTries * CommandLog::kNextAnswerMs);
}

// --- An operation's command

TEST_CASE("an answer is one to the operation's command that is under way") {
  CommandLog log = CommandLog();
  CHECK_FALSE(log.isAnswer(kMode, kSequence, kBeganMs));
  log.sent(kMode, CommandLog::kAnswerMs, kBeganMs);
  CHECK_FALSE(log.isAnswer(kArm, kSequence, kBeganMs));
  CHECK(log.isAnswer(kMode, kSequence, kBeganMs));
  CHECK(log.isAnswer(kMode, kSequence, kBeganMs));  // PX4 answers twice
  log.ended(1, kBeganMs);
  CHECK_FALSE(log.isAnswer(kMode, kSequence, kBeganMs));
}

TEST_CASE("a message is answered by no COMMAND_ACK") {
  CommandLog log = CommandLog();
  log.sent(CommandLog::kNoCommand, CommandLog::kAnswerMs, kBeganMs);
  CHECK_FALSE(log.isAnswer(CommandLog::kNoCommand, kSequence, kBeganMs));
  log.ended(3, kBeganMs);
  CHECK(log.maySend(CommandLog::kNoCommand, kBeganMs));
}

TEST_CASE("behind a command that was sent twice the same one waits for the second answer, and no other waits") {
  for (uint8_t times = 1; times <= 5; ++times) {
    CommandLog log = answered(kMode, times);
    const uint16_t restMs = static_cast<uint16_t>((times - 1) * CommandLog::kNextAnswerMs);
    CHECK(log.maySend(kArm, kBeganMs));
    CHECK(log.maySend(kMode, kBeganMs) == (times == 1));
    if (times > 1) CHECK_FALSE(log.maySend(kMode, later(kBeganMs, restMs - 1)));
    CHECK(log.maySend(kMode, later(kBeganMs, restMs)));
  }
}

TEST_CASE("late answers to many attempts on a lossy link are waited for as to five") {
  CommandLog log = answered(kMode, 100);
  CHECK_FALSE(log.maySend(kMode, later(kBeganMs, 4 * CommandLog::kNextAnswerMs - 1)));
  CHECK(log.maySend(kMode, later(kBeganMs, 4 * CommandLog::kNextAnswerMs)));
}

TEST_CASE("late answers are waited for from the first answer on, not from the last attempt") {
  CommandLog log = CommandLog();
  log.sent(kMode, CommandLog::kAnswerMs, kBeganMs);
  log.sent(kMode, CommandLog::kAnswerMs, kBeganMs);
  log.ended(2, later(kBeganMs, 700));
  log.ended(5, later(kBeganMs, 5000));  // it has ended
  CHECK_FALSE(log.maySend(kMode, later(kBeganMs, 2299)));
  CHECK(log.maySend(kMode, later(kBeganMs, 2300)));
}

TEST_CASE("the next operation waits for late answers, and only for those") {
  CommandLog log = answered(kMode, 2);
  log.begin(Before::Command, kBeganMs);
  CHECK_FALSE(log.isAnswer(kMode, kSequence, kBeganMs));
  CHECK_FALSE(log.maySend(kMode, later(kBeganMs, CommandLog::kNextAnswerMs - 1)));
  log.begin(Before::Nothing, kBeganMs);
  CHECK(log.maySend(kMode, kBeganMs));
  log = answered(kMode, 2);
  log.forget();
  CHECK(log.maySend(kMode, kBeganMs));
}

TEST_CASE("behind an operation without commands it is waited for 1.5 s, whatever the clock says by now") {
  for (const int much : {0, 3000, 40000, 62000}) {
    CommandLog log = answered(kMode, 2);
    const uint16_t nowMs = later(kBeganMs, much);
    log.begin(Before::Other, nowMs);
    CHECK_FALSE(log.maySend(kMode, later(nowMs, CommandLog::kAnswerMs - 1)));
    CHECK(log.maySend(kRequest, nowMs));
    CHECK(log.maySend(kMode, later(nowMs, CommandLog::kAnswerMs)));
    log = answered(kMode, 1);  // of which no other answer comes
    log.begin(Before::Other, nowMs);
    CHECK(log.maySend(kMode, nowMs));
    log.askedAside(nowMs);
    log.begin(Before::Other, nowMs);
    CHECK(log.asksOpen() == 0);
  }
}

TEST_CASE("what was waited for in vain is not found again when the clock wraps") {
  CommandLog log = answered(kMode, 2);
  CHECK(log.maySend(kMode, later(kBeganMs, 2000)));
  CHECK(log.maySend(kMode, later(kBeganMs, 65536 + 100)));
}

TEST_CASE("a cancelled command may be answered until 1.5 s after its last attempt, or later on a slow line") {
  for (const int answer : {80, 1500, 4000}) {
    CommandLog log = CommandLog();
    const uint16_t answerMs = static_cast<uint16_t>(answer);
    log.sent(kMode, answerMs, kBeganMs);
    log.sent(kMode, answerMs, later(kBeganMs, 300));
    log.begin(Before::Command, kBeganMs);
    CHECK_FALSE(log.isAnswer(kMode, kSequence, later(kBeganMs, 300)));
    const uint16_t untilMs = later(kBeganMs, 300u + (answerMs < 1500 ? 1500 : answerMs));
    CHECK_FALSE(log.maySend(kMode, later(untilMs, 65535)));
    CHECK(log.maySend(kMode, untilMs));
  }
}

TEST_CASE("a cancelled command that was in progress may be answered for five seconds") {
  CommandLog log = CommandLog();
  log.sent(kMode, CommandLog::kAnswerMs, kBeganMs);
  log.onProgress(later(kBeganMs, 1000));
  log.begin(Before::Command, kBeganMs);
  CHECK_FALSE(log.maySend(kMode, later(kBeganMs, 5999)));
  CHECK(log.maySend(kMode, later(kBeganMs, 6000)));
}

TEST_CASE("a command that nobody has answered in all its attempts is not waited for, and what was before it is") {
  CommandLog log = CommandLog();
  log.sent(kMode, CommandLog::kAnswerMs, kBeganMs);
  log.gaveUp();
  log.ended(5, kBeganMs);
  CHECK(log.maySend(kMode, kBeganMs));
  log = answered(kMode, 2);
  log.gaveUp();  // of another one, that has not left
  CHECK_FALSE(log.maySend(kMode, kBeganMs));
}

// --- Requests for a heartbeat

TEST_CASE("the answer to a request for a heartbeat is not taken for one to another request") {
  CommandLog log = CommandLog();
  log.askedAside(kBeganMs);
  CHECK(log.asksOpen() == 1);
  log.sent(kRequest, CommandLog::kAnswerMs, kBeganMs);
  CHECK_FALSE(log.isAnswer(kMode, kSequence, kBeganMs));
  CHECK(log.asksOpen() == 1);
  CHECK_FALSE(log.isAnswer(kRequest, kSequence, later(kBeganMs, 1499)));
  CHECK(log.asksOpen() == 0);
  CHECK(log.isAnswer(kRequest, kSequence, later(kBeganMs, 1499)));
}

TEST_CASE("a request for a heartbeat that nobody has answered within 1.5 s is lost, with those before it") {
  CommandLog log = CommandLog();
  log.askedAside(kBeganMs);
  log.askedAside(later(kBeganMs, 100));
  log.sent(kRequest, CommandLog::kAnswerMs, kBeganMs);
  CHECK(log.isAnswer(kRequest, kSequence, later(kBeganMs, 1600)));
  CHECK(log.asksOpen() == 0);
  CHECK(log.isAnswer(kRequest, kSequence, later(kBeganMs, 1600)));
}

TEST_CASE("requests for a heartbeat are counted, and the last three may be answered when it has come") {
  CommandLog log = CommandLog();
  for (int n = 0; n < 200; ++n) log.askedAside(kBeganMs);
  CHECK(log.asksOpen() == 127);
  log.onHeartbeat();
  CHECK(log.asksOpen() == 3);
  CHECK_FALSE(log.isAnswer(kRequest, kSequence, kBeganMs));
  log.onHeartbeat();
  CHECK(log.asksOpen() == 2);
}

TEST_CASE(
    "the last three requests for a heartbeat may be answered in the next operation, unless that begins much later") {
  CommandLog log = CommandLog();
  for (int n = 0; n < 5; ++n) log.askedAside(kBeganMs);
  log.begin(Before::Command, kBeganMs);
  CHECK(log.asksOpen() == 3);
  log.sent(kRequest, CommandLog::kAnswerMs, kBeganMs);
  CHECK_FALSE(log.isAnswer(kRequest, kSequence, kBeganMs));
  log.begin(Before::Nothing, kBeganMs);
  CHECK(log.asksOpen() == 0);
}

// --- Listeners

TEST_CASE("of the listeners one asks at a time, and the others wait for its answer, or for 1.5 s") {
  CommandLog log = CommandLog();
  CommandLog::Asked one = CommandLog::Asked(), other = CommandLog::Asked();
  CHECK(log.mayAsk(one, kBeganMs));
  CHECK_FALSE(log.isOf(one));
  log.await(one, kBeganMs);
  CHECK(log.isOf(one));
  CHECK_FALSE(log.isOf(other));
  CHECK(log.mayAsk(one, kBeganMs));
  CHECK_FALSE(log.mayAsk(other, later(kBeganMs, 1499)));
  CHECK(log.mayAsk(other, later(kBeganMs, 1500)));
  log.await(one, later(kBeganMs, 1000));  // one of several answers
  CHECK_FALSE(log.mayAsk(other, later(kBeganMs, 2499)));
  log.settle();
  CHECK(log.mayAsk(other, later(kBeganMs, 1000)));
}

TEST_CASE("an answer is that of the listener that has asked last, and a frame that comes again is none") {
  CommandLog log = CommandLog();
  CommandLog::Asked one = CommandLog::Asked(), other = CommandLog::Asked();
  log.await(one, kBeganMs);
  CHECK_FALSE(log.isAnswerTo(other, kSequence));
  CHECK(log.isAnswerTo(one, kSequence));
  log.settle();
  log.await(other, kBeganMs);
  CHECK_FALSE(log.isAnswerTo(other, kSequence));
  CHECK_FALSE(log.isAnswerTo(one, kSequence + 1));
  CHECK(log.isAnswerTo(other, kSequence + 1));
}

TEST_CASE("a listener that nobody answers is not remembered when the clock wraps") {
  CommandLog log = CommandLog();
  CommandLog::Asked one = CommandLog::Asked(), other = CommandLog::Asked();
  log.await(one, kBeganMs);
  log.giveUpOld(one, later(kBeganMs, 1499));
  log.giveUpOld(other, later(kBeganMs, 1500));
  CHECK(log.isOf(one));
  log.giveUpOld(one, later(kBeganMs, 1500));
  CHECK_FALSE(log.isOf(one));
  CHECK(log.mayAsk(other, later(kBeganMs, 65536 + 100)));
}

TEST_CASE("an operation's SET_MESSAGE_INTERVAL waits for a listener's answer, and another command does not") {
  CommandLog log = CommandLog();
  CommandLog::Asked one = CommandLog::Asked();
  log.await(one, kBeganMs);
  CHECK(log.maySend(kArm, kBeganMs));
  CHECK_FALSE(log.maySend(kInterval, later(kBeganMs, 1499)));
  CHECK(log.maySend(kInterval, later(kBeganMs, 1500)));
}

TEST_CASE("behind a command that nobody has answered, too, SET_MESSAGE_INTERVAL waits for a listener's answer") {
  CommandLog log = CommandLog();
  CommandLog::Asked one = CommandLog::Asked();
  log.sent(kMode, CommandLog::kAnswerMs, kBeganMs);
  log.gaveUp();
  log.await(one, kBeganMs);
  CHECK_FALSE(log.maySend(kInterval, kBeganMs));
}

TEST_CASE("the answer to an operation's SET_MESSAGE_INTERVAL is no listener's, and comes once") {
  CommandLog log = CommandLog();
  CommandLog::Asked one = CommandLog::Asked();
  log.await(one, kBeganMs);
  const uint16_t nowMs = later(kBeganMs, 1500);
  log.sent(kArm, CommandLog::kAnswerMs, kBeganMs);
  CHECK(log.isOf(one));
  log.sent(kInterval, CommandLog::kAnswerMs, nowMs);
  CHECK_FALSE(log.isAnswerTo(one, kSequence));
  CHECK(log.isAnswer(kInterval, kSequence, nowMs));
  CHECK_FALSE(log.isAnswer(kInterval, kSequence, nowMs));
  log.ended(1, nowMs);
  log.await(one, nowMs);
  CHECK_FALSE(log.isAnswerTo(one, kSequence));
  CHECK(log.isAnswerTo(one, kSequence + 1));
}

TEST_CASE("a listener waits for late answers to an operation's SET_MESSAGE_INTERVAL, answered or cancelled") {
  CommandLog::Asked one = CommandLog::Asked();
  CommandLog log = answered(kInterval, 2);
  CHECK_FALSE(log.mayAsk(one, later(kBeganMs, 1599)));
  CHECK(log.mayAsk(one, later(kBeganMs, 1600)));
  log = CommandLog();
  log.sent(kInterval, CommandLog::kAnswerMs, kBeganMs);
  CHECK_FALSE(log.mayAsk(one, later(kBeganMs, 1499)));
  CHECK(log.mayAsk(one, later(kBeganMs, 1500)));
  log = answered(kArm, 2);
  CHECK(log.mayAsk(one, kBeganMs));
}
