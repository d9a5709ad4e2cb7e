// Steering where a step is refused, is not answered, or somebody else takes the aircraft: what it ends with, and when.
#include <doctest/doctest.h>

#include <initializer_list>

#include "SteeredAircraft.h"

using namespace mavmission;
using namespace steered;

namespace {

constexpr uint8_t kArduPilot = ClientOnLine::kArduPilot, kPx4 = ClientOnLine::kPx4;
constexpr uint8_t kFirmwares[] = {kArduPilot, kPx4};

// What a pilot sets.
uint32_t pilotsMode(uint8_t firmware) { return firmware == kPx4 ? uint32_t{kPx4Position} : uint32_t{kLoiter}; }

// On the ground, in a mode from which a takeoff leads away; and in its mission.
struct Standing : Aircraft {
  explicit Standing(uint8_t firmware) : Aircraft(firmware) { stand(); }
};
struct Flying : Aircraft {
  explicit Flying(uint8_t firmware) : Aircraft(firmware) { inMission(); }
};

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
        aircraft.answering(one.command, result).takeOff().end();
        CHECK(static_cast<int>(aircraft.ended) == static_cast<int>(Status::CommandRejected) + result - 1);
        CHECK((aircraft.steering.step() == one.step));
        CHECK_FALSE(aircraft.isArmed);
        CHECK(aircraft.times(kDisarm) == (one.disarms ? 1 : 0));
        CHECK(aircraft.times("L22 ") == (one.disarms ? 1 : 0));
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
      aircraft.once[command] = kUnheard;
      const uint32_t firstMs = aircraft.answering(command).takeOff().until(command).nowMs();
      for (uint32_t i = 1; i < 5; ++i) {
        REQUIRE(aircraft.passUntil(command, 1600));
        CHECK(aircraft.nowMs() - firstMs >= 1500 * i);
      }
      aircraft.gives.clear();
      CHECK((aircraft.end(3000) == Status::NoAnswer));
      CHECK(aircraft.times(kDisarm) == (command == 22 ? 1 : 0));  // a heartbeat that shows it disarmed is enough
      CHECK(aircraft.times("L" + std::to_string(command) + " ") == 5);
      CHECK((aircraft.steering.step() == (command == 176 ? SteerStep::Mode : SteerStep::Disarm)));
    }
  }
}

TEST_CASE("a mode that was accepted and is not shown is unconfirmed; one that was never answered is not answered") {
  for (uint8_t firmware : kFirmwares) {
    Flying aircraft(firmware);
    CHECK((aircraft.answering(176).landNow().end() == Status::NoAnswer));
    CHECK((aircraft.steering.step() == SteerStep::Mode));
    aircraft.wait(25000).landNow().until(176).answer(176, 0);
    CHECK((aircraft.end() == Status::Unconfirmed));
    CHECK(aircraft.tookMs <= 7620);
  }
}

TEST_CASE(
    "a takeoff that does not leave the ground is given up 15 s after its acceptance, and PX4's asked each second") {
  Standing copter(kArduPilot);
  copter.takesOff = false;
  const uint32_t answeredMs = copter.takeOff().until(22).nowMs() + 31;
  REQUIRE(copter.passUntil(400));
  CHECK(copter.nowMs() - answeredMs >= 15000);
  CHECK(copter.nowMs() - answeredMs <= 15030);
  copter.said();
  CHECK(copter.how() == "Unconfirmed at Disarm: ");
  CHECK_FALSE(copter.isArmed);

  Standing px4(kPx4);
  px4.takesOff = false;
  const uint32_t sentMs = px4.takeOff().until(22).nowMs();
  px4.said();
  CHECK((px4.end() == Status::Unconfirmed));
  CHECK_FALSE(px4.isArmed);
  const std::vector<uint32_t> times = px4.saidMs;
  REQUIRE(times.size() == 15);
  CHECK(px4.times("L512 245 ") == 14);
  CHECK(px4.times(kDisarm) == 1);
  for (size_t i = 1; i + 1 < times.size(); ++i) CHECK(times[i] - times[i - 1] == 1032);
  CHECK(times.back() - sentMs > 14000);
  CHECK(times.back() - sentMs < 15100);
}

TEST_CASE("PX4 is done with the first answer that says it has left the ground, and disarmed if none comes") {
  Standing px4(kPx4), silent(kPx4);
  px4.takesOff = silent.takesOff = false;
  CHECK(px4.takeOff().until(22).wait(5000).client.isBusy());
  px4.landed = 3;
  CHECK((px4.end() == Status::Done));
  CHECK(px4.tookMs <= 1100);
  silent.takeOff().until(22).hasLanded = false;
  CHECK(silent.wait(7000).client.isBusy());
  CHECK((silent.end() == Status::Unconfirmed));  // after five questions
  CHECK_FALSE(silent.isArmed);
}

