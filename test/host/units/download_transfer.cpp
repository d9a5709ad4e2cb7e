#include "mavmission/transfer/DownloadTransfer.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef DownloadTransfer::State State;
typedef DownloadTransfer::Send Send;

Pace pace;

// In the client the memory may hold anything before begin().
DownloadTransfer begun(uint16_t nowMs = 0) {
  pace = Pace();

  DownloadTransfer transfer;
  memset(static_cast<void*>(&transfer), 0xA5, sizeof(transfer));
  transfer.begin(nowMs);
  return transfer;
}

// As far as the items of a plan being asked for, none of which has come.
DownloadTransfer fetching(uint16_t items, uint16_t nowMs = 0) {
  DownloadTransfer transfer = begun(nowMs);
  transfer.sent(nowMs);
  transfer.onCount(items, 0, pace);
  transfer.sent(nowMs);
  return transfer;
}

// This item comes; true if it was asked for.
bool came(DownloadTransfer& transfer, uint16_t item, uint16_t nowMs = 0) {
  const bool isExpected = transfer.expectsItem(item, nowMs, pace);
  const uint8_t others = transfer.othersAsked();
  if (isExpected) {
    transfer.onItem(nowMs, pace);
    transfer.stayAhead(others, nowMs);
  }
  return isExpected;
}

bool goesOn(Status status) { return status == Status::Transferring; }

}  // namespace

TEST_CASE("a plan is asked for item by item, each when the one before has come, and then acknowledged") {
  DownloadTransfer transfer = begun();
  CHECK(transfer.toSend() == Send::List);
  CHECK_FALSE(transfer.sent(0));
  CHECK(transfer.toSend() == Send::Nothing);
  CHECK(transfer.onCount(3, 0, pace));
  for (uint16_t item = 0; item < 3; ++item) {
    CHECK(transfer.toSend() == Send::Request);
    CHECK(transfer.itemToAsk() == item);
    CHECK_FALSE(transfer.sent(0));
    CHECK(came(transfer, item));
  }
  CHECK(transfer.state() == State::Closing);
  CHECK(transfer.toSend() == Send::Accepted);
  CHECK(transfer.sent(0));
}

TEST_CASE("the list is asked for 5 times, 1500 ms apart, and then there is no answer") {
  for (uint16_t start : {uint16_t(0), uint16_t(65000)}) {
    DownloadTransfer transfer = begun(start);
    uint16_t now = start;
    for (int tries = 0; tries < 5; ++tries) {
      CHECK(transfer.toSend() == Send::List);
      transfer.sent(now);
      now = static_cast<uint16_t>(now + 1499);
      CHECK(goesOn(transfer.onTime(now, pace)));
      CHECK(transfer.toSend() == Send::Nothing);
      const Status status = transfer.onTime(++now, pace);
      CHECK((status == (tries < 4 ? Status::Transferring : Status::NoAnswer)));
    }
  }
}

TEST_CASE("an item is asked for 8 times, 250 ms apart, and then the time is out") {
  DownloadTransfer transfer = fetching(2);
  came(transfer, 0);
  uint16_t now = 0;
  for (int tries = 0; tries < 8; ++tries) {
    CHECK(transfer.toSend() == Send::Request);
    CHECK(transfer.itemToAsk() == 1);
    transfer.sent(now);
    CHECK(transfer.tries() == tries + 1);
    now = static_cast<uint16_t>(now + 249);
    CHECK(goesOn(transfer.onTime(now, pace)));
    CHECK(transfer.toSend() == Send::Nothing);
    const Status status = transfer.onTime(++now, pace);
    CHECK((status == (tries < 7 ? Status::Transferring : Status::TimedOut)));
  }
}

TEST_CASE("on a lossy link, an item is asked for again after half the time of the list") {
  DownloadTransfer transfer = begun();
  pace.noteLoss();
  transfer.sent(0);
  CHECK(goesOn(transfer.onTime(PaceRules::kLeastMs - 1, pace, false)));
  CHECK(transfer.toSend() == Send::Nothing);
  CHECK(goesOn(transfer.onTime(PaceRules::kLeastMs, pace, false)));
  CHECK(transfer.toSend() == Send::List);

  transfer = fetching(2);
  pace.noteLoss();
  CHECK(goesOn(transfer.onTime(PaceRules::kLeastMs / 2 - 1, pace, false)));
  CHECK(transfer.toSend() == Send::Nothing);
  CHECK(goesOn(transfer.onTime(PaceRules::kLeastMs / 2, pace, false)));
  CHECK(transfer.toSend() == Send::Request);
}

