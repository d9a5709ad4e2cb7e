// How old: what waited in the receive buffer while loop() stood still is no reason for anything that takes an aircraft.
#include <doctest/doctest.h>

#include <functional>
#include <string>

#include "SteeredAircraft.h"

using namespace mavmission;
using namespace steered;

namespace {

const LatLon kPlace = {-35.3630000_deg, 149.1652374_deg};
const FlightCommand kRawMode = flightCommand(176, 1, 9);

uint32_t rtlOf(Aircraft& a) { return a.client.firmware() == Firmware::Px4 ? uint32_t{kPx4Rtl} : uint32_t{kRtl}; }

struct Order {
  const char* name;
  bool flies;  // it begins in the air
  std::function<Status(Aircraft&)> begin;
};
const Order kOrders[] = {
    {"returnHome", true, [](Aircraft& a) { return a.steering.returnHome(); }},
    {"landNow", true, [](Aircraft& a) { return a.steering.landNow(); }},
    {"pause", true, [](Aircraft& a) { return a.steering.pause(); }},
    {"goTo", true, [](Aircraft& a) { return a.steering.goTo(kPlace, 20_m); }},
    {"takeOff", false, [](Aircraft& a) { return a.steering.takeOff(10_m); }},
    {"setMode", true, [](Aircraft& a) { return a.client.setMode(FlightMode::ReturnToLaunch); }},
    {"setCustomMode", true, [](Aircraft& a) { return a.client.setCustomMode(rtlOf(a)); }},
    {"startMission", false, [](Aircraft& a) { return a.client.startMission(); }},
    {"send", true, [](Aircraft& a) { return a.client.send(kRawMode, CommandRepeat::Always); }},
    {"arm", false, [](Aircraft& a) { return a.client.arm(); }},
};

bool isOrder(const SentFrame& frame) {
  if (frame.messageId != 76 && frame.messageId != 75) return false;
  const uint16_t id = static_cast<uint16_t>(frame.payload[28] | frame.payload[29] << 8);
  return id == 176 || id == 192 || id == 22 || id == 300 || id == 400;
}

// loop() stands still for so long. The buffer is filled at its beginning, by heartbeats that show what was.
void standStill(Aircraft& aircraft, size_t bufferBytes, uint32_t ms) {
  for (size_t bytes = 0; bytes + 21 <= bufferBytes; bytes += 21) aircraft.beat();
  aircraft.run(ms, ms);
}

}  // namespace

TEST_CASE("no order leaves after what waited while loop() stood still, however long, in a buffer of any size") {
  for (uint8_t firmware : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    const bool isPx4 = firmware == ClientOnLine::kPx4;
    for (const Order& order : kOrders) {
      for (size_t buffer : {63, 255, 511, 1023}) {
        for (uint32_t ms : {250u, 700u, 3000u, 65536u, 131072u, 600000u}) {
          for (int beginsMs : {-1, 0, 5, 20}) {  // before the standstill; -1: after it
            CAPTURE(order.name);
            CAPTURE(isPx4);
            CAPTURE(buffer);
            CAPTURE(ms);
            CAPTURE(beginsMs);
            Aircraft aircraft(firmware);
            if (order.flies) {
              aircraft.fly(isPx4 ? uint32_t{kPx4Mission} : uint32_t{kAuto});
            } else {
              aircraft.stand(isPx4 ? uint32_t{kPx4Hold} : uint32_t{kGuided});
            }
            aircraft.pass(450);
            if (beginsMs >= 0) {
              order.begin(aircraft);
              aircraft.pass(static_cast<uint32_t>(beginsMs));
            }
            aircraft.forget();
            standStill(aircraft, buffer, ms);
            aircraft.mode = isPx4 ? uint32_t{kPx4Position} : uint32_t{kLoiter};  // a pilot has taken it meanwhile
            aircraft.isArmed = true;
            aircraft.state = kActive;
            aircraft.landed = 2;
            if (beginsMs < 0) order.begin(aircraft);
            aircraft.beatsBySecond = aircraft.beatsWhenAsked = false;  // nothing new is heard yet
            aircraft.pass(900);
            for (const SentFrame& frame : aircraft.sent) CHECK_FALSE(isOrder(frame));
            CHECK_FALSE(aircraft.steering.hasArrived());
            if (ms >= 600) CHECK_FALSE(aircraft.steering.maySteer());
          }
        }
      }
    }
  }
}

TEST_CASE("what a heartbeat shows after a standstill decides: a pilot keeps what he has taken") {
  for (const Order& order : kOrders) {
    if (!order.flies || std::string(order.name) == "send" || std::string(order.name).find("set") == 0) continue;
    for (uint32_t ms : {250u, 3000u, 65536u}) {
      CAPTURE(order.name);
      CAPTURE(ms);
      Aircraft aircraft(ClientOnLine::kArduPilot);
      aircraft.fly(kAuto);
      aircraft.pass(450);
      aircraft.forget();
      standStill(aircraft, 511, ms);
      aircraft.mode = kLoiter;
      order.begin(aircraft);
      CHECK((aircraft.end(9000) == Status::PilotHasIt));
      CHECK(aircraft.mode == kLoiter);
      for (const SentFrame& frame : aircraft.sent) CHECK_FALSE(isOrder(frame));
    }
  }
}

TEST_CASE("after a standstill in which nothing has happened an order is carried out") {
  for (uint32_t ms : {250u, 3000u, 65536u}) {
    CAPTURE(ms);
    Aircraft aircraft(ClientOnLine::kArduPilot);
    aircraft.fly(kAuto);
    standStill(aircraft, 255, ms);
    aircraft.steering.returnHome();
    CHECK((aircraft.end(9000) == Status::Done));
    CHECK(aircraft.tookMs < 1500);
  }
}

TEST_CASE("a loop() that always takes 200 ms or longer gives no orders, and the operation ends") {
  for (uint32_t each : {150u, 400u, 700u}) {
    CAPTURE(each);
    Aircraft aircraft(ClientOnLine::kArduPilot);
    aircraft.fly(kAuto);
    aircraft.client.setMode(FlightMode::ReturnToLaunch);
    for (uint32_t ms = 0; ms < 130000 && aircraft.client.isBusy(); ms += each) {
      aircraft.beat();
      aircraft.run(each, each);
    }
    bool hasLeft = false;
    for (const SentFrame& frame : aircraft.sent) hasLeft |= isOrder(frame);
    CHECK(hasLeft == (each < 200));
    CHECK_FALSE(aircraft.client.isBusy());
  }
}

TEST_CASE("heartbeats that later frames have overtaken show nothing, until nothing newer has come for a while") {
  ClientOnLine desk(ClientOnLine::kArduPilot);
  desk.run(3000);
  desk.beats = false;
  const auto beat = [&](uint8_t sequence, bool isArmed) {
    FrameParts parts = heartbeatParts(ClientOnLine::kArduPilot, isArmed ? 0xD1 : 0x51);
    parts.sequence = sequence;
    desk.line.bring(packed(parts));
    desk.run(100);
    return desk.client.isArmed();
  };
  CHECK(beat(100, true));
  const uint16_t lost = desk.client.counters().framesLost;
  CHECK(beat(60, false));
  CHECK(beat(61, false));
  CHECK_FALSE(beat(101, false));
  CHECK(desk.client.counters().framesLost == lost);
  desk.run(900);
  CHECK(beat(40, true));
  CHECK_FALSE(beat(41, false));
}
