// When the listeners of telemetry request their messages beside what else a client does, and after a restart.
#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <string>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

constexpr uint16_t kCommandLong = MAVLINK_MSG_ID_COMMAND_LONG;
constexpr uint8_t kAccepted = 0;
const MissionItem kPlan[] = {waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), returnToLaunch()};

struct Desk : ClientOnLine {
  AttitudeListener listener;

  explicit Desk(uint16_t intervalMs = 1000) : ClientOnLine(kArduPilot), listener(client, intervalMs) {}

  void answer(uint8_t result = kAccepted) {
    const uint16_t command = MAV_CMD_SET_MESSAGE_INTERVAL;
    hear(FrameParts(MAVLINK_MSG_ID_COMMAND_ACK, {command & 255, command >> 8, result, 0, 0, 0, 0, 0, 1, 191},
                    MAVLINK_MSG_ID_COMMAND_ACK_CRC));
    run(1);
  }
  void come() {
    hear(FrameParts(MAVLINK_MSG_ID_ATTITUDE, Bytes(28, 0), MAVLINK_MSG_ID_ATTITUDE_CRC));
    run(1);
  }
  void beat(uint8_t systemId = 1) {
    FrameParts parts = heartbeatParts(kArduPilot);
    parts.systemId = systemId;
    hear(parts);
    run(1);
  }
  // When the listener's requests left [ms, since then].
  std::string requests(uint32_t fromMs) const {
    std::string times;
    for (const SentFrame& frame : sent) {
      mavlink_command_long_t command;
      memcpy(&command, frame.payload.data(), sizeof(command));
      const bool isOurs = frame.messageId == kCommandLong && command.command == MAV_CMD_SET_MESSAGE_INTERVAL &&
                          command.param1 == MAVLINK_MSG_ID_ATTITUDE;
      if (isOurs && frame.atMs >= fromMs) times += (times.empty() ? "" : " ") + std::to_string(frame.atMs - fromMs);
    }
    return times;
  }
};

}  // namespace

TEST_CASE("a gap of 2.5 s between two heartbeats may be a restart, and one of 2.499 s is none") {
  for (uint32_t gapMs : {2499u, 2500u}) {
    CAPTURE(gapMs);
    Desk desk;
    desk.run(3000);
    desk.answer();
    desk.beats = false;
    desk.beat();
    REQUIRE(desk.listener.isConfirmed());
    desk.run(gapMs - 1);
    desk.sent.clear();
    desk.beat();
    desk.run(1);
    CHECK(desk.listener.isConfirmed() == (gapMs == 2499));
    CHECK(desk.requests(0).empty() == (gapMs == 2499));
  }
}

TEST_CASE("after a restart the pauses between the requests begin anew") {
  Desk desk;
  desk.run(20000);  // pauses of 2, 4, 8 s: the next is one of 16
  desk.beats = false;
  desk.run(3000);
  desk.beats = true;
  const uint32_t fromMs = desk.nowMs();
  desk.run(15000);
  CHECK(desk.requests(fromMs) == "2 2002 6002 14002");
}

TEST_CASE("heartbeats that come more often than once a second do not bring a second request before the answer") {
  Desk desk;
  desk.beats = false;
  const uint32_t fromMs = desk.nowMs();
  for (int i = 0; i < 8; ++i) {
    desk.beat();
    desk.run(199);
  }
  CHECK(desk.requests(fromMs) == "2");
  desk.beat();
  desk.run(1);
  CHECK(desk.requests(fromMs) == "2 1602");
}

TEST_CASE("a message that is twice late is requested again: the intervals count in whole seconds") {
  for (uint16_t intervalMs : {999, 1000, 1999, 2000, 2999, 3000}) {
    CAPTURE(intervalMs);
    Desk desk(intervalMs);
    desk.run(500);
    REQUIRE_FALSE(desk.requests(0).empty());
    desk.answer();
    desk.come();
    const uint32_t fromMs = desk.nowMs() - desk.nowMs() % 1000;
    desk.sent.clear();
    desk.run(20000);
    const uint32_t seconds = 2u * (intervalMs / 1000u) + 3u;
    const std::string times = desk.requests(fromMs);
    CHECK(times.substr(0, times.find(' ')) == std::to_string(1000 * seconds + 2));
  }
}

TEST_CASE("nothing is requested while a command of the client's runs, and then it is") {
  Desk desk;
  desk.run(500);
  const uint32_t fromMs = desk.nowMs();
  static const FlightCommand zoom = flightCommand(531, 1);
  desk.client.send(zoom);
  desk.run(7000);
  REQUIRE((desk.client.status() == Status::Transferring));
  CHECK(desk.requests(fromMs).empty());
  desk.run(4000);
  REQUIRE_FALSE(desk.client.isBusy());
  CHECK_FALSE(desk.requests(fromMs).empty());
}

TEST_CASE("while a plan is transferred the requests go on") {
  Desk desk;
  desk.run(500);
  desk.client.uploadWithoutReadback(inRam(kPlan));
  REQUIRE(desk.runUntilSent(ClientOnLine::kCount, 3000));
  desk.hear(requestParts(0));
  REQUIRE(desk.runUntilSent(ClientOnLine::kItemInt, 50));
  const uint32_t fromMs = desk.nowMs();
  desk.run(6000);
  REQUIRE((desk.client.status() == Status::Transferring));
  CHECK_FALSE(desk.requests(fromMs).empty());
}

TEST_CASE("of two autopilots neither is asked") {
  Desk desk;
  desk.beats = false;
  desk.line.room = 0;  // the first request has not left yet
  for (int second = 0; second < 12; ++second) {
    desk.beat(1);
    desk.beat(2);
    if (second == 1) desk.line.room = MemoryStream::kAlwaysRoom;
    if (second == 1) desk.sent.clear();
    desk.run(998);
  }
  CHECK(desk.requests(0).empty());
}

TEST_CASE("a message that no listener wants is none's") {
  Desk desk(0);
  WindListener wind(desk.client, 0);
  desk.run(1500);
  const uint16_t before = desk.client.counters().unknownMessages;
  desk.hear(FrameParts(MAVLINK_MSG_ID_VFR_HUD, Bytes(20, 1), MAVLINK_MSG_ID_VFR_HUD_CRC));
  desk.run(100);
  CHECK(desk.client.counters().unknownMessages == before + 1);
  CHECK_FALSE(desk.listener.isHeard());
  CHECK_FALSE(wind.isHeard());
}