TEST_CASE("on a lossy link, an autopilot that answers each request is asked again when the answer is overdue") {
  DownloadTransfer transfer = fetching(2);
  pace.learn(20, true);
  pace.noteLoss();
  uint16_t now = 0;
  for (int tries = 1; tries < 100; ++tries) {
    now = static_cast<uint16_t>(now + (tries < 64 ? 15 : 25));
    CHECK(goesOn(transfer.onTime(static_cast<uint16_t>(now - 1), pace)));
    CHECK(transfer.toSend() == Send::Nothing);
    CHECK(goesOn(transfer.onTime(now, pace)));
    CHECK(transfer.toSend() == Send::Request);
    transfer.sent(now);
  }
}

TEST_CASE("a question that the line has not taken yet is not counted, and no time runs") {
  DownloadTransfer transfer = begun();
  CHECK(goesOn(transfer.onTime(60000, pace)));
  CHECK(transfer.toSend() == Send::List);
  transfer.sent(60000);
  CHECK(goesOn(transfer.onTime(61499, pace)));
  CHECK(transfer.toSend() == Send::Nothing);
}

TEST_CASE("a count is an answer once: a second one is of a list that was asked for twice") {
  DownloadTransfer transfer = fetching(2);
  CHECK_FALSE(transfer.onCount(7, 0, pace));
  CHECK(transfer.toSend() == Send::Nothing);
  CHECK_FALSE(begun().onCount(2, 0, pace));  // before the list was asked for
}

TEST_CASE("an item that is not taken is asked for again at once, and has all its tries again") {
  DownloadTransfer transfer = fetching(2);
  transfer.onTime(250, pace);
  transfer.sent(250);
  CHECK(transfer.tries() == 2);
  transfer.askAgain();
  CHECK(transfer.toSend() == Send::Request);
  CHECK(transfer.itemToAsk() == 0);
  CHECK(transfer.tries() == 0);
  transfer.sent(251);
  CHECK(transfer.tries() == 1);
  CHECK(came(transfer, 0));
}

TEST_CASE("each refusal ends the reading, but for the words that belong to something else") {
  const uint8_t kAccepted = 0, kInvalidSequence = 13;
  DownloadTransfer listing = begun();
  listing.sent(0);
  DownloadTransfer closing = fetching(1);
  came(closing, 0);
  for (uint8_t result = 0; result <= 30; ++result) {
    CAPTURE(result);
    const bool isNoise = result == kAccepted || result == kInvalidSequence;
    const Status said = isNoise ? Status::Transferring : fromMissionResult(result);
    CHECK((listing.onAck(result) == said));
    CHECK((fetching(2).onAck(result) == said));
    CHECK(goesOn(closing.onAck(result)));  // every item is there
  }
}

TEST_CASE("a count that comes before the list was asked for is no answer") {
  DownloadTransfer transfer = begun();
  transfer.onCount(0, 0, pace);
  CHECK(transfer.state() == State::Listing);
  CHECK(transfer.toSend() == Send::List);
  transfer.sent(0);
  transfer.onCount(2, 0, pace);
  CHECK(transfer.state() == State::Fetching);
}

TEST_CASE("an item that comes before it was asked for is no answer") {
  DownloadTransfer transfer = begun();
  transfer.sent(0);
  transfer.onCount(2, 0, pace);
  CHECK_FALSE(came(transfer, 0));
  transfer.sent(0);
  CHECK(came(transfer, 0));
  CHECK_FALSE(came(transfer, 1));
  transfer.sent(0);
  CHECK_FALSE(came(transfer, 0));
  CHECK(came(transfer, 1));
  CHECK(transfer.state() == State::Closing);
}

TEST_CASE("a plan without items is read when its count has come") {
  DownloadTransfer transfer = begun();
  transfer.sent(0);
  transfer.onCount(0, 0, pace);
  CHECK(transfer.state() == State::Closing);
  CHECK(transfer.toSend() == Send::Accepted);
  CHECK(transfer.sent(0));
}

TEST_CASE("an item that comes again shows how long the line takes, however soon its first coming was") {
  DownloadTransfer transfer = fetching(3);
  CHECK(came(transfer, 0, 20));  // the answer to a request of an earlier reading
  CHECK(pace.roundTripMs() == 20);
  CHECK_FALSE(came(transfer, 0, 40));  // the next one has not been asked for yet: it shows nothing
  CHECK(pace.roundTripMs() == 20);
  transfer.sent(60);
  CHECK_FALSE(came(transfer, 1 + 1, 900));
  CHECK_FALSE(came(transfer, 0, 70));
  CHECK(pace.roundTripMs() == 20);
  CHECK_FALSE(came(transfer, 0, 1000));
  CHECK(pace.roundTripMs() == 940);
  CHECK_FALSE(came(transfer, 0, 5000));
  CHECK(pace.roundTripMs() == uint16_t(Pace::kMostMs));
  CHECK(came(transfer, 1, 5100));
}

