// Steering where a step is refused, is not answered, or somebody else takes the aircraft: what it ends with, and when.
#include <doctest/doctest.h>

#include <initializer_list>

#include "SteeredAircraft.h"

using namespace mavmission;
using namespace steered;

namespace {

constexpr LatLon kPlace = {-35.3630000_deg, 149.1652374_deg};
constexpr uint8_t kFirmwares[] = {ClientOnLine::kArduPilot, ClientOnLine::kPx4};
constexpr char kDisarm[] = "L400 0 0 0 0 0 0 0";

// On the ground, in a mode from which a takeoff leads away.
struct Standing : Aircraft {
  explicit Standing(uint8_t firmware) : Aircraft(firmware) {
    stand(firmware == kPx4 ? uint32_t{kPx4Mission} : uint32_t{kStabilize});
  }
};
struct Flying : Aircraft {
  explicit Flying(uint8_t firmware) : Aircraft(firmware) {
    fly(firmware == kPx4 ? uint32_t{kPx4Mission} : uint32_t{kAuto});
  }
};

// How often this was sent, and whether it was the last command.
uint32_t count(const std::string& words, const std::string& one) {
  uint32_t found = 0;
  for (size_t at = words.find(one); at != std::string::npos; at = words.find(one, at + 1)) ++found;
  return found;
}
bool endsWith(const std::string& words, const std::string& one) {
  return words.size() >= one.size() && words.compare(words.size() - one.size(), one.size(), one) == 0;
}

}  // namespace

TEST_CASE("a takeoff that is refused at a step ends with that refusal, and disarms only what it has armed") {
  const struct {
    uint16_t command;
    SteerStep step;
    bool disarms;
  } kSteps[] = {{176, SteerStep::Mode, false}, {400, SteerStep::Arm, false}, {22, SteerStep::Disarm, true}};
  for (uint8_t firmware : kFirmwares) {
    for (const auto& one : kSteps) {
      for (int result : {1, 2, 3, 4}) {
        CAPTURE(one.command);
        Standing aircraft(firmware);
        aircraft.gives[one.command] = result;
        aircraft.steering.takeOff(20_m);
        aircraft.end();
        CHECK(static_cast<int>(aircraft.ended) == static_cast<int>(Status::CommandRejected) + result - 1);
        CHECK((aircraft.steering.step() == one.step));
        CHECK_FALSE(aircraft.isArmed);
        const std::string words = aircraft.said();
        CHECK(count(words, kDisarm) == (one.disarms ? 1 : 0));
        CHECK(count(words, "L22 ") == (one.disarms ? 1 : 0));
      }
    }
  }
}

TEST_CASE("a takeoff whose step is not answered ends after five attempts, and disarms when it may have armed") {
  for (uint8_t firmware : kFirmwares) {
    for (uint16_t command : {176, 400, 22}) {
      CAPTURE(firmware);
      CAPTURE(command);
      Standing aircraft(firmware);
      aircraft.gives[command] = kUnheard;
      aircraft.once[command] = kUnheard;
      aircraft.steering.takeOff(20_m);
      REQUIRE(aircraft.passUntil(command));
      const uint32_t firstMs = aircraft.nowMs();
      for (int i = 1; i < 5; ++i) {
        REQUIRE(aircraft.passUntil(command, 1600));
        CHECK(aircraft.nowMs() - firstMs >= static_cast<uint32_t>(1500 * i));
      }
      aircraft.gives.clear();
      CHECK((aircraft.end(3000) == Status::NoAnswer));
      const std::string words = aircraft.said();
      // A heartbeat that shows it disarmed is enough.
      CHECK(count(words, kDisarm) == (command == 22 ? 1 : 0));
      CHECK(count(words, "L" + std::to_string(command) + " ") == 5);
      CHECK((aircraft.steering.step() == (command == 176 ? SteerStep::Mode : SteerStep::Disarm)));
    }
  }
}

