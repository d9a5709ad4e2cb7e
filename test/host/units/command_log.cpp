#include "mavmission/transfer/CommandLog.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <string>

#include "Script.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef CommandLog::Before Before;
const std::map<std::string, uint16_t> kCommands = {{"arm", 400},
                                                   {"mode", 176},
                                                   {"interval", uint16_t{CommandLog::kSetMessageInterval}},
                                                   {"request", uint16_t{CommandLog::kRequestMessage}},
                                                   {"message", uint16_t{CommandLog::kNoCommand}}};

// A log and its clock, which wraps soon, for an operation and two listeners, "one" and "other".
class Log {
 public:
  // What is said when this happens. ("mode" stands for any command, and "one" for either listener.)
  // mode leaves: it is sent; "too early" if it might not leave yet
  // answer to mode, answer to one: "taken" as one, or "ignored"; next frame: what follows comes with another number
  // ended N: answered or given up, after so many attempts; progress, gave up
  // next operation, next after another, next much later: the next one begins; forget
  // heartbeat asked, heartbeat comes; open: says how many of those requests are open
  // one asks, one gives up, settled; is one: whether its answer may come
  // when mode, when one: after how many ms it may leave, if it may at all; may mode, may one: the same of now, asked
  //                      once and for all
  // slow N: the line is, what leaves is answered within so many ms; wait N
  std::string plays(const std::string& script) {
    said_.clear();
    for (const Event& event : eventsOf(script)) {
      happens(event, event.first(), event.last());
    }
    return said_;
  }

 private:
  CommandLog log_ = CommandLog();
  CommandLog::Asked one_ = CommandLog::Asked(), other_ = CommandLog::Asked();
  uint16_t nowMs_ = 65000, answerMs_ = uint16_t{CommandLog::kAnswerMs};
  uint8_t sequence_ = 7;
  std::string said_;

  void say(const std::string& words) { said_ += (said_.empty() ? "" : ", ") + words; }
  CommandLog::Asked& listener(const std::string& name) { return name == "one" ? one_ : other_; }
  void happens(const Event& event, const std::string& begin, const std::string& end) {
    if (event.is("wait")) nowMs_ = static_cast<uint16_t>(nowMs_ + event.number);
    if (event.is("slow")) answerMs_ = static_cast<uint16_t>(event.number);
    if (event.is("next frame")) ++sequence_;
    if (event.known(end == "leaves") && !may(log_, begin, 0)) say("too early");
    if (end == "leaves") log_.sent(kCommands.at(begin), answerMs_, nowMs_);
    if (event.is("ended")) log_.ended(static_cast<uint8_t>(event.number), nowMs_);
    if (event.is("progress")) log_.onProgress(nowMs_);
    if (event.is("gave up")) log_.gaveUp();
    if (event.is("next operation")) log_.begin(Before::Command, nowMs_);
    if (event.is("next after another")) log_.begin(Before::Other, nowMs_);
    if (event.is("next much later")) log_.begin(Before::Nothing, nowMs_);
    if (event.is("forget")) log_.forget();
    if (event.is("heartbeat asked")) log_.askedAside(nowMs_);
    if (event.is("heartbeat comes")) log_.onHeartbeat();
    if (event.is("open")) say(std::to_string(log_.asksOpen()));
    if (event.known(end == "asks")) log_.await(listener(begin), nowMs_);
    if (event.known(end == "up" && begin != "gave")) log_.giveUpOld(listener(begin), nowMs_);
    if (event.is("settled")) log_.settle();
    if (event.known(begin == "is")) say(log_.isOf(listener(end)) ? "is" : "is not");
    if (event.known(begin == "answer")) say(isAnswer(end) ? "taken" : "ignored");
    if (event.known(begin == "may")) say(may(log_, end, 0) ? "may" : "waits");
    if (event.known(begin == "when")) say(std::to_string(msUntil(end)));
  }
  bool isAnswer(const std::string& name) {
    const auto command = kCommands.find(name);
    return command != kCommands.end() ? log_.isAnswer(command->second, sequence_, nowMs_)
                                      : log_.isAnswerTo(listener(name), sequence_);
  }
  bool may(CommandLog& log, const std::string& name, uint32_t ms) {
    const uint16_t atMs = static_cast<uint16_t>(nowMs_ + ms);
    const auto command = kCommands.find(name);
    return command != kCommands.end() ? log.maySend(command->second, atMs) : log.mayAsk(listener(name), atMs);
  }
  uint32_t msUntil(const std::string& name) {
    uint32_t ms = 0;
    for (CommandLog copy = log_; ms < 10000 && !may(copy, name, ms); ++ms) copy = log_;
    return ms;
  }
};

