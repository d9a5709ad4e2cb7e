#include "mavmission/transfer/CommandTransfer.h"

#include <doctest/doctest.h>

#include <initializer_list>
#include <string>

#include "Script.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef CommandTransfer::State State;

constexpr uint16_t kBeganMs = 65000;  // it wraps soon

uint16_t later(uint16_t nowMs, uint32_t ms) { return static_cast<uint16_t>(nowMs + ms); }

// A command that leaves whenever it is due, and its clock.
class Command {
 public:
  CommandTransfer transfer = CommandTransfer();
  uint16_t nowMs = kBeganMs;

  // When it leaves and how it ends, each after the milliseconds since the one before, when this happens:
  // command, once: the next one begins, which may be repeated or not; listen N, pause N: in the place of that
  // wait N: N ms pass; silence: until it ends
  // progress; accepted: the answer to an order, found: to a question; slow N: its answer is waited for so long, or
  // quick N
  std::string plays(const std::string& script) {
    Transcript said;
    uint32_t sinceMs = 0;
    Status status = Status::Transferring;
    for (const Event& event : eventsOf(script)) {
      const uint16_t ms = static_cast<uint16_t>(event.number);
      if (event.is("command") || event.is("once")) transfer.next(event.is("command"));
      if (event.is("listen")) transfer.listen(ms, nowMs);
      if (event.is("pause")) transfer.pause(ms, nowMs);
      if (event.is("progress")) transfer.onProgress(nowMs);
      if (event.is("accepted") || event.is("found")) transfer.onAccepted(event.is("found"));
      if (event.is("slow") || event.is("quick")) answerMs_ = ms;
      const uint32_t limitMs = event.is("wait") ? event.number : event.is("silence") ? 200000 : 0;
      for (uint32_t passed = 0; passed <= limitMs && status == Status::Transferring; ++passed) {
        if (passed != 0) ++nowMs, ++sinceMs, status = transfer.onTime(0, nowMs);
        const bool leaves = status == Status::Transferring && hasBegun(event) && transfer.isDue();
        if (leaves) transfer.sent(nowMs, answerMs_);
        if (!leaves && status == Status::Transferring) continue;
        said.note(leaves ? "sent" : nameOf(status), sinceMs);
        sinceMs = 0;
      }
    }
    return said.text();
  }

 private:
  uint16_t answerMs_ = CommandTransfer::kAnswerMs;

  // What follows says more of the one that begins.
  static bool hasBegun(const Event& event) { return event.is("wait") || event.is("silence") || event.is("now"); }
};

}  // namespace

TEST_CASE("the times and attempts are those of the guide, and what is added to them") {
  CHECK(+CommandTransfer::kTries == 5);
  CHECK(+CommandTransfer::kAnswerMs == 1500);
  CHECK(+CommandTransfer::kProgressMs == 5000);
}

TEST_CASE("a command is sent every 1500 ms, five times, and then has no answer; the next one is due at once") {
  Command one;
  CHECK(one.plays("command, wait 7499") == "sent, 1500 sent (4 times)");
  CHECK(one.transfer.tries() == 5);
  CHECK(one.transfer.waitMs() == 1500);
  CHECK(one.plays("wait 1") == "1 NoAnswer");
  CHECK(one.transfer.tries() == 0);
  CHECK(one.plays("command, now") == "sent");
}

TEST_CASE("progress gives five seconds more, and then it is sent again, or unconfirmed if it must not happen twice") {
  Command one;
  CHECK(one.plays("command, wait 2500, progress") == "sent, 1500 sent");
  CHECK((one.transfer.state() == State::InProgress));
  CHECK(one.plays("wait 5000") == "5000 sent");
  CHECK(Command().plays("once, wait 3000, progress, silence") == "sent, 8000 Unconfirmed");
}

TEST_CASE("what listens sends nothing, and is unconfirmed in the end") {
  CHECK(Command().plays("command, listen 7500, silence") == "7500 Unconfirmed");
}

TEST_CASE("after a pause it is sent, with all its attempts") {
  Command one;
  CHECK(one.plays("command, now, command, pause 1000") == "sent");
  CHECK((one.transfer.state() == State::Pausing));
  CHECK(one.plays("silence") == "1000 sent, 1500 sent (4 times), 1500 NoAnswer");
  CHECK(Command().plays("command, now, once, pause 1000, silence") == "sent, 1000 sent, 5000 Unconfirmed");
}

TEST_CASE("whether a command may be sent again can be said before it is sent") {
  for (const bool repeats : {false, true}) {
    Command one;
    one.transfer.next(!repeats);
    one.transfer.setRepeats(repeats);
    CHECK(one.plays("wait 5000") == (repeats ? "sent, 1500 sent (3 times)" : "sent, 5000 Unconfirmed"));
  }
}

TEST_CASE("on a lossy link an accepted question is sent again after 1500 ms, up to 4 more times") {
  Command one;
  CHECK(one.plays("quick 80, command, wait 2320") == "sent, 80 sent (29 times)");
  CHECK(one.plays("found, slow 1500, silence") == "1500 sent (3 times), 1500 NoAnswer");
  // The first attempt stays the first.
  Command first;
  first.plays("quick 80, command, now, found");
  CHECK(first.transfer.tries() == 1);
}

TEST_CASE("on a lossy link an order that is accepted each time is given up after the 16th, a question never") {
  Command order, question;
  for (int command = 0; command < 2; ++command) {  // and the next one is counted anew
    order.plays("quick 80, command, now");
    CHECK(order.plays(times(16, "accepted, wait 1500")) == "1499 sent (15 times), 1499 NoAnswer");
    question.plays("quick 80, command, now");
    CHECK(question.plays(times(16, "found, wait 1500")) == "1500 sent (16 times)");
  }
}

// Heartbeats

TEST_CASE("a guarded command leaves right after a heartbeat, and each attempt after another one") {
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

TEST_CASE("what has left stays under way after the next command, and not for ever") {
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

TEST_CASE("after a standstill what has left is under way to whatever was sent before, and no longer") {
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

TEST_CASE("a mode is set again after each heartbeat, and as often as it can while that is fresh where bytes are lost") {
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

TEST_CASE("a mode that is set again in vain is given up after 40 times, also after an order that was accepted") {
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
  Command one;
  one.plays("command, now");
  CommandTransfer& transfer = one.transfer;
  uint16_t nowMs = one.nowMs;
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
