// ensure() by a whole client: the look, and what follows it.
#include <doctest/doctest.h>

#include "ClientOnLine.h"
#include "PlanFrames.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr MissionItem kPlan[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m)};
constexpr uint8_t kDenied = 14, kCancelled = 15;

struct Looking : ClientOnLine {
  explicit Looking(uint8_t autopilot) : ClientOnLine(autopilot) {
    run(3000);
    client.ensure(inRam(kPlan));
    REQUIRE(runUntilSent(kRequestList, 3000));
  }
};

}  // namespace

TEST_CASE("the look asks every 1500 ms, up to 5 times, and then says NoAnswer") {
  Looking desk(ClientOnLine::kArduPilot);
  const uint32_t firstMs = desk.nowMs();
  desk.run(9000);
  CHECK(desk.timesOf(ClientOnLine::kRequestList, firstMs) == std::vector<uint32_t>{0, 1500, 3000, 4500, 6000});
  CHECK((desk.ended == Status::NoAnswer));
  CHECK(desk.timesOf(ClientOnLine::kCount, firstMs).empty());
}

TEST_CASE("a refusal of the look is believed when all attempts are used up") {
  Looking desk(ClientOnLine::kArduPilot);
  desk.hear(ackParts(kDenied));
  desk.run(3000);
  CHECK(desk.client.isBusy());
  desk.run(6000);
  CHECK((desk.ended == Status::Denied));
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("the end of an older upload of ours begins the look anew at once") {
  Looking desk(ClientOnLine::kArduPilot);
  desk.sent.clear();
  desk.hear(ackParts(kDenied));
  desk.run(100);
  desk.hear(ackParts(kCancelled));
  CHECK(desk.runUntilSent(ClientOnLine::kRequestList, 10));
}

TEST_CASE("the reading is closed before MISSION_COUNT leaves, and the first denial of that is not believed") {
  Looking desk(ClientOnLine::kArduPilot);
  desk.sent.clear();
  desk.hear(countParts(7));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 600));
  REQUIRE(desk.sent.size() >= 2);
  CHECK(desk.sent[desk.sent.size() - 2].messageId == ClientOnLine::kAck);
  CHECK(desk.sent[desk.sent.size() - 2].payload[2] == kCancelled);
  desk.hear(ackParts(kDenied));
  desk.run(100);
  CHECK(desk.client.isBusy());
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 2000));
  desk.hear(ackParts(kDenied));
  desk.run(100);
  CHECK((desk.ended == Status::Denied));
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("PX4's checksum decides by itself, and the same number of items does not") {
  Looking desk(ClientOnLine::kPx4);
  desk.sent.clear();
  desk.hear(countParts(2, PlanType::Mission, 0x12345678));
  CHECK(desk.runUntilSent(ClientOnLine::kCount, 600));
  CHECK(desk.timesOf(ClientOnLine::kRequestInt, 0).empty());
}

TEST_CASE("a PX4 that names no checksum is read") {
  Looking desk(ClientOnLine::kPx4);
  desk.hear(countParts(2));
  CHECK(desk.runUntilSent(ClientOnLine::kRequestInt, 100));
}

TEST_CASE("what was known to be aboard is not known from the question on whether another plan is there") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(3000);
  desk.client.clear();
  REQUIRE(desk.runUntilSent(45, 3000));
  desk.hear(ackParts(0));
  desk.run(10);
  REQUIRE((desk.client.aboard() == Aboard::Nothing));
  desk.client.ensure(inRam(kPlan));
  CHECK((desk.client.aboard() == Aboard::Nothing));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 9000));
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}

namespace {

// Answers every request for an item of kPlan, and ends when nothing is asked any more.
void answerReading(ClientOnLine& desk, uint16_t changed = 0xFFFF) {
  for (uint16_t seq = 0; seq < 2; ++seq) {
    FrameParts parts = itemParts(seq, kPlan[seq]);
    if (seq == changed) parts.payload[16] = static_cast<uint8_t>(parts.payload[16] ^ 1);  // x
    desk.hear(parts);
    desk.run(5);
  }
}

}  // namespace

TEST_CASE("a plan that is read and found is aboard, and all its items are done") {
  Looking desk(ClientOnLine::kOther);
  desk.hear(countParts(2));
  desk.run(5);
  CHECK(desk.client.itemsDone() == 0);
  answerReading(desk);
  CHECK((desk.ended == Status::AlreadyAboard));
  CHECK((desk.client.aboard() == Aboard::OurPlan));
  CHECK((desk.client.aboard(PlanType::Fence) == Aboard::NotKnown));
  CHECK(desk.client.itemsDone() == 2);
  CHECK((desk.client.failedItem() == MissionClient::kNoItem));
}

