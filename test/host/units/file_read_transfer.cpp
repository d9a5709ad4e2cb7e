#include "mavmission/transfer/FileReadTransfer.h"

#include <doctest/doctest.h>
#include <string.h>

#include <string>

#include "Names.h"
#include "Script.h"

using namespace mavmission;
using namespace mavmission::detail;
using Send = FileReadTransfer::Send;

namespace {

class Reading : public Player {
 public:
  FileReadTransfer transfer;

  explicit Reading(bool takesAnyOrder = true) {
    memset(static_cast<void*>(&transfer), 0xA5, sizeof(transfer));  // whatever another operation has left there
    transfer.begin(takesAnyOrder);
  }

 private:
  // opened, count N, item N, burst ends, closed: the answers; what is not used is noted
  // taken: notes how many items have been; differs: what came is not what was expected, and the file is closed
  void happens(const Event& event) override {
    const uint16_t number = static_cast<uint16_t>(event.number);
    if (event.is("opened")) transfer.onOpened(now(), pace);
    if (event.is("count") && !transfer.onCount(number, now(), pace)) note("ignored count", number);
    if (event.is("item") && transfer.wants(number)) {
      transfer.onItem(number, now(), pace);
    } else if (event.is("item")) {
      transfer.onUnused(now());
      note("unused", number);
    }
    if (event.is("burst ends")) transfer.onBurstEnd();
    if (event.is("burst ends") && transfer.isTooSlow()) note("too slow");
    if (event.is("closed")) status_ = transfer.onClosed();
    if (event.is("taken")) note("taken", transfer.itemsTaken());
    if (event.is("differs")) transfer.close(Status::Differs);
  }
  Status onTime() override { return transfer.onTime(now(), pace); }
  void leave() override {
    if (isFull_) return;
    switch (transfer.toSend()) {
      case Send::Open: note("open"); break;
      case Send::Header: note("header"); break;
      case Send::Burst: note("burst", transfer.itemToAsk()); break;
      case Send::Item: note("item", transfer.itemToAsk()); break;
      case Send::Close: note("close"); break;
      case Send::Nothing: return;
    }
    transfer.sent(now());
  }
};

// As far as the first burst, which has been asked for.
Reading bursting(unsigned items, bool takesAnyOrder = true) {
  Reading reading(takesAnyOrder);
  CHECK(reading.plays("opened, count " + std::to_string(items)) == "open, header, burst 0");
  return reading;
}

}  // namespace

TEST_CASE("a file is opened, its length read, its items given in one burst, and it is closed") {
  CHECK(Reading().plays("wait 20, opened, wait 20, count 3, item 0 to 1, line full, item 2, taken, closed, line free, "
                        "wait 20, closed") == "open, 20 header, 20 burst 0, taken 3, close, 20 Downloaded");
}

TEST_CASE("answers to what was not asked for are ignored") {
  Reading reading;
  CHECK(reading.plays("line full, opened, line free, count 3, item 0, burst ends") ==
        "open, ignored count 3, unused 0");
  CHECK(reading.plays("line full, opened, count 3, line free, count 3, count 4, item 3, item 0 to 2") ==
        "ignored count 3, header, burst 0, ignored count 4, unused 3, close");
  CHECK(reading.transfer.count() == 3);
}

TEST_CASE("an empty file is closed at once, and a file of one item needs no burst") {
  CHECK(Reading().plays("opened, count 0") == "open, header, close");
  CHECK(Reading().plays("opened, count 1") == "open, header, item 0");
}

TEST_CASE("the opening is repeated 12 times, 600 ms apart, and then there is no FTP") {
  Reading reading;
  CHECK(reading.plays("silence") == "open, 600 open (11 times), 600 NoAnswer");
  CHECK(reading.transfer.tries() == 12);
}

TEST_CASE("an item is asked for 8 times, 250 ms apart, and then the time is out") {
  CHECK(bursting(2).plays("item 0, burst ends, silence") == "item 1, 250 item 1 (7 times), 250 TimedOut");
}

TEST_CASE("items that a burst has left out are read one by one, the first first") {
  CHECK(bursting(20).plays("item 0 to 1, item 4 to 6, item 8 to 19, item 5, burst ends, item 2, item 3, taken, item 7, "
                           "taken") == "unused 5, item 2 to 3, item 7, taken 19, close, taken 20");
}

TEST_CASE("the middle of a hole is not taken, its ends are") {
  Reading reading = bursting(6);
  CHECK(reading.plays("item 4, item 1, item 3, item 0") == "unused 1");
  CHECK(Reading(reading).plays("burst ends") == "item 1");
  CHECK(reading.plays("item 2, item 1, item 5") == "close");
}

TEST_CASE("there is room for 4 holes; what lies after a fifth is asked for again") {
  CHECK(bursting(40).plays("item 1, item 3, item 5, item 7, item 9, item 8, item 9, burst ends") ==
        "unused 9, too slow, item 0");
}

TEST_CASE("where the order matters nothing after a lost item is taken, and another burst brings it") {
  CHECK(bursting(20, false).plays("item 0, item 2 to 19, burst ends") == "unused 2 to 19, burst 1");
}

TEST_CASE("a burst of which more than 1 of 8 pieces is lost is the last, and many items are left to another way") {
  CHECK(bursting(16, false).plays("item 2 to 15, burst ends") == "unused 2 to 15, burst 0");
  CHECK(bursting(16, false).plays("item 3 to 15, burst ends") == "unused 3 to 15, too slow, item 0");
  CHECK(bursting(8).plays("burst ends") == "item 0");
}

TEST_CASE("a burst that falls silent is asked for anew, from what is missing") {
  CHECK(bursting(20).plays("wait 198, item 0 to 18, wait 250") == "448 item 19");
  CHECK(bursting(20).plays("wait 250") == "250 burst 0");
}

TEST_CASE(
    "on a lossy line that answers late a burst is asked for again after one and a half round trips, an item sooner") {
  for (bool isBurst : {true, false}) {
    Reading reading;
    CHECK(reading.plays("lossy, wait 1000, opened") == "open, 50 open (20 times), header");
    CHECK(reading.pace.roundTripMs() == 1000);  // whichever was answered: no more than a second
    CHECK(reading.plays(isBurst ? "wait 990, count 20" : "wait 990, count 1") ==
          (isBurst ? "100 header (9 times), 90 burst 0" : "100 header (9 times), 90 item 0"));
    CHECK(reading.pace.roundTripMs() == 990);
    CHECK(reading.plays("wait 1500") == (isBurst ? "1485 burst 0" : "100 item 0 (15 times)"));
  }
}

TEST_CASE("pieces of a burst show that the answer to a request after it is still to come") {
  CHECK(bursting(20, false).plays("item 0, wait 240, item 2, wait 240, item 3, wait 249") ==
        "240 unused 2, 240 unused 3");
}

TEST_CASE("a closing that is not answered ends the reading all the same, as it was to end") {
  CHECK(bursting(3).plays("differs, wait 250") == "close, 250 Differs");
}
