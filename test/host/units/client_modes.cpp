// Modes by a whole client: by name and by number, which vehicle an ArduPilot is, and what somebody else sets meanwhile.
#include <doctest/doctest.h>
#include <string.h>

#include "ClientOnLine.h"
#include "PlanFrames.h"

using namespace mavmission;

namespace {

constexpr uint16_t kCommandLong = 76, kSetMode = 176, kTransition = 3000, kRequestMessage = 512;
constexpr uint8_t kAccepted = 0, kUnsupported = 3, kFailed = 4;
constexpr uint8_t kPlaneType = 1, kCopterType = 2, kRocketType = 9, kQuadPlaneType = 20;  // HEARTBEAT.type
constexpr uint32_t kStabilize = 0, kLoiter = 5, kGuided = 4;
constexpr uint32_t kPlaneAuto = 10, kPlaneRtl = 11, kPlaneGuided = 15, kPlaneQRtl = 21;
constexpr uint32_t kPx4Position = 3ul << 16, kPx4Hold = 4ul << 16 | 3ul << 24;

template <typename Value>
Value valueAt(const SentFrame& frame, size_t at) {
  Value value;
  memcpy(&value, &frame.payload[at], sizeof(value));
  return value;
}

struct Ordering : ClientOnLine {
  const uint8_t kind;
  const uint8_t type;
  uint8_t baseMode = 1;
  uint32_t mode;

  Ordering(uint8_t autopilot, uint8_t is, uint32_t shown)
      : ClientOnLine(autopilot), kind(autopilot), type(is), mode(shown) {
    beats = false;
    saysVehicle = false;
    for (int second = 0; second < 3; ++second) {
      show(mode);
      run(1000);
    }
    sent.clear();
  }
  void show(uint32_t customMode) {
    mavlink_heartbeat_t message = mavlink_heartbeat_t();
    message.custom_mode = customMode;
    message.type = type;
    message.autopilot = kind;
    message.base_mode = baseMode;
    message.system_status = 4;
    message.mavlink_version = 3;
    Bytes payload(sizeof(message));
    memcpy(payload.data(), &message, sizeof(message));
    hear(FrameParts(0, payload, 50));
  }
  void answer(uint16_t command, uint8_t result) {
    hear(commandAckParts(command, result));
    run(2);
  }
  static bool isCommand(const SentFrame& frame, uint16_t id) {
    return frame.messageId == kCommandLong && valueAt<uint16_t>(frame, 28) == id;
  }
  size_t count(uint16_t id) const {
    size_t all = 0;
    for (const SentFrame& frame : sent) all += isCommand(frame, id) ? 1 : 0;
    return all;
  }
  const SentFrame& last(uint16_t id) const {
    for (size_t i = sent.size(); i != 0; --i) {
      if (isCommand(sent[i - 1], id)) return sent[i - 1];
    }
    FAIL("no such command has left");
    return sent.back();
  }
  // Until a command with this id leaves; each request for a heartbeat is answered, with what flies.
  bool runUntilOrdered(uint16_t id, uint32_t limitMs) {
    const size_t before = count(id);
    for (uint32_t at = 0; at < limitMs; ++at) {
      const size_t asked = count(kRequestMessage);
      run(1);
      if (count(id) != before) return true;
      if (count(kRequestMessage) != asked) show(mode);
    }
    return false;
  }
  // The same until the operation ends.
  Status outcome(uint32_t limitMs) {
    for (uint32_t at = 0; at < limitMs && client.isBusy(); ++at) {
      const size_t asked = count(kRequestMessage);
      if (at % 1000 == 0) show(mode);
      run(1);
      if (count(kRequestMessage) != asked) show(mode);
    }
    return client.status();
  }
};

}  // namespace

