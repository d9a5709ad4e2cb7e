#include "mavmission/base/Status.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <set>
#include <string>

#include "mavmission/transfer/Operations.h"

using namespace mavmission;

namespace {
const Status kAll[] = {
#define NAME(name, text) Status::name,
    MAVMISSION_STATUSES(NAME)
#undef NAME
};
const Aboard kAllAboard[] = {
#define NAME(name, text) Aboard::name,
    MAVMISSION_ABOARD(NAME)
#undef NAME
};
}  // namespace

TEST_CASE("every status has a text of its own") {
  std::set<std::string> texts;
  for (Status status : kAll) {
    REQUIRE(toString(status) != nullptr);
    CHECK(strlen(toString(status)) > 3);
    texts.insert(toString(status));
  }
  CHECK(texts.size() == sizeof(kAll) / sizeof(*kAll));
}

TEST_CASE("everything that can be aboard has a text of its own") {
  std::set<std::string> texts;
  for (Aboard aboard : kAllAboard) {
    REQUIRE(toString(aboard) != nullptr);
    texts.insert(toString(aboard));
  }
  CHECK(texts.size() == sizeof(kAllAboard) / sizeof(*kAllAboard));
}

TEST_CASE("each step of start() has a text of its own") {
  std::set<std::string> texts;
  for (uint8_t step = 0; step <= static_cast<uint8_t>(StartStep::Confirm); ++step) {
    REQUIRE(toString(static_cast<StartStep>(step)) != nullptr);
    texts.insert(toString(static_cast<StartStep>(step)));
  }
  CHECK(texts.size() == 7);
}

TEST_CASE("a value that is no status has no text") {
  CHECK(toString(static_cast<Status>(sizeof(kAll) / sizeof(*kAll))) == nullptr);
  CHECK(toString(static_cast<Status>(255)) == nullptr);
  CHECK(toString(static_cast<Aboard>(255)) == nullptr);
  CHECK(toString(static_cast<StartStep>(7)) == nullptr);
}

TEST_CASE("an operation is over with every status but the few at the beginning") {
  for (Status status :
       {Status::Idle, Status::WaitingForAutopilot, Status::BackingOff, Status::Checking, Status::Transferring}) {
    CHECK_FALSE(isEnd(status));
  }
  int running = 0;
  for (Status status : kAll) running += !isEnd(status);
  CHECK(running == 5);
  for (Status status :
       {Status::Accepted, Status::Unconfirmed, Status::Cancelled, Status::Busy, Status::UnknownResult}) {
    CHECK(isEnd(status));
  }
}

TEST_CASE("each MAV_MISSION_RESULT has its status, and an unknown one its own") {
  const Status inOrder[] = {
      Status::Accepted,      Status::Error,           Status::UnsupportedFrame, Status::Unsupported,
      Status::NoSpace,       Status::Invalid,         Status::InvalidParam1,    Status::InvalidParam2,
      Status::InvalidParam3, Status::InvalidParam4,   Status::InvalidParam5,    Status::InvalidParam6,
      Status::InvalidParam7, Status::InvalidSequence, Status::Denied,           Status::CancelledByAutopilot};
  for (unsigned result = 0; result <= 255; ++result) {
    const Status expected = result < 16 ? inOrder[result] : Status::UnknownResult;
    CHECK((fromMissionResult(static_cast<uint8_t>(result)) == expected));
  }
}

TEST_CASE("only what may go well as it is is worth a retry") {
  for (Status status : kAll) {
    const std::string text = toString(status);
    // The plan, or what the sketch asked for, is at fault: the same would be refused again.
    if (text.compare(0, 8, "refused:") == 0 || text.find(": bad ") != std::string::npos) {
      CHECK_FALSE_MESSAGE(isWorthRetry(status), text);
    }
    if (!isEnd(status)) CHECK_FALSE_MESSAGE(isWorthRetry(status), text);
  }
  for (Status status :
       {Status::Accepted, Status::AlreadyAboard, Status::Verified, Status::Downloaded, Status::Cleared, Status::Done,
        Status::Cancelled, Status::Busy, Status::Infeasible, Status::TakenOver, Status::Overruled}) {
    CHECK_FALSE_MESSAGE(isWorthRetry(status), toString(status));
  }
  for (Status status :
       {Status::NoAnswer, Status::TimedOut, Status::TookTooLong, Status::Unconfirmed, Status::Differs, Status::Error,
        Status::NoSpace, Status::Denied, Status::OtherPlanAboard, Status::CancelledByAutopilot}) {
    CHECK_MESSAGE(isWorthRetry(status), toString(status));
  }
}
