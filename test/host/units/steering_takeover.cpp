// Steering where somebody else acts while an order begins or is under way, and where loop() has stood still.
#include <doctest/doctest.h>

#include "SteeredAircraft.h"

using namespace mavmission;
using namespace steered;

namespace {

constexpr LatLon kPlace = {-35.3630000_deg, 149.1652374_deg};

uint32_t count(const std::string& words, const std::string& one) {
  uint32_t found = 0;
  for (size_t at = words.find(one); at != std::string::npos; at = words.find(one, at + 1)) ++found;
  return found;
}
const char kArm[] = "L400 1 0 0 0 0 0 0", kDisarm[] = "L400 0 0 0 0 0 0 0";

// Until a heartbeat is asked for, behind which the order of this step leaves; no heartbeat comes by itself.
bool passUntilAsked(Aircraft& aircraft, SteerStep step) {
  aircraft.beatsBySecond = aircraft.beatsWhenAsked = false;
  const uint32_t before = aircraft.asks;
  for (int ms = 0; ms < 3000; ++ms) {
    if (aircraft.asks != before && aircraft.steering.step() == step) return true;
    aircraft.pass(1);
  }
  return false;
}

// What comes while loop() stands still for 300 ms is read then.
void standStill(Aircraft& aircraft) { aircraft.run(300, 300); }

}  // namespace

TEST_CASE("a pilot who takes the aircraft before it was armed keeps it as it is") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.stand(kGuided);
  copter.steering.takeOff(20_m);
  REQUIRE(copter.passUntil(511));
  REQUIRE(passUntilAsked(copter, SteerStep::Arm));
  copter.show(kLoiter);
  copter.pass(100);
  CHECK((copter.ended == Status::PilotHasIt));
  CHECK(count(copter.said(), "L400") == 0);

  Aircraft ordered(ClientOnLine::kArduPilot);
  ordered.stand(kStabilize);
  ordered.gives[176] = kUnheard;
  ordered.steering.takeOff(20_m);
  REQUIRE(ordered.passUntil(176));
  ordered.pass(450);
  ordered.show(kLoiter);
  ordered.pass(1000);
  CHECK((ordered.ended == Status::PilotHasIt));
  CHECK(count(ordered.said(), "L400") == 0);
}

TEST_CASE("a rover that a pilot takes is not disarmed") {
  Aircraft rover(ClientOnLine::kArduPilot, 10);
  rover.fly(kRoverAuto);
  rover.state = kStandby;
  rover.gives[192] = kUnheard;
  rover.steering.goTo(kPlace, 0_m);
  REQUIRE(rover.passUntil(192));
  rover.pass(450);
  rover.show(0);
  rover.pass(1000);
  CHECK((rover.ended == Status::PilotHasIt));
  CHECK(count(rover.said(), "L400") == 0);
}

TEST_CASE("a later order disarms nothing that an earlier takeoff has armed") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.stand(kGuided);
  copter.steering.takeOff(20_m);
  REQUIRE((copter.end() == Status::Done));
  copter.gives[176] = kUnheard;
  copter.steering.landNow();
  REQUIRE(copter.passUntil(176));
  copter.pass(450);
  copter.state = kStandby;
  copter.said();
  copter.show(kLoiter);
  copter.pass(1000);
  CHECK((copter.ended == Status::PilotHasIt));
  CHECK(count(copter.said(), "L400") == 0);
}

TEST_CASE("a pilot's takeover on the ground is disarmed with five attempts") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.stand(kGuided);
  copter.gives[22] = kUnheard;
  copter.steering.takeOff(20_m);
  REQUIRE(copter.passUntil(22));
  copter.pass(450);
  copter.gives[400] = kUnheard;
  copter.said();
  copter.show(kLoiter);
  CHECK((copter.end() == Status::PilotHasIt));
  CHECK(count(copter.said(), kDisarm) == 5);
}

