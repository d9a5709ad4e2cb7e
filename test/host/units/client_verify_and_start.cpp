// verifyAndStart() by a whole client: a start between two looks at each item.
#include <doctest/doctest.h>

#include "ObedientVehicle.h"

using namespace mavmission;
using namespace obedient;

namespace {

constexpr uint32_t kLoiter = 5;

struct Sketch : Flown {
  std::vector<Status> told;

  explicit Sketch(uint8_t autopilot = kArduPilot) : Flown(autopilot) {
    client.onEnd(note, this);
    sent.clear();
  }
  static void note(void* context, Status status) { static_cast<Sketch*>(context)->told.push_back(status); }
  size_t looks() const { return timesOf(kRequestList, 0).size(); }
  // Until items are asked for. They do not come before isMute is false again.
  Sketch& flyIntoFirstLook() {
    client.verifyAndStart(inRam(kFlownPlan));
    for (int i = 0; i < 6000 && looks() == 0; ++i) fly(1);
    isMute = true;
    fly(5);
    REQUIRE(client.isBusy());
    REQUIRE_FALSE(timesOf(kRequestInt, 0).empty());
    return *this;
  }
  // Until the second look has begun, with the aircraft in flight.
  Sketch& flyIntoSecondLook(uint16_t item = 0) {
    if (!client.isBusy()) client.verifyAndStart(inRam(kFlownPlan), item);
    for (int i = 0; i < 6000 && looks() < 2; ++i) fly(5);
    REQUIRE(looks() == 2);
    REQUIRE(baseMode == kArmed);
    return *this;
  }
  // The same as flies(), and onEnd() must have been told that end alone.
  std::string ends(uint32_t ms) {
    const std::string text = flies(ms);
    CHECK(told == std::vector<Status>{ended});
    return text + ", " + nameOf(client.aboard());
  }
};

}  // namespace

TEST_CASE("an ArduPilot's plan is looked at, started, and looked at once more") {
  for (const uint16_t item : {0, 2}) {
    Sketch sketch;
    sketch.flown = item == 0 ? 1 : 3;
    CHECK((sketch.client.verifyAndStart(inRam(kFlownPlan), item) == Status::WaitingForAutopilot));
    CHECK((sketch.client.verifyAndStart(inRam(kFlownPlan), item) == Status::Busy));
    sketch.flyIntoSecondLook();
    CHECK(sketch.ordered == (item == 0 ? "mode, item 0, arm, begin 0" : "mode, item 3, arm, begin 0"));
    CHECK(sketch.client.isBusy());
    CHECK(sketch.client.itemsTotal() == 4);
    CHECK(sketch.told.empty());
    CHECK(sketch.ClientOnLine::ends.empty());
    CHECK(sketch.ends(3000) == "-> Done, OurPlan");
    CHECK(sketch.ClientOnLine::ends == std::vector<Status>{Status::Done});
    CHECK((sketch.client.startArming() == StartArming::Armed));
    CHECK(sketch.client.itemsDone() == 4);
    CHECK(sketch.looks() == 2);
    CHECK(sketch.baseMode == kArmed);
    CHECK(sketch.mode == kAuto);
    // What comes next is told as ever.
    sketch.client.disarm();
    CHECK(sketch.flies(1000) == "disarm -> Done");
    CHECK(sketch.told.size() == 2);
  }
}

TEST_CASE("a plan that is not ours is not started") {
  Sketch sketch;
  sketch.held[2] = returnToLaunch();
  sketch.client.verifyAndStart(inRam(kFlownPlan));
  CHECK(sketch.ends(3000) == "-> Differs at 1, NotKnown");
}

TEST_CASE("what was said of an earlier start is forgotten when the next one looks") {
  Sketch sketch;
  sketch.upload();
  sketch.refusedOn = MAV_CMD_MISSION_START;
  sketch.client.start();
  sketch.fly(15000);
  REQUIRE((sketch.client.startStep() == StartStep::Begin));
  REQUIRE((sketch.client.startArming() == StartArming::Disarmed));
  sketch.client.verifyAndStart(inRam(kFlownPlan));
  CHECK((sketch.client.startStep() == StartStep::None));
  CHECK((sketch.client.startArming() == StartArming::Untouched));
  sketch.client.cancel();
  CHECK((sketch.told.back() == Status::Cancelled));
  sketch.client.start();
  CHECK((sketch.client.startStep() == StartStep::None));
}

