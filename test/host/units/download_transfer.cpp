#include "mavmission/transfer/DownloadTransfer.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <string>

#include "Script.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef DownloadTransfer::State State;
typedef DownloadTransfer::Send Send;

class Download : public Player {
 public:
  DownloadTransfer transfer;

  explicit Download(uint16_t startMs = 0) : Player(startMs) {
    memset(static_cast<void*>(&transfer), 0xA5, sizeof(transfer));  // in the client it may hold anything
    transfer.begin(now());
  }

 private:
  bool asksAhead_ = false, answersAny_ = true;

  // count N: MISSION_COUNT; item N: it comes; "ignored" if it is no answer. result N: MISSION_ACK
  // again: the item that came could not be used; ahead, one by one: several may be asked for at once, or not
  // by timers: the autopilot does not answer each request by itself
  void happens(const Event& event) override {
    const uint16_t number = static_cast<uint16_t>(event.number);
    if (event.is("count") && !transfer.onCount(number, now(), pace)) note("ignored");
    if (event.is("item") && !comes(number)) note("ignored");
    if (event.is("result")) status_ = transfer.onAck(static_cast<uint8_t>(number));
    if (event.is("again")) transfer.askAgain();
    if (event.is("ahead") || event.is("one by one")) asksAhead_ = event.is("ahead");
    if (event.is("by timers")) answersAny_ = false;
  }
  bool comes(uint16_t item) {
    if (!transfer.expectsItem(item, now(), pace)) return false;
    const uint8_t others = transfer.othersAsked();
    transfer.onItem(now(), pace);
    transfer.stayAhead(others, now());
    return true;
  }
  Status onTime() override { return transfer.onTime(now(), pace, answersAny_); }
  void leave() override {
    while (!isFull_ && transfer.toSend(asksAhead_) != Send::Nothing) {
      const Send send = transfer.toSend(asksAhead_);
      const uint16_t item = transfer.itemToAsk();
      const bool isLast = transfer.sent(now());
      if (send == Send::Request) {
        note("ask", item);
      } else {
        note(send == Send::List ? "list" : "acknowledge");
      }
      CHECK(isLast == (send == Send::Accepted));
      if (isLast) return;
    }
  }
};

// As far as the first item being asked for.
Download fetching(unsigned items) {
  Download download;
  CHECK(download.plays("count " + std::to_string(items)) == "list, ask 0");
  return download;
}

}  // namespace

TEST_CASE("a plan is asked for item by item, each when the one before has come, and then acknowledged") {
  CHECK(Download().plays("count 3, item 0 to 2") == "list, ask 0 to 2, acknowledge");
  CHECK(Download().plays("count 0") == "list, acknowledge");
}

TEST_CASE("a reading that is closed early asks for nothing more, and is acknowledged at once") {
  Download download = fetching(3);
  download.transfer.close();
  CHECK(download.transfer.othersAsked() == 0);
  CHECK(download.plays("wait 1") == "acknowledge");
}

TEST_CASE("the list is asked for 5 times, 1500 ms apart, and then there is no answer") {
  for (uint16_t startMs : {0, 65000}) {
    CHECK(Download(startMs).plays("silence") == "list, 1500 list (4 times), 1500 NoAnswer");
  }
}

TEST_CASE("an item is asked for 8 times, 250 ms apart, and then the time is out") {
  Download download = fetching(2);
  CHECK(download.plays("item 0, wait 1999") == "ask 1, 250 ask 1 (7 times)");
  CHECK(download.transfer.tries() == 8);
  CHECK(download.plays("wait 1") == "1 TimedOut");
}

TEST_CASE("on a lossy link, an item is asked for again after half the time of the list") {
  CHECK(Download().plays("by timers, lossy, wait 50") == "list, 50 list");
  CHECK(fetching(2).plays("by timers, lossy, wait 25") == "25 ask 0");
}

TEST_CASE("on a lossy link, an autopilot that answers each request is asked again when the answer is overdue") {
  Download download = fetching(2);
  download.pace.learn(20, true);
  CHECK(download.plays("lossy, wait 1845") == "15 ask 0 (63 times), 25 ask 0 (36 times)");
}

TEST_CASE("a question that the line has not taken yet is not counted, and no time runs") {
  CHECK(Download().plays("line full, wait 60000, line free, wait 1500") == "60000 list, 1500 list");
}

TEST_CASE("a count is an answer once, to a list that was asked for") {
  CHECK(fetching(2).plays("count 7") == "ignored");
  CHECK(Download().plays("line full, count 2, count 0, line free, count 2") == "ignored (2 times), list, ask 0");
}

