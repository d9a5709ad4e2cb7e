// Steering where somebody else acts while an order begins or is under way, and where loop() has stood still.
#include <doctest/doctest.h>

#include "SteeredAircraft.h"

using namespace mavmission;
using namespace steered;

namespace {

constexpr uint8_t kArduPilot = ClientOnLine::kArduPilot, kPx4 = ClientOnLine::kPx4;
// kThere, as the autopilot names it.
constexpr int32_t kLatitude = -353630000, kLongitude = 1491652374;

// Until a heartbeat is asked for, after which the order of this step leaves; no heartbeat comes by itself.
Aircraft& untilAsked(Aircraft& aircraft, SteerStep step) {
  const uint32_t before = aircraft.silence().asks;
  for (int ms = 0; ms < 3000 && (aircraft.asks == before || aircraft.steering.step() != step); ++ms) aircraft.pass(1);
  CHECK(aircraft.asks != before);
  CHECK((aircraft.steering.step() == step));
  aircraft.said();
  return aircraft;
}

// What comes while loop() stands still for 300 ms is read then.
void standStill(Aircraft& aircraft) { aircraft.run(300, 300); }

// What an order has ended with in this time, and what was sent.
std::string within(Aircraft& aircraft, uint32_t ms) {
  aircraft.pass(ms);
  return std::string(aircraft.client.isBusy() ? "goes on" : nameOf(aircraft.ended)) + ": " + aircraft.said();
}

}  // namespace

TEST_CASE("a pilot who takes the aircraft keeps it as it is: it is disarmed only where the order has armed it") {
  Aircraft copter(kArduPilot);  // before it was armed
  untilAsked(copter.stand(kGuided).takeOff().until(511), SteerStep::Arm).show(kLoiter);
  CHECK(within(copter, 100) == "PilotHasIt: ");

  Aircraft ordered(kArduPilot);
  ordered.stand(kStabilize).answering(176).takeOff().until(176).wait(450).show(kLoiter);
  CHECK(within(ordered, 1000).substr(0, 12) == "PilotHasIt: ");
  CHECK(ordered.times("L400") == 0);

  Aircraft rover(kArduPilot, 10);
  rover.inMission().answering(192).state = kStandby;
  rover.goTo(0_m).until(192).wait(450).said();
  rover.show(0);
  CHECK(within(rover, 1000).find("L400") == std::string::npos);
  CHECK((rover.ended == Status::PilotHasIt));

  Aircraft landing(kArduPilot);  // a takeoff before has armed it
  landing.stand(kGuided).takeOff().done().answering(176).landNow().until(176).wait(450).said();
  landing.state = kStandby;
  landing.show(kLoiter);
  CHECK(within(landing, 1000).find("L400") == std::string::npos);
  CHECK((landing.ended == Status::PilotHasIt));
}

TEST_CASE("the disarming of a takeoff that a pilot takes over, or that took too long, has five attempts") {
  for (bool isPilot : {true, false}) {
    Aircraft copter(kArduPilot);
    copter.takesOff = false;
    if (!isPilot) copter.client.setOperationTimeout(5);
    copter.stand(kGuided).answering(22, isPilot ? kUnheard : 0).takeOff().until(22).wait(isPilot ? 450 : 0).said();
    copter.answering(400);
    if (isPilot) copter.show(kLoiter);
    CHECK(copter.status() == (isPilot ? "PilotHasIt" : "TookTooLong"));
    CHECK(copter.times(kDisarm) == 5);
  }
}

