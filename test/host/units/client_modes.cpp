// Modes by a whole client: by name and by number, which vehicle an ArduPilot is, and what somebody else sets meanwhile.
#include <doctest/doctest.h>

#include "Conversation.h"

using namespace mavmission;

namespace {

constexpr uint8_t kArduPilot = Conversation::kArduPilot, kPx4 = Conversation::kPx4, kOther = Conversation::kOther;
constexpr uint8_t kCopterType = 2, kRocketType = 9, kQuadPlaneType = 20;  // HEARTBEAT.type
constexpr uint32_t kStabilize = 0, kLoiter = 5, kGuided = 4;
constexpr uint32_t kPlaneAuto = 10, kPlaneRtl = 11, kPlaneGuided = 15, kPlaneQRtl = 21;
constexpr uint32_t kPx4Position = 3ul << 16, kPx4Hold = 4ul << 16 | 3ul << 24;

// A vehicle that the test answers for when it is asked which one it is (3000: DO_VTOL_TRANSITION).
struct Ordering : Conversation {
  explicit Ordering(uint8_t autopilot = kArduPilot, uint8_t is = kCopterType, uint32_t shown = kStabilize)
      : Conversation(autopilot, 65000, 0) {
    vehicle = is;
    mode = shown;
    saysVehicle = false;
    pass(3000);
  }
  Ordering& sets(FlightMode named) {
    client.setMode(named);
    return *this;
  }
  Ordering& sets(uint32_t number) {
    client.setCustomMode(number);
    return *this;
  }
  // It shows its mode when the test says so, and not before.
  Ordering& quiet() {
    beatsBySecond = beatsWhenAsked = false;
    return *this;
  }
};

// The order to set GUIDED, five times.
const std::string kFiveTimes = "LONG 176 1 4, LONG 176 1 4 #1, LONG 176 1 4 #2, LONG 176 1 4 #3, LONG 176 1 4 #4";

// GUIDED has been ordered, and somebody has set LOITER before that arrived: it is undone, and a heartbeat shows that.
struct Undone : Ordering {
  Undone() {
    sets(kGuided).plays("10 ms");
    quiet();
    plays("mode 5");
    CHECK(plays("mode 4") == "LONG 176 1 5, BEAT?");
  }
};

}  // namespace

TEST_CASE("an ArduPilot that does not say that it is a plane is asked once which vehicle it is") {
  const struct {
    const char *answer, *guided, *hold;
    uint32_t mode;
  } kVehicles[] = {{"unsupported", "LONG 176 1 4", "LONG 176 1 5", kGuided},
                   {"failed", "LONG 176 1 15", "LONG 176 1 12", kPlaneGuided}};
  for (const auto& vehicle : kVehicles) {
    Ordering desk;
    CHECK(desk.sets(FlightMode::Guided).plays("10 ms, silence, 1200 ms, beat") == "LONG 3000");  // to no state
    desk.beatsWhenAsked = false;
    // No order leaves after an old heartbeat.
    CHECK(desk.plays(std::string("answer 3000 ") + vehicle.answer + " | beat") ==
          std::string("BEAT? | ") + vehicle.guided);
    CHECK(desk.client.lastResult() == 255);
    desk.mode = vehicle.mode;
    CHECK(desk.plays("answer 176 accepted, beat") == "BEAT?, -> Done (NotKnown)");
    desk.beatsWhenAsked = true;
    CHECK(desk.sets(FlightMode::Hold).plays("50 ms") == vehicle.hold);
  }
}

TEST_CASE("another answer to that question, or none, is the end") {
  Ordering denied, silent;
  CHECK(denied.sets(FlightMode::Guided).plays("20 ms | answer 3000 accepted, mode 4") == "LONG 3000 |");
  CHECK((denied.client.status() == Status::Transferring));
  denied.plays("cancel, 5 ms");
  CHECK(denied.sets(FlightMode::Guided).plays("until LONG 2 s, answer 3000 denied") ==
        "LONG 3000, -> CommandDenied (NotKnown)");
  CHECK(silent.sets(FlightMode::Guided).plays("9 s") ==
        "LONG 3000, LONG 3000 #1, LONG 3000 #2, LONG 3000 #3, LONG 3000 #4, -> NoAnswer (NotKnown)");
}

TEST_CASE("after that question the order is repeated as any other") {
  CHECK(Ordering().sets(FlightMode::Guided).plays("20 ms, answer 3000 unsupported, 9 s") ==
        "LONG 3000, " + kFiveTimes + ", -> NoAnswer (NotKnown)");
}

