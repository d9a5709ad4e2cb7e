#include "mavmission/transfer/FileReadTransfer.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef FileReadTransfer::State State;
typedef FileReadTransfer::Send Send;

Pace pace;

// In the client the memory may hold anything before begin().
FileReadTransfer begun(bool takesAnyOrder = true) {
  pace = Pace();

  FileReadTransfer transfer;
  memset(static_cast<void*>(&transfer), 0xA5, sizeof(transfer));
  transfer.begin(takesAnyOrder);
  return transfer;
}

// As far as the first burst, which has been asked for.
FileReadTransfer bursting(uint16_t items, bool takesAnyOrder = true) {
  FileReadTransfer transfer = begun(takesAnyOrder);
  transfer.sent(0);
  transfer.onOpened(0, pace);
  transfer.sent(0);
  transfer.onCount(items, 0, pace);
  transfer.sent(0);
  return transfer;
}

bool take(FileReadTransfer& transfer, uint16_t item, uint16_t nowMs = 0) {
  const bool isWanted = transfer.wants(item);
  if (isWanted) {
    transfer.onItem(item, nowMs, pace);
  } else {
    transfer.onUnused(nowMs);
  }
  return isWanted;
}

bool goesOn(Status status) { return status == Status::Transferring; }

}  // namespace

TEST_CASE("a file is opened, its length read, its items given in one burst, and it is closed") {
  FileReadTransfer transfer = begun();
  CHECK(transfer.toSend() == Send::Open);
  transfer.sent(0);
  CHECK(transfer.toSend() == Send::Nothing);
  transfer.onOpened(20, pace);
  CHECK(transfer.toSend() == Send::Header);
  transfer.sent(20);
  CHECK(transfer.onCount(3, 40, pace));
  CHECK(transfer.toSend() == Send::Burst);
  CHECK(transfer.itemToAsk() == 0);
  transfer.sent(40);
  for (uint16_t item = 0; item < 3; ++item) CHECK(take(transfer, item));
  CHECK(transfer.itemsTaken() == 3);
  CHECK(transfer.toSend() == Send::Close);
  CHECK(goesOn(transfer.onClosed()));
  transfer.sent(60);
  CHECK((transfer.onClosed() == Status::Downloaded));
}

TEST_CASE("answers to what was not asked for are ignored") {
  FileReadTransfer transfer = begun();
  transfer.onOpened(0, pace);
  CHECK(transfer.state() == State::Opening);
  transfer.sent(0);
  CHECK_FALSE(transfer.onCount(3, 0, pace));
  CHECK_FALSE(transfer.wants(0));
  transfer.onBurstEnd();
  transfer.onOpened(0, pace);
  CHECK_FALSE(transfer.onCount(3, 0, pace));
  transfer.sent(0);
  CHECK(transfer.onCount(3, 0, pace));
  CHECK_FALSE(transfer.onCount(4, 0, pace));
  CHECK(transfer.count() == 3);
  CHECK_FALSE(transfer.wants(3));
}

TEST_CASE("an empty file is closed at once, and a file of one item needs no burst") {
  CHECK(bursting(0).state() == State::Closing);
  FileReadTransfer transfer = begun();
  transfer.sent(0);
  transfer.onOpened(0, pace);
  transfer.sent(0);
  transfer.onCount(1, 0, pace);
  CHECK(transfer.toSend() == Send::Item);
}

TEST_CASE("the opening is repeated 12 times, 600 ms apart, and then there is no FTP") {
  FileReadTransfer transfer = begun();
  uint16_t now = 65000;
  for (int tries = 0; tries < 12; ++tries) {
    CHECK(transfer.toSend() == Send::Open);
    transfer.sent(now);
    CHECK(transfer.tries() == tries + 1);
    now = static_cast<uint16_t>(now + 599);
    CHECK(goesOn(transfer.onTime(now, pace)));
    CHECK(transfer.toSend() == Send::Nothing);
    const Status status = transfer.onTime(++now, pace);
    CHECK((status == (tries < 11 ? Status::Transferring : Status::NoAnswer)));
  }
}

TEST_CASE("an item is asked for 8 times, 250 ms apart, and then the time is out") {
  FileReadTransfer transfer = bursting(2);
  take(transfer, 0);
  transfer.onBurstEnd();
  uint16_t now = 0;
  for (int tries = 0; tries < 8; ++tries) {
    CHECK(transfer.toSend() == Send::Item);
    CHECK(transfer.itemToAsk() == 1);
    transfer.sent(now);
    now = static_cast<uint16_t>(now + 249);
    CHECK(goesOn(transfer.onTime(now, pace)));
    const Status status = transfer.onTime(++now, pace);
    CHECK((status == (tries < 7 ? Status::Transferring : Status::TimedOut)));
  }
}

TEST_CASE("items that a burst has left out are read one by one, the first first") {
  FileReadTransfer transfer = bursting(20);
  for (uint16_t item : {0, 1, 4, 5, 6, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19}) CHECK(take(transfer, item));
  CHECK_FALSE(take(transfer, 5));
  transfer.onBurstEnd();
  for (uint16_t item : {2, 3, 7}) {
    CHECK(transfer.toSend() == Send::Item);
    CHECK(transfer.itemToAsk() == item);
    transfer.sent(0);
    CHECK(take(transfer, item));
  }
  CHECK(transfer.state() == State::Closing);
  CHECK(transfer.itemsTaken() == 20);
}