TEST_CASE("an ArduPilot that does not say that it is a plane is asked once which vehicle it is") {
  const struct {
    uint8_t result;
    uint32_t guided;
  } kVehicles[] = {{kUnsupported, kGuided}, {kFailed, kPlaneGuided}};
  for (const auto& vehicle : kVehicles) {
    Ordering desk(ClientOnLine::kArduPilot, kCopterType, kStabilize);
    desk.client.setMode(FlightMode::Guided);
    REQUIRE(desk.runUntilOrdered(kTransition, 20));
    const SentFrame question = desk.last(kTransition);
    for (size_t i = 0; i < 7; ++i) CHECK(valueAt<float>(question, 4 * i) == 0);  // to no state: it changes nothing
    desk.run(1200);
    CHECK(desk.count(kSetMode) == 0);
    desk.hear(commandAckParts(kTransition, vehicle.result));
    REQUIRE(desk.runUntilOrdered(kSetMode, 50));
    CHECK(desk.client.lastResult() == 255);
    CHECK(desk.count(kRequestMessage) == 1);  // no order leaves behind an old heartbeat
    const SentFrame order = desk.last(kSetMode);
    CHECK(valueAt<float>(order, 0) == 1);
    CHECK(valueAt<float>(order, 4) == static_cast<float>(vehicle.guided));
    CHECK(valueAt<float>(order, 8) == 0);
    desk.mode = vehicle.guided;
    desk.answer(kSetMode, kAccepted);
    CHECK((desk.outcome(1000) == Status::Done));
    desk.client.setMode(FlightMode::Hold);
    REQUIRE(desk.runUntilOrdered(kSetMode, 50));
    CHECK(desk.count(kTransition) == 1);
  }
}

TEST_CASE("neither PX4 nor a plane that says so is asked which vehicle it is") {
  Ordering px4(ClientOnLine::kPx4, kCopterType, kPx4Position), plane(ClientOnLine::kArduPilot, kPlaneType, kStabilize);
  px4.client.setMode(FlightMode::Hold);
  REQUIRE(px4.runUntilOrdered(kSetMode, 50));
  CHECK(px4.count(kTransition) == 0);
  CHECK(valueAt<float>(px4.last(kSetMode), 0) == 1);
  CHECK(valueAt<float>(px4.last(kSetMode), 4) == 4);
  CHECK(valueAt<float>(px4.last(kSetMode), 8) == 3);
  px4.mode = kPx4Hold;
  CHECK((px4.outcome(1000) == Status::Done));
  plane.client.setMode(FlightMode::Guided);
  REQUIRE(plane.runUntilOrdered(kSetMode, 50));
  CHECK(plane.count(kTransition) == 0);
  CHECK(valueAt<float>(plane.last(kSetMode), 4) == kPlaneGuided);
}

TEST_CASE("another answer to that question, or none, is the end") {
  Ordering denied(ClientOnLine::kArduPilot, kCopterType, kStabilize), silent(ClientOnLine::kArduPilot, kCopterType, 0);
  denied.client.setMode(FlightMode::Guided);
  REQUIRE(denied.runUntilOrdered(kTransition, 20));
  denied.answer(kTransition, kAccepted);
  denied.show(kGuided);
  denied.run(5);
  CHECK(denied.client.isBusy());
  CHECK((denied.client.status() == Status::Transferring));
  denied.client.cancel();
  denied.run(5);
  denied.client.setMode(FlightMode::Guided);
  REQUIRE(denied.runUntilOrdered(kTransition, 2000));
  denied.answer(kTransition, 2);
  CHECK((denied.ended == Status::CommandDenied));
  silent.client.setMode(FlightMode::Guided);
  CHECK((silent.outcome(9000) == Status::NoAnswer));
  CHECK(silent.count(kTransition) == 5);
  CHECK(silent.count(kSetMode) == 0);
}

TEST_CASE("behind that question the order is repeated as any other") {
  Ordering desk(ClientOnLine::kArduPilot, kCopterType, kStabilize);
  desk.client.setMode(FlightMode::Guided);
  REQUIRE(desk.runUntilOrdered(kTransition, 20));
  desk.answer(kTransition, kUnsupported);
  CHECK((desk.outcome(9000) == Status::NoAnswer));
  CHECK(desk.count(kSetMode) == 5);
}