TEST_CASE("a mode that somebody sets before the order has left is theirs, also if it is that of the order") {
  Aircraft copter(kArduPilot);
  untilAsked(copter.inMission().goTo().done().landNow(), SteerStep::Mode).show(kLand);
  CHECK(within(copter, 100) == "FailsafeHasIt: ");
  CHECK_FALSE(copter.steering.maySteer());

  Aircraft rover(kArduPilot, 10);
  rover.inMission().goTo(0_m).done().pause().until(176).said();  // HOLD
  rover.beatsBySecond = false;
  rover.wait(40).line.room = 0;  // GUIDED cannot be ordered right after the heartbeat that shows HOLD
  mavlink_command_ack_t other = mavlink_command_ack_t();
  REQUIRE(rover.client.sendMessage(OutgoingMessage{77, 143, sizeof(other), 3, &other}));
  rover.wait(60).silence().line.room = MemoryStream::kAlwaysRoom;
  rover.wait(40).show(kRoverGuided);
  CHECK(within(rover, 100) == "PilotHasIt: ");

  Aircraft px4(kPx4);  // somebody makes it take off
  untilAsked(px4.stand(kPx4Mission).takeOff().until(400), SteerStep::Command).show(kPx4TakeOff);
  CHECK(within(px4, 1000).find("L22") == std::string::npos);
  CHECK((px4.ended == Status::PilotHasIt));
  CHECK_FALSE(px4.steering.maySteer());

  Aircraft taken(kPx4);  // a pilot takes it out of its takeoff while an order begins
  untilAsked(taken.stand(kPx4Position).takeOff().done().resume(), SteerStep::Mode).show(kPx4Position);
  taken.beatsWhenAsked = true;
  CHECK(within(taken, 1000) == "PilotHasIt: ");
}

TEST_CASE("only a heartbeat that shows PX4 armed stands for the answer to the arming, and only after the command") {
  enum What { Unheard, CarriedOut, ArmedByAnother };
  for (What what : {Unheard, CarriedOut, ArmedByAnother}) {
    CAPTURE(int{what});
    Aircraft px4(kPx4);
    px4.stand(kPx4Position).answering(400, what == CarriedOut ? kSilent : kUnheard).beatsBySecond = false;
    untilAsked(px4.takeOff().until(511), SteerStep::Arm);
    if (what == ArmedByAnother) px4.isArmed = true;
    px4.beat();
    REQUIRE(px4.passUntil(400, 100));
    CHECK_FALSE(px4.passUntil(22, 90));
    px4.beatsWhenAsked = true;
    CHECK(px4.passUntil(22, 200) == (what != Unheard));  // by a heartbeat that was asked for
  }
  Aircraft px4(kPx4);  // its mode stands for the answer to the takeoff, and nothing is repeated
  CHECK(px4.stand(kPx4Position).answering(22, kSilent).takeOff().status() == "Done");
  CHECK(px4.times("L22") == 1);
}

TEST_CASE("a foreign mode that is shown after the answer is no confirmation") {
  Aircraft copter(kArduPilot);
  copter.inMission().goTo().until(192).silence().pass(35);
  REQUIRE((copter.steering.step() == SteerStep::Confirm));
  copter.show(kLoiter);
  CHECK(copter.wait(20).client.isBusy());

  Aircraft seen(kArduPilot);
  seen.inMission().tellTarget(1, 2, 3);
  seen.goTo().until(192).silence().wait(35).show(kGuided);
  seen.wait(5).show(kLoiter);
  seen.wait(5).tellTarget(kLatitude, kLongitude, 20);
  CHECK(seen.wait(20).client.isBusy());
}

TEST_CASE("a heartbeat that was sent while loop() stood still proves nothing: another one is asked for") {
  Aircraft copter(kArduPilot);
  copter.inMission().answering(176, kSilent).landNow().until(176).silence().wait(100).beat();
  const uint32_t asks = copter.asks;
  standStill(copter);
  CHECK(copter.client.isBusy());
  copter.beatsWhenAsked = true;
  CHECK(copter.wait(20).client.isBusy());
  CHECK(copter.status(400) == "Done");
  CHECK(copter.asks > asks);

  Aircraft there(kArduPilot);  // before a place is confirmed the mode is looked at again
  there.inMission().tellTarget(1, 2, 3);
  there.goTo().until(192).beatsBySecond = false;
  REQUIRE(there.wait(1200).silence().client.isBusy());
  there.tellTarget(kLatitude, kLongitude, 20);
  const uint32_t before = there.asks;
  standStill(there);
  CHECK(there.wait(150).client.isBusy());
  CHECK(there.asks > before);
  there.beat();
  CHECK((there.wait(5).ended == Status::Done));

  Aircraft paused(kArduPilot);  // nor is a position from then the present one
  paused.inMission().pause().done().hasPosition = false;
  paused.pause().until(511).wait(200).tellPosition();
  standStill(paused);
  CHECK((paused.wait(100).steering.step() == SteerStep::AskPosition));
  paused.tellPosition();
  CHECK(paused.status(200) == "Done");
}