// The operation has sent this command so many times at once, and has been answered.
std::string answered(const std::string& command, unsigned attempts) {
  return times(attempts, command + " leaves") + "ended " + std::to_string(attempts) + ", ";
}

}  // namespace

TEST_CASE("the ids and times are MAVLink's, and those of the guide") {
  CHECK(+CommandLog::kSetMessageInterval == MAV_CMD_SET_MESSAGE_INTERVAL);
  CHECK(+CommandLog::kRequestMessage == MAV_CMD_REQUEST_MESSAGE);
  CHECK(+CommandLog::kNoCommand == 0);
  CHECK(+CommandLog::kNextAnswerMs == 1600);
  CHECK(+CommandLog::kLateAnswersS == 20);
  // Late answers to all attempts, each after a pause for progress, have come by then.
  CHECK(CommandLog::kLateAnswersS * 1000u >= CommandLog::kTries * CommandLog::kNextAnswerMs);
}

// --- An operation's command

TEST_CASE("an answer is one to the operation's command that is under way") {
  // PX4 answers twice.
  CHECK(Log().plays("answer to mode, mode leaves, answer to arm, answer to mode, answer to mode, ended 1, "
                    "answer to mode") == "ignored, ignored, taken, taken, ignored");
  // No COMMAND_ACK answers a message.
  CHECK(Log().plays("message leaves, answer to message, ended 3, when message") == "ignored, 0");
}

TEST_CASE("after a command that was sent twice the same one waits for the second answer, and no other waits") {
  for (unsigned attempts : {1, 2, 3, 4, 5, 100}) {  // of many on a lossy link the answers to five are waited for
    CHECK(Log().plays(answered("mode", attempts) + "when arm, when mode") ==
          "0, " + std::to_string((std::min(attempts, 5u) - 1) * 1600));
  }
}

TEST_CASE("the next operation waits for late answers, and only for those") {
  CHECK(Log().plays(answered("mode", 2) + "next operation, answer to mode, when mode, next much later, when mode") ==
        "ignored, 1600, 0");
  CHECK(Log().plays(answered("mode", 2) + "forget, when mode") == "0");
}

TEST_CASE("after an operation without commands it is waited for 1.5 s, whatever the clock says by now") {
  for (const char* much : {"wait 0, ", "wait 3000, ", "wait 40000, ", "wait 62000, "}) {
    CHECK(Log().plays(answered("mode", 2) + much + "next after another, when mode, when request") == "1500, 0");
    CHECK(Log().plays(answered("mode", 1) + much + "next after another, when mode") == "0");  // no other comes
    CHECK(Log().plays(std::string(much) + "heartbeat asked, next after another, open") == "0");
  }
}

TEST_CASE("what was waited for in vain is not found again when the clock wraps") {
  CHECK(Log().plays(answered("mode", 2) + "wait 2000, may mode, wait 63636, may mode") == "may, may");
}