TEST_CASE("a mode that was accepted and is not shown is unconfirmed; one that was never answered is not answered") {
  for (uint8_t firmware : kFirmwares) {
    Flying aircraft(firmware);
    aircraft.gives[176] = kUnheard;
    aircraft.steering.landNow();
    CHECK((aircraft.end() == Status::NoAnswer));
    CHECK((aircraft.steering.step() == SteerStep::Mode));
    aircraft.pass(25000);
    aircraft.steering.landNow();
    REQUIRE(aircraft.passUntil(176));
    aircraft.answer(176, 0);
    CHECK((aircraft.end() == Status::Unconfirmed));
    CHECK(aircraft.tookMs <= 7620);
  }
}

TEST_CASE("ArduPilot's takeoff that does not leave the ground is given up 15 s behind its acceptance") {
  Standing copter(ClientOnLine::kArduPilot);
  copter.takesOff = false;
  copter.steering.takeOff(20_m);
  REQUIRE(copter.passUntil(22));
  const uint32_t answeredMs = copter.nowMs() + 31;
  REQUIRE(copter.passUntil(400));
  CHECK(copter.nowMs() - answeredMs >= 15000);
  CHECK(copter.nowMs() - answeredMs <= 15030);
  CHECK((copter.steering.step() == SteerStep::Disarm));
  CHECK((copter.end() == Status::Unconfirmed));
  CHECK_FALSE(copter.isArmed);
}

TEST_CASE("PX4's takeoff is asked once a second whether it has left the ground, for 15 s") {
  Standing px4(ClientOnLine::kPx4);
  px4.takesOff = false;
  px4.steering.takeOff(20_m);
  REQUIRE(px4.passUntil(22));
  const uint32_t sentMs = px4.nowMs();
  px4.said();
  CHECK((px4.end() == Status::Unconfirmed));
  CHECK_FALSE(px4.isArmed);
  const std::vector<uint32_t> times = px4.saidMs;
  CHECK(endsWith(px4.said(), kDisarm));
  REQUIRE(times.size() == 15);
  for (size_t i = 1; i + 1 < times.size(); ++i) CHECK(times[i] - times[i - 1] == 1032);
  CHECK(times.back() - sentMs > 14000);
  CHECK(times.back() - sentMs < 15100);
}

TEST_CASE("PX4 that leaves the ground later is done with the first answer that says so") {
  Standing px4(ClientOnLine::kPx4);
  px4.takesOff = false;
  px4.steering.takeOff(20_m);
  REQUIRE(px4.passUntil(22));
  px4.pass(5000);
  CHECK(px4.client.isBusy());
  px4.landed = 3;
  CHECK((px4.end() == Status::Done));
  CHECK(px4.tookMs <= 1100);
}

TEST_CASE("PX4 that does not say whether it has left the ground is disarmed after five questions") {
  Standing px4(ClientOnLine::kPx4);
  px4.takesOff = false;
  px4.steering.takeOff(20_m);
  REQUIRE(px4.passUntil(22));
  px4.hasLanded = false;
  px4.pass(7000);
  CHECK(px4.client.isBusy());
  CHECK((px4.end() == Status::Unconfirmed));
  CHECK_FALSE(px4.isArmed);
}

TEST_CASE("the repeat of a takeoff that was carried out is refused, and the takeoff done all the same") {
  Standing copter(ClientOnLine::kArduPilot);
  copter.once[22] = kSilent;
  copter.gives[22] = 4;
  copter.steering.takeOff(20_m);
  CHECK((copter.end() == Status::Done));
  CHECK(copter.isArmed);
  CHECK(count(copter.said(), "L22 ") == 2);
  Standing other(ClientOnLine::kArduPilot);
  other.takesOff = false;
  other.once[22] = kUnheard;
  other.gives[22] = 4;
  other.steering.takeOff(20_m);
  CHECK((other.end() == Status::Unconfirmed));
  CHECK_FALSE(other.isArmed);
}

TEST_CASE("an aircraft that flies is not disarmed when its takeoff was never answered") {
  Standing copter(ClientOnLine::kArduPilot);
  copter.gives[22] = kSilent;
  copter.steering.takeOff(20_m);
  CHECK((copter.end() == Status::NoAnswer));
  CHECK(copter.isArmed);
  CHECK(count(copter.said(), kDisarm) == 0);
}

