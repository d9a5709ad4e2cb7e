#include "mavmission/transfer/FileWriteTransfer.h"

#include <doctest/doctest.h>
#include <string.h>

#include <string>

#include "Names.h"
#include "Script.h"

using namespace mavmission;
using namespace mavmission::detail;
using State = FileWriteTransfer::State;

namespace {

class Writing : public Player {
 public:
  FileWriteTransfer transfer;

  explicit Writing(uint16_t items) {
    memset(static_cast<void*>(&transfer), 0xA5, sizeof(transfer));  // whatever another operation has left there
    transfer.begin(items);
  }

 private:
  bool isSlow_ = false;
  uint16_t sequence_ = 0;

  // Each request leaves after its number.
  // answer N: to the request with this number; line slow: what leaves from here on is not all gone before "left"
  // written: notes how many items have been
  void happens(const Event& event) override {
    if (event.is("answer") && transfer.onAnswer(static_cast<uint16_t>(event.number), now(), pace)) note("closed");
    if (event.is("line slow")) isSlow_ = true;
    if (event.is("left")) transfer.onLeft(now());
    if (event.is("written")) note("written " + std::to_string(transfer.itemsWritten()));
  }
  Status onTime() override { return transfer.onTime(now(), pace); }
  void leave() override {
    while (status_ == Status::Transferring && !transfer.isLeaving() && transfer.isDue()) {
      const State state = transfer.state();
      const FileWriteTransfer::Request request = transfer.begun(sequence_);
      CHECK(transfer.isLeaving());
      std::string what = state == State::Creating ? "create" : state == State::Heading ? "header" : "close";
      if (state == State::Items) what = "item " + std::to_string(request.first);
      if (request.count > 1) what = "items" + what.substr(4) + "-" + std::to_string(request.first + request.count - 1);
      note("#" + std::to_string(request.sequence) + " " + what);
      if (!isSlow_) transfer.onLeft(now());
    }
  }
};

}  // namespace

TEST_CASE("a file is created, its items written six at a time, then its header, and it is closed") {
  CHECK(Writing(8).plays("wait 100, answer 1, wait 100, answer 2, written, wait 100, answer 3, wait 100, answer 4, "
                         "wait 100, answer 5") ==
        "#1 create, 100 #2 items 0-5, 100 #3 items 6-7, written 6, 100 #4 header, 100 #5 close, 100 closed");
  // An empty plan is a header alone.
  CHECK(Writing(0).plays("answer 1, answer 2") == "#1 create, #2 header, #3 close");
}

TEST_CASE("each request has a number of its own, and its repeats have the same") {
  Writing writing(1);
  CHECK(writing.plays("wait 620") == "#1 create, 600 #1 create");
  CHECK(writing.transfer.isOpen(1));
  CHECK_FALSE(writing.transfer.isOpen(2));
  CHECK(writing.plays("answer 1") == "#2 item 0");
  CHECK_FALSE(writing.transfer.isOpen(1));
}

TEST_CASE("two writes are on their way where the answers come quickly") {
  Writing writing(20);
  CHECK(writing.plays("wait 40, answer 1") == "#1 create, 40 #2 items 0-5, #3 items 6-11");
  // The header waits for both, whichever is answered first.
  CHECK(writing.plays("answer 3, answer 2") == "#4 items 12-17, #5 items 18-19");
  CHECK(writing.plays("answer 5") == "");
  CHECK(writing.plays("answer 4") == "#6 header");
}

TEST_CASE("an answer after more than 40 ms, or to a repeat, lets one write go at a time") {
  CHECK(Writing(20).plays("wait 41, answer 1") == "#1 create, 41 #2 items 0-5");
  CHECK(Writing(20).plays("wait 620, answer 1") == "#1 create, 600 #1 create, 20 #2 items 0-5");
}

TEST_CASE("a lossy link is given one item at a time, also of a write that was longer") {
  Writing writing(8);
  CHECK(writing.plays("wait 100, answer 1, lossy, wait 50") == "#1 create, 100 #2 items 0-5, 50 #3 item 0");
  CHECK(writing.plays("answer 3 to 10") ==
        "#4 item 1, #5 item 6, #6 item 2, #7 item 7, #8 item 3, #9 item 4, #10 item 5, #11 header");
}

TEST_CASE("an answer that comes while its repeat is leaving is taken, and the repeat leaves") {
  CHECK(Writing(7).plays("wait 100, answer 1, line slow, wait 1010, answer 2, written, wait 10, left") ==
        "#1 create, 100 #2 items 0-5, 1000 #2 items 0-5, 10 written 6, 10 #3 item 6");
}

TEST_CASE("silence ends the writing as its state says") {
  CHECK(Writing(1).plays("silence") == "#1 create, 600 #1 create (11 times), 600 NoAnswer");
  const std::string created = "wait 100, answer 1, ", written = created + "answer 2, ", headed = written + "answer 3, ";
  CHECK(Writing(1).plays(created + "silence") == "#1 create, 100 #2 item 0, 1000 #2 item 0 (7 times), 1000 TimedOut");
  CHECK(Writing(1).plays(written + "silence") ==
        "#1 create, 100 #2 item 0, #3 header, 1000 #3 header (7 times), 1000 Unconfirmed");
  CHECK(Writing(1).plays(headed + "silence") ==
        "#1 create, 100 #2 item 0, #3 header, #4 close, 1000 #4 close (7 times), 1000 Unconfirmed");
}
