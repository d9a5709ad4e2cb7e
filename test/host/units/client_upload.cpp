// Uploads by a whole client.
#include <doctest/doctest.h>

#include <algorithm>

#include "ClientOnLine.h"

using namespace mavmission;

namespace {

typedef std::vector<uint32_t> Times;

const uint8_t kAccepted = 0, kError = 1, kNoSpace = 4, kDenied = 14;
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), returnToLaunch()};
const MissionItem kOne[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m)};

uint16_t itemOf(const SentFrame& frame) { return static_cast<uint16_t>(frame.payload[28] | frame.payload[29] << 8); }

// The first COUNTs of an upload are refused, the next one is left without an answer. When they left, from the first on.
Times countsWhenDenied(ClientOnLine& desk, int times) {
  desk.sent.clear();
  desk.client.uploadWithoutReadback(inRam(kPlan));
  for (int i = 0; i < times; ++i) {
    REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 20000));
    desk.hear(ackParts(kDenied));
  }
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 20000));
  return desk.timesOf(ClientOnLine::kCount, desk.sent.front().atMs);
}

bool isNear(const Times& times, const Times& expected) {
  bool isSo = times.size() == expected.size();
  for (size_t i = 0; isSo && i < times.size(); ++i) isSo = times[i] >= expected[i] && times[i] <= expected[i] + 10;
  return isSo;
}

}  // namespace

TEST_CASE("an upload goes out item by item as it is asked for, and each is the item that was asked for") {
  for (uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4, ClientOnLine::kOther}) {
    ClientOnLine desk(autopilot);
    desk.run(3000);
    desk.client.uploadWithoutReadback(inRam(kPlan));
    REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 3000));
    const uint16_t items = autopilot == ClientOnLine::kArduPilot ? 3 : 2;
    CHECK(desk.sent.back().payload[0] == items);
    for (uint16_t item = 0; item < items; ++item) {
      desk.hear(requestParts(item));
      REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
      CHECK(itemOf(desk.sent.back()) == item);
    }
    desk.hear(ackParts(kAccepted));
    desk.run(5);
    // The acceptance of an autopilot that is neither is no proof.
    const bool isKnown = autopilot != ClientOnLine::kOther;
    CHECK((desk.ended == (isKnown ? Status::Accepted : Status::Unconfirmed)));
    CHECK((desk.client.aboard() == (isKnown ? Aboard::OurPlan : Aboard::NotKnown)));
  }
}

TEST_CASE("a busy autopilot is tried again after 1, 2, 4, 8, 8 s, in each upload anew") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.client.retryWhenBusy(60);
  desk.run(11000);  // what came before can be answered no more
  const Times counts = countsWhenDenied(desk, 5);
  CHECK(isNear(counts, {0, 1000, 3000, 7000, 15000, 23000}));
  desk.client.cancel();
  desk.run(11000);
  CHECK(isNear(countsWhenDenied(desk, 2), {0, 1000, 3000}));
}

TEST_CASE("the time that is allowed for back-offs begins with the first refusal of each upload") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.client.retryWhenBusy(4);
  desk.run(11000);
  for (int upload = 0; upload < 2; ++upload) {
    CHECK(isNear(countsWhenDenied(desk, 2), {0, 1000, 3000}));
    desk.hear(ackParts(kDenied));  // the next one would come 7 s after the first
    desk.run(20);
    CHECK((desk.ended == Status::Denied));
    desk.ended = Status::Idle;
    desk.run(11000);
  }
}

TEST_CASE("the time that is allowed for back-offs begins with the refusal, and the last try may be at its very end") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.client.retryWhenBusy(3);
  desk.run(11000);
  desk.client.uploadWithoutReadback(inRam(kPlan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 1000));
  desk.run(4000);  // COUNT has been sent again twice
  desk.sent.clear();
  const uint32_t refusedMs = desk.nowMs();
  desk.hear(ackParts(kDenied));
  desk.run(50);
  CHECK((desk.client.status() == Status::BackingOff));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 20000));
  desk.hear(ackParts(kDenied));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 20000));
  CHECK(isNear(desk.timesOf(ClientOnLine::kCount, refusedMs), {1000, 3000}));
  CHECK((desk.client.status() == Status::Transferring));
}