TEST_CASE("a quadplane that returns near home shows QRTL: by its name that is its return, by its number another mode") {
  const struct {
    bool isNamed;
    uint32_t shown;
    Status end;
  } kWays[] = {{true, kPlaneQRtl, Status::Done},
               {true, kPlaneRtl, Status::Done},
               {true, kPlaneAuto, Status::TakenOver},
               {false, kPlaneRtl, Status::Done},
               {false, kPlaneQRtl, Status::TakenOver}};
  for (const auto& way : kWays) {
    Ordering plane(ClientOnLine::kArduPilot, kQuadPlaneType, kPlaneGuided);
    way.isNamed ? plane.client.setMode(FlightMode::ReturnToLaunch) : plane.client.setCustomMode(kPlaneRtl);
    REQUIRE(plane.runUntilOrdered(kSetMode, 50));
    plane.mode = way.shown;
    plane.answer(kSetMode, kAccepted);
    CHECK((plane.outcome(4000) == way.end));
  }
  Ordering near(ClientOnLine::kArduPilot, kQuadPlaneType, kPlaneQRtl);
  near.client.setMode(FlightMode::Auto);  // away from it, it is the mode of before
  REQUIRE(near.runUntilOrdered(kSetMode, 50));
  near.mode = kPlaneAuto;
  near.answer(kSetMode, kAccepted);
  CHECK((near.outcome(1000) == Status::Done));
}

TEST_CASE("a mode that the vehicle does not have is not ordered") {
  Ordering rocket(ClientOnLine::kArduPilot, kRocketType, 0), px4(ClientOnLine::kPx4, kCopterType, kPx4Position);
  rocket.client.setMode(FlightMode::Guided);
  px4.client.setMode(FlightMode::Brake);
  for (Ordering* desk : {&rocket, &px4}) {
    desk->run(20);
    CHECK((desk->ended == Status::NoSuchMode));
    CHECK(desk->count(kTransition) == 0);
    CHECK(desk->count(kSetMode) == 0);
  }
}

TEST_CASE("a mode by its number has one byte on an ArduPilot, and on a PX4 two that lie higher") {
  const struct {
    uint8_t autopilot;
    uint32_t number;
    bool isOrdered;
    float main, sub;
  } kModes[] = {{ClientOnLine::kArduPilot, 254, true, 254, 0},
                {ClientOnLine::kArduPilot, 255, true, 255, 0},
                {ClientOnLine::kArduPilot, 256, false, 0, 0},
                {ClientOnLine::kArduPilot, 257, false, 0, 0},
                {ClientOnLine::kArduPilot, kPx4Hold, false, 0, 0},
                {ClientOnLine::kArduPilot, 3, true, 3, 0},
                {ClientOnLine::kPx4, kPx4Hold, true, 4, 3},
                {ClientOnLine::kPx4, 2ul << 16, true, 2, 0},
                {ClientOnLine::kPx4, 7ul << 16 | 9ul << 24, true, 7, 9},
                {ClientOnLine::kOther, 300, true, 300 & 255, 1}};
  for (const auto& one : kModes) {
    CAPTURE(one.number);
    Ordering desk(one.autopilot, kCopterType, kStabilize);
    desk.client.setCustomMode(one.number);
    CHECK(desk.runUntilOrdered(kSetMode, 100) == one.isOrdered);
    CHECK(desk.count(kTransition) == 0);
    if (!one.isOrdered) {
      CHECK((desk.ended == Status::NoSuchMode));
      for (const Status status : desk.returned) CHECK((status != Status::Transferring));
      continue;
    }
    CHECK(valueAt<float>(desk.last(kSetMode), 0) == 1);
    CHECK(valueAt<float>(desk.last(kSetMode), 4) == one.main);
    CHECK(valueAt<float>(desk.last(kSetMode), 8) == one.sub);
    desk.mode = one.number;
    desk.answer(kSetMode, kAccepted);
    CHECK((desk.outcome(2000) == Status::Done));
    CHECK(desk.client.customMode() == one.number);
  }
}

TEST_CASE("a second mode is refused, and the first one is ordered") {
  ClientOnLine desk(ClientOnLine::kPx4);
  CHECK((desk.client.setMode(FlightMode::Land) == Status::WaitingForAutopilot));
  CHECK((desk.client.setMode(FlightMode::Hold) == Status::Busy));
  for (int i = 0; i < 3; ++i) {
    REQUIRE(desk.runUntilSent(kCommandLong, 4000));
    if (Ordering::isCommand(desk.sent.back(), kSetMode)) break;
    desk.hear(heartbeatParts(ClientOnLine::kPx4));
  }
  CHECK(valueAt<float>(desk.sent.back(), 4) == 4);
  CHECK(valueAt<float>(desk.sent.back(), 8) == 6);  // AUTO, LAND
}