TEST_CASE("an item that differs begins the upload, and is forgotten then") {
  Looking desk(ClientOnLine::kOther);
  desk.hear(countParts(2));
  desk.run(5);
  answerReading(desk, 1);
  desk.run(600);
  CHECK(desk.timesOf(ClientOnLine::kCount, 0).size() == 1);
  CHECK((desk.client.failedItem() == MissionClient::kNoItem));
  CHECK((desk.client.differingField() == ItemField::None));
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}

TEST_CASE("ensure() of a fence looks for a fence") {
  ClientOnLine desk(ClientOnLine::kOther);
  desk.run(3000);
  desk.client.ensure(emptyPlan(), PlanType::Fence);
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  CHECK(desk.sent.back().payload[2] == static_cast<uint8_t>(PlanType::Fence));
}

TEST_CASE("a look that takes too long ends as such") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(3000);
  desk.client.setOperationTimeout(3);
  desk.client.ensure(inRam(kPlan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  desk.run(3100);
  CHECK((desk.ended == Status::TookTooLong));
}

TEST_CASE("a look that is denied again and again is taken up after the back-off") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(3000);
  desk.client.retryWhenBusy(60);
  desk.client.ensure(inRam(kPlan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  desk.hear(ackParts(kDenied));
  desk.run(7600);
  CHECK((desk.client.status() == Status::BackingOff));
  desk.sent.clear();
  const uint32_t pausedMs = desk.nowMs();
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  CHECK(desk.nowMs() - pausedMs > 800);
}

TEST_CASE("an upload behind a look that is denied twice backs off, and then looks again") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(3000);
  desk.client.retryWhenBusy(60);
  desk.client.ensure(inRam(kPlan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  desk.hear(countParts(7));
  for (int i = 0; i < 2; ++i) {
    REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 2000));
    desk.hear(ackParts(kDenied));
    desk.run(10);
  }
  CHECK((desk.client.status() == Status::BackingOff));
  desk.sent.clear();
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  CHECK(desk.timesOf(ClientOnLine::kCount, 0).empty());
}

TEST_CASE("ACCEPTED and INVALID_SEQUENCE, late answers to something earlier, do not end a look") {
  Looking desk(ClientOnLine::kOther);
  for (uint8_t result : {0, 13}) desk.hear(ackParts(result));
  desk.run(5);
  desk.hear(countParts(2));
  desk.run(5);
  for (uint8_t result : {0, 13}) desk.hear(ackParts(result));
  desk.run(5);
  CHECK(desk.client.isBusy());
  answerReading(desk);
  CHECK((desk.ended == Status::AlreadyAboard));
}

TEST_CASE("a refusal while items are read ends the look with it") {
  Looking desk(ClientOnLine::kArduPilot);
  desk.hear(countParts(3));
  desk.run(5);
  desk.hear(ackParts(kDenied));
  desk.run(5);
  CHECK((desk.ended == Status::Denied));
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}

namespace {

// An empty plan is uploaded behind the look, and read back: REQUEST_LIST has been sent once.
struct ProvingEmpty : ClientOnLine {
  ProvingEmpty() : ClientOnLine(ClientOnLine::kArduPilot) {
    run(3000);
    client.ensure(emptyPlan(), PlanType::Mission, Readback::Always);
    REQUIRE(runUntilSent(kRequestList, 3000));
    hear(countParts(2));
    REQUIRE(runUntilSent(kCount, 600));
    hear(ackParts(0));
    REQUIRE(runUntilSent(kRequestList, 100));
    hear(countParts(2));  // the look's, which the line brings again
    run(5);
  }
};

}  // namespace

TEST_CASE("a COUNT of the look that the line repeats is not the one of the read-back") {
  ProvingEmpty desk;
  CHECK(desk.client.isBusy());
  desk.hear(countParts(1));  // home
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestInt, 100));
}

TEST_CASE("another number of items in the read-back behind a look is believed when it comes again") {
  ProvingEmpty desk;
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 2000));
  desk.hear(countParts(2));
  desk.run(5);
  CHECK((desk.ended == Status::Differs));
  CHECK((desk.client.differingField() == ItemField::Count));
}
