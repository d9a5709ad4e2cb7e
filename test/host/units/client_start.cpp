// start() and startMission() by a whole client: what is refused before anything leaves, and what each step says.
#include <doctest/doctest.h>

#include <cmath>

#include "ObedientVehicle.h"

using namespace mavmission;
using namespace obedient;

namespace {

constexpr uint8_t kArduPilot = ClientOnLine::kArduPilot, kPx4 = ClientOnLine::kPx4;
const MissionItem kFence[] = {fenceInsideCircle(-35.36_deg, 149.16_deg, 100_m)};

// A vehicle that has the plan, which is known.
struct Loaded : Flown {
  explicit Loaded(uint8_t autopilot = kArduPilot, uint8_t is = MAV_TYPE_QUADROTOR) : Flown(autopilot, is) { upload(); }
  std::string starts(uint32_t ms, uint16_t item = 0) {
    client.start(item);
    return flies(ms);
  }
};

std::string startsMission(Flown& flight, uint32_t ms = 1200) {
  flight.client.startMission();
  return flight.flies(ms);
}

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

TEST_CASE(
    "a start is refused before anything leaves: without our plan, while it is armed, for an item that is not there") {
  for (const uint8_t autopilot : {kArduPilot, kPx4}) {
    Flown unknown(autopilot);
    unknown.client.start();
    CHECK(unknown.flies(1200) == "-> Unproven");
  }
  Loaded flight;
  CHECK(flight.starts(1200, 4) == "-> NoSuchItem at 4");
  CHECK(flight.starts(1200, 65535) == "-> NoSuchItem");
  flight.baseMode = kArmed;
  flight.fly(1100);
  CHECK(flight.starts(1200) == "-> Armed");
  flight.client.allowWhileArmed(true);
  flight.client.start();
  CHECK((flight.client.start(2) == Status::Busy));
  CHECK(flight.flies(5000) == "item 0, begin 0 -> Done");
}

TEST_CASE("a vehicle whose modes are not known is not started, nor one that does not answer which vehicle it is") {
  Loaded rocket(kArduPilot, MAV_TYPE_ROCKET), silent;
  CHECK(rocket.starts(1200) == "-> NoSuchMode");
  rocket.baseMode = kArmed;
  rocket.fly(1100);
  CHECK(startsMission(rocket) == "-> NoSuchMode");
  silent.saysVehicle = false;
  CHECK(silent.starts(9000) == "-> NoAnswer");
}

TEST_CASE("ArduPilot is given its own number of the item where the start begins, and 0 for the first one") {
  for (const uint16_t item : {0, 1, 2, 3}) {
    CHECK(Loaded().starts(2000, item) ==
          "mode, item " + std::to_string(item == 0 ? 0 : item + 1) +
              (item == 0 ? ", arm, begin 0 -> Done" : ", arm, begin 0 -> OtherItem at 0"));
  }
  // Behind an operation with a fence the items of the mission are counted.
  for (const bool clears : {true, false}) {
    Loaded flight;
    if (clears) flight.client.clear(PlanType::Fence);
    if (!clears) flight.client.verify(inRam(kFence), PlanType::Fence);
    flight.isMute = true;
    flight.fly(100);
    flight.client.cancel();
    flight.fly(3000);
    CHECK(flight.starts(3000, 2).compare(0, 12, "mode, item 3") == 0);
  }
}

TEST_CASE("a copter is started step by step, and flies to the first item that can be flown to, or to another one") {
  for (const uint16_t flown : {1, 3, 4}) {
    Loaded flight;
    flight.flown = flown;
    flight.client.start();
    CHECK((flight.client.startArming() == StartArming::Untouched));
    CHECK(flight.flies(15000) == "mode, item 0, arm, begin 0 -> " + std::string(flown == 1   ? "Done"
                                                                                : flown == 3 ? "OtherItem at 2"
                                                                                             : "OtherItem at 3"));
    CHECK(flight.mode == kAuto);
    CHECK((flight.client.startArming() == StartArming::Armed));
  }
  Loaded flight;  // from a command: with the next item that can be flown to
  flight.flown = 3;
  CHECK(flight.starts(15000, 1) == "mode, item 2, arm, begin 0 -> Done");
}

TEST_CASE("a step that is refused, or not answered, is the status, and what has been armed is disarmed") {
  const struct {
    uint16_t command;
    bool isRefused;
    const char* end;
    StartStep step;
    StartArming arming;
  } kEnds[] = {{MAV_CMD_DO_SET_MODE, true, "mode -> CommandFailed", StartStep::ReadyMode, StartArming::Untouched},
               {MAV_CMD_COMPONENT_ARM_DISARM, true, "mode, item 0, arm -> CommandFailed", StartStep::Arm,
                StartArming::Untouched},
               {MAV_CMD_MISSION_START, true, "mode, item 0, arm, begin 0, disarm -> CommandFailed", StartStep::Begin,
                StartArming::Disarmed},
               {MAV_CMD_COMPONENT_ARM_DISARM, false, "mode, item 0, arm, arm, arm, arm, arm -> NoAnswer",
                StartStep::Arm, StartArming::Untouched},
               {MAV_CMD_MISSION_START, false,
                "mode, item 0, arm, begin 0, begin 0, begin 0, begin 0, begin 0, disarm -> NoAnswer", StartStep::Begin,
                StartArming::Disarmed}};
  for (const auto& one : kEnds) {
    Loaded flight;
    (one.isRefused ? flight.refusedOn : flight.silentOn) = one.command;
    CHECK(flight.starts(30000) == one.end);
    CHECK((flight.client.startStep() == one.step));
    CHECK((flight.client.startArming() == one.arming));
    CHECK(flight.baseMode == kDisarmed);
    // It is forgotten when the next one begins.
    flight.client.start();
    CHECK((flight.client.startStep() == StartStep::None));
  }
}

TEST_CASE("another plan that is named meanwhile is the end, and it is known that it is aboard, and whether it flies") {
  for (const bool isArmed : {false, true}) {
    Loaded flight;
    flight.silentOn = isArmed ? MAV_CMD_MISSION_START : MAV_CMD_COMPONENT_ARM_DISARM;
    flight.starts(3000);
    flight.refusedOn = MAV_CMD_COMPONENT_ARM_DISARM;
    for (int i = 0; i < 20 && flight.client.isBusy(); ++i) {
      flight.tellCurrent(1, MISSION_STATE_NOT_STARTED, 9);
      flight.fly(1000);
    }
    CHECK((flight.ended == (isArmed ? Status::FliesOtherPlan : Status::Unproven)));
    CHECK((flight.client.aboard() == Aboard::OtherPlan));
  }
}

TEST_CASE("PX4 is started with the item as the command's parameter") {
  CHECK(Loaded(kPx4).starts(4000).find("begin 0") != std::string::npos);
  CHECK(Loaded(kPx4).starts(4000, 2).find("begin 2") != std::string::npos);
}

TEST_CASE("startMission() is for an armed aircraft, and sends nothing that arms") {
  for (const uint8_t autopilot : {kArduPilot, kPx4}) {
    Flown flight(autopilot);
    CHECK(startsMission(flight) == "-> NotArmed");
  }
  Flown px4(kPx4);
  px4.baseMode = kArmed;
  px4.fly(1100);
  CHECK(startsMission(px4, 2200) == "mode -> Done");
  CHECK(px4.mode == kPx4Mission);
}

TEST_CASE("startMission() of an ArduPilot in AUTO waits for the answer to its command") {
  Flown flight;
  flight.baseMode = kArmed;
  flight.mode = kAuto;
  flight.fly(1100);
  flight.silentOn = MAV_CMD_MISSION_START;
  CHECK(startsMission(flight) == "begin 0");
  CHECK(flight.client.isBusy());
  flight.answer(MAV_CMD_MISSION_START, 0);
  CHECK(flight.flies(1100) == "-> Done");
}

TEST_CASE("a mission is under way when the autopilot says so, or does not say") {
  for (const uint8_t state : {MISSION_STATE_UNKNOWN, MISSION_STATE_ACTIVE, MISSION_STATE_NOT_STARTED,
                              MISSION_STATE_PAUSED, MISSION_STATE_COMPLETE}) {
    Loaded flight;
    flight.state = state;
    flight.starts(20000);
    CHECK((flight.ended == Status::Done) == (state == MISSION_STATE_UNKNOWN || state == MISSION_STATE_ACTIVE));
  }
}

TEST_CASE("the items are looked at one in an update(), and the first message leaves then") {
  Loaded flight;
  flight.run(10);
  flight.client.setCustomMode(kStabilize);
  flight.fly(1100);
  flight.run(10);
  flight.sent.clear();
  flight.client.start();
  CHECK((flight.client.status() == Status::WaitingForAutopilot));
  flight.run(20);
  CHECK(flight.sent.size() == 1);
}

TEST_CASE("while our own frame waits for room the look at the plan waits, and harms nothing") {
  Loaded flight(kPx4);
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
  Flown flight(kPx4);
  accept(flight, fromFunction(readFarPlace, 14));
  flight.client.start();
  CHECK(flight.flies(1000).find("begin 0") != std::string::npos);
  for (int second = 0; second < 9 && flight.client.isBusy(); ++second) {
    flight.tellCurrent(1, MISSION_STATE_ACTIVE, 14);
    flight.fly(1000);
  }
  CHECK((flight.ended == Status::Done));
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
  Loaded flight(kArduPilot, MAV_TYPE_GROUND_ROVER);
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