namespace {

// Asks for items as long as several may be asked for, and says for how many.
int askedAhead(DownloadTransfer& transfer, uint16_t nowMs) {
  int asked = 0;
  for (; transfer.toSend(true) == Send::Request; ++asked) transfer.sent(nowMs);
  return asked;
}

}  // namespace

TEST_CASE("where several may be asked for, five are under way, as long as there are so many") {
  DownloadTransfer transfer = fetching(7);
  CHECK(transfer.toSend() == Send::Nothing);
  CHECK(transfer.itemToAsk() == 1);
  CHECK(askedAhead(transfer, 0) == 4);
  CHECK(transfer.itemToAsk() == 5);
  for (uint16_t item = 0; item < 7; ++item) {
    CHECK_FALSE(came(transfer, item + 1, 10));
    CHECK(came(transfer, item, 10));
    CHECK(transfer.toSend() == (item == 6 ? Send::Accepted : Send::Nothing));
    CHECK(askedAhead(transfer, 10) == (item < 2 ? 1 : 0));
  }
  CHECK(transfer.state() == State::Closing);
}

TEST_CASE("a list is asked for once, however many items may be asked for") {
  DownloadTransfer transfer = begun();
  transfer.sent(0);
  CHECK(transfer.toSend(true) == Send::Nothing);
  transfer.onCount(0, 0, pace);
  CHECK(transfer.toSend(true) == Send::Accepted);
  transfer.sent(0);
  CHECK(transfer.toSend(true) == Send::Nothing);
}

TEST_CASE("of several nothing is asked for anew before their answers have had time to come, on a lossy link too") {
  DownloadTransfer transfer = fetching(9);
  pace.learn(300, true);
  askedAhead(transfer, 100);
  pace.noteLoss();
  CHECK(came(transfer, 0, 300));
  for (uint16_t now = 300; now < 300 + 300 + Pace::kLeastMs; ++now) {
    CHECK(goesOn(transfer.onTime(now, pace)));
    REQUIRE(transfer.toSend() == Send::Nothing);
  }
  CHECK(goesOn(transfer.onTime(300 + 300 + Pace::kLeastMs, pace)));
  CHECK(transfer.toSend() == Send::Request);
  CHECK(transfer.itemToAsk() == 1);
  transfer.sent(650);
  CHECK(transfer.tries() == 2);  // it was one of several before
  // Now it is the only one, and repeated as ever.
  CHECK(goesOn(transfer.onTime(650 + 300 / Pace::kHurry, pace)));
  CHECK(transfer.toSend() == Send::Request);
}

TEST_CASE("an item that is one of several is asked for 8 times, too") {
  DownloadTransfer transfer = fetching(9);
  askedAhead(transfer, 0);
  CHECK(came(transfer, 0, 10));
  uint16_t now = 10;
  for (int tries = 1; tries < 8; ++tries) {
    now = static_cast<uint16_t>(now + 250);
    CHECK(goesOn(transfer.onTime(now, pace)));
    CHECK(transfer.itemToAsk() == 1);
    CHECK(askedAhead(transfer, now) == 5);
  }
  CHECK((transfer.onTime(static_cast<uint16_t>(now + 250), pace) == Status::TimedOut));
}

TEST_CASE("of several the first to come shows how long the line takes, and no later one") {
  DownloadTransfer transfer = fetching(20);
  askedAhead(transfer, 0);
  CHECK(came(transfer, 0, 40));
  CHECK(pace.roundTripMs() == 40);
  askedAhead(transfer, 40);
  CHECK(came(transfer, 1, 5));  // 65,541 ms: more than the clock has bits for
  CHECK(pace.roundTripMs() == 40);
  askedAhead(transfer, 5);
  CHECK_FALSE(came(transfer, 1, 900));  // once more: it shows nothing either
  CHECK(pace.roundTripMs() == 40);
  // Nothing comes: what comes then took at least so long since the last sign of it.
  CHECK(goesOn(transfer.onTime(5 + 250, pace)));
  CHECK(transfer.toSend() == Send::Request);
  transfer.sent(260);
  CHECK(came(transfer, 2, 262));
  CHECK(pace.roundTripMs() == 40);
}