TEST_CASE("an upload with retryWhenBusy() backs off after no other refusal") {
  const struct {
    uint8_t autopilot, result;
    Status status;
  } kRefusals[] = {{ClientOnLine::kArduPilot, kNoSpace, Status::NoSpace},
                   {ClientOnLine::kArduPilot, kError, Status::Error},
                   {ClientOnLine::kPx4, kNoSpace, Status::NoSpace},
                   {ClientOnLine::kOther, kNoSpace, Status::NoSpace}};
  for (const auto& refusal : kRefusals) {
    ClientOnLine desk(refusal.autopilot);
    desk.client.retryWhenBusy(60);
    desk.run(11000);
    desk.client.uploadWithoutReadback(inRam(kPlan));
    REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 1000));
    desk.hear(ackParts(refusal.result));
    desk.run(50);
    CHECK((desk.ended == refusal.status));
  }
}

TEST_CASE("PX4's error to COUNT is waited for as a denial is, and the wait can be cancelled") {
  for (const uint8_t result : {kError, kDenied}) {
    ClientOnLine desk(ClientOnLine::kPx4);
    desk.client.retryWhenBusy(60);
    desk.run(11000);
    desk.client.uploadWithoutReadback(inRam(kPlan));
    for (int i = 0; i < 9 && desk.client.status() != Status::BackingOff; ++i) {
      REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 3000));
      desk.hear(ackParts(result));
      desk.run(20);
    }
    CHECK((desk.client.status() == Status::BackingOff));
    CHECK(desk.runUntilSent(ClientOnLine::kCount, 1100));
    desk.hear(ackParts(kDenied));
    desk.run(20);
    REQUIRE((desk.client.status() == Status::BackingOff));
    desk.sent.clear();
    desk.client.cancel();
    desk.run(20000);
    CHECK((desk.ended == Status::Cancelled));
    CHECK(desk.timesOf(ClientOnLine::kCount, 0).empty());
  }
}

TEST_CASE("without time for a back-off a denial is the end, and with one second there is one more try") {
  for (const uint16_t seconds : {0, 1}) {
    ClientOnLine desk(ClientOnLine::kArduPilot);
    desk.client.retryWhenBusy(60);
    desk.client.retryWhenBusy(seconds);
    desk.run(11000);
    desk.client.uploadWithoutReadback(inRam(kPlan));
    REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 1000));
    desk.hear(ackParts(kDenied));
    desk.run(50);
    CHECK((desk.ended == (seconds == 0 ? Status::Denied : Status::Idle)));
    CHECK(desk.runUntilSent(ClientOnLine::kCount, 3000) == (seconds != 0));
  }
}

TEST_CASE("behind a back-off an upload begins anew, with the autopilot and the check of the plan") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.client.retryWhenBusy(60);
  desk.run(11000);
  countsWhenDenied(desk, 1);
  const std::vector<Status> expected = {Status::BackingOff, Status::WaitingForAutopilot, Status::Checking,
                                        Status::Transferring};
  REQUIRE(desk.returned.size() >= expected.size());
  CHECK(std::equal(expected.rbegin(), expected.rend(), desk.returned.rbegin()));
}

TEST_CASE("behind back-offs an upload has its whole time, and goes on as any other") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.client.retryWhenBusy(60);
  desk.client.setOperationTimeout(10);
  desk.run(11000);
  countsWhenDenied(desk, 4);  // 15 s later
  desk.run(5000);
  CHECK((desk.client.status() == Status::Transferring));
  for (uint16_t item = 0; item < 3; ++item) {
    desk.hear(requestParts(item));
    REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
  }
  desk.hear(ackParts(kAccepted));
  desk.run(5);
  CHECK((desk.ended == Status::Accepted));
}

TEST_CASE("an autopilot that fell silent during a back-off is waited for first") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.client.retryWhenBusy(60);
  desk.run(11000);
  countsWhenDenied(desk, 4);
  desk.hear(ackParts(kDenied));
  desk.beats = false;
  desk.run(7900);
  desk.sent.clear();
  desk.run(2000);
  CHECK((desk.client.status() == Status::WaitingForAutopilot));
  CHECK(desk.timesOf(ClientOnLine::kCount, 0).empty());
  desk.beats = true;
  CHECK(desk.runUntilSent(ClientOnLine::kCount, 1500));
}

TEST_CASE(
    "an upload that is begun on an autopilot that was not there yet has its whole time from the check of the plan on") {
  ClientOnLine desk(ClientOnLine::kPx4);
  desk.client.setOperationTimeout(3);
  desk.client.uploadWithoutReadback(inRam(kOne));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 10000));
  desk.run(2990);
  CHECK((desk.ended == Status::Idle));
  desk.run(1010);  // it is counted in whole seconds
  CHECK((desk.ended == Status::TookTooLong));
}