TEST_CASE("another plan that the second look finds is left: the aircraft is disarmed, and what is aboard is known") {
  for (const bool isRefused : {false, true}) {
    Sketch sketch;
    sketch.flyIntoSecondLook().held[3] = returnToLaunch();
    if (isRefused) sketch.refusedOn = MAV_CMD_COMPONENT_ARM_DISARM;
    CHECK(sketch.ends(20000) == (isRefused ? "disarm -> FliesOtherPlan, OtherPlan" : "disarm -> Unproven, OtherPlan"));
    CHECK(sketch.baseMode == (isRefused ? kArmed : kDisarmed));
    CHECK((sketch.client.startArming() == (isRefused ? StartArming::Armed : StartArming::Disarmed)));
  }
}

TEST_CASE("a plan that cannot be read a second time is flown on, and may be another one") {
  Sketch sketch;
  sketch.flyIntoSecondLook().isMute = true;
  CHECK(sketch.ends(12000) == "-> FliesOtherPlan, OurPlan");
  CHECK(sketch.baseMode == kArmed);
  CHECK(sketch.mode == kAuto);
}

TEST_CASE("who disarms the aircraft, or sets another mode, during the second look has it, whatever that finds") {
  for (const bool disarms : {true, false}) {
    Sketch sketch;
    sketch.flyIntoSecondLook();
    if (disarms) sketch.baseMode = kDisarmed;
    if (!disarms) sketch.mode = kLoiter;
    sketch.beat();
    CHECK(sketch.ends(3000) == (disarms ? "-> NotArmed, OurPlan" : "-> TakenOver, OurPlan"));
  }
  Sketch sketch;
  sketch.flyIntoSecondLook().held[3] = returnToLaunch();
  sketch.baseMode = kDisarmed;
  sketch.beat();
  CHECK(sketch.ends(3000) == "-> NotArmed at 2, OtherPlan");
}

TEST_CASE("a second look without a heartbeat since loop() stood still does not tell that it flies") {
  Sketch sketch;
  sketch.flyIntoSecondLook();
  sketch.tellCount();
  sketch.run(2000, 2000);
  for (int i = 0; i < 100 && sketch.told.empty(); ++i) {
    const size_t before = sketch.sent.size();
    sketch.run(5);
    for (size_t sent = before; sent < sketch.sent.size(); ++sent) {
      if (sketch.sent[sent].messageId == ClientOnLine::kRequestInt) sketch.give(sketch.sent[sent].payload[0]);
    }
  }
  CHECK(sketch.told == std::vector<Status>{Status::Unconfirmed});
}

TEST_CASE("a mode that somebody sets during the first look stays") {
  enum class Case { Heard, NotHeardBefore, SetTwice };
  for (const Case which : {Case::Heard, Case::NotHeardBefore, Case::SetTwice}) {
    Sketch sketch;
    if (which == Case::NotHeardBefore) {
      sketch.run(7000);
      REQUIRE_FALSE(sketch.client.hasAutopilot());
    }
    sketch.flyIntoFirstLook();
    sketch.mode = kLoiter;
    sketch.beat();
    if (which == Case::SetTwice) {
      sketch.give(0);
      sketch.fly(5);
      sketch.mode = kStabilize;  // as before
      sketch.beat();
    }
    sketch.isMute = false;
    const uint32_t mode = sketch.mode;
    CHECK(sketch.ends(4000) == "-> TakenOver, OurPlan");
    CHECK(sketch.mode == mode);
  }
}

TEST_CASE("a mode that somebody sets before the first look has begun stays") {
  Sketch sketch;
  sketch.upload();  // a copy of its last frame may still come, and is waited for
  sketch.client.setTargetIds(2, 1);
  sketch.client.setTargetIds(1, 1);  // what is known of it is forgotten
  sketch.client.verifyAndStart(inRam(kFlownPlan));
  sketch.beat();
  sketch.run(20);
  sketch.mode = kLoiter;
  sketch.beat();
  sketch.run(20);
  REQUIRE(sketch.looks() == 0);
  CHECK(sketch.flies(4000) == "-> TakenOver");
}