TEST_CASE("a cancelled command may be answered until 1.5 s after its last attempt, or later on a slow line") {
  const std::string cancelled = ", mode leaves, wait 300, mode leaves, next operation, answer to mode, when mode";
  CHECK(Log().plays("slow 80" + cancelled) == "ignored, 1500");
  CHECK(Log().plays("slow 1500" + cancelled) == "ignored, 1500");
  CHECK(Log().plays("slow 4000" + cancelled) == "ignored, 4000");
  // One that was in progress: for five seconds.
  CHECK(Log().plays("mode leaves, wait 1000, progress, next operation, when mode") == "5000");
}

TEST_CASE("a command that nobody has answered in all its attempts is not waited for, and what was before it is") {
  CHECK(Log().plays("mode leaves, gave up, ended 5, when mode") == "0");
  CHECK(Log().plays(answered("mode", 2) + "gave up, when mode") == "1600");  // of another one, that has not left
}

// --- Requests for a heartbeat

TEST_CASE("the answer to a request for a heartbeat is not taken for one to another request") {
  CHECK(Log().plays("heartbeat asked, open, request leaves, answer to mode, open, wait 1499, answer to request, open, "
                    "answer to request") == "1, ignored, 1, ignored, 0, taken");
}

TEST_CASE("a request for a heartbeat that nobody has answered within 1.5 s is lost, with those before it") {
  CHECK(Log().plays("heartbeat asked, wait 100, heartbeat asked, request leaves, wait 1500, answer to request, open, "
                    "answer to request") == "taken, 0, taken");
}

TEST_CASE("requests for a heartbeat are counted, and the last three may be answered when it has come") {
  CHECK(Log().plays(times(200, "heartbeat asked") +
                    "open, heartbeat comes, open, answer to request, heartbeat comes, open") == "127, 3, ignored, 2");
  // Also in the next operation, unless that begins much later.
  CHECK(Log().plays(times(5, "heartbeat asked") +
                    "next operation, open, request leaves, answer to request, next much later, open") ==
        "3, ignored, 0");
}

// --- Listeners

TEST_CASE("of the listeners one asks at a time, and the others wait for its answer, or for 1.5 s") {
  Log log;
  CHECK(log.plays("may one, is one, one asks, is one, is other, may one, when other") ==
        "may, is not, is, is not, may, 1500");
  CHECK(log.plays("wait 1000, one asks, when other, settled, may other") == "1500, may");  // one of several answers
}

TEST_CASE("an answer is that of the listener that has asked last, and a frame that comes again is none") {
  CHECK(Log().plays("one asks, answer to other, answer to one, settled, other asks, answer to other, next frame, "
                    "answer to one, answer to other") == "ignored, taken, ignored, ignored, taken");
}

TEST_CASE("a listener that nobody answers is not remembered when the clock wraps") {
  CHECK(Log().plays("one asks, wait 1499, one gives up, wait 1, other gives up, is one, one gives up, is one, "
                    "wait 64136, may other") == "is, is not, may");
}

TEST_CASE("an operation's SET_MESSAGE_INTERVAL waits for a listener's answer, and another command does not") {
  CHECK(Log().plays("one asks, when arm, when interval") == "0, 1500");
  // Behind a command that nobody has answered, too.
  CHECK(Log().plays("mode leaves, gave up, one asks, may interval") == "waits");
}

TEST_CASE("the answer to an operation's SET_MESSAGE_INTERVAL is no listener's, and comes once") {
  Log log;
  CHECK(log.plays("one asks, arm leaves, is one, wait 1500, interval leaves, answer to one, answer to interval, "
                  "answer to interval") == "is, ignored, taken, ignored");
  CHECK(log.plays("ended 1, one asks, answer to one, next frame, answer to one") == "ignored, taken");
}

TEST_CASE("a listener waits for late answers to an operation's SET_MESSAGE_INTERVAL, answered or cancelled") {
  CHECK(Log().plays(answered("interval", 2) + "when one") == "1600");
  CHECK(Log().plays("interval leaves, when one") == "1500");
  CHECK(Log().plays(answered("arm", 2) + "when one") == "0");
}