TEST_CASE("a mode that somebody sets before the order has left is theirs, also if it is that of the order") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.fly(kAuto);
  copter.steering.goTo(kPlace, 20_m);
  REQUIRE((copter.end() == Status::Done));
  copter.steering.landNow();
  REQUIRE(passUntilAsked(copter, SteerStep::Mode));
  copter.said();
  copter.show(kLand);
  copter.pass(100);
  CHECK((copter.ended == Status::FailsafeHasIt));
  CHECK(copter.said() == "");
  CHECK_FALSE(copter.steering.maySteer());

  Aircraft rover(ClientOnLine::kArduPilot, 10);
  rover.fly(kRoverAuto);
  rover.steering.goTo(kPlace, 0_m);
  REQUIRE((rover.end() == Status::Done));
  rover.steering.pause();
  REQUIRE(rover.passUntil(176));  // HOLD
  rover.said();
  rover.beatsBySecond = false;
  rover.pass(40);
  rover.line.room = 0;  // GUIDED cannot be ordered right behind the heartbeat that shows HOLD
  mavlink_command_ack_t other = mavlink_command_ack_t();
  REQUIRE(rover.client.sendMessage(OutgoingMessage{77, 143, sizeof(other), 3, &other}));
  rover.pass(60);
  rover.beatsWhenAsked = false;
  rover.line.room = MemoryStream::kAlwaysRoom;
  rover.pass(40);
  rover.show(kRoverGuided);
  rover.pass(100);
  CHECK((rover.ended == Status::PilotHasIt));
  CHECK(rover.said() == "");
}

TEST_CASE("PX4 that somebody makes take off is not the sketch's") {
  Aircraft px4(ClientOnLine::kPx4);
  px4.stand(kPx4Mission);
  px4.steering.takeOff(20_m);
  REQUIRE(px4.passUntil(400));
  REQUIRE(passUntilAsked(px4, SteerStep::Command));
  px4.said();
  px4.show(kPx4TakeOff);
  px4.pass(1000);
  CHECK((px4.ended == Status::PilotHasIt));
  CHECK(count(px4.said(), "L22") == 0);
  CHECK_FALSE(px4.steering.maySteer());
}

TEST_CASE("a pilot who takes PX4 out of its takeoff while an order begins keeps it") {
  Aircraft px4(ClientOnLine::kPx4);
  px4.stand(kPx4Position);
  px4.steering.takeOff(20_m);
  REQUIRE((px4.end() == Status::Done));
  px4.steering.resume();
  REQUIRE(passUntilAsked(px4, SteerStep::Mode));
  px4.said();
  px4.show(kPx4Position);
  px4.beatsWhenAsked = true;
  px4.pass(1000);
  CHECK((px4.ended == Status::PilotHasIt));
  CHECK(px4.said() == "");
}

TEST_CASE("PX4's mode of a takeoff stands for the answer, and nothing is repeated") {
  Aircraft px4(ClientOnLine::kPx4);
  px4.stand(kPx4Position);
  px4.gives[22] = kSilent;
  px4.steering.takeOff(20_m);
  CHECK((px4.end() == Status::Done));
  CHECK(count(px4.said(), "L22") == 1);
}

TEST_CASE("only a heartbeat that shows PX4 armed stands for the answer to the arming, and only behind the command") {
  for (int what = 0; what < 3; ++what) {
    CAPTURE(what);
    Aircraft px4(ClientOnLine::kPx4);
    px4.stand(kPx4Position);
    px4.gives[400] = what == 1 ? kSilent : kUnheard;
    px4.beatsBySecond = false;
    px4.steering.takeOff(20_m);
    REQUIRE(px4.passUntil(511));
    REQUIRE(passUntilAsked(px4, SteerStep::Arm));
    if (what == 2) px4.isArmed = true;  // somebody has armed it
    px4.beat();
    REQUIRE(px4.passUntil(400, 100));
    CHECK_FALSE(px4.passUntil(22, 90));
    px4.beatsWhenAsked = true;
    CHECK(px4.passUntil(22, 200) == (what != 0));  // by a heartbeat that was asked for
  }
}

TEST_CASE("a foreign mode that is shown behind the answer is no confirmation") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.fly(kAuto);
  copter.steering.goTo(kPlace, 20_m);
  REQUIRE(copter.passUntil(192));
  copter.beatsBySecond = copter.beatsWhenAsked = false;
  copter.pass(35);
  REQUIRE((copter.steering.step() == SteerStep::Confirm));
  copter.show(kLoiter);
  copter.pass(20);
  CHECK(copter.client.isBusy());

  Aircraft seen(ClientOnLine::kArduPilot);
  seen.fly(kAuto);
  seen.tellTarget(1, 2, 3);
  seen.steering.goTo(kPlace, 20_m);
  REQUIRE(seen.passUntil(192));
  seen.beatsBySecond = seen.beatsWhenAsked = false;
  seen.pass(35);
  seen.show(kGuided);
  seen.pass(5);
  seen.show(kLoiter);
  seen.pass(5);
  seen.tellTarget(-353630000, 1491652374, 20);
  seen.pass(20);
  CHECK(seen.client.isBusy());
}

