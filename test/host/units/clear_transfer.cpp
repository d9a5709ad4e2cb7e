#include "mavmission/transfer/ClearTransfer.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef ClearTransfer::State State;

// In the client the memory may hold anything before begin().
ClearTransfer begun(PlanType type, bool isDoubtful = false) {
  ClearTransfer transfer;
  memset(static_cast<void*>(&transfer), 0xA5, sizeof(transfer));
  transfer.begin(type, isDoubtful);
  return transfer;
}

}  // namespace

namespace {
const Pace quiet = Pace();  // a line that has lost nothing
}

TEST_CASE("CLEAR_ALL is due at once, and nothing can answer it before it has left") {
  ClearTransfer transfer = begun(PlanType::Fence);
  CHECK((transfer.state() == State::Due));
  CHECK((transfer.type() == PlanType::Fence));
  CHECK_FALSE(transfer.hasBeenSent());
  transfer.sent(65000);
  CHECK((transfer.state() == State::Sent));
  CHECK(transfer.hasBeenSent());
}

TEST_CASE("CLEAR_ALL is repeated 1500 ms after it left, up to 5 attempts, across a wrap of the clock") {
  ClearTransfer transfer = begun(PlanType::Mission);
  uint16_t nowMs = 65000;
  CHECK((transfer.onTime(nowMs, quiet) == Status::Transferring));
  for (uint8_t sent = 1; sent <= ClearTransfer::kTries; ++sent) {
    CHECK((transfer.state() == State::Due));
    transfer.sent(nowMs);
    nowMs = static_cast<uint16_t>(nowMs + ClearTransfer::kAnswerMs - 1);
    CHECK((transfer.onTime(nowMs, quiet) == Status::Transferring));
    CHECK((transfer.state() == State::Sent));
    const bool isLast = sent == ClearTransfer::kTries;
    CHECK((transfer.onTime(++nowMs, quiet) == (isLast ? Status::NoAnswer : Status::Transferring)));
  }
}

TEST_CASE("one type is cleared by its acceptance") {
  for (PlanType type : {PlanType::Mission, PlanType::Fence, PlanType::Rally}) {
    ClearTransfer transfer = begun(type);
    transfer.sent(0);
    CHECK(transfer.onAccepted());
    CHECK_FALSE(transfer.next());
  }
}

TEST_CASE("all three are cleared one by one, each with its own attempts") {
  ClearTransfer transfer = begun(PlanType::All);
  for (PlanType type : {PlanType::Mission, PlanType::Fence}) {
    CHECK((transfer.type() == type));
    transfer.sent(0);
    CHECK((transfer.onTime(ClearTransfer::kAnswerMs, quiet) == Status::Transferring));
    transfer.sent(ClearTransfer::kAnswerMs);
    CHECK(transfer.onAccepted());
    CHECK(transfer.next());
    CHECK((transfer.state() == State::Due));
    CHECK_FALSE(transfer.hasBeenSent());
  }
  CHECK((transfer.type() == PlanType::Rally));
  transfer.sent(0);
  CHECK(transfer.onAccepted());
  CHECK_FALSE(transfer.next());
}

TEST_CASE("an acceptance that something else may have caused is proven by the number of items, and else not believed") {
  ClearTransfer transfer = begun(PlanType::Mission, true);
  for (uint8_t clears = 1; clears <= ClearTransfer::kTries; ++clears) {
    CHECK_FALSE(transfer.isAsking());
    transfer.sent(0);
    CHECK(transfer.tries() == clears);
    CHECK_FALSE(transfer.onAccepted());
    CHECK(transfer.isAsking());
    CHECK((transfer.state() == State::Due));
    CHECK_FALSE(transfer.hasBeenSent());
    ClearTransfer emptied = transfer;
    emptied.sent(0);
    CHECK(emptied.onCount(true));
    transfer.sent(0);
    CHECK_FALSE(transfer.onCount(false));
  }
  // As often as CLEAR_ALL is sent at all.
  CHECK((transfer.onTime(0, quiet) == Status::Unconfirmed));
}

TEST_CASE("an acceptance in doubt whose number of items is not heard is unconfirmed") {
  ClearTransfer transfer = begun(PlanType::Mission, true);
  transfer.sent(0);
  transfer.onAccepted();
  uint16_t nowMs = 0;
  for (uint8_t asked = 1; asked <= ClearTransfer::kTries; ++asked) {
    CHECK((transfer.onTime(nowMs, quiet) == Status::Transferring));
    transfer.sent(nowMs);
    nowMs = static_cast<uint16_t>(nowMs + ClearTransfer::kAnswerMs);
  }
  CHECK((transfer.onTime(nowMs, quiet) == Status::Unconfirmed));
}

TEST_CASE("on a lossy link CLEAR_ALL is repeated every 50 ms, up to 250 attempts") {
  Pace lossy = Pace();
  lossy.noteLoss();
  lossy.learn(30, true);
  ClearTransfer transfer = begun(PlanType::Mission);
  uint16_t nowMs = 65000;
  for (int sent = 1; sent <= 250; ++sent) {
    CHECK((transfer.state() == State::Due));
    transfer.sent(nowMs);
    nowMs = static_cast<uint16_t>(nowMs + 49);
    CHECK((transfer.onTime(nowMs, lossy) == Status::Transferring));
    CHECK((transfer.state() == State::Sent));
    CHECK((transfer.onTime(++nowMs, lossy) == (sent == 250 ? Status::NoAnswer : Status::Transferring)));
  }
}