TEST_CASE("what ends a takeoff stays its status, whatever becomes of the disarming") {
  for (int result : {4, int{kSilent}, int{kUnheard}}) {
    CAPTURE(result);
    Standing copter(ClientOnLine::kArduPilot);
    copter.gives[22] = 3;
    copter.steering.takeOff(20_m);
    REQUIRE(copter.passUntil(22));
    copter.gives[400] = result;
    CHECK((copter.end() == Status::CommandUnsupported));
    CHECK((copter.steering.step() == SteerStep::Disarm));
    const uint32_t sent = count(copter.said(), kDisarm);
    CHECK(sent == (result == kUnheard ? 5 : 1));
    CHECK(copter.isArmed == (result != kSilent));
  }
}

TEST_CASE("a heartbeat that shows it disarmed ends the disarming, and one that shows it armed does not") {
  Standing copter(ClientOnLine::kArduPilot);
  copter.beatsBySecond = false;
  copter.gives[22] = 4;
  copter.steering.takeOff(20_m);
  REQUIRE(copter.passUntil(22));
  copter.gives[400] = kUnheard;
  REQUIRE(copter.passUntil(400));
  copter.beat();
  copter.pass(5);
  CHECK(copter.client.isBusy());
  copter.isArmed = false;
  copter.beat();
  copter.pass(5);
  CHECK_FALSE(copter.client.isBusy());
  CHECK((copter.ended == Status::CommandFailed));
}

TEST_CASE("a heartbeat that shows it armed stands for the answer to the arming") {
  for (uint32_t mode : {kStabilize, kGuided}) {
    Aircraft copter(ClientOnLine::kArduPilot);
    copter.stand(mode);
    copter.beatsBySecond = false;
    copter.gives[400] = kSilent;
    copter.steering.takeOff(20_m);
    REQUIRE(copter.passUntil(400));
    CHECK(copter.passUntil(22, 200));  // a heartbeat was asked for
    CHECK((copter.end() == Status::Done));
  }
}

TEST_CASE("a pilot who takes the aircraft on the ground gets it disarmed, if the takeoff has armed it") {
  for (uint8_t firmware : kFirmwares) {
    for (uint16_t command : {176, 400, 22}) {
      CAPTURE(firmware);
      CAPTURE(command);
      Standing aircraft(firmware);
      aircraft.takesOff = false;
      aircraft.gives[22] = kUnheard;
      aircraft.steering.takeOff(20_m);
      REQUIRE(aircraft.passUntil(command));
      if (command == 176) aircraft.gives[176] = kUnheard;
      aircraft.pass(450);
      aircraft.said();
      if (command == 400) {  // the takeoff waits for its answer
        aircraft.mode = firmware == ClientOnLine::kPx4 ? uint32_t{kPx4Position} : uint32_t{kLoiter};
      }
      aircraft.show(firmware == ClientOnLine::kPx4 ? uint32_t{kPx4Position} : uint32_t{kLoiter});
      aircraft.end(10000);
      CHECK((aircraft.ended == Status::PilotHasIt));
      CHECK(aircraft.isArmed == false);
    }
  }
}

TEST_CASE("a pilot who takes the aircraft in the air keeps it armed") {
  Standing copter(ClientOnLine::kArduPilot);
  copter.gives[22] = kSilent;
  copter.beatsBySecond = false;
  copter.steering.takeOff(20_m);
  REQUIRE(copter.passUntil(22));
  copter.pass(450);
  copter.state = kActive;
  copter.show(kLoiter);
  copter.pass(500);
  CHECK((copter.ended == Status::PilotHasIt));
  CHECK(copter.isArmed);
  CHECK(count(copter.said(), kDisarm) == 0);
}

TEST_CASE("a takeoff that is refused when the pilot has it already leaves the disarming to the pilot") {
  Standing copter(ClientOnLine::kArduPilot);
  copter.gives[22] = kUnheard;
  copter.steering.takeOff(20_m);
  REQUIRE(copter.passUntil(22));
  copter.mode = kLoiter;
  copter.beat();
  copter.answer(22, 4);
  copter.end(5000);
  CHECK(copter.isArmed);
}

TEST_CASE("a failsafe of PX4 that begins during an order has the aircraft, and nothing is sent any more") {
  Flying px4(ClientOnLine::kPx4);
  px4.gives[192] = kUnheard;
  px4.steering.goTo(kPlace, aboveSeaLevel(620_m));
  REQUIRE(px4.passUntil(192));
  px4.pass(450);
  px4.said();
  px4.state = kCritical;
  px4.beat();
  CHECK((px4.end(1000) == Status::FailsafeHasIt));
  CHECK(px4.said() == "");
}