TEST_CASE("the repeat of a takeoff that was carried out is refused, and the takeoff done all the same") {
  for (bool takesOff : {true, false}) {
    Standing copter(kArduPilot);
    copter.takesOff = takesOff;
    copter.once[22] = takesOff ? kSilent : kUnheard;
    CHECK(copter.answering(22, 4).takeOff().status() == (takesOff ? "Done" : "Unconfirmed"));
    CHECK(copter.isArmed == takesOff);
    CHECK(copter.times("L22 ") == 2);
  }
  Standing copter(kArduPilot);  // nor is one that flies disarmed when its takeoff was never answered
  CHECK(copter.answering(22, kSilent).takeOff().status() == "NoAnswer");
  CHECK(copter.isArmed);
  CHECK(copter.times(kDisarm) == 0);
}

TEST_CASE("what ends a takeoff stays its status, whatever becomes of the disarming") {
  for (int result : {4, int{kSilent}, int{kUnheard}}) {
    CAPTURE(result);
    Standing copter(kArduPilot);
    copter.answering(22, 3).takeOff().until(22).answering(400, result);
    CHECK((copter.end() == Status::CommandUnsupported));
    CHECK((copter.steering.step() == SteerStep::Disarm));
    CHECK(copter.times(kDisarm) == (result == kUnheard ? 5 : 1));
    CHECK(copter.isArmed == (result != kSilent));
  }
}

TEST_CASE("a heartbeat that shows it disarmed ends the disarming, and one that shows it armed stands for an arming") {
  Standing copter(kArduPilot);
  copter.beatsBySecond = false;
  copter.answering(22, 4).takeOff().until(22).answering(400).until(400).beat();
  CHECK(copter.wait(5).client.isBusy());
  copter.isArmed = false;
  copter.beat();
  CHECK_FALSE(copter.wait(5).client.isBusy());
  CHECK((copter.ended == Status::CommandFailed));
  for (uint32_t mode : {kStabilize, kGuided}) {
    Aircraft arming(kArduPilot);
    arming.stand(mode).answering(400, kSilent).beatsBySecond = false;
    CHECK(arming.takeOff().until(400).passUntil(22, 200));  // a heartbeat was asked for
    CHECK((arming.end() == Status::Done));
  }
}

TEST_CASE("a pilot who takes the aircraft on the ground gets it disarmed, if the takeoff has armed it") {
  for (uint8_t firmware : kFirmwares) {
    for (uint16_t command : {176, 400, 22}) {
      CAPTURE(firmware);
      CAPTURE(command);
      Standing aircraft(firmware);
      aircraft.takesOff = false;
      aircraft.answering(22).takeOff().until(command);
      if (command == 176) aircraft.gives[176] = kUnheard;
      aircraft.wait(450).show(pilotsMode(firmware));
      aircraft.end(10000);
      CHECK((aircraft.ended == Status::PilotHasIt));
      CHECK_FALSE(aircraft.isArmed);
    }
  }
  Standing copter(kArduPilot);  // in the air it stays armed
  copter.beatsBySecond = false;
  copter.answering(22, kSilent).takeOff().until(22).wait(450).state = kActive;
  copter.show(kLoiter);
  CHECK((copter.wait(500).ended == Status::PilotHasIt));
  CHECK(copter.isArmed);
  CHECK(copter.times(kDisarm) == 0);
  Standing refused(kArduPilot);  // a takeoff that is refused when the pilot has it already leaves that to the pilot
  refused.answering(22).takeOff().until(22).mode = kLoiter;
  refused.beat();
  refused.answer(22, 4);
  refused.end(5000);
  CHECK(refused.isArmed);
}

TEST_CASE("a failsafe of PX4 that begins during an order has it, and is looked at again if the order is under way") {
  Flying px4(kPx4);
  px4.answering(192).goTo(aboveSeaLevel(620_m)).until(192).wait(450).said();
  px4.state = kCritical;
  px4.beat();
  CHECK(px4.how(1000) == "FailsafeHasIt at Command: ");
  for (bool isWanted : {false, true}) {  // it is shown in the mode of the order
    Flying landing(kPx4);
    landing.beatsBySecond = false;
    landing.answering(176).landNow().until(176).wait(50).state = kCritical;
    landing.show(isWanted ? uint32_t{kPx4Land} : uint32_t{kPx4Rtl});
    CHECK(landing.wait(5).client.isBusy() == !isWanted);
    CHECK(landing.status(1000) == (isWanted ? "Idle" : "FailsafeHasIt"));
  }
}

TEST_CASE("a place that is refused in its mode is a refusal if the next heartbeat shows that mode, else a pilot") {
  enum What { InItsMode, InAPilots, NoHeartbeat };
  for (uint8_t firmware : kFirmwares) {
    for (What what : {InItsMode, InAPilots, NoHeartbeat}) {
      CAPTURE(firmware);
      CAPTURE(int{what});
      Flying aircraft(firmware);
      aircraft.goTo(aboveSeaLevel(620_m)).done().wait(600).beatsBySecond = false;
      aircraft.answering(192, 4).goTo(aboveSeaLevel(630_m)).until(192);
      if (what == NoHeartbeat) aircraft.beatsWhenAsked = false;
      if (what == InAPilots) aircraft.mode = pilotsMode(firmware);
      CHECK(aircraft.status() == (what == InAPilots ? "PilotHasIt" : "CommandFailed"));
      CHECK(aircraft.tookMs >= (what == NoHeartbeat ? 7500 : 0));
      CHECK(aircraft.tookMs <= (what == NoHeartbeat ? 7620 : 100));
      CHECK(aircraft.times("I192") == 2);
    }
  }
}

