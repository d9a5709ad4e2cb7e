#include "mavmission/transfer/FileWriteTransfer.h"

#include <doctest/doctest.h>
#include <string.h>

#include <vector>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef FileWriteTransfer::State State;
typedef FileWriteTransfer::Request Request;

Pace pace;
uint16_t sequence;

FileWriteTransfer begun(uint16_t items) {
  pace = Pace();

  sequence = 1000;
  FileWriteTransfer transfer;
  memset(static_cast<void*>(&transfer), 0xA5, sizeof(transfer));
  transfer.begin(items);
  return transfer;
}

// Sends what is due, all at once.
Request sent(FileWriteTransfer& transfer, uint16_t nowMs = 0) {
  REQUIRE(transfer.isDue());
  const Request request = transfer.begun(sequence);
  CHECK(transfer.isLeaving());
  transfer.onLeft(nowMs);
  CHECK_FALSE(transfer.isLeaving());
  return request;
}

FileWriteTransfer open(uint16_t items, uint16_t tookMs = 20) {
  FileWriteTransfer transfer = begun(items);
  CHECK_FALSE(transfer.onAnswer(sent(transfer).sequence, tookMs, pace));
  return transfer;
}

bool goesOn(Status status) { return status == Status::Transferring; }

}  // namespace

TEST_CASE("a file is created, its items written six at a time, then its header, and it is closed") {
  FileWriteTransfer transfer = begun(8);
  CHECK(transfer.state() == State::Creating);
  CHECK_FALSE(transfer.onAnswer(sent(transfer).sequence, 100, pace));
  CHECK(transfer.state() == State::Items);
  const Request first = sent(transfer);
  CHECK(first.first == 0);
  CHECK(first.count == 6);
  CHECK_FALSE(transfer.isDue());  // the answer was slow
  CHECK_FALSE(transfer.onAnswer(first.sequence, 100, pace));
  CHECK(transfer.itemsWritten() == 6);
  const Request second = sent(transfer);
  CHECK(second.first == 6);
  CHECK(second.count == 2);
  CHECK(transfer.state() == State::Items);
  CHECK_FALSE(transfer.onAnswer(second.sequence, 100, pace));
  CHECK(transfer.state() == State::Heading);
  CHECK_FALSE(transfer.onAnswer(sent(transfer).sequence, 100, pace));
  CHECK(transfer.state() == State::Closing);
  CHECK(transfer.onAnswer(sent(transfer).sequence, 100, pace));
}

TEST_CASE("each request has a number of its own, and its repeats have the same") {
  FileWriteTransfer transfer = begun(1);
  const Request create = sent(transfer);
  CHECK(create.sequence == 1001);
  CHECK(goesOn(transfer.onTime(599, pace)));
  CHECK_FALSE(transfer.isDue());
  CHECK(goesOn(transfer.onTime(600, pace)));
  CHECK(sent(transfer, 600).sequence == create.sequence);
  CHECK(transfer.isOpen(create.sequence));
  CHECK_FALSE(transfer.isOpen(1002));
  transfer.onAnswer(create.sequence, 620, pace);
  CHECK_FALSE(transfer.isOpen(create.sequence));
  CHECK(sent(transfer).sequence == 1002);
}

TEST_CASE("two writes are on their way where the answers come quickly") {
  FileWriteTransfer transfer = open(20);
  const Request one = sent(transfer), other = sent(transfer);
  CHECK(one.first == 0);
  CHECK(other.first == 6);
  CHECK_FALSE(transfer.isDue());
  // The header waits for both, whichever is answered first.
  transfer.onAnswer(other.sequence, 20, pace);
  const Request third = sent(transfer);
  CHECK(third.first == 12);
  CHECK(third.count == 6);
  transfer.onAnswer(one.sequence, 20, pace);
  const Request last = sent(transfer);
  CHECK(last.first == 18);
  CHECK(last.count == 2);
  transfer.onAnswer(last.sequence, 20, pace);
  CHECK(transfer.state() == State::Items);
  transfer.onAnswer(third.sequence, 20, pace);
  CHECK(transfer.state() == State::Heading);
}

TEST_CASE("an answer after more than 40 ms, or to a repeat, lets one write go at a time") {
  FileWriteTransfer late = open(20, 41);
  sent(late);
  CHECK_FALSE(late.isDue());

  FileWriteTransfer repeated = begun(20);
  const Request create = sent(repeated);
  repeated.onTime(600, pace);
  sent(repeated, 600);
  repeated.onAnswer(create.sequence, 620, pace);
  sent(repeated);
  CHECK_FALSE(repeated.isDue());
}

TEST_CASE("a lossy link is given one item at a time, also of a write that was longer") {
  FileWriteTransfer transfer = open(8, 100);
  const Request six = sent(transfer);
  CHECK(six.count == 6);
  pace.noteLoss();
  uint16_t now = 0;
  while (!transfer.isDue()) REQUIRE(goesOn(transfer.onTime(++now, pace)));
  std::vector<uint16_t> written;
  while (transfer.state() == State::Items) {
    const Request one = sent(transfer, now);
    CHECK(one.count == 1);
    CHECK(one.sequence != six.sequence);
    written.push_back(one.first);
    transfer.onAnswer(one.sequence, now, pace);
  }
  CHECK(written == std::vector<uint16_t>{0, 1, 2, 3, 4, 5, 6, 7});
}

TEST_CASE("an answer that comes while its repeat is leaving is taken, and the repeat leaves") {
  FileWriteTransfer transfer = open(7, 100);
  const Request six = sent(transfer);
  transfer.onTime(1000, pace);
  transfer.begun(sequence);
  transfer.onAnswer(six.sequence, 1010, pace);
  CHECK(transfer.itemsWritten() == 6);
  CHECK(transfer.isLeaving());
  transfer.onLeft(1020);
  const Request next = sent(transfer, 1020);
  CHECK(next.first == 6);
  CHECK(next.count == 1);
}

TEST_CASE("an empty plan is a header alone") {
  FileWriteTransfer transfer = open(0);
  CHECK(transfer.state() == State::Heading);
}

TEST_CASE("silence ends the writing as its state says") {
  struct {
    int answers;
    uint16_t waitMs;
    int tries;
    Status status;
  } const cases[] = {{0, 600, 12, Status::NoAnswer},
                     {1, 1000, 8, Status::TimedOut},
                     {2, 1000, 8, Status::Unconfirmed},
                     {3, 1000, 8, Status::Unconfirmed}};
  for (const auto& one : cases) {
    FileWriteTransfer transfer = begun(1);
    for (int answered = 0; answered < one.answers; ++answered) transfer.onAnswer(sent(transfer).sequence, 100, pace);
    uint16_t now = 65000;
    for (int tries = 0; tries < one.tries; ++tries) {
      sent(transfer, now);
      now = static_cast<uint16_t>(now + one.waitMs - 1);
      CHECK(goesOn(transfer.onTime(now, pace)));
      CHECK_FALSE(transfer.isDue());
      const Status status = transfer.onTime(++now, pace);
      CHECK((status == (tries + 1 < one.tries ? Status::Transferring : one.status)));
    }
  }
}