TEST_CASE("on a lossy link, an order that was accepted is not sent again before a heartbeat must have shown it") {
  for (const bool isAccepted : {false, true}) {
    Ordering desk(ClientOnLine::kArduPilot, kCopterType, kStabilize);
    Bytes broken = packed(heartbeatParts(ClientOnLine::kArduPilot));
    broken[12] = static_cast<uint8_t>(broken[12] ^ 1);
    desk.line.bring(broken);
    desk.run(100);
    desk.client.setCustomMode(kGuided);
    REQUIRE(desk.runUntilOrdered(kSetMode, 20));
    if (isAccepted) desk.answer(kSetMode, kAccepted);
    CHECK(desk.runUntilOrdered(kSetMode, 1400) != isAccepted);
  }
}

TEST_CASE("a mode that flies already is not ordered") {
  Ordering desk(ClientOnLine::kArduPilot, kCopterType, kGuided);
  desk.client.setCustomMode(kGuided);
  CHECK((desk.outcome(1500) == Status::Done));
  CHECK(desk.count(kSetMode) == 0);
}

TEST_CASE("an order leaves right behind a heartbeat, which is asked for, and again 100 ms later") {
  Ordering desk(ClientOnLine::kArduPilot, kCopterType, kStabilize);
  desk.client.setCustomMode(kGuided);
  REQUIRE(desk.runUntilSent(kCommandLong, 20));
  const uint32_t askedMs = desk.nowMs();
  CHECK(Ordering::isCommand(desk.sent.back(), kRequestMessage));
  for (size_t i = 0; i < 7; ++i) CHECK(valueAt<float>(desk.sent.back(), 4 * i) == 0);  // HEARTBEAT
  desk.run(350);
  CHECK(desk.timesOf(kCommandLong, askedMs) == std::vector<uint32_t>{0, 100, 200, 300});
  CHECK(desk.count(kSetMode) == 0);
  desk.show(kStabilize);
  REQUIRE(desk.runUntilSent(kCommandLong, 3));
  CHECK(Ordering::isCommand(desk.sent.back(), kSetMode));
  CHECK(desk.sent.back().payload[32] == 0);
}

TEST_CASE("a mode that somebody else sets before the order leaves stays") {
  Ordering desk(ClientOnLine::kArduPilot, kCopterType, kStabilize);
  desk.client.setCustomMode(kGuided);
  REQUIRE(desk.runUntilSent(kCommandLong, 20));
  desk.show(kLoiter);
  desk.run(5);
  CHECK((desk.ended == Status::TakenOver));
  CHECK(desk.count(kSetMode) == 0);
}

TEST_CASE("an accepted order that no heartbeat shows is unconfirmed, and the others are refused or not answered") {
  for (const int answer : {-1, 0, 4}) {
    Ordering desk(ClientOnLine::kArduPilot, kCopterType, kStabilize);
    desk.client.setCustomMode(kGuided);
    REQUIRE(desk.runUntilOrdered(kSetMode, 20));
    if (answer >= 0) desk.answer(kSetMode, static_cast<uint8_t>(answer));
    const Status expected = answer < 0 ? Status::NoAnswer : answer == 0 ? Status::Unconfirmed : Status::CommandFailed;
    CHECK((desk.outcome(10000) == expected));
    CHECK(desk.count(kSetMode) == (answer < 0 ? 5 : 1));
  }
}

TEST_CASE("a mode that PX4 accepts and then refuses is refused") {
  Ordering desk(ClientOnLine::kPx4, kCopterType, kPx4Position);
  desk.client.setMode(FlightMode::Guided);
  REQUIRE(desk.runUntilOrdered(kSetMode, 50));
  desk.hear(commandAckParts(kSetMode, kAccepted));
  desk.answer(kSetMode, 1);
  CHECK((desk.ended == Status::CommandRejected));
}

TEST_CASE("behind its acceptance an order asks for a heartbeat, and is done when that shows the mode") {
  Ordering desk(ClientOnLine::kArduPilot, kCopterType, kStabilize);
  desk.client.setCustomMode(kGuided);
  REQUIRE(desk.runUntilOrdered(kSetMode, 20));
  const size_t asked = desk.count(kRequestMessage);
  desk.hear(commandAckParts(kSetMode, kAccepted));
  REQUIRE(desk.runUntilSent(kCommandLong, 10));
  CHECK((desk.client.status() == Status::Transferring));
  CHECK(desk.count(kRequestMessage) == asked + 1);
  desk.show(kGuided);
  desk.run(2);
  CHECK((desk.ended == Status::Done));
}