TEST_CASE("a quadplane that returns near home shows QRTL: by its name that is its return, by its number another mode") {
  const struct {
    bool isNamed;
    uint32_t shown;
    const char* end;
  } kWays[] = {{true, kPlaneQRtl, "-> Done (NotKnown)"},
               {true, kPlaneRtl, "-> Done (NotKnown)"},
               {true, kPlaneAuto, "-> TakenOver (NotKnown)"},
               {false, kPlaneRtl, "-> Done (NotKnown)"},
               {false, kPlaneQRtl, "-> TakenOver (NotKnown)"}};
  for (const auto& way : kWays) {
    Ordering plane(kArduPilot, kQuadPlaneType, kPlaneGuided);
    way.isNamed ? plane.sets(FlightMode::ReturnToLaunch) : plane.sets(kPlaneRtl);
    CHECK(plane.plays("50 ms") == "LONG 176 1 11");
    plane.mode = way.shown;
    CHECK(plane.plays("answer 176 accepted, 4 s") == way.end);
  }
  Ordering near(kArduPilot, kQuadPlaneType, kPlaneQRtl);
  near.sets(FlightMode::Auto).plays("50 ms");  // away from it, it is the mode of before
  near.mode = kPlaneAuto;
  CHECK(near.plays("answer 176 accepted, 1 s") == "-> Done (NotKnown)");
}

TEST_CASE("a mode that the vehicle does not have is not ordered") {
  CHECK(Ordering(kArduPilot, kRocketType).sets(FlightMode::Guided).plays("20 ms") == "-> NoSuchMode (NotKnown)");
  CHECK(Ordering(kPx4, kCopterType, kPx4Position).sets(FlightMode::Brake).plays("20 ms") == "-> NoSuchMode (NotKnown)");
}

TEST_CASE("a mode by its number has one byte on an ArduPilot, and on a PX4 two that lie higher") {
  const struct {
    uint8_t autopilot;
    uint32_t number;
    const char* order;
  } kModes[] = {{kArduPilot, 254, "LONG 176 1 254"},
                {kArduPilot, 255, "LONG 176 1 255"},
                {kArduPilot, 256, nullptr},
                {kArduPilot, 257, nullptr},
                {kArduPilot, kPx4Hold, nullptr},
                {kArduPilot, 3, "LONG 176 1 3"},
                {kPx4, kPx4Hold, "LONG 176 1 4 3"},
                {kPx4, 2ul << 16, "LONG 176 1 2"},
                {kPx4, 7ul << 16 | 9ul << 24, "LONG 176 1 7 9"},
                {kOther, 300, "LONG 176 1 44 1"}};
  for (const auto& one : kModes) {
    Ordering desk(one.autopilot);
    CHECK(desk.sets(one.number).plays("20 ms") == (one.order == nullptr ? "-> NoSuchMode (NotKnown)" : one.order));
    if (one.order == nullptr) {
      for (const Status status : desk.returned) CHECK((status != Status::Transferring));
      continue;
    }
    desk.mode = one.number;
    CHECK(desk.plays("answer 176 accepted, 2 s") == "-> Done (NotKnown)");
    CHECK(desk.client.customMode() == one.number);
  }
}

TEST_CASE("a second mode is refused, and the first one is ordered") {
  Ordering desk(kPx4);
  CHECK((desk.client.setMode(FlightMode::Land) == Status::WaitingForAutopilot));
  CHECK((desk.client.setMode(FlightMode::Hold) == Status::Busy));
  CHECK(desk.plays("20 ms") == "LONG 176 1 4 6");  // AUTO, LAND
}

TEST_CASE("on a lossy link, an order that was accepted is not sent again before a heartbeat must have shown it") {
  const auto behind = [](const std::string& events) {
    Ordering desk;
    desk.plays("broken, 40 ms");
    return desk.sets(kGuided).plays("20 ms | " + events);
  };
  CHECK(behind("1400 ms") == "LONG 176 1 4 | LONG 176 1 4 #1, LONG 176 1 4 #2, LONG 176 1 4 #3");
  CHECK(behind("answer 176 accepted, 1395 ms") == "LONG 176 1 4 |");
}

TEST_CASE("a mode that somebody else sets before the order leaves stays") {
  CHECK(Ordering().quiet().sets(kGuided).plays("until BEAT? 20 ms, mode 5") == "BEAT?, -> TakenOver (NotKnown)");
}

TEST_CASE("an accepted order that no heartbeat shows is unconfirmed, and the others are refused or not answered") {
  const auto ends = [](const std::string& events) { return Ordering().sets(kGuided).plays("20 ms, " + events); };
  CHECK(ends("10 s") == kFiveTimes + ", -> NoAnswer (NotKnown)");
  CHECK(ends("answer 176 accepted, 10 s") == "LONG 176 1 4, -> Unconfirmed (NotKnown)");
  CHECK(ends("answer 176 failed, 10 s") == "LONG 176 1 4, -> CommandFailed (NotKnown)");
  // PX4 accepts it, and then refuses it.
  Ordering px4(kPx4, kCopterType, kPx4Position);
  px4.sets(FlightMode::Guided).plays("50 ms");
  px4.hear(commandAckParts(176, 0));
  CHECK(px4.plays("answer 176 rejected") == "-> CommandRejected (NotKnown)");
}