TEST_CASE(
    "a failsafe that is shown while an order may be under way is looked at again, unless it is in the order's mode") {
  for (bool isWanted : {false, true}) {
    Flying px4(ClientOnLine::kPx4);
    px4.beatsBySecond = false;
    px4.gives[176] = kUnheard;
    px4.steering.landNow();
    REQUIRE(px4.passUntil(176));
    px4.pass(50);
    px4.state = kCritical;
    px4.show(isWanted ? uint32_t{kPx4Land} : uint32_t{kPx4Rtl});
    px4.pass(5);
    CHECK(px4.client.isBusy() == !isWanted);
    CHECK((px4.end(1000) == (isWanted ? Status::Idle : Status::FailsafeHasIt)));
  }
}

TEST_CASE("a place that is refused in its mode is a refusal if the next heartbeat shows that mode, else a pilot") {
  for (uint8_t firmware : kFirmwares) {
    for (int what = 0; what < 3; ++what) {
      CAPTURE(firmware);
      CAPTURE(what);
      Flying aircraft(firmware);
      aircraft.steering.goTo(kPlace, aboveSeaLevel(620_m));
      REQUIRE((aircraft.end() == Status::Done));
      aircraft.pass(600);
      aircraft.beatsBySecond = false;
      aircraft.gives[192] = 4;
      aircraft.steering.goTo(kPlace, aboveSeaLevel(630_m));
      REQUIRE(aircraft.passUntil(192));
      if (what == 2) aircraft.beatsWhenAsked = false;
      if (what == 1) aircraft.mode = firmware == ClientOnLine::kPx4 ? uint32_t{kPx4Position} : uint32_t{kLoiter};
      CHECK((aircraft.end() == (what == 1 ? Status::PilotHasIt : Status::CommandFailed)));
      if (what == 2) {
        CHECK(aircraft.tookMs >= 7500);
        CHECK(aircraft.tookMs <= 7620);
      } else {
        CHECK(aircraft.tookMs <= 100);
      }
      CHECK(count(aircraft.said(), "I192") == 2);
    }
  }
}

TEST_CASE("PX4 says of a place that it does not support it, and flies there; of ArduPilot that is a refusal") {
  for (uint8_t firmware : kFirmwares) {
    Flying aircraft(firmware);
    aircraft.steering.goTo(kPlace, aboveSeaLevel(620_m));
    REQUIRE((aircraft.end() == Status::Done));
    aircraft.gives[192] = 3;
    aircraft.steering.goTo(kPlace, aboveSeaLevel(630_m));
    CHECK((aircraft.end() == (firmware == ClientOnLine::kPx4 ? Status::Done : Status::CommandUnsupported)));
    aircraft.gives[192] = 1;
    aircraft.steering.goTo(kPlace, aboveSeaLevel(630_m));
    CHECK((aircraft.end() == Status::CommandRejected));
  }
  // In another mode it is a refusal of either.
  for (uint8_t firmware : kFirmwares) {
    Flying aircraft(firmware);
    aircraft.gives[192] = 3;
    aircraft.steering.goTo(kPlace, aboveSeaLevel(620_m));
    CHECK((aircraft.end() == Status::CommandUnsupported));
    CHECK(aircraft.asks == 1);
  }
}

TEST_CASE("PX4 without a home, or whose height is not known, gets no height above home") {
  for (int what = 0; what < 4; ++what) {
    CAPTURE(what);
    Flying px4(ClientOnLine::kPx4);
    if (what == 1) px4.hasPosition = false;
    if (what == 2) px4.gives[511] = kUnheard;
    if (what == 3) px4.gives[511] = 2;
    px4.steering.goTo(kPlace, 20_m);
    if (what == 0) {
      REQUIRE(px4.passUntil(512));  // whether it flies
      px4.once[512] = 4;
    }
    px4.end();
    CHECK((px4.ended == (what == 3 ? Status::CommandDenied : what == 2 ? Status::NoAnswer : Status::NoHome)));
    CHECK(count(px4.said(), "192 ") == 0);
    if (what == 1) CHECK(px4.tookMs > 7500);
    if (what == 1) CHECK(px4.tookMs < 7700);
  }
}