namespace {

// The order has left, and somebody has set LOITER before it arrived: it is undone, and a heartbeat shows that.
struct Undone : Ordering {
  Undone() : Ordering(ClientOnLine::kArduPilot, kCopterType, kStabilize) {
    client.setCustomMode(kGuided);
    REQUIRE(runUntilOrdered(kSetMode, 20));
    show(kLoiter);
    run(5);
    REQUIRE(client.isBusy());
    show(kGuided);
    REQUIRE(runUntilSent(kCommandLong, 5));
    CHECK(valueAt<uint16_t>(sent.back(), 28) == kSetMode);
    CHECK(valueAt<float>(sent.back(), 4) == kLoiter);
  }
};

}  // namespace

TEST_CASE("a mode that the order has undone is set again, and flies then") {
  Undone desk;
  desk.answer(kSetMode, kAccepted);
  desk.run(410);  // no repeat may still arrive
  desk.show(kLoiter);
  desk.run(5);
  CHECK((desk.ended == Status::TakenOver));
  CHECK(desk.count(kSetMode) == 2);
}

TEST_CASE("a mode that was undone, and is not set again, was overruled") {
  Undone refused, silent;
  refused.answer(kSetMode, kFailed);
  CHECK((refused.ended == Status::Overruled));
  silent.mode = kGuided;
  CHECK((silent.outcome(20000) == Status::Overruled));
}

TEST_CASE("while somebody's mode may be undone heartbeats are asked for every 50 ms") {
  Ordering desk(ClientOnLine::kArduPilot, kCopterType, kStabilize);
  desk.client.setCustomMode(kGuided);
  REQUIRE(desk.runUntilOrdered(kSetMode, 20));
  desk.show(kLoiter);
  desk.sent.clear();
  const uint32_t shownMs = desk.nowMs();
  desk.run(160);
  CHECK(desk.timesOf(kCommandLong, shownMs) == std::vector<uint32_t>{51, 101, 151});
  CHECK(desk.count(kSetMode) == 0);
  desk.show(kLoiter);
  desk.run(410);
  desk.show(kLoiter);
  desk.run(5);
  CHECK((desk.ended == Status::TakenOver));
  CHECK(desk.count(kSetMode) == 0);
}

TEST_CASE("while somebody's mode may be undone the current item does not matter") {
  Undone desk;
  desk.hear(FrameParts(42, {1, 0, 6, 0, 3}, 28));
  desk.run(5);
  CHECK(desk.client.isBusy());
}

TEST_CASE("behind a loop() that stood still an order waits for a new heartbeat") {
  Ordering desk(ClientOnLine::kArduPilot, kCopterType, kStabilize);
  desk.client.setCustomMode(kGuided);
  REQUIRE(desk.runUntilSent(kCommandLong, 20));
  desk.sent.clear();
  desk.show(kStabilize);
  desk.run(300, 300);
  desk.run(5);
  CHECK(desk.count(kSetMode) == 0);
  REQUIRE(desk.runUntilOrdered(kSetMode, 100));
  CHECK(desk.count(kRequestMessage) >= 1);
}

TEST_CASE("startMission() that has undone somebody's mode sets that mode again, and does not start the mission again") {
  Ordering desk(ClientOnLine::kArduPilot, kCopterType, kStabilize);
  desk.baseMode = 1 | 128;  // armed
  desk.show(kStabilize);
  desk.run(1000);
  desk.sent.clear();
  desk.client.startMission();
  REQUIRE(desk.runUntilOrdered(kTransition, 20));
  desk.hear(commandAckParts(kTransition, kUnsupported));
  REQUIRE(desk.runUntilOrdered(300, 50));
  desk.show(kLoiter);
  desk.run(5);
  desk.show(3);  // AUTO
  REQUIRE(desk.runUntilSent(kCommandLong, 5));
  CHECK(valueAt<uint16_t>(desk.sent.back(), 28) == kSetMode);
  CHECK(valueAt<float>(desk.sent.back(), 4) == kLoiter);
}