TEST_CASE("a heartbeat that was sent while loop() stood still proves nothing: another one is asked for") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.fly(kAuto);
  copter.gives[176] = kSilent;
  copter.steering.landNow();
  REQUIRE(copter.passUntil(176));
  copter.beatsBySecond = copter.beatsWhenAsked = false;
  copter.pass(100);
  copter.beat();
  const uint32_t asks = copter.asks;
  standStill(copter);
  CHECK(copter.client.isBusy());
  copter.beatsWhenAsked = true;
  copter.pass(20);
  CHECK(copter.client.isBusy());
  CHECK((copter.end(400) == Status::Done));
  CHECK(copter.asks > asks);
}

TEST_CASE("who disarms the aircraft before an order that arms can begin keeps it disarmed") {
  for (const bool isTakeOff : {true, false}) {
    Aircraft copter(ClientOnLine::kArduPilot);
    copter.stand(kGuided);
    copter.isArmed = true;
    copter.pass(1000);
    copter.beatsBySecond = copter.beatsWhenAsked = false;
    copter.run(1500, 1500);  // loop() stands still: a heartbeat is waited for
    if (isTakeOff) {
      copter.steering.takeOff(20_m);
    } else {
      copter.client.arm();
    }
    copter.pass(50);
    copter.isArmed = false;
    copter.beatsBySecond = copter.beatsWhenAsked = true;
    CHECK((copter.end(2000) == Status::NotArmed));
    CHECK_FALSE(copter.isArmed);
    CHECK((copter.client.takenBy() == (isTakeOff ? Status::PilotHasIt : Status::Idle)));
  }
}

TEST_CASE("a heartbeat that lay in the receive buffer does not show that an armed aircraft was disarmed") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.stand(kAuto);
  copter.client.setTargetIds(2, 1);
  copter.pass(10);
  copter.client.setTargetIds(1, 1);
  copter.beatsBySecond = false;
  copter.beat();
  copter.run(300, 300);
  copter.state = kActive;
  copter.isArmed = true;
  copter.show(kAuto);
  copter.pass(100);
  copter.steering.landNow();
  CHECK((copter.end(2000) == Status::Armed));
}

TEST_CASE("behind a standstill the mode is looked at again before a place is confirmed") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.fly(kAuto);
  copter.tellTarget(1, 2, 3);
  copter.steering.goTo(kPlace, 20_m);
  REQUIRE(copter.passUntil(192));
  copter.beatsBySecond = false;
  copter.pass(1200);
  copter.beatsWhenAsked = false;
  REQUIRE(copter.client.isBusy());
  copter.tellTarget(-353630000, 1491652374, 20);
  const uint32_t asks = copter.asks;
  standStill(copter);
  copter.pass(150);
  CHECK(copter.client.isBusy());
  CHECK(copter.asks > asks);
  copter.beat();
  copter.pass(5);
  CHECK((copter.ended == Status::Done));
}

TEST_CASE("a position that was sent while loop() stood still is not the present one") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.fly(kAuto);
  copter.steering.pause();
  REQUIRE((copter.end() == Status::Done));
  copter.hasPosition = false;
  copter.steering.pause();
  REQUIRE(copter.passUntil(511));
  copter.pass(200);
  copter.tellPosition();
  standStill(copter);
  copter.pass(100);
  CHECK((copter.steering.step() == SteerStep::AskPosition));
  copter.tellPosition();
  CHECK((copter.end(200) == Status::Done));
}