TEST_CASE("who disarms the aircraft before an order that arms can begin keeps it disarmed") {
  for (const bool isTakeOff : {true, false}) {
    Aircraft copter(kArduPilot);
    copter.stand(kGuided).isArmed = true;
    copter.wait(1000).silence().run(1500, 1500);  // loop() stands still: a heartbeat is waited for
    isTakeOff ? copter.steering.takeOff(20_m) : copter.client.arm();
    copter.wait(50).silence(false).isArmed = false;
    CHECK(copter.status(2000) == "NotArmed");
    CHECK_FALSE(copter.isArmed);
    CHECK((copter.client.takenBy() == (isTakeOff ? Status::PilotHasIt : Status::Idle)));
  }
}

TEST_CASE("a heartbeat that lay in the receive buffer does not show that an armed aircraft was disarmed") {
  Aircraft copter(kArduPilot);
  copter.stand(kAuto).client.setTargetIds(2, 1);
  copter.wait(10).client.setTargetIds(1, 1);
  copter.beatsBySecond = false;
  copter.beat();
  standStill(copter);
  copter.state = kActive;
  copter.isArmed = true;
  copter.show(kAuto);
  CHECK(copter.wait(100).landNow().status(2000) == "Armed");
}

TEST_CASE("an answer that comes when its repeat is due leaves all attempts to the next step") {
  Aircraft copter(kArduPilot);
  copter.stand(kGuided).answering(400).answering(22).takeOff().until(400).silence().pass(1550);
  CHECK(copter.times("L400 1 0 0 0 0 0 0") == 1);  // the repeat waits for a heartbeat
  copter.answer(400, 0);
  REQUIRE((copter.wait(5).steering.step() == SteerStep::Command));
  copter.isArmed = copter.beatsWhenAsked = true;
  CHECK(copter.answering(400, 0).status() == "NoAnswer");
  CHECK(copter.times("L22") == 5);
}

TEST_CASE("a question to PX4 whether it has left the ground is repeated, and its refusal proves nothing") {
  Aircraft px4(kPx4);
  px4.takesOff = false;
  px4.stand(kPx4Position).takeOff().until(22).until(512).until(512).once[512] = kUnheard;
  CHECK(px4.until(512).passUntil(512, 1600));
  px4.landed = 3;
  CHECK(px4.status(3000) == "Done");
  Aircraft refusing(kPx4);
  refusing.takesOff = false;
  CHECK(refusing.stand(kPx4Position).takeOff().until(22).answering(512, 4).wait(3000).client.isBusy());
}

TEST_CASE("the 15 s of PX4's takeoff begin with its acceptance, and an order's time when its autopilot is heard") {
  Aircraft px4(kPx4);
  px4.takesOff = px4.hasPosition = false;
  px4.stand(kPx4Position).takeOff().wait(6000).hasPosition = true;
  px4.until(22).said();
  CHECK(px4.wait(13500).client.isBusy());
  CHECK(px4.times(kDisarm) == 0);
  Aircraft waiting(kPx4);
  waiting.mode = kPx4Position;
  waiting.beatsBySecond = false;
  waiting.takeOff().wait(7500).beatsBySecond = true;
  CHECK(waiting.status(10000) == "Done");
  // One that could not be begun for 10 s is not carried out when the autopilot is heard again.
  for (bool isInAir : {false, true}) {
    Aircraft copter(kArduPilot);
    isInAir ? copter.inMission().silence().wait(6000).landNow() : copter.stand().silence().wait(6000).takeOff();
    CHECK(copter.status(20000) == "NoAutopilot");
    CHECK(copter.tookMs <= 10010);
    CHECK(copter.silence(false).wait(5000).said() == "");
  }
}

