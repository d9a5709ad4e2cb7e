#include <doctest/doctest.h>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

FrameParts missionCurrent() { return FrameParts(MAVLINK_MSG_ID_MISSION_CURRENT, Bytes(6, 0), 28); }

// Whether a SET_MESSAGE_INTERVAL of the client's leaves within this time.
bool leavesWithin(ClientOnLine& on, uint32_t ms) {
  on.sent.clear();
  on.client.setMessageInterval(30, 100000);
  return on.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, ms);
}

}  // namespace

TEST_CASE("a listener's request that nobody answers delays a command for 1.5 s, and not again when the clock wraps") {
  ClientOnLine on(ClientOnLine::kArduPilot);
  MissionFollower follower(on.client);
  REQUIRE(on.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 8000));
  const uint32_t askedMs = on.nowMs();
  SUBCASE("at once") {
    CHECK(!leavesWithin(on, 1400));
    CHECK(on.runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 200));
  }
  SUBCASE("after 65.7 s, when 16 bits of milliseconds are what they were") {
    while (on.nowMs() - askedMs < 65700) {
      on.hear(missionCurrent());  // so that the follower does not ask again
      on.run(100);
    }
    CHECK(leavesWithin(on, 100));
  }
}