TEST_CASE("an answer that comes when its repeat is due leaves all attempts to the next step") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.stand(kGuided);
  copter.gives[400] = copter.gives[22] = kUnheard;
  copter.steering.takeOff(20_m);
  REQUIRE(copter.passUntil(400));
  copter.beatsBySecond = copter.beatsWhenAsked = false;
  copter.pass(1550);  // the repeat waits for a heartbeat
  CHECK(count(copter.said(), kArm) == 1);
  copter.answer(400, 0);
  copter.pass(5);
  REQUIRE((copter.steering.step() == SteerStep::Command));
  copter.isArmed = copter.beatsWhenAsked = true;
  copter.gives[400] = 0;
  CHECK((copter.end() == Status::NoAnswer));
  CHECK(count(copter.said(), "L22") == 5);
}

TEST_CASE("a question to PX4 whether it has left the ground is repeated, and its refusal proves nothing") {
  Aircraft px4(ClientOnLine::kPx4);
  px4.stand(kPx4Position);
  px4.takesOff = false;
  px4.steering.takeOff(20_m);
  REQUIRE(px4.passUntil(22));
  REQUIRE(px4.passUntil(512));
  REQUIRE(px4.passUntil(512));
  px4.once[512] = kUnheard;
  REQUIRE(px4.passUntil(512));
  CHECK(px4.passUntil(512, 1600));
  px4.landed = 3;
  CHECK((px4.end(3000) == Status::Done));

  Aircraft refusing(ClientOnLine::kPx4);
  refusing.stand(kPx4Position);
  refusing.takesOff = false;
  refusing.steering.takeOff(20_m);
  REQUIRE(refusing.passUntil(22));
  refusing.gives[512] = 4;
  refusing.pass(3000);
  CHECK(refusing.client.isBusy());
}

TEST_CASE("the 15 s of PX4's takeoff begin with its acceptance, however long the steps before have taken") {
  Aircraft px4(ClientOnLine::kPx4);
  px4.stand(kPx4Position);
  px4.takesOff = px4.hasPosition = false;
  px4.steering.takeOff(20_m);
  px4.pass(6000);
  px4.hasPosition = true;
  REQUIRE(px4.passUntil(22));
  px4.said();
  px4.pass(13500);
  CHECK(px4.client.isBusy());
  CHECK(count(px4.said(), kDisarm) == 0);
}

TEST_CASE("an order that had to wait for its autopilot has all its time behind that") {
  Aircraft px4(ClientOnLine::kPx4);
  px4.mode = kPx4Position;
  px4.beatsBySecond = false;
  px4.steering.takeOff(20_m);
  px4.pass(7500);
  px4.beatsBySecond = true;
  CHECK((px4.end(10000) == Status::Done));
}

TEST_CASE("an order that could not be begun for 10 s is not carried out when the autopilot is heard again") {
  for (bool isInAir : {false, true}) {
    Aircraft copter(ClientOnLine::kArduPilot);
    isInAir ? copter.fly(kAuto) : copter.stand(kStabilize);
    copter.beatsBySecond = copter.beatsWhenAsked = false;
    copter.pass(6000);
    if (isInAir) {
      copter.steering.landNow();
    } else {
      copter.steering.takeOff(20_m);
    }
    CHECK((copter.end(20000) == Status::NoAutopilot));
    CHECK(copter.tookMs <= 10010);
    copter.beatsBySecond = copter.beatsWhenAsked = true;
    copter.pass(5000);
    CHECK(copter.said() == "");
  }
}

TEST_CASE("a takeover is remembered behind the landing, until the sketch asks for the aircraft again") {
  for (int who = 0; who < 3; ++who) {
    CAPTURE(who);
    Aircraft copter(ClientOnLine::kArduPilot);
    copter.stand(kGuided);
    copter.steering.takeOff(20_m);
    REQUIRE((copter.end() == Status::Done));
    CHECK((copter.client.takenBy() == Status::Idle));
    copter.pass(1500);
    const Status taken = who == 1 ? Status::FailsafeHasIt : Status::PilotHasIt;
    if (who == 2) {  // while an order is under way
      copter.gives[192] = kUnheard;
      copter.steering.goTo(kPlace, 20_m);
      copter.passUntil(192);
    }
    copter.show(who == 1 ? kRtl : kLoiter);
    copter.pass(3000);
    CHECK((copter.client.takenBy() == taken));
    copter.isArmed = false;  // it has landed
    copter.state = kStandby;
    copter.pass(2000);
    copter.mode = kGuided;
    copter.pass(60000);
    copter.said();
    copter.steering.takeOff(20_m);
    CHECK((copter.end() == taken));
    copter.client.arm();
    CHECK((copter.end() == taken));
    CHECK(copter.said() == "");
    CHECK((copter.client.takenBy() == taken));
    copter.steering.requestControl();
    CHECK((copter.client.takenBy() == Status::Idle));
    copter.steering.takeOff(20_m);
    CHECK((copter.end() == Status::Done));
  }
}

