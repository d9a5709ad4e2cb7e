#include "mavmission/transfer/DownloadTransfer.h"

#include <doctest/doctest.h>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef DownloadTransfer::State State;
typedef DownloadTransfer::Send Send;

Pace pace;

DownloadTransfer begun() {
  pace = Pace();
  pace.begin();
  DownloadTransfer transfer;
  transfer.begin(0);
  return transfer;
}

}  // namespace

TEST_CASE("a count that comes before the list was asked for is no answer") {
  DownloadTransfer transfer = begun();
  transfer.onCount(0);
  CHECK(transfer.state() == State::Listing);
  CHECK(transfer.toSend() == Send::List);
  transfer.sent(0);
  transfer.onCount(2);
  CHECK(transfer.state() == State::Fetching);
  CHECK(transfer.count() == 2);
}

TEST_CASE("an item that comes before it was asked for is no answer") {
  DownloadTransfer transfer = begun();
  transfer.sent(0);
  transfer.onCount(2);
  CHECK_FALSE(transfer.onItem(0, 0, pace));
  transfer.sent(0);
  CHECK(transfer.onItem(0, 0, pace));
  CHECK_FALSE(transfer.onItem(1, 0, pace));
  transfer.sent(0);
  CHECK_FALSE(transfer.onItem(0, 0, pace));
  CHECK(transfer.onItem(1, 0, pace));
  CHECK(transfer.state() == State::Closing);
}

TEST_CASE("a plan without items is read when its count has come") {
  DownloadTransfer transfer = begun();
  transfer.sent(0);
  transfer.onCount(0);
  CHECK(transfer.state() == State::Closing);
  CHECK(transfer.toSend() == Send::Accepted);
  CHECK(transfer.sent(0));
}