TEST_CASE("after its acceptance an order asks for a heartbeat, and is done when that shows the mode") {
  Ordering desk;
  desk.sets(kGuided).plays("20 ms");
  CHECK(desk.quiet().plays("answer 176 accepted") == "BEAT?");
  CHECK((desk.client.status() == Status::Transferring));
  CHECK(desk.plays("mode 4") == "-> Done (NotKnown)");
}

TEST_CASE("a mode that the order has undone is set again, and flies then, or was overruled") {
  CHECK(Undone().plays("answer 176 accepted, 405 ms, mode 5") == "BEAT? x8, -> TakenOver (NotKnown)");
  CHECK(Undone().plays("answer 176 failed") == "-> Overruled (NotKnown)");
  Undone silent;
  silent.beatsBySecond = silent.beatsWhenAsked = true;
  silent.plays("20 s");
  CHECK((silent.ended == Status::Overruled));
  // The current item does not matter meanwhile.
  Undone desk;
  desk.plays("current 1 of 6");
  CHECK(desk.client.isBusy());
}

TEST_CASE("while somebody's mode may be undone heartbeats are asked for every 50 ms") {
  Ordering desk;
  desk.sets(kGuided).plays("20 ms");
  desk.quiet().mode = kLoiter;
  desk.beat();
  CHECK(desk.plays("clock, 160 ms") == "BEAT? @51 101 151");
  desk.beatsWhenAsked = true;
  CHECK(desk.plays("mode 5, 410 ms, mode 5") == "-> TakenOver (NotKnown)");
}

TEST_CASE("after a loop() that stood still an order waits for a new heartbeat, and so does what it believes") {
  Ordering before, behind;
  before.quiet().sets(kGuided).plays("until BEAT? 20 ms");
  before.beat();
  before.run(300, 300);
  CHECK(before.plays("20 ms") == "BEAT?");
  CHECK(before.plays("beat") == "LONG 176 1 4");
  behind.sets(kGuided).plays("20 ms");
  behind.quiet().mode = kGuided;
  behind.beat();
  behind.run(300, 300);
  CHECK(behind.plays("until BEAT? 30 ms | mode 4") == "BEAT? | -> Done (NotKnown)");
}

TEST_CASE("startMission() that has undone somebody's mode sets that mode again, and does not start the mission again") {
  Ordering desk;
  desk.plays("armed, 1 s");
  desk.client.startMission();
  CHECK(desk.plays("20 ms | answer 3000 unsupported, 50 ms") == "LONG 3000 | LONG 300");
  CHECK(desk.quiet().plays("mode 5 | mode 3") == "| LONG 176 1 5, BEAT?");
}

TEST_CASE("on a lossy link, an order that is accepted again and again, and that nothing shows, is given up") {
  Ordering desk;
  desk.quiet().sets(kGuided);
  uint32_t ms = 0;
  for (size_t orders = 0; ms < 60000 && (ms == 0 || desk.client.isBusy()); ++ms) {
    if (ms % 1000 == 0)
      desk.line.bring({0xFD, 9, 0, 0, 200, 1, 1, 0, 0, 0, 4, 0, 0, 0, 2, 3, 1, 4, 3, 0, 0});  // broken
    if (ms % 500 == 250) desk.beat();
    const std::string said = desk.plays("1 ms");
    if (said.find("LONG 176") == std::string::npos) continue;
    ++orders;
    desk.hear(commandAckParts(176, 0));
  }
  CHECK((desk.ended == Status::Unconfirmed));
  CHECK(ms < 40000);
}

TEST_CASE("the answer to a request for a heartbeat is not that of the sketch's own request") {
  Ordering desk;
  desk.sets(kGuided).plays("20 ms");
  REQUIRE(desk.plays("mode 4") == "-> Done (NotKnown)");
  desk.command = flightCommand(512, 148);
  CHECK(desk.plays("send, 20 ms | answer 512 failed | answer 512 accepted") ==  // the first is of the request before
        "LONG 512 148 | | -> Done (NotKnown)");
}

TEST_CASE("the rest of an order that loop() has kept back for too long is withdrawn, so that nobody obeys it") {
  for (const uint32_t stillMs : {10, 300}) {
    Ordering desk(kPx4);
    desk.quiet().sets(kPx4Hold).plays("10 ms");
    desk.line.room = 12;
    desk.line.takes = 12;
    const size_t before = desk.sent.size();
    desk.beat();
    desk.line.writes = 0;
    for (int i = 0; i < 8 && desk.line.writes == 0; ++i) desk.pass(1);  // until the order begins to leave
    desk.line.room = desk.line.kAlwaysRoom;
    desk.line.takes = 1000000;
    desk.run(stillMs, stillMs);
    desk.pass(5);
    REQUIRE(desk.sent.size() > before);
    const SentFrame& order = desk.sent[before];
    CHECK(order.messageId == 76);
    FrameParts parts(76, Bytes(order.frame.begin() + 10, order.frame.end() - 2), 152);
    parts.sequence = order.frame[4];
    parts.systemId = order.frame[5];
    parts.componentId = order.frame[6];
    CHECK((packed(parts) == order.frame) == (stillMs < 200));
  }
}
