// start() and startMission() by a whole client: what is refused before anything leaves, and what each step says.
#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

#include "ObedientVehicle.h"

using namespace mavmission;
using namespace obedient;

TEST_CASE(
    "a start is refused before anything leaves: without our plan, while it is armed, for an item that is not there") {
  Flown flight;
  flight.client.start();
  CHECK((flight.refusal() == Status::Unproven));
  flight.upload();
  flight.client.start(4);
  CHECK((flight.refusal() == Status::NoSuchItem));
  flight.client.start(65535);
  CHECK((flight.refusal() == Status::NoSuchItem));
  flight.baseMode = kArmed;
  flight.fly(1100);
  flight.client.start();
  CHECK((flight.refusal() == Status::Armed));
  flight.client.allowWhileArmed(true);
  flight.client.start();
  CHECK((flight.client.start(2) == Status::Busy));
  flight.fly(5000);
  CHECK((flight.ended == Status::Done));
  CHECK(flight.firstItem == 0);
}

TEST_CASE("a vehicle whose modes are not known is not started") {
  Flown flight(ClientOnLine::kArduPilot, MAV_TYPE_ROCKET);
  flight.upload();
  flight.client.start();
  CHECK((flight.refusal() == Status::NoSuchMode));
  flight.baseMode = kArmed;
  flight.fly(1100);
  flight.client.startMission();
  CHECK((flight.refusal() == Status::NoSuchMode));
}

TEST_CASE("a copter that does not answer which vehicle it is gets no order of a start()") {
  Flown flight;
  flight.upload();
  flight.saysVehicle = false;
  flight.client.start();
  flight.fly(9000);
  CHECK((flight.ended == Status::NoAnswer));
  CHECK(flight.orders.empty());
}

TEST_CASE("ArduPilot is given its own number of the item where the start begins, and 0 for the first one") {
  for (uint16_t item : {0, 1, 2, 3}) {
    Flown flight;
    flight.upload();
    flight.client.start(item);
    flight.fly(2000);
    CHECK(flight.firstItem == (item == 0 ? 0 : item + 1));
  }
}

TEST_CASE("a copter is started step by step, and flies to the first item that can be flown to, or to another one") {
  for (uint16_t flown : {1, 3, 4}) {
    Flown flight;
    flight.upload();
    flight.flown = flown;
    flight.client.start();
    CHECK((flight.client.startArming() == StartArming::Untouched));
    flight.fly(15000);
    CHECK(flight.orders ==
          std::vector<uint16_t>{MAV_CMD_DO_SET_MODE, MAV_CMD_COMPONENT_ARM_DISARM, MAV_CMD_MISSION_START});
    CHECK(flight.parameters.back() == 0);
    CHECK(flight.mode == kAuto);
    CHECK((flight.client.startArming() == StartArming::Armed));
    CHECK((flight.ended == (flown == 1 ? Status::Done : Status::OtherItem)));
    CHECK(flight.client.failedItem() == (flown == 1 ? 0xFFFF : flown - 1));
  }
}

TEST_CASE("a start from a command begins with the next item that can be flown to") {
  Flown flight;
  flight.upload();
  flight.flown = 3;
  flight.client.start(1);
  flight.fly(15000);
  CHECK((flight.ended == Status::Done));
}

TEST_CASE("a step that is refused is the status, and what has been armed is disarmed") {
  const struct {
    uint16_t command;
    StartStep step;
    StartArming arming;
  } kRefusals[] = {{MAV_CMD_COMPONENT_ARM_DISARM, StartStep::Arm, StartArming::Untouched},
                   {MAV_CMD_DO_SET_MODE, StartStep::ReadyMode, StartArming::Untouched},
                   {MAV_CMD_MISSION_START, StartStep::Begin, StartArming::Disarmed}};
  for (const auto& one : kRefusals) {
    Flown flight;
    flight.upload();
    flight.refusedOn = one.command;
    flight.client.start();
    flight.fly(15000);
    CHECK((flight.ended == Status::CommandFailed));
    CHECK((flight.client.startStep() == one.step));
    CHECK((flight.client.startArming() == one.arming));
    CHECK(flight.baseMode == kDisarmed);
  }
}

TEST_CASE("a step without an answer is told as such") {
  Flown flight;
  flight.upload();
  flight.silentOn = MAV_CMD_COMPONENT_ARM_DISARM;
  flight.client.start();
  flight.fly(20000);
  CHECK((flight.ended == Status::NoAnswer));
  CHECK((flight.client.startStep() == StartStep::Arm));
}

TEST_CASE("another plan that is named meanwhile is the end, and it is known that it is aboard") {
  Flown flight;
  flight.upload();
  flight.silentOn = MAV_CMD_COMPONENT_ARM_DISARM;
  flight.client.start();
  flight.fly(3000);
  for (int i = 0; i < 3; ++i) {
    flight.tellCurrent(1, MISSION_STATE_NOT_STARTED, 9);
    flight.fly(1000);
  }
  CHECK((flight.ended == Status::Unproven));
  CHECK((flight.client.aboard() == Aboard::OtherPlan));
}