TEST_CASE("where the position is only for hasArrived(), its refusal changes nothing, and its silence ends the order") {
  Flying copter(ClientOnLine::kArduPilot);
  copter.gives[511] = 4;
  copter.steering.goTo(kPlace, 20_m);
  CHECK((copter.end() == Status::Done));
  Flying silent(ClientOnLine::kArduPilot);
  silent.gives[511] = kUnheard;
  silent.steering.goTo(kPlace, 20_m);
  CHECK((silent.end() == Status::NoAnswer));
  CHECK((silent.steering.step() == SteerStep::AskPosition));
  // A pause is made of it: there its refusal is one.
  Flying paused(ClientOnLine::kArduPilot);
  paused.steering.pause();
  REQUIRE((paused.end() == Status::Done));
  paused.gives[511] = 4;
  paused.steering.pause();
  CHECK((paused.end() == Status::CommandFailed));
}

TEST_CASE("PX4 that accepts the question whether it flies, and never tells, is asked five times") {
  Flying px4(ClientOnLine::kPx4);
  px4.hasLanded = false;
  px4.steering.resume();
  CHECK((px4.end() == Status::NoAnswer));
  CHECK(px4.tookMs >= 7500);
  CHECK(px4.tookMs < 7600);
  // Told without an answer, it is not known to which question that was.
  Flying told(ClientOnLine::kPx4);
  told.gives[512] = kUnheard;
  told.steering.resume();
  REQUIRE(told.passUntil(512));
  told.tellLanded();
  told.pass(100);
  CHECK(told.client.isBusy());
  told.answer(512, 0);
  CHECK((told.end(100) == Status::Done));
}

TEST_CASE("PX4 that comes to the top of its takeoff while an order begins is still the sketch's") {
  for (int order = 0; order < 2; ++order) {
    CAPTURE(order);
    Aircraft px4(ClientOnLine::kPx4);
    px4.stand(kPx4Position);
    px4.steering.takeOff(20_m);
    REQUIRE((px4.end() == Status::Done));
    px4.homeMm = 20000;
    px4.seaMm = 604000;
    px4.tellPosition();
    px4.pass(2);
    px4.said();
    if (order == 0) {
      px4.steering.goTo(kPlace, aboveSeaLevel(620_m));
    } else {
      px4.steering.resume();
    }
    px4.pass(5);
    px4.show(kPx4Hold);
    CHECK((px4.end() == Status::Done));
    CHECK(px4.said() == (order == 0 ? "L512 245 0 0 0 0 0 0, I192 frame 5 -1 0 0 nan -353630000 1491652374 620"
                                    : "L512 245 0 0 0 0 0 0, L176 1 4 4 0 0 0 0"));
  }
}

TEST_CASE("a mode that is set again takes the target away, and the aircraft is not the sketch's") {
  Flying copter(ClientOnLine::kArduPilot);
  copter.homeMm = 20000;
  copter.here = kPlace;
  copter.steering.goTo(kPlace, 20_m);
  REQUIRE((copter.end() == Status::Done));
  copter.pass(600);
  REQUIRE(copter.steering.hasArrived());
  copter.gives[176] = kUnheard;
  copter.beatsBySecond = false;
  copter.steering.landNow();
  REQUIRE(copter.passUntil(176));
  copter.show(kRtl);
  copter.pass(5);
  copter.show(kLand);
  CHECK(copter.passUntil(176, 20));
  CHECK((copter.steering.step() == SteerStep::GiveBack));
  CHECK((copter.end() == Status::Overruled));
  CHECK_FALSE(copter.steering.maySteer());
  CHECK_FALSE(copter.steering.hasArrived());
}

TEST_CASE("an order ends with its time, and disarms before that") {
  Standing copter(ClientOnLine::kArduPilot);
  copter.takesOff = false;
  copter.client.setOperationTimeout(10);
  copter.steering.takeOff(20_m);
  CHECK((copter.end() == Status::TookTooLong));
  CHECK(copter.tookMs >= 9000);
  CHECK(copter.tookMs < 11100);
  CHECK_FALSE(copter.isArmed);
  CHECK(endsWith(copter.said(), kDisarm));
}