TEST_CASE("the middle of a hole is not taken, its ends are") {
  FileReadTransfer transfer = bursting(6);
  CHECK(take(transfer, 4));
  CHECK_FALSE(transfer.wants(1));
  CHECK(take(transfer, 3));
  CHECK(take(transfer, 0));
  CHECK(transfer.itemToAsk() == 1);
  CHECK(take(transfer, 2));
  CHECK(take(transfer, 1));
  CHECK(take(transfer, 5));
  CHECK(transfer.state() == State::Closing);
}

TEST_CASE("there is room for 4 holes; what lies behind a fifth is asked for again") {
  FileReadTransfer transfer = bursting(40);
  uint16_t item = 0;
  for (; item < 8; item += 2) CHECK(take(transfer, item + 1));  // 0, 2, 4 and 6 are missing
  CHECK_FALSE(take(transfer, 9));
  CHECK(take(transfer, 8));
  CHECK(take(transfer, 9));
  CHECK(transfer.itemToAsk() == 0);
}

TEST_CASE("where the order matters nothing behind a lost item is taken, and another burst brings it") {
  FileReadTransfer transfer = bursting(20, false);
  take(transfer, 0);
  for (uint16_t item = 2; item < 20; ++item) CHECK_FALSE(take(transfer, item));
  transfer.onBurstEnd();
  CHECK(transfer.toSend() == Send::Burst);
  CHECK(transfer.itemToAsk() == 1);
  CHECK_FALSE(transfer.isTooSlow());
}

TEST_CASE("a burst of which more than 1 of 8 pieces is lost is the last, and many items are left to another way") {
  for (uint16_t lost : {2, 3}) {
    FileReadTransfer transfer = bursting(16, false);
    for (uint16_t item = lost; item < 16; ++item) take(transfer, item);
    transfer.onBurstEnd();
    CHECK((transfer.toSend() == (lost == 2 ? Send::Burst : Send::Item)));
    CHECK(transfer.isTooSlow() == (lost == 3));
  }
  FileReadTransfer few = bursting(8);
  few.onBurstEnd();
  CHECK(few.toSend() == Send::Item);
  CHECK_FALSE(few.isTooSlow());
}

TEST_CASE("a burst that falls silent is asked for anew, from what is missing") {
  FileReadTransfer transfer = bursting(20);
  for (uint16_t item = 0; item < 19; ++item) take(transfer, item, 11 * item);
  CHECK(goesOn(transfer.onTime(11 * 18 + 249, pace)));
  CHECK(transfer.toSend() == Send::Nothing);
  CHECK(goesOn(transfer.onTime(11 * 18 + 250, pace)));
  CHECK(transfer.toSend() == Send::Item);
  CHECK(transfer.itemToAsk() == 19);

  FileReadTransfer unheard = bursting(20);
  CHECK(goesOn(unheard.onTime(250, pace)));
  CHECK(unheard.toSend() == Send::Burst);
  CHECK(unheard.tries() == 1);
}

TEST_CASE(
    "on a lossy line that answers late a burst is asked for again after one and a half round trips, an item sooner") {
  for (bool isBurst : {true, false}) {
    FileReadTransfer transfer = begun(true);
    pace.noteLoss();
    transfer.sent(0);
    transfer.sent(50);              // repeated
    transfer.onOpened(1000, pace);  // whichever was answered: no more than a second
    CHECK(pace.roundTripMs() == 1000);
    transfer.sent(1000);
    transfer.onCount(isBurst ? 20 : 1, 1990, pace);
    CHECK(pace.roundTripMs() == 990);
    transfer.sent(1990);
    const uint16_t waitMs = isBurst ? 990 + 990 / 2 : Pace::kMostWaitMs;
    CHECK(goesOn(transfer.onTime(static_cast<uint16_t>(1990 + waitMs - 1), pace)));
    CHECK(transfer.toSend() == Send::Nothing);
    CHECK(goesOn(transfer.onTime(static_cast<uint16_t>(1990 + waitMs), pace)));
    CHECK(transfer.toSend() == (isBurst ? Send::Burst : Send::Item));
  }
}

TEST_CASE("pieces of a burst show that the answer to a request behind it is still to come") {
  FileReadTransfer transfer = bursting(20, false);
  take(transfer, 0);
  for (uint16_t item = 2; item < 20; ++item) take(transfer, item, 100 * item);
  CHECK(goesOn(transfer.onTime(1900 + 249, pace)));
  CHECK(transfer.toSend() == Send::Nothing);
}

TEST_CASE("a closing that is not answered ends the reading all the same, as it was to end") {
  FileReadTransfer transfer = bursting(3);
  transfer.close(Status::Differs);
  CHECK(transfer.toSend() == Send::Close);
  transfer.sent(0);
  CHECK(goesOn(transfer.onTime(249, pace)));
  CHECK((transfer.onTime(250, pace) == Status::Differs));
}