TEST_CASE("PX4 is started with the item as the command's parameter") {
  for (uint16_t item : {0, 2}) {
    Flown flight(ClientOnLine::kPx4);
    flight.upload();
    flight.client.start(item);
    flight.fly(4000);
    REQUIRE(!flight.orders.empty());
    CHECK(flight.orders.back() == MAV_CMD_MISSION_START);
    CHECK(flight.parameters.back() == item);
  }
}

TEST_CASE("startMission() is for an armed aircraft") {
  for (uint8_t autopilot : {ClientOnLine::kArduPilot, ClientOnLine::kPx4}) {
    Flown flight(autopilot);
    flight.client.startMission();
    CHECK((flight.refusal() == Status::NotArmed));
  }
}

TEST_CASE("startMission() of an ArduPilot in AUTO waits for the answer to its command") {
  Flown flight;
  flight.baseMode = kArmed;
  flight.mode = kAuto;
  flight.fly(1100);
  flight.silentOn = MAV_CMD_MISSION_START;
  flight.client.startMission();
  flight.fly(1200);
  CHECK(flight.orders == std::vector<uint16_t>{MAV_CMD_MISSION_START});
  CHECK(flight.client.isBusy());
  flight.answer(MAV_CMD_MISSION_START, 0);
  flight.fly(1100);
  CHECK((flight.ended == Status::Done));
}

TEST_CASE("startMission() of a PX4 sets its mode, and sends nothing that arms") {
  Flown flight(ClientOnLine::kPx4);
  flight.baseMode = kArmed;
  flight.fly(1100);
  flight.client.startMission();
  flight.fly(2200);
  CHECK((flight.ended == Status::Done));
  CHECK(flight.orders == std::vector<uint16_t>{MAV_CMD_DO_SET_MODE});
  CHECK(flight.mode == kPx4Mission);
}

TEST_CASE("a mission is under way when the autopilot says so, or does not say") {
  for (const uint8_t state : {MISSION_STATE_UNKNOWN, MISSION_STATE_ACTIVE, MISSION_STATE_NOT_STARTED,
                              MISSION_STATE_PAUSED, MISSION_STATE_COMPLETE}) {
    Flown flight;
    flight.upload();
    flight.state = state;
    flight.client.start();
    flight.fly(20000);
    const bool isUnderWay = state == MISSION_STATE_UNKNOWN || state == MISSION_STATE_ACTIVE;
    CHECK((flight.ended == Status::Done) == isUnderWay);
  }
}

TEST_CASE("a step behind arming that nobody answers is told, and the aircraft is disarmed") {
  Flown flight;
  flight.upload();
  flight.silentOn = MAV_CMD_MISSION_START;
  flight.client.start();
  flight.fly(30000);
  CHECK((flight.ended == Status::NoAnswer));
  CHECK((flight.client.startStep() == StartStep::Begin));
  CHECK((flight.client.startArming() == StartArming::Disarmed));
  CHECK(flight.baseMode == kDisarmed);
}

TEST_CASE("the items are looked at one in an update(), and the first message leaves then") {
  Flown flight;
  flight.upload();
  flight.run(10);
  flight.client.setCustomMode(kStabilize);
  flight.fly(1100);
  flight.run(10);
  flight.saysVehicle = true;
  flight.sent.clear();
  flight.client.start();
  CHECK((flight.client.status() == Status::WaitingForAutopilot));
  flight.run(20);
  CHECK(flight.sent.size() == 1);
}

TEST_CASE("while our own frame waits for room the look at the plan waits, and harms nothing") {
  Flown flight(ClientOnLine::kPx4);
  flight.upload();
  flight.line.room = 0;
  flight.fly(1200);
  flight.client.start();
  flight.run(20);
  flight.line.room = flight.line.kAlwaysRoom;
  flight.run(2);
  REQUIRE(!flight.sent.empty());
  CHECK(flight.sent[0].messageId == 0);
  CHECK(flight.sent[0].payload[4] == MAV_TYPE_ONBOARD_CONTROLLER);
  CHECK(flight.sent[0].payload[5] == MAV_AUTOPILOT_INVALID);
  for (size_t at = 0; at < 4; ++at) CHECK(flight.sent[0].payload[at] == 0);
}

namespace {

// What the plan's source gives at the start.
enum class Gives { Plan, Nothing, BadItem };
Gives gives = Gives::Plan;

bool read(void*, uint16_t index, MissionItem& item) {
  item = kFlownPlan[index];
  if (gives == Gives::BadItem) item.param1 = NAN;
  return gives != Gives::Nothing;
}

// PX4 gives a takeoff the place of the next item that has one: the library looks for it in several steps.
bool readFarPlace(void*, uint16_t index, MissionItem& item) {
  item = index == 1 ? takeoff(20_m) : index == 13 ? kFlownPlan[2] : changeSpeed(5_mps);
  return true;
}

void accept(Flown& flight, const ItemSource& plan) {
  flight.client.uploadWithoutReadback(plan);
  flight.fly(200);
  const uint16_t items = static_cast<uint16_t>(plan.count + (flight.isPx4 ? 0 : 1));
  for (uint16_t item = 0; item < items; ++item) {
    flight.hear(requestParts(item));
    flight.fly(30);
  }
  flight.hear(ackParts(0));
  flight.fly(10);
  REQUIRE((flight.client.aboard() == Aboard::OurPlan));
}

}  // namespace

