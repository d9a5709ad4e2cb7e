// Downloads and verifications by a whole client.
#include <doctest/doctest.h>

#include "ClientOnLine.h"

using namespace mavmission;

namespace {

bool ignore(void*, uint16_t, const MissionItem&) { return true; }

FrameParts countParts(uint16_t items) {
  return FrameParts(44, {static_cast<uint8_t>(items), static_cast<uint8_t>(items >> 8), 1, 191, 0}, 221);
}

// The messages by which an item is asked for that never comes.
std::vector<uint16_t> requestsOfAnItem(uint8_t autopilot) {
  ClientOnLine desk(autopilot);
  desk.run(3000);
  desk.client.download(toFunction(ignore));
  REQUIRE(desk.runUntilSent(ClientOnLine::kRequestList, 3000));
  desk.hear(countParts(3));
  desk.sent.clear();
  desk.run(3000);
  CHECK((desk.ended == Status::TimedOut));
  std::vector<uint16_t> messages;
  for (const SentFrame& frame : desk.sent) {
    if (frame.messageId == ClientOnLine::kRequest || frame.messageId == ClientOnLine::kRequestInt) {
      messages.push_back(frame.messageId);
    }
  }
  return messages;
}

}  // namespace

TEST_CASE("an autopilot that is neither is asked for an item twice by the new request, then by both in turns") {
  const uint16_t newer = ClientOnLine::kRequestInt, older = ClientOnLine::kRequest;
  CHECK(requestsOfAnItem(ClientOnLine::kOther) ==
        std::vector<uint16_t>{newer, newer, older, newer, older, newer, older, newer});
}

TEST_CASE("ArduPilot and PX4 are asked for an item by the new request alone") {
  for (uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    CHECK(requestsOfAnItem(autopilot) == std::vector<uint16_t>(8, ClientOnLine::kRequestInt));
  }
}