TEST_CASE("an item that is not taken is asked for again at once, and has all its tries again") {
  Download download = fetching(2);
  CHECK(download.plays("wait 250") == "250 ask 0");
  CHECK(download.transfer.tries() == 2);
  download.plays("line full, again");
  CHECK(download.transfer.tries() == 0);
  CHECK(download.plays("line free") == "ask 0");
  CHECK(download.transfer.tries() == 1);
  CHECK(download.plays("item 0") == "ask 1");
}

TEST_CASE("each refusal ends the reading, but for the words that belong to something else") {
  const uint8_t kAccepted = 0, kInvalidSequence = 13;
  Download closing = fetching(1);
  closing.plays("line full, item 0");
  for (uint8_t result = 0; result <= 30; ++result) {
    const std::string refuses = "result " + std::to_string(result);
    const bool isNoise = result == kAccepted || result == kInvalidSequence;
    const std::string said = isNoise ? "" : nameOf(fromMissionResult(result));
    CHECK(fetching(2).plays(refuses) == said);
    CHECK(Download().plays(refuses) == (isNoise ? "list" : "list, " + said));
    CHECK(closing.plays(refuses) == "");  // every item is there
  }
}

TEST_CASE("an item that comes before it was asked for is no answer") {
  Download download;
  CHECK(download.plays("wait 0, line full, count 2, item 0, line free") == "list, ignored, ask 0");
  CHECK(download.plays("line full, item 0, item 1, line free, item 0") == "ignored, ask 1, ignored");
  CHECK(download.plays("item 1") == "acknowledge");
  CHECK(download.transfer.state() == State::Closing);
}

TEST_CASE("an item that comes again shows how long the line takes, however soon its first coming was") {
  Download download = fetching(3);
  const auto roundTripMs = [&download](const char* script) {
    download.plays(script);
    return download.pace.roundTripMs();
  };
  CHECK(roundTripMs("sleep 20, line full, item 0") == 20);  // the answer to a request of an earlier reading
  CHECK(roundTripMs("sleep 20, item 0") == 20);             // the next one has not been asked for yet: it shows nothing
  CHECK(download.plays("sleep 20, line free") == "20 ask 1");
  CHECK(roundTripMs("sleep 10, item 0, sleep 830, item 2") == 20);
  CHECK(roundTripMs("sleep 100, item 0") == 940);
  CHECK(roundTripMs("sleep 4000, item 0") == uint16_t{Pace::kMostMs});
  CHECK(download.plays("sleep 100, item 1") == "100 ask 2");
}

TEST_CASE("where several may be asked for, five are under way, as long as there are so many") {
  Download download = fetching(7);
  CHECK(download.plays("ahead") == "ask 1 to 4");
  CHECK(download.plays("item 1, item 0") == "ignored, ask 5");
  CHECK(download.plays("item 2, item 1") == "ignored, ask 6");
  CHECK(download.plays("item 3, item 2, item 4, item 3, item 5, item 4, item 6, item 5") == "ignored (4 times)");
  CHECK(download.plays("item 7, item 6") == "ignored, acknowledge");
}

TEST_CASE("a list is asked for once, however many items may be asked for") {
  CHECK(Download().plays("ahead, wait 1, count 0, wait 1") == "list, 1 acknowledge");
}

TEST_CASE("of several nothing is asked for anew before their answers have had time to come, on a lossy link too") {
  Download download = fetching(9);
  download.pace.learn(300, true);
  CHECK(download.plays("sleep 100, ahead, one by one") == "100 ask 1, ask 2 to 4");
  CHECK(download.plays("lossy, sleep 200, item 0, wait 350") == "550 ask 1");
  CHECK(download.transfer.tries() == 2);  // it was one of several before
  // Now it is the only one, and repeated as ever.
  CHECK(download.plays("wait 37") == "37 ask 1");
}

TEST_CASE("an item that is one of several is asked for 8 times, too") {
  Download download = fetching(9);
  CHECK(download.plays("ahead, sleep 10, item 0") == "ask 1 to 4, 10 ask 5");
  CHECK(download.plays("silence") == times(7, "250 ask 1, ask 2 to 5") + "250 TimedOut");
}

TEST_CASE("of several the first to come shows how long the line takes, and no later one") {
  Download download = fetching(20);
  const auto roundTripMs = [&download](const char* script) {
    download.plays(script);
    return download.pace.roundTripMs();
  };
  CHECK(roundTripMs("ahead, sleep 40, item 0") == 40);
  CHECK(roundTripMs("sleep 65501, item 1") == 40);  // 65,541 ms: more than the clock has bits for
  CHECK(roundTripMs("sleep 895, item 1") == 40);    // once more: it shows nothing either
  // Nothing comes: what comes then took at least so long since the last sign of it.
  CHECK(download.plays("one by one, wait 1") == "1 ask 2");
  CHECK(roundTripMs("wait 2, item 2") == 40);
}