TEST_CASE("a plan whose source does not give it any more is not confirmed to be flown from the right item on") {
  for (const Gives what : {Gives::Plan, Gives::Nothing, Gives::BadItem}) {
    gives = Gives::Plan;
    Flown flight;
    accept(flight, fromFunction(read, 4));
    gives = what;
    flight.client.start();
    flight.fly(15000);
    // Nobody knows which item is the first that is flown to.
    CHECK((flight.ended == (what == Gives::Plan ? Status::Done : Status::OtherItem)));
  }
}

TEST_CASE("a start looks at an item whose place has to be searched as well") {
  Flown flight(ClientOnLine::kPx4);
  accept(flight, fromFunction(readFarPlace, 14));
  flight.client.start();
  flight.fly(1000);
  REQUIRE(!flight.orders.empty());
  CHECK(flight.orders.back() == MAV_CMD_MISSION_START);
  for (int second = 0; second < 9 && flight.client.isBusy(); ++second) {
    flight.tellCurrent(1, MISSION_STATE_ACTIVE, 14);
    flight.fly(1000);
  }
  CHECK((flight.ended == Status::Done));
}

TEST_CASE("behind an operation with a fence a start counts the items of the mission") {
  const MissionItem fence[] = {fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m)};
  for (const bool clears : {true, false}) {
    Flown flight;
    flight.upload();
    if (clears) {
      flight.client.clear(PlanType::Fence);
    } else {
      flight.client.verify(inRam(fence), PlanType::Fence);
    }
    flight.isMute = true;
    flight.fly(100);
    flight.client.cancel();
    flight.fly(3000);
    flight.client.start(2);
    flight.fly(3000);
    CHECK(flight.firstItem == 3);
  }
}

TEST_CASE("what was said of a start is forgotten when the next one begins, and what is refused is refused anywhere") {
  Flown flight;
  flight.upload();
  flight.refusedOn = MAV_CMD_COMPONENT_ARM_DISARM;
  flight.client.start();
  flight.fly(9000);
  REQUIRE((flight.client.startStep() == StartStep::Arm));
  flight.client.start();
  CHECK((flight.client.startStep() == StartStep::None));
  flight.client.cancel();
  Flown px4(ClientOnLine::kPx4);
  px4.client.start();
  CHECK((px4.refusal() == Status::Unproven));
}

TEST_CASE("startMission() of a copter asks which vehicle it is, and a disarmed one is not asked") {
  for (const bool isArmed : {false, true}) {
    Flown flight;
    flight.saysVehicle = false;
    if (isArmed) flight.baseMode = kArmed;
    flight.fly(1100);
    flight.sent.clear();
    flight.client.startMission();
    flight.fly(50);
    size_t asked = 0;
    for (const SentFrame& frame : flight.sent) {
      if (frame.messageId == kCommand && Flown::commandOf(frame) == MAV_CMD_DO_VTOL_TRANSITION) ++asked;
    }
    CHECK(asked == (isArmed ? 1 : 0));
    CHECK(flight.client.isBusy() == isArmed);
  }
}

TEST_CASE("a rover that refuses AUTO is asked again 1 s later, also where the order had been repeated") {
  Flown flight(ClientOnLine::kArduPilot, MAV_TYPE_GROUND_ROVER);
  flight.upload();
  flight.client.start();
  for (int i = 0; i < 4000 && flight.baseMode != kArmed; ++i) flight.fly(5);
  REQUIRE(flight.baseMode == kArmed);
  flight.sent.clear();
  flight.silentOn = MAV_CMD_DO_SET_MODE;
  const auto orders = [&] {
    std::vector<uint32_t> times;
    for (const SentFrame& frame : flight.sent) {
      const bool isOrder = frame.messageId == kCommand && Flown::commandOf(frame) == MAV_CMD_DO_SET_MODE;
      if (isOrder) times.push_back(frame.atMs);
    }
    return times;
  };
  for (int i = 0; i < 1000 && orders().empty(); ++i) flight.fly(5);
  flight.silentOn = 0;
  flight.refusedOn = MAV_CMD_DO_SET_MODE;
  flight.fly(5000);
  REQUIRE(orders().size() >= 3);
  CHECK(orders()[1] - orders()[0] >= 1500);
  CHECK(orders()[2] - orders()[1] >= 1000);
  CHECK(orders()[2] - orders()[1] <= 1200);
  CHECK(flight.client.isBusy());
}
