// When a telemetry listener requests its message: by itself, beside another one, beside what else a client does, and
// after a restart.
#include <doctest/doctest.h>

#include <string>

#include "PlanFrames.h"
#include "Script.h"
#include "ToldClient.h"
#include "mavmission/telemetry/AttitudeListener.h"
#include "mavmission/telemetry/EstimatorListener.h"
#include "mavmission/telemetry/GpsListener.h"
#include "mavmission/telemetry/WindListener.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = ClientOnLine::kArduPilot, kPx4 = ClientOnLine::kPx4;

// A client with a listener that requests its message every `intervalMs`, or not at all where that is 0.
template <typename Listener>
struct Desk : Told<Listener> {
  explicit Desk(uint16_t intervalMs = 0, uint8_t autopilot = kArduPilot) : Told<Listener>(intervalMs, autopilot) {}

  // The requests that leave, "30 each 250", a message and its interval in ms, and "2 again", so many seconds after the
  // one before, when this happens:
  // until asked: the next one has left; wait N: N seconds pass; accepted, denied: the answer; comes: the message
  // no room, room: to send
  std::string plays(const std::string& script) {
    Transcript said;
    for (const Event& event : eventsOf(script)) {
      this->sent.clear();
      if (event.is("until asked")) REQUIRE(this->runUntilSent(MAVLINK_MSG_ID_COMMAND_LONG, 20000));
      if (event.is("wait")) this->run(1000 * event.number);
      if (event.is("accepted")) answer(MAV_RESULT_ACCEPTED);
      if (event.is("denied")) answer(MAV_RESULT_DENIED);
      if (event.is("comes")) this->tell("ATTITUDE");
      if (event.is("no room")) this->line.room = 0;
      if (event.is("room")) this->line.room = MemoryStream::kAlwaysRoom;
      for (const SentFrame& frame : this->sent) {
        if (frame.messageId != MAVLINK_MSG_ID_COMMAND_LONG) continue;
        const auto command = messageIn<mavlink_command_long_t>(frame.payload);
        const std::string id = std::to_string(static_cast<long>(command.param1));
        const std::string us = std::to_string(static_cast<long>(command.param2));
        CHECK(wordsOf(frame.messageId, frame.payload) ==
              "COMMAND_LONG target_system 1 target_component 1 command 511 "
              "param1 " +
                  id + " param2 " + us);
        const uint32_t seconds = askedMs_ == 0 ? 0 : (frame.atMs - askedMs_ + 500) / 1000;
        const std::string asked = id + " each " + us.substr(0, us.size() - 3);
        said.note(asked == asked_ ? "again" : asked, seconds);
        askedMs_ = frame.atMs;
        asked_ = asked;
      }
    }
    return said.text();
  }
  void answer(uint8_t result = MAV_RESULT_ACCEPTED) {
    this->tell(commandAckParts(MAV_CMD_SET_MESSAGE_INTERVAL, result));
    this->run(5);
  }
  void beat(uint8_t systemId = 1) {
    FrameParts parts = heartbeatParts(kArduPilot);
    parts.systemId = systemId;
    this->tell(parts);
  }

 private:
  uint32_t askedMs_ = 0;
  std::string asked_;
};

typedef Desk<AttitudeListener> Attitude;

}  // namespace

TEST_CASE("a message is requested at its interval, as soon as the autopilot is known") {
  Attitude desk(250);
  CHECK(desk.plays("until asked") == "30 each 250");
  CHECK_FALSE(desk.listener.isConfirmed());
  desk.plays("accepted");
  CHECK(desk.listener.isConfirmed());
  CHECK_FALSE(desk.listener.isHeard());
}

TEST_CASE("with an interval of 0 nothing is requested, and what comes is taken, but from no other vehicle") {
  Attitude desk;
  CHECK(desk.plays("wait 200, comes") == "");
  CHECK(desk.listener.isNew());
  desk.run(700);
  desk.tell("ATTITUDE", 7);
  CHECK_FALSE(desk.listener.isNew());
  CHECK(desk.listener.ageMs() >= 700);
}

TEST_CASE("a request without an answer is repeated after 2, 4, 8 s and so on, at most a minute") {
  CHECK(Attitude(1000).plays("until asked, wait 300") ==
        "30 each 1000, 2 again, 4 again, 8 again, 16 again, 32 again, "
        "64 again (3 times)");
  CHECK(Attitude(1000).plays("until asked, denied, until asked, denied, wait 5") == "30 each 1000, 2 again, 4 again");
  // A message that comes without having been confirmed is requested all the same.
  CHECK(Attitude(1000).plays("until asked, " + times(8, "comes, wait 1")) == "30 each 1000, 2 again, 4 again");
}

TEST_CASE(
    "a confirmed message that does not come is requested again when it is twice late, in whole seconds, and 3 s more") {
  const int kLate[][2] = {{200, 3}, {999, 3}, {1000, 5}, {1999, 5}, {2000, 7}, {2999, 7}, {3000, 9}, {5000, 13}};
  for (const auto& late : kLate) {
    const std::string asked = "30 each " + std::to_string(late[0]);
    const std::string script = "until asked, accepted, wait " + std::to_string(late[1] + 1);
    CHECK(Attitude(static_cast<uint16_t>(late[0])).plays(script) == asked + ", " + std::to_string(late[1]) + " again");
  }
}

