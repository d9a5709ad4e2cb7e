// ensure() by a whole client: the look, and what follows it.
#include <doctest/doctest.h>

#include "ClientOnLine.h"

using namespace mavmission;

namespace {

constexpr MissionItem kPlan[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m)};
constexpr uint8_t kDenied = 14, kCancelled = 15;

FrameParts countParts(uint16_t items, uint32_t opaqueId = 0) {
  Bytes payload = {static_cast<uint8_t>(items), static_cast<uint8_t>(items >> 8), 1, 191, 0};
  for (int shift = 0; shift < 32; shift += 8) payload.push_back(static_cast<uint8_t>(opaqueId >> shift));
  return FrameParts(44, payload, 221);
}

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
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 100));
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
  desk.hear(countParts(2, 0x12345678));
  CHECK(desk.runUntilSent(ClientOnLine::kCount, 100));
  CHECK(desk.timesOf(ClientOnLine::kRequestInt, 0).empty());
}

TEST_CASE("a PX4 that names no checksum is read") {
  Looking desk(ClientOnLine::kPx4);
  desk.hear(countParts(2));
  CHECK(desk.runUntilSent(ClientOnLine::kRequestInt, 100));
}

TEST_CASE("what was known to be aboard is not known while another plan is looked for") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(3000);
  desk.client.clear();
  REQUIRE(desk.runUntilSent(45, 3000));
  desk.hear(ackParts(0));
  desk.run(10);
  REQUIRE((desk.client.aboard() == Aboard::Nothing));
  desk.client.ensure(inRam(kPlan));
  CHECK((desk.client.aboard() == Aboard::NotKnown));
}