TEST_CASE("PX4 says of a place that it does not support it, and flies there; of ArduPilot that is a refusal") {
  for (uint8_t firmware : kFirmwares) {
    Flying aircraft(firmware);
    aircraft.goTo(aboveSeaLevel(620_m)).done().answering(192, 3).goTo(aboveSeaLevel(630_m));
    CHECK(aircraft.status() == (firmware == kPx4 ? "Done" : "CommandUnsupported"));
    CHECK(aircraft.answering(192, 1).goTo(aboveSeaLevel(630_m)).status() == "CommandRejected");
    Flying other(firmware);  // in another mode it is a refusal of either
    CHECK(other.answering(192, 3).goTo(aboveSeaLevel(620_m)).status() == "CommandUnsupported");
    CHECK(other.asks == 1);
  }
}

TEST_CASE("PX4 without a home, or whose height is not known, gets no height above home") {
  Flying homeless(kPx4), unknown(kPx4), silent(kPx4), denying(kPx4);
  homeless.goTo().until(512).once[512] = 4;  // after the question whether it flies
  CHECK(homeless.status() == "NoHome");
  unknown.hasPosition = false;
  CHECK(unknown.goTo().status() == "NoHome");
  CHECK(unknown.tookMs > 7500);
  CHECK(unknown.tookMs < 7700);
  CHECK(silent.answering(511).goTo().status() == "NoAnswer");
  CHECK(denying.answering(511, 2).goTo().status() == "CommandDenied");
  for (Aircraft* px4 : {&homeless, &unknown, &silent, &denying}) CHECK(px4->said().find("192 ") == std::string::npos);
}

TEST_CASE("where the position is only for hasArrived(), its refusal changes nothing, and its silence ends the order") {
  CHECK(Flying(kArduPilot).answering(511, 4).goTo().status() == "Done");
  CHECK(Flying(kArduPilot).answering(511).goTo().how().substr(0, 23) == "NoAnswer at AskPosition");
  // A pause is made of it: there its refusal is one.
  CHECK(Flying(kArduPilot).pause().done().answering(511, 4).pause().how() ==
        "CommandFailed at AskPosition: L176 1 4 0 0 0 0 0, L511 33 500000 0 0 0 0 0");
}

TEST_CASE("PX4 that accepts the question whether it flies, and never tells, is asked five times") {
  Flying px4(kPx4);
  px4.hasLanded = false;
  CHECK(px4.resume().status() == "NoAnswer");
  CHECK(px4.tookMs >= 7500);
  CHECK(px4.tookMs < 7600);
  // Told without an answer, it is not known to which question that was.
  Flying told(kPx4);
  told.answering(512).resume().until(512).tellLanded();
  CHECK(told.wait(100).client.isBusy());
  told.answer(512, 0);
  CHECK((told.end(100) == Status::Done));
}

TEST_CASE("PX4 that comes to the top of its takeoff while an order begins is still the sketch's") {
  for (bool isPlace : {true, false}) {
    Aircraft px4(kPx4);
    px4.stand(kPx4Position).takeOff().done().atHeight(20000).said();
    (isPlace ? px4.goTo(aboveSeaLevel(620_m)) : px4.resume()).wait(5).show(kPx4Hold);
    CHECK(px4.status() == "Done");
    CHECK(px4.said() == (isPlace ? "L512 245 0 0 0 0 0 0, I192 frame 5 -1 0 0 nan -353630000 1491652374 620"
                                 : "L512 245 0 0 0 0 0 0, L176 1 4 4 0 0 0 0"));
  }
}

TEST_CASE("a mode that is set again takes the target away, and the aircraft is not the sketch's") {
  Flying copter(kArduPilot);
  copter.homeMm = 20000;
  copter.here = kThere;
  REQUIRE(copter.goTo().done().wait(600).steering.hasArrived());
  copter.beatsBySecond = false;
  copter.answering(176).landNow().until(176).show(kRtl);
  copter.wait(5).show(kLand);
  CHECK(copter.passUntil(176, 20));
  copter.said();
  CHECK(copter.how().substr(0, 21) == "Overruled at GiveBack");
  CHECK_FALSE(copter.steering.maySteer());
  CHECK_FALSE(copter.steering.hasArrived());
}

TEST_CASE("an order ends with its time, and disarms before that") {
  Standing copter(kArduPilot);
  copter.takesOff = false;
  copter.client.setOperationTimeout(10);
  CHECK(copter.takeOff().status() == "TookTooLong");
  CHECK(copter.tookMs >= 9000);
  CHECK(copter.tookMs < 11100);
  CHECK_FALSE(copter.isArmed);
  CHECK(copter.times(kDisarm) == 1);
}