TEST_CASE("on PX4 a pilot's RETURN or HOLD is a takeover from the sketch's own mode, and may be the end of a plan") {
  for (const bool isOwn : {true, false}) {
    Aircraft px4(ClientOnLine::kPx4);
    px4.fly(kPx4Mission);
    if (isOwn) {
      px4.steering.landNow();
      REQUIRE((px4.end() == Status::Done));
    }
    px4.show(isOwn ? kPx4Hold : kPx4Rtl);
    px4.pass(3000);
    CHECK((px4.client.takenBy() == (isOwn ? Status::PilotHasIt : Status::Idle)));
    CHECK_FALSE(px4.steering.maySteer());
  }
}

TEST_CASE("the mode that the sketch has set is forgotten at the disarming, and after 20 s without a heartbeat") {
  for (int what = 0; what < 4; ++what) {
    CAPTURE(what);
    Aircraft copter(ClientOnLine::kArduPilot);
    copter.fly(kAuto);
    copter.steering.goTo(kPlace, 20_m);
    REQUIRE((copter.end() == Status::Done));
    CHECK(copter.steering.maySteer());
    if (what == 2) {
      copter.isArmed = false;
      copter.pass(2000);
      copter.isArmed = true;
    } else {
      copter.beatsBySecond = copter.beatsWhenAsked = false;
      copter.hasPosition = what == 3;
      copter.pass(what == 0 ? 15000 : 21000);
      copter.beatsBySecond = copter.beatsWhenAsked = true;
    }
    copter.pass(2000);
    CHECK(copter.steering.maySteer() == (what == 0));
    copter.steering.requestControl();
    CHECK(copter.steering.maySteer());
    copter.steering.landNow();  // at once
    CHECK((copter.end() == Status::Done));
    copter.pass(1001);
    CHECK(copter.steering.maySteer());
  }
}

TEST_CASE("a position alone is no answer to the question whether PX4 flies") {
  Aircraft px4(ClientOnLine::kPx4);
  px4.fly(kPx4Mission);
  px4.hasLanded = false;
  px4.steering.landNow();
  REQUIRE(px4.passUntil(512));
  px4.pass(40);
  px4.tellPosition();
  px4.pass(100);
  CHECK((px4.steering.step() == SteerStep::AskLanded));
}

TEST_CASE("PX4 that accepts the question for its position is not asked again, and may take 7.5 s to tell it") {
  Aircraft px4(ClientOnLine::kPx4);
  px4.fly(kPx4Mission);
  px4.hasPosition = false;
  px4.steering.goTo(kPlace, 20_m);
  CHECK((px4.end() == Status::NoHome));
  CHECK(count(px4.said(), "L511") == 1);
}

TEST_CASE("the disarming of a takeoff that took too long has five attempts of its own") {
  Aircraft copter(ClientOnLine::kArduPilot);
  copter.stand(kGuided);
  copter.takesOff = false;
  copter.client.setOperationTimeout(5);
  copter.steering.takeOff(20_m);
  REQUIRE(copter.passUntil(22));
  copter.gives[400] = kUnheard;
  CHECK((copter.end() == Status::TookTooLong));
  CHECK(count(copter.said(), kDisarm) == 5);
}

TEST_CASE("on a lossy link, PX4 that accepts the question and never tells is asked for 20 s") {
  Aircraft px4(ClientOnLine::kPx4);
  px4.fly(kPx4Mission);
  for (int i = 0; i < 100; ++i) {
    px4.lose(3);
    px4.tellPosition();
    px4.pass(20);
  }
  px4.hasLanded = false;
  px4.steering.landNow();
  const uint32_t beganMs = px4.nowMs();
  for (int i = 0; i < 300 && px4.client.isBusy(); ++i) {
    px4.lose(3);
    px4.pass(100);
  }
  CHECK((px4.ended == Status::NoAnswer));
  CHECK(px4.nowMs() - beganMs >= 19000);
  CHECK(px4.nowMs() - beganMs <= 20200);
}