TEST_CASE(
    "behind a loop() that stood still the wanted mode is believed when a new heartbeat shows it, which is asked for") {
  Ordering desk(ClientOnLine::kArduPilot, kCopterType, kStabilize);
  desk.client.setCustomMode(kGuided);
  REQUIRE(desk.runUntilOrdered(kSetMode, 20));
  desk.sent.clear();
  desk.show(kGuided);
  desk.run(300, 300);
  CHECK(desk.client.isBusy());
  REQUIRE(desk.runUntilSent(kCommandLong, 30));
  CHECK(Ordering::isCommand(desk.sent.back(), kRequestMessage));
  desk.show(kGuided);
  desk.run(5);
  CHECK((desk.ended == Status::Done));
}

TEST_CASE("on a lossy link, an order that is accepted again and again, and that nothing shows, is given up") {
  Ordering desk(ClientOnLine::kArduPilot, kCopterType, kStabilize);
  desk.client.setCustomMode(kGuided);
  uint32_t ms = 0;
  for (size_t orders = 0; ms < 60000 && (ms == 0 || desk.client.isBusy()); ++ms) {
    if (ms % 1000 == 0) {
      Bytes broken = packed(heartbeatParts(ClientOnLine::kArduPilot));
      broken[12] = static_cast<uint8_t>(broken[12] ^ 1);
      desk.line.bring(broken);
    }
    if (ms % 500 == 250) desk.show(kStabilize);
    desk.run(1);
    if (desk.count(kSetMode) == orders) continue;
    ++orders;
    desk.hear(commandAckParts(kSetMode, kAccepted));
  }
  CHECK((desk.ended == Status::Unconfirmed));
  CHECK(ms < 40000);
}

TEST_CASE("the answer to a request for a heartbeat is not that of the sketch's own request") {
  const FlightCommand own = flightCommand(kRequestMessage, 148);
  Ordering desk(ClientOnLine::kArduPilot, kCopterType, kStabilize);
  desk.client.setCustomMode(kGuided);
  REQUIRE(desk.runUntilOrdered(kSetMode, 20));
  desk.mode = kGuided;
  desk.show(kGuided);
  desk.run(5);
  REQUIRE((desk.ended == Status::Done));
  desk.sent.clear();
  desk.client.send(own);
  REQUIRE(desk.runUntilSent(kCommandLong, 20));
  desk.answer(kRequestMessage, kFailed);  // of the request before
  CHECK(desk.client.isBusy());
  desk.answer(kRequestMessage, kAccepted);
  CHECK((desk.ended == Status::Done));
}

TEST_CASE("the rest of an order that loop() has kept back for too long is spoiled, so that nobody obeys it") {
  for (const uint32_t stillMs : {10, 300}) {
    setMillis(1000);
    MemoryStream line;
    MissionClient client(line);
    client.setTargetIds(1, 1);
    uint32_t nowMs = 1000;
    uint8_t sequence = 0;
    const auto hear = [&] {
      FrameParts beat = heartbeatParts(ClientOnLine::kPx4);
      beat.sequence = sequence++;
      line.bring(packed(beat));
    };
    const auto run = [&](uint32_t ms) {
      setMillis(nowMs += ms);
      client.update();
    };
    hear();
    for (int i = 0; i < 50; ++i) run(1);
    hear();
    run(1);
    client.setCustomMode(kPx4Hold);
    for (int i = 0; i < 10; ++i) run(1);
    line.takeWritten();
    line.room = 12;
    line.takes = 12;
    hear();
    Bytes written;  // until the order begins to leave
    for (int i = 0; i < 8 && written.empty(); ++i) {
      run(1);
      written = line.takeWritten();
    }
    REQUIRE(!written.empty());
    REQUIRE(written.size() < 30);
    line.room = line.kAlwaysRoom;
    line.takes = 1000000;
    run(stillMs);
    for (int i = 0; i < 5; ++i) run(1);
    written = written + line.takeWritten();
    REQUIRE(written.size() > 12);
    REQUIRE(written[0] == 0xFD);
    REQUIRE(written[7] == 76);
    const size_t length = 10u + written[1] + 2;
    REQUIRE(written.size() >= length);
    const Bytes frame(written.begin(), written.begin() + static_cast<long>(length));
    FrameParts parts(76, Bytes(frame.begin() + 10, frame.end() - 2), 152);
    parts.sequence = frame[4];
    parts.systemId = frame[5];
    parts.componentId = frame[6];
    CHECK((packed(parts) == frame) == (stillMs < 200));
  }
}