TEST_CASE("a takeover is remembered after the landing, until the sketch asks for the aircraft again") {
  enum Who { Pilot, Failsafe, PilotDuringAnOrder };
  for (Who who : {Pilot, Failsafe, PilotDuringAnOrder}) {
    CAPTURE(int{who});
    const Status taken = who == Failsafe ? Status::FailsafeHasIt : Status::PilotHasIt;
    Aircraft copter(kArduPilot);
    copter.stand(kGuided).takeOff().done();
    CHECK((copter.client.takenBy() == Status::Idle));
    copter.pass(1500);
    if (who == PilotDuringAnOrder) copter.answering(192).goTo().until(192);
    copter.show(who == Failsafe ? kRtl : kLoiter);
    CHECK((copter.wait(3000).client.takenBy() == taken));
    copter.isArmed = false;  // it has landed
    copter.state = kStandby;
    copter.wait(2000).mode = kGuided;
    copter.wait(60000).said();
    CHECK((copter.takeOff().end() == taken));
    copter.client.arm();
    CHECK((copter.end() == taken));
    CHECK(copter.said() == "");
    CHECK((copter.client.takenBy() == taken));
    copter.steering.requestControl();
    CHECK((copter.client.takenBy() == Status::Idle));
    CHECK((copter.takeOff().end() == Status::Done));
  }
}

TEST_CASE("on PX4 a pilot's RETURN or HOLD is a takeover from the sketch's own mode, and may be the end of a plan") {
  for (const bool isOwn : {true, false}) {
    Aircraft px4(kPx4);
    px4.inMission();
    if (isOwn) px4.landNow().done();
    px4.show(isOwn ? kPx4Hold : kPx4Rtl);
    CHECK((px4.wait(3000).client.takenBy() == (isOwn ? Status::PilotHasIt : Status::Idle)));
    CHECK_FALSE(px4.steering.maySteer());
  }
}

TEST_CASE("the mode that the sketch has set is forgotten at the disarming, and after 20 s without a heartbeat") {
  const struct {
    uint32_t silentMs;  // 0: it is disarmed instead
    bool hasPosition;
  } kCases[] = {{15000, false}, {21000, false}, {0, true}, {21000, true}};
  for (const auto& one : kCases) {
    CAPTURE(one.silentMs);
    Aircraft copter(kArduPilot);
    CHECK(copter.inMission().goTo().done().steering.maySteer());
    copter.hasPosition = one.hasPosition;
    copter.isArmed = one.silentMs != 0;
    if (one.silentMs != 0) copter.silence();
    copter.wait(one.silentMs != 0 ? one.silentMs : 2000).silence(false).isArmed = true;
    CHECK(copter.wait(2000).steering.maySteer() == (one.silentMs == 15000));
    copter.steering.requestControl();
    CHECK(copter.steering.maySteer());
    CHECK(copter.landNow().status() == "Done");  // at once
    CHECK(copter.wait(1001).steering.maySteer());
  }
}

TEST_CASE("a position alone is no answer to whether PX4 flies; it may take 7.5 s to tell it, and is not asked again") {
  Aircraft px4(kPx4);
  px4.inMission().hasLanded = false;
  px4.landNow().until(512).wait(40).tellPosition();
  CHECK((px4.wait(100).steering.step() == SteerStep::AskLanded));
  Aircraft other(kPx4);
  other.inMission().hasPosition = false;
  CHECK(other.goTo().status() == "NoHome");
  CHECK(other.times("L511") == 1);
}

TEST_CASE("on a lossy link, PX4 that accepts the question and never tells is asked for 20 s") {
  Aircraft px4(kPx4);
  px4.inMission();
  for (int i = 0; i < 100; ++i) {
    px4.lose(3);
    px4.tellPosition();
    px4.pass(20);
  }
  px4.hasLanded = false;
  const uint32_t beganMs = px4.landNow().nowMs();
  for (int i = 0; i < 300 && px4.client.isBusy(); ++i) {
    px4.lose(3);
    px4.pass(100);
  }
  CHECK((px4.ended == Status::NoAnswer));
  CHECK(px4.nowMs() - beganMs >= 19000);
  CHECK(px4.nowMs() - beganMs <= 20200);
}