TEST_CASE("who disarms an armed aircraft before its start can begin keeps it disarmed") {
  enum class Armed { Before, WhileItReads, BeforeAStart };
  for (const Armed armed : {Armed::Before, Armed::WhileItReads, Armed::BeforeAStart}) {
    Sketch sketch;
    if (armed == Armed::BeforeAStart) sketch.upload();
    sketch.baseMode = armed == Armed::WhileItReads ? kDisarmed : kArmed;
    sketch.fly(1100);
    if (armed == Armed::BeforeAStart) {
      sketch.run(0, 1500);  // loop() stands still: the last heartbeat is too old to begin with
      sketch.client.start();
    } else {
      sketch.flyIntoFirstLook();
    }
    REQUIRE(sketch.client.isBusy());
    sketch.baseMode = kArmed;
    if (armed == Armed::WhileItReads) {
      sketch.beat();
      sketch.give(0);
      sketch.fly(15);
    }
    sketch.isMute = false;
    sketch.baseMode = kDisarmed;
    sketch.beat();
    CHECK(sketch.flies(4000) == "-> NotArmed");
    CHECK(sketch.baseMode == kDisarmed);
  }
}

TEST_CASE("an autopilot that was not heard before is waited for, and started in the mode that it has then") {
  Sketch sketch;
  sketch.run(7000);
  REQUIRE_FALSE(sketch.client.hasAutopilot());
  sketch.mode = kLoiter;
  sketch.client.verifyAndStart(inRam(kFlownPlan));
  CHECK(sketch.ends(20000) == "mode, item 0, arm, begin 0 -> Done, OurPlan");
}

TEST_CASE("an aircraft that flew its mission before is not disarmed when the second look finds another plan") {
  Sketch sketch;
  sketch.client.allowWhileArmed(true);
  sketch.baseMode = kArmed;
  sketch.mode = kAuto;
  sketch.fly(1100);
  sketch.flyIntoSecondLook();
  sketch.held[3] = returnToLaunch();
  CHECK(sketch.ends(5000) == "-> Unproven, OtherPlan");
  CHECK((sketch.client.startArming() == StartArming::Untouched));
  CHECK((sketch.client.startStep() == StartStep::Confirm));
  CHECK(sketch.baseMode == kArmed);
}

TEST_CASE("cancel() ends it in each look, and in the start between") {
  for (const size_t look : {1, 2}) {
    Sketch sketch;
    sketch.client.verifyAndStart(inRam(kFlownPlan));
    for (int i = 0; i < 6000 && sketch.looks() < look; ++i) sketch.fly(5);
    sketch.client.cancel();
    CHECK(sketch.ordered == (look == 1 ? "" : "mode, item 0, arm, begin 0"));
    CHECK(sketch.flies(2000) == "-> Cancelled");
    CHECK(sketch.told == std::vector<Status>{Status::Cancelled});
    CHECK(sketch.looks() == look);
  }
}

TEST_CASE("a PX4 that names its plan is looked at once, and one that does not is looked at twice") {
  for (const uint32_t name : {0u, 0x12345678u}) {
    Sketch sketch(ClientOnLine::kPx4);
    sketch.held[0].x = sketch.held[2].x;  // PX4 takes off from a place
    sketch.held[0].y = sketch.held[2].y;
    sketch.name = name;
    sketch.client.verifyAndStart(inRam(kFlownPlan), 2);
    CHECK(sketch.flies(500).find("begin 2") != std::string::npos);
    mavlink_mission_current_t message = mavlink_mission_current_t();
    message.seq = 2;
    message.total = 4;
    message.mission_state = MISSION_STATE_ACTIVE;
    message.mission_id = name;
    for (int second = 0; second < 6 && sketch.client.isBusy(); ++second) {
      sketch.tell(MAVLINK_MSG_ID_MISSION_CURRENT, MAVLINK_MSG_ID_MISSION_CURRENT_CRC, message);
      sketch.fly(1000);
    }
    CHECK(sketch.told == std::vector<Status>{Status::Done});
    CHECK(sketch.looks() == (name == 0 ? 2 : 1));
  }
}