TEST_CASE("a message that comes keeps its request from being repeated, and begins the pauses anew") {
  Attitude desk(1000);
  desk.plays("until asked, wait 16, until asked, accepted");  // three more, without an answer
  CHECK(desk.plays(times(100, "comes, wait 1")) == "");
  CHECK(desk.plays("wait 12") == "104 again, 2 again, 4 again");
}

TEST_CASE("of two listeners each gets its own answer, one after the other") {
  Attitude desk(1000);
  GpsListener gps(desk.client, 500);
  const std::string first = desk.plays("until asked");
  desk.run(50);
  CHECK(desk.plays("wait 0") == "");                  // no second one while the answer may come
  const std::string second = desk.plays("accepted");  // now the other one may ask
  CHECK(desk.listener.isConfirmed() != gps.isConfirmed());
  CHECK((first == "24 each 500" && second == "30 each 1000"));
  desk.plays("denied");
  CHECK(desk.listener.isConfirmed() != gps.isConfirmed());
}

TEST_CASE("nothing is requested without room to send") {
  CHECK(Attitude(1000).plays("until asked, no room, wait 5, room, wait 2") == "30 each 1000, 6 again");
}

TEST_CASE("of two messages the one of the autopilot is requested") {
  const struct {
    uint8_t autopilot, other;
    const char *wind, *estimator, *otherWind;
  } kRows[] = {
      {kArduPilot, kPx4, "168 each 1000", "193 each 2000", "231 each 1000"},
      {kPx4, kArduPilot, "231 each 1000", "230 each 2000", "168 each 1000"},
  };
  for (const auto& row : kRows) {
    Desk<WindListener> desk(1000, row.autopilot);
    CHECK(desk.plays("until asked") == row.wind);
    CHECK(Desk<EstimatorListener>(2000, row.autopilot).plays("until asked") == row.estimator);
    // Another autopilot, in the place of that one.
    desk.beats = false;
    std::string asked;
    for (int second = 0; second < 8; ++second) {
      desk.hear(heartbeatParts(row.other));
      const std::string said = desk.plays("wait 1");
      if (!said.empty()) asked += said + ", ";
    }
    CHECK(asked == "1 " + std::string(row.otherWind) + ", 4 again, ");
  }
}

TEST_CASE("a gap of 2.5 s between two heartbeats may be a restart, and one of 2.499 s is none") {
  for (uint32_t gapMs : {2499u, 2500u}) {
    CAPTURE(gapMs);
    Attitude desk(1000);
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
    CHECK(desk.requests(30, 1000).empty() == (gapMs == 2499));
  }
}

TEST_CASE("after a restart the pauses between the requests begin anew") {
  Attitude desk(1000);
  desk.run(20000);  // pauses of 2, 4, 8 s: the next is one of 16
  desk.beats = false;
  desk.run(3000);
  desk.beats = true;
  const uint32_t fromMs = desk.nowMs();
  desk.run(15000);
  CHECK(desk.requests(30, 1000, fromMs) == "2 2002 6002 14002");
}

TEST_CASE("heartbeats that come more often than once a second do not bring a second request before the answer") {
  Attitude desk(1000);
  desk.beats = false;
  const uint32_t fromMs = desk.nowMs();
  for (int i = 0; i < 9; ++i) {
    desk.beat();
    desk.run(199);
    CHECK(desk.requests(30, 1000, fromMs) == (i < 8 ? "2" : "2 1602"));
  }
}

TEST_CASE("nothing is requested while a command of the client's runs, and then it is") {
  Attitude desk(1000);
  desk.run(500);
  const uint32_t fromMs = desk.nowMs();
  static const FlightCommand zoom = flightCommand(531, 1);
  desk.client.send(zoom);
  desk.run(7000);
  REQUIRE((desk.client.status() == Status::Transferring));
  CHECK(desk.requests(30, 1000, fromMs).empty());
  desk.run(4000);
  REQUIRE_FALSE(desk.client.isBusy());
  CHECK_FALSE(desk.requests(30, 1000, fromMs).empty());
}

TEST_CASE("of two autopilots neither is asked") {
  Attitude desk(1000);
  desk.beats = false;
  desk.line.room = 0;  // the first request has not left yet
  for (int second = 0; second < 12; ++second) {
    desk.beat(1);
    desk.beat(2);
    if (second == 1) desk.line.room = MemoryStream::kAlwaysRoom;
    if (second == 1) desk.sent.clear();
    desk.run(998);
  }
  CHECK(desk.requests(30, 1000).empty());
}

TEST_CASE("a message that no listener wants is none's") {
  Attitude desk;
  WindListener wind(desk.client, 0);
  const uint16_t before = desk.client.counters().unknownMessages;
  desk.tell("VFR_HUD throttle 1");
  desk.run(100);
  CHECK(desk.client.counters().unknownMessages == before + 1);
  CHECK_FALSE(desk.listener.isHeard());
  CHECK_FALSE(wind.isHeard());
}
