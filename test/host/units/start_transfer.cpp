#include "mavmission/transfer/StartTransfer.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <vector>

#include "mavmission/autopilot/FlightMode.h"
#include "mavmission/item/MissionItem.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef StartTransfer::State State;
typedef StartTransfer::Message Message;

constexpr uint8_t kCopter = 2, kPlane = 1, kRover = 10;  // MAV_TYPE
constexpr uint16_t kJumpTag = 601;
constexpr uint16_t kNoItem = 0xFFFF;

MissionItem fly() { return waypoint(-35.36_deg, 149.16_deg, 20_m); }
MissionItem speed() { return changeSpeed(5_mps); }

// start() on an aircraft, as the client runs it, with a plan of wire items.
struct Flown {
  StartTransfer start;
  CommandTransfer sending;
  Aircraft aircraft;
  std::vector<MissionItem> plan;
  uint16_t other;    // a mode that nobody has asked for
  uint8_t done = 0;  // steps that goTo() has gone through

  Flown(Firmware firmware, uint8_t vehicleType, std::vector<MissionItem> items = {fly(), fly(), speed(), fly()})
      : plan(items) {
    memset(static_cast<void*>(&start), 0, sizeof(start));
    memset(static_cast<void*>(&sending), 0, sizeof(sending));
    aircraft = Aircraft{firmware, vehicleType, false, 0, modeNumber(FlightMode::Auto, firmware, vehicleType), 0, 65000};
    aircraft.mode = number(FlightMode::Hold);
    other = number(FlightMode::ReturnToLaunch);
  }

  uint16_t number(FlightMode mode) const { return modeNumber(mode, aircraft.firmware, aircraft.vehicleType); }

  // Gives it the items that it wants.
  Status look() {
    for (int n = 0; n < 300; ++n) {
      Status read = start.wantsItem(static_cast<uint16_t>(plan.size()), aircraft.firmware);
      if (read == Status::Done) return read;
      const MissionItem* item = read == Status::Accepted ? &plan[start.next()] : nullptr;
      const Status status = start.onItem(read, item, aircraft, sending);
      if (status != Status::Transferring || !(start.isLooking() || start.isJudging())) return status;
    }
    return Status::TookTooLong;
  }
  Status begin(uint16_t first = 0, bool isMission = true) {
    start.setFirst(static_cast<uint16_t>(first + 7));  // by the sketch's number
    CHECK(start.first() == first + 7);
    CHECK((start.state() == State::New));
    start.begin(first, isMission, aircraft.firmware);
    CHECK((start.state() == State::Looking));
    return look();
  }
  // True if the client's gate lets the message leave right behind a heartbeat alone.
  bool isOrder() const { return start.message() != Message::FirstItem && start.message() != Message::AskCurrent; }
  bool lacksHeartbeat(uint16_t nowMs) {
    if (isOrder()) sending.guard();
    return sending.lacksHeartbeat(nowMs);
  }
  void sent() {
    CHECK(sending.isDue());
    if (isOrder()) sending.guard();
    sending.sent(aircraft.nowMs);
  }
  void sent(Message message) {
    CHECK((start.message() == message));
    sent();
  }
  Status heartbeat(bool armed, uint16_t mode) {
    aircraft.isArmed = armed;
    aircraft.mode = mode;
    aircraft.nowMs = static_cast<uint16_t>(aircraft.nowMs + 1000);
    ++aircraft.seconds;
    sending.onHeartbeat(aircraft.nowMs);
    return start.onHeartbeat(aircraft, sending);
  }
  Status heartbeat() { return heartbeat(aircraft.isArmed, aircraft.mode); }
  Status current(uint16_t item, bool isUnderWay = true) { return start.onCurrent(item, isUnderWay, aircraft, sending); }
  // True if the message that was sent is sent again when nothing answers it.
  bool isRepeated() {
    aircraft.nowMs = static_cast<uint16_t>(aircraft.nowMs + CommandTransfer::kAnswerMs);
    return sending.onTime(0, aircraft.nowMs) == Status::Transferring && sending.state() == CommandTransfer::State::Due;
  }
  Status accepted() { return start.onAccepted(aircraft, sending); }
  Status refused(Status status = Status::CommandFailed) { return start.onRefused(status, aircraft, sending); }
  Status silent(Status status = Status::NoAnswer) { return start.onSilent(status, aircraft, sending); }

  // True if it asks for a heartbeat.
  bool asks() const { return sending.isAskDue(static_cast<uint16_t>(aircraft.nowMs + 100), 100); }

  bool isAt(StartStep step, State state = State::Steps) const { return start.step() == step && start.state() == state; }

  // Goes on to this step as an autopilot leads it there that does what it is told; nothing of the step was sent.
  void goTo(StartStep step, uint16_t first = 0) {
    if (start.state() == State::New) REQUIRE((begin(first) == Status::Transferring));
    while (start.step() < step) {
      const StartStep now = start.step();
      if (now == StartStep::FirstItem && has(aircraft.firmware, kNamesFlownItems)) {
        sent(Message::FirstItem);
        REQUIRE((current(start.next()) == Status::Transferring));
        REQUIRE((start.state() == State::Asking));
      }
      sent();
      switch (now) {
        case StartStep::FirstItem: REQUIRE((current(start.first()) == Status::Transferring)); break;
        case StartStep::ReadyMode:
        case StartStep::AutoMode:
          REQUIRE((heartbeat(aircraft.isArmed, start.modeToSet()) == Status::Transferring));
          break;
        case StartStep::Arm:
          REQUIRE((accepted() == Status::Transferring));
          REQUIRE((heartbeat(true, aircraft.mode) == Status::Transferring));
          break;
        default:
          REQUIRE((accepted() == Status::Transferring));
          aircraft.isArmed = true;
          aircraft.mode = aircraft.autoMode;
          break;
      }
      REQUIRE((start.step() > now));
      ++done;
    }
  }
};

Flown copter() { return Flown(Firmware::ArduPilot, kCopter); }
Flown rover() { return Flown(Firmware::ArduPilot, kRover); }
Flown px4() { return Flown(Firmware::Px4, kCopter); }

// Has armed, was refused, and waits for a heartbeat.
Flown leaving() {
  Flown flight = copter();
  flight.goTo(StartStep::Begin);
  flight.sent(Message::Start);
  CHECK((flight.refused() == Status::Transferring));
  CHECK((flight.start.state() == State::Leaving));
  CHECK((flight.sending.state() == CommandTransfer::State::Listening));
  CHECK(flight.asks());
  CHECK(flight.sending.tries() == 0);  // nothing can be answered
  return flight;
}

Flown disarming() {
  Flown flight = leaving();
  CHECK((flight.heartbeat() == Status::Transferring));
  CHECK((flight.start.state() == State::Disarming));
  flight.sent(Message::Disarm);
  return flight;
}

}  // namespace

// New --> Looking --> Steps

TEST_CASE("the item that is flown first is the first navigation command on the way over DO commands and jumps") {
  struct Way {
    std::vector<MissionItem> plan;  // without home
    uint16_t first, flown;
  };
  const Way ways[] = {
      {{fly(), fly()}, 1, 1},
      {{fly(), fly()}, 2, 2},
      {{speed(), speed(), fly()}, 1, 3},
      {{jump(3, 1), fly(), speed(), fly()}, 1, 4},
      {{jump(1, 2), fly()}, 1, 2},  // into itself: followed once, and passed
      {{jump(1, 1), fly()}, 1, 2},
      {{jump(3, -1), speed(), fly()}, 1, 3},  // for ever, but to something that is flown
      {{jump(2, 0), speed(), fly()}, 1, 3},   // no times at all: not followed
      {{anyCommand(201), fly()}, 1, 2},
  };
  for (const Way& way : ways) {
    std::vector<MissionItem> plan = {fly()};
    plan.insert(plan.end(), way.plan.begin(), way.plan.end());
    Flown flight(Firmware::ArduPilot, kCopter, plan);
    CHECK((flight.begin(way.first) == Status::Transferring));
    CHECK(flight.start.next() == way.flown);
    CHECK(flight.isAt(StartStep::ReadyMode));
  }
}

TEST_CASE("scripts and speeds of turning are flown, a region of interest among the navigation commands is not") {
  for (uint16_t command : {213, 42702, 42703, 95}) {
    Flown flight(Firmware::Px4, kCopter, {anyCommand(command), fly()});
    flight.begin();
    CHECK(flight.start.next() == 0);
  }
  for (uint16_t command : {80, 96, 112, 178}) {
    Flown flight(Firmware::Px4, kCopter, {anyCommand(command), fly()});
    flight.begin();
    CHECK(flight.start.next() == 1);
  }
}

TEST_CASE("home is not looked at") {
  Flown flight = copter();
  flight.begin(0);
  CHECK(flight.start.next() == 1);
  Flown other = px4();
  other.begin(0);
  CHECK(other.start.next() == 0);
}

TEST_CASE("a plan in which nothing is flown ends start() before the first step") {
  const std::vector<MissionItem> plans[] = {
      {speed(), speed()},
      {speed(), jump(0, -1)},
      {},
  };
  for (const std::vector<MissionItem>& plan : plans) {
    Flown flight(Firmware::Px4, kCopter, plan);
    CHECK((flight.begin() == Status::NothingToFly));
    CHECK((flight.start.step() == StartStep::None));
    CHECK((flight.start.arming() == StartArming::Untouched));
  }
}

TEST_CASE("a way that cannot be followed does not hinder the steps, and no item is expected then") {
  Flown fence = copter();
  CHECK((fence.begin(0, false) == Status::Transferring));
  CHECK(fence.start.next() == kNoItem);
  CHECK(fence.isAt(StartStep::ReadyMode));

  Flown tag(Firmware::Px4, kCopter, {anyCommand(kJumpTag), fly()});
  CHECK((tag.begin() == Status::Transferring));
  CHECK(tag.start.next() == kNoItem);

  Flown source = px4();
  source.start.begin(0, true, Firmware::Px4);
  CHECK((source.start.onItem(Status::SourceRefused, nullptr, source.aircraft, source.sending) == Status::Transferring));
  CHECK(source.start.next() == kNoItem);

  for (size_t others : {99u, 100u}) {
    std::vector<MissionItem> plan(others, speed());
    plan.push_back(fly());
    Flown flight(Firmware::Px4, kCopter, plan);
    CHECK((flight.begin() == Status::Transferring));
    CHECK(flight.start.next() == (others == 99 ? 99 : kNoItem));
  }
}

// The steps

TEST_CASE("each vehicle gets the steps that it needs, in their order") {
  struct Vehicle {
    Firmware firmware;
    uint8_t type;
    bool isArmed;
    std::vector<StartStep> steps;
  };
  const StartStep kReady = StartStep::ReadyMode, kItem = StartStep::FirstItem, kArm = StartStep::Arm,
                  kAuto = StartStep::AutoMode, kBegin = StartStep::Begin, kConfirm = StartStep::Confirm;
  const Vehicle vehicles[] = {
      {Firmware::ArduPilot, kCopter, false, {kReady, kItem, kArm, kBegin, kConfirm}},
      {Firmware::ArduPilot, kRover, false, {kReady, kItem, kArm, kAuto, kConfirm}},
      {Firmware::ArduPilot, kPlane, false, {kItem, kArm, kAuto, kConfirm}},
      {Firmware::ArduPilot, kCopter, true, {kItem, kBegin, kConfirm}},
      {Firmware::ArduPilot, kRover, true, {kItem, kAuto, kConfirm}},
      {Firmware::Px4, kCopter, false, {kItem, kBegin, kConfirm}},
      {Firmware::Px4, kCopter, true, {kItem, kBegin, kConfirm}},
  };
  for (const Vehicle& vehicle : vehicles) {
    Flown flight(vehicle.firmware, vehicle.type);
    flight.aircraft.isArmed = vehicle.isArmed;
    uint8_t before = 0;
    for (StartStep step : vehicle.steps) {
      flight.goTo(step);
      CHECK((flight.start.step() == step));
      CHECK((flight.sending.state() != CommandTransfer::State::Sent));
      CHECK(flight.done == before++);
    }
    CHECK((flight.start.arming() == (vehicle.isArmed ? StartArming::Untouched : StartArming::Armed)));
  }
}

TEST_CASE("an aircraft that flies its mission already gets no command, and is only asked what it flies") {
  for (Flown flight : {copter(), px4()}) {
    flight.aircraft.isArmed = true;
    flight.aircraft.mode = flight.aircraft.autoMode;
    CHECK((flight.begin() == Status::Transferring));
    CHECK(flight.isAt(StartStep::Confirm));
    CHECK((flight.start.message() == Message::AskCurrent));
  }
}

TEST_CASE("a copter is armed in GUIDED and begins by MISSION_START, a rover is armed in MANUAL and drives in AUTO") {
  Flown flight = copter();
  flight.begin();
  CHECK((flight.start.message() == Message::Mode));
  CHECK(flight.start.modeToSet() == flight.number(FlightMode::Guided));
  flight.goTo(StartStep::Begin);
  CHECK((flight.start.message() == Message::Start));

  Flown other = rover();
  other.begin();
  CHECK((other.start.message() == Message::Mode));
  CHECK(other.start.modeToSet() == other.number(FlightMode::Manual));
  other.goTo(StartStep::AutoMode);
  CHECK((other.start.message() == Message::Mode));
  CHECK(other.start.modeToSet() == other.aircraft.autoMode);
}

TEST_CASE("a mode that is there already is not set, and no other order takes its place") {
  Flown flight = copter();
  flight.aircraft.mode = flight.number(FlightMode::Guided);
  flight.begin();
  CHECK(flight.isAt(StartStep::FirstItem));
  Flown meanwhile = copter();
  meanwhile.begin();
  CHECK((meanwhile.heartbeat(false, meanwhile.number(FlightMode::Guided)) == Status::Transferring));
  CHECK(meanwhile.isAt(StartStep::FirstItem));
}

TEST_CASE("a mode is set when a heartbeat shows it, which is asked for when the order was accepted") {
  for (StartStep step : {StartStep::ReadyMode, StartStep::AutoMode}) {
    Flown flight = rover();
    flight.goTo(step);
    const uint16_t mode = flight.start.modeToSet();
    CHECK(flight.lacksHeartbeat(static_cast<uint16_t>(flight.aircraft.nowMs + 50)));
    flight.sent(Message::Mode);
    CHECK((flight.accepted() == Status::Transferring));
    CHECK(flight.isAt(step));
    CHECK(flight.asks());
    CHECK((flight.heartbeat(step != StartStep::ReadyMode, mode) == Status::Transferring));
    CHECK((flight.start.step() > step));
  }
}

TEST_CASE("each order that changes the mode or arms leaves behind a heartbeat, and no other message does") {
  for (Flown flight : {copter(), rover(), px4()}) {
    for (StartStep step : {StartStep::ReadyMode, StartStep::FirstItem, StartStep::Arm, StartStep::AutoMode,
                           StartStep::Begin, StartStep::Confirm}) {
      if (flight.start.step() > step) continue;
      flight.goTo(step);
      if (flight.start.step() != step) continue;
      const bool isOrder = step != StartStep::FirstItem && step != StartStep::Confirm;
      CHECK(flight.lacksHeartbeat(static_cast<uint16_t>(flight.aircraft.nowMs + 50)) == isOrder);
    }
  }
}

TEST_CASE("ArduPilot is asked for its current item when it has answered, PX4's MISSION_CURRENT suffices") {
  Flown flight = copter();
  flight.goTo(StartStep::FirstItem);
  CHECK((flight.heartbeat() == Status::Transferring));
  CHECK((flight.current(1) == Status::Transferring));  // came before the command left
  CHECK(flight.isAt(StartStep::FirstItem));
  flight.sent(Message::FirstItem);
  CHECK((flight.current(3) == Status::Transferring));  // came unasked
  CHECK(flight.isAt(StartStep::FirstItem));
  CHECK((flight.accepted() == Status::Transferring));
  CHECK(flight.isAt(StartStep::FirstItem));
  CHECK((flight.current(0) == Status::Transferring));
  CHECK(flight.isAt(StartStep::FirstItem, State::Asking));
  CHECK(flight.start.seen() == kNoItem);
  flight.sent(Message::AskCurrent);
  CHECK(flight.isRepeated());
  flight.sent(Message::AskCurrent);
  CHECK((flight.refused() == Status::Transferring));  // MISSION_CURRENT may come unasked
  CHECK((flight.heartbeat() == Status::Transferring));
  CHECK((flight.current(3) == Status::Transferring));
  CHECK(flight.isAt(StartStep::FirstItem, State::Asking));
  CHECK((flight.current(1) == Status::Transferring));
  CHECK(flight.isAt(StartStep::Arm));

  Flown other = px4();
  other.goTo(StartStep::FirstItem);
  CHECK((other.current(0) == Status::Transferring));
  CHECK(other.isAt(StartStep::FirstItem));
  other.sent(Message::FirstItem);
  CHECK((other.current(2) == Status::Transferring));
  CHECK(other.isAt(StartStep::FirstItem));
  CHECK((other.current(0) == Status::Transferring));
  CHECK(other.isAt(StartStep::Begin));
}

TEST_CASE("ArduPilot may name home, the first item, or the one that will be flown first") {
  for (uint16_t named : {0, 1, 2}) {
    Flown flight(Firmware::ArduPilot, kCopter, {fly(), speed(), fly(), fly()});
    flight.goTo(StartStep::FirstItem);
    flight.sent();
    flight.current(2);
    flight.sent(Message::AskCurrent);
    flight.current(named);
    CHECK(flight.isAt(StartStep::Arm));
  }
  Flown second = copter();  // home is no item to begin with in the middle
  second.goTo(StartStep::FirstItem, 3);
  second.sent();
  second.current(3);
  second.sent(Message::AskCurrent);
  second.current(0);
  CHECK(second.isAt(StartStep::FirstItem, State::Asking));
}

TEST_CASE("where the plan cannot be looked at, the item that ArduPilot names is the one that is flown first") {
  Flown flight = copter();
  flight.begin(0, false);
  flight.goTo(StartStep::FirstItem);
  flight.sent();
  flight.current(0);
  flight.sent(Message::AskCurrent);
  CHECK((flight.current(0) == Status::Transferring));  // home is no answer then
  CHECK(flight.isAt(StartStep::FirstItem, State::Asking));
  CHECK((flight.current(3) == Status::Transferring));
  CHECK(flight.isAt(StartStep::Arm));
  CHECK(flight.start.next() == 3);
}

TEST_CASE("arming is confirmed by a heartbeat, which is asked for when it was accepted") {
  Flown flight = copter();
  flight.goTo(StartStep::Arm);
  flight.sent(Message::Arm);
  CHECK((flight.heartbeat(false, flight.aircraft.mode) == Status::Transferring));
  CHECK(flight.isAt(StartStep::Arm));
  CHECK((flight.accepted() == Status::Transferring));
  CHECK(flight.isAt(StartStep::Arm));
  CHECK(flight.asks());
  CHECK((flight.heartbeat(true, flight.aircraft.mode) == Status::Transferring));
  CHECK(flight.isAt(StartStep::Begin));
  CHECK((flight.start.arming() == StartArming::Armed));
}

TEST_CASE("an aircraft that somebody else arms first was not armed by start()") {
  Flown flight = copter();
  flight.goTo(StartStep::Arm);
  CHECK((flight.heartbeat(true, flight.aircraft.mode) == Status::Transferring));
  CHECK(flight.isAt(StartStep::Begin));
  CHECK((flight.start.arming() == StartArming::Untouched));
}

TEST_CASE("what somebody disarms ends start(), which says so") {
  for (StartStep step : {StartStep::Begin, StartStep::Confirm}) {
    Flown flight = copter();
    flight.goTo(step);
    CHECK((flight.heartbeat(false, flight.aircraft.mode) == Status::NotArmed));
    CHECK((flight.start.arming() == StartArming::Disarmed));
  }
  Flown px = px4();  // has accepted MISSION_START, which arms, and no heartbeat has shown it armed
  px.goTo(StartStep::Confirm);
  px.aircraft.nowMs = static_cast<uint16_t>(px.aircraft.nowMs - 800);
  CHECK((px.heartbeat(false, px.aircraft.mode) == Status::Transferring));
  CHECK((px.heartbeat() == Status::NotArmed));
  CHECK((px.start.arming() == StartArming::Disarmed));
  Flown before = copter();  // it was armed before start()
  before.aircraft.isArmed = true;
  before.begin();
  CHECK((before.heartbeat(false, before.aircraft.mode) == Status::NotArmed));
  CHECK((before.start.arming() == StartArming::Untouched));
}

TEST_CASE("the order that begins is answered, or a heartbeat shows what it does") {
  for (Flown flight : {copter(), px4()}) {
    flight.goTo(StartStep::Begin);
    const bool isPx4 = flight.aircraft.firmware == Firmware::Px4;
    Flown answered = flight;
    if (isPx4) CHECK((flight.heartbeat(false, flight.aircraft.mode) == Status::Transferring));
    flight.sent(Message::Start);
    CHECK((flight.heartbeat(true, flight.aircraft.autoMode) == Status::Transferring));
    CHECK(flight.isAt(StartStep::Confirm, State::Shown));
    answered.sent(Message::Start);
    CHECK((answered.accepted() == Status::Transferring));
    CHECK(answered.isAt(StartStep::Confirm));
    CHECK(answered.asks());
    const CommandTransfer::State state = answered.sending.state();
    CHECK((state == (isPx4 ? CommandTransfer::State::Listening : CommandTransfer::State::Due)));
  }
}

TEST_CASE("a PX4 that is armed in the mode of before is somebody else's, since it sets the mode before it arms") {
  Flown flight = px4();
  flight.goTo(StartStep::Begin);
  flight.sent(Message::Start);
  Flown other = flight;
  flight.aircraft.nowMs = static_cast<uint16_t>(flight.aircraft.nowMs - 800);
  CHECK((flight.heartbeat(true, flight.aircraft.mode) == Status::Transferring));  // the mode may follow
  CHECK(flight.asks());
  Flown answered = other;
  CHECK((other.heartbeat(true, other.aircraft.mode) == Status::TakenOver));
  CHECK((other.start.arming() == StartArming::Armed));
  answered.accepted();
  CHECK((answered.heartbeat(true, answered.aircraft.mode) == Status::TakenOver));
  CHECK((answered.start.arming() == StartArming::Armed));
}

// Confirm --> Shown --> Judging, JudgingNext --> the end

TEST_CASE("start() is done by a heartbeat and a MISSION_CURRENT, in either order") {
  for (Flown flight : {copter(), rover(), px4()}) {
    for (bool isHeartbeatFirst : {true, false}) {
      Flown one = flight;
      one.goTo(StartStep::Confirm);
      const uint16_t first = one.start.next(), mode = one.aircraft.autoMode;
      const bool isShown = one.start.state() == State::Shown;  // a rover, by the heartbeat that shows AUTO
      if (isHeartbeatFirst || isShown) {
        CHECK((one.heartbeat(true, mode) == Status::Transferring));
        CHECK(one.isAt(StartStep::Confirm, State::Shown));
        CHECK((one.current(first, false) == Status::Transferring));  // it says that nothing is flown
        CHECK((one.current(first) == Status::Done));
      } else {
        CHECK((one.current(first) == Status::Transferring));
        CHECK(one.isAt(StartStep::Confirm));
        CHECK((one.heartbeat(true, mode) == Status::Done));
      }
      CHECK((one.start.arming() == StartArming::Armed));
    }
  }
}

TEST_CASE("PX4 may name each command on the way to the item that is flown first, and no other") {
  const std::vector<MissionItem> plan = {speed(), jump(3, 2), fly(), speed(), fly(), fly()};
  for (uint16_t named : {0, 1, 2, 3, 4, 5}) {
    Flown flight(Firmware::Px4, kCopter, plan);
    flight.goTo(StartStep::Confirm);
    flight.heartbeat(true, flight.aircraft.autoMode);
    Status status = flight.current(named);
    if (named != 0) {
      CHECK((status == Status::Transferring));
      CHECK((flight.start.state() == State::Judging));
      CHECK((flight.current(5) == Status::Transferring));  // judged is the one that was named first
      CHECK(flight.start.seen() == named);
      status = flight.look();
    }
    const bool isOnTheWay = named == 0 || named == 1 || named == 3 || named == 4;
    CHECK((status == (isOnTheWay ? Status::Done : Status::OtherItem)));
    CHECK(flight.start.seen() == named);
  }
}

TEST_CASE("a long way is followed twice, each time with all its looks") {
  std::vector<MissionItem> plan(60, speed());
  plan.push_back(fly());
  Flown flight(Firmware::Px4, kCopter, plan);
  flight.goTo(StartStep::Confirm);
  flight.heartbeat(true, flight.aircraft.autoMode);
  CHECK((flight.current(59) == Status::Transferring));
  CHECK((flight.look() == Status::Done));
}

TEST_CASE("a rover, and an aircraft that was in the air, may have finished the first item already, but not the next") {
  struct Case {
    uint8_t type;
    bool wasArmed;
    uint16_t named;
    Status status;
  };
  const Case cases[] = {
      {kRover, false, 2, Status::Done},       {kRover, false, 3, Status::OtherItem}, {kCopter, true, 2, Status::Done},
      {kCopter, false, 2, Status::OtherItem}, {kCopter, true, 3, Status::OtherItem},
  };
  for (const Case& one : cases) {
    Flown flight(Firmware::ArduPilot, one.type, {fly(), fly(), fly(), fly()});
    flight.aircraft.isArmed = one.wasArmed;
    flight.goTo(StartStep::Confirm);
    flight.heartbeat(true, flight.aircraft.autoMode);
    CHECK((flight.current(one.named) == Status::Transferring));
    CHECK((flight.start.state() == State::Judging));
    CHECK((flight.look() == one.status));
    const bool hasNext = one.type == kRover || one.wasArmed;
    CHECK((flight.start.state() == (hasNext ? State::JudgingNext : State::Judging)));
  }
}

TEST_CASE("behind the last item there is no next one") {
  Flown flight(Firmware::ArduPilot, kRover, {fly(), fly()});
  flight.goTo(StartStep::Confirm);
  flight.heartbeat(true, flight.aircraft.autoMode);
  flight.current(3);
  CHECK((flight.look() == Status::OtherItem));
}

TEST_CASE("an aircraft that was flying its mission before start() must be at the first item itself") {
  Flown flight(Firmware::ArduPilot, kCopter, {fly(), fly(), fly()});
  flight.aircraft.isArmed = true;
  flight.aircraft.mode = flight.aircraft.autoMode;
  flight.begin();
  flight.heartbeat();
  flight.current(2);
  CHECK((flight.look() == Status::OtherItem));
}

TEST_CASE("where the plan cannot be looked at, only the expected item is right") {
  Flown flight = px4();
  flight.begin(0, false);
  flight.goTo(StartStep::Confirm);
  flight.heartbeat(true, flight.aircraft.autoMode);
  CHECK((flight.current(1) == Status::OtherItem));
  Flown tag(Firmware::Px4, kCopter, {anyCommand(kJumpTag), fly()});
  tag.goTo(StartStep::Confirm);
  tag.heartbeat(true, tag.aircraft.autoMode);
  CHECK((tag.current(1) == Status::OtherItem));
  CHECK((tag.start.state() == State::Shown));

  Flown flying = copter();  // it was asked for no item, and none is known
  flying.aircraft.isArmed = true;
  flying.aircraft.mode = flying.aircraft.autoMode;
  flying.begin(0, false);
  flying.heartbeat();
  CHECK((flying.current(1) == Status::Unconfirmed));
}

// A refusal, or silence

TEST_CASE("a refusal before anything was armed is the end") {
  for (StartStep step : {StartStep::ReadyMode, StartStep::FirstItem, StartStep::Arm}) {
    Flown flight = copter();
    flight.goTo(step);
    flight.sent();
    CHECK((flight.refused(Status::CommandDenied) == Status::CommandDenied));
    CHECK((flight.start.arming() == StartArming::Untouched));
    CHECK((flight.start.step() == step));
  }
  Flown flight = px4();
  flight.goTo(StartStep::Begin);
  flight.sent();
  CHECK((flight.refused() == Status::Transferring));  // its mode may have changed all the same
  CHECK((flight.start.state() == State::Leaving));
  CHECK(flight.asks());
  Flown changed = flight;
  CHECK((flight.heartbeat(false, flight.aircraft.mode) == Status::CommandFailed));
  CHECK((flight.start.arming() == StartArming::Untouched));

  const uint16_t before = changed.aircraft.mode;
  CHECK((changed.heartbeat(false, changed.aircraft.autoMode) == Status::Transferring));
  CHECK((changed.start.state() == State::Restoring));
  CHECK(changed.start.modeToSet() == before);
  changed.sent(Message::Mode);
  Flown refused = changed;
  CHECK((changed.heartbeat(false, changed.aircraft.autoMode) == Status::Transferring));
  CHECK((changed.heartbeat(false, before) == Status::CommandFailed));
  CHECK((refused.refused(Status::CommandDenied) == Status::CommandFailed));
}

TEST_CASE("a refusal of a repeated arming, or one that a heartbeat contradicts, leaves it in doubt") {
  Flown repeated = copter();
  repeated.goTo(StartStep::Arm);
  repeated.sent();
  repeated.sending.onTime(0, static_cast<uint16_t>(repeated.aircraft.nowMs + CommandTransfer::kAnswerMs));
  repeated.sent();
  CHECK((repeated.refused() == Status::Transferring));
  CHECK((repeated.start.state() == State::Leaving));
  CHECK((repeated.heartbeat(false, repeated.aircraft.mode) == Status::CommandFailed));
  CHECK((repeated.start.arming() == StartArming::Untouched));

  Flown armed = copter();
  armed.goTo(StartStep::Arm);
  armed.sent();
  armed.aircraft.isArmed = true;
  CHECK((armed.refused() == Status::Transferring));
  CHECK((armed.start.arming() == StartArming::Armed));
  CHECK((armed.heartbeat(true, armed.aircraft.mode) == Status::Transferring));
  CHECK((armed.start.state() == State::Disarming));
  CHECK((armed.heartbeat(false, armed.aircraft.mode) == Status::CommandFailed));
  CHECK((armed.start.arming() == StartArming::Disarmed));
}

TEST_CASE("a copter whose start is refused is disarmed, though a heartbeat shows AUTO, or shows it disarmed first") {
  Flown flight = copter();
  flight.goTo(StartStep::Begin);
  flight.sent();
  Flown other = flight;
  CHECK((flight.refused() == Status::Transferring));
  CHECK((flight.heartbeat(true, flight.aircraft.autoMode) == Status::Transferring));
  CHECK((flight.start.state() == State::Disarming));
  other.aircraft.isArmed = false;
  CHECK((other.refused() == Status::Transferring));
  CHECK((other.start.state() == State::Leaving));
}

TEST_CASE("AUTO is tried again for 15 s on a rover, a second after each refusal, and not on a copter") {
  Flown flight = rover();
  flight.aircraft.seconds = 65530;
  flight.goTo(StartStep::AutoMode);
  const uint16_t began = flight.aircraft.seconds;
  for (uint16_t second = 0; second < StartTransfer::kAutoTriesS; ++second) {
    flight.aircraft.seconds = static_cast<uint16_t>(began + second);
    flight.sent(Message::Mode);
    CHECK((flight.refused() == Status::Transferring));
    CHECK((flight.sending.state() == CommandTransfer::State::Pausing));
    flight.aircraft.nowMs = static_cast<uint16_t>(flight.aircraft.nowMs + StartTransfer::kAutoAgainMs - 1);
    flight.sending.onTime(0, flight.aircraft.nowMs);
    CHECK((flight.sending.state() == CommandTransfer::State::Pausing));
    flight.sending.onTime(0, ++flight.aircraft.nowMs);
    Flown silent = flight;
    silent.sent();
    CHECK(silent.isRepeated());
    CHECK(silent.lacksHeartbeat(silent.aircraft.nowMs));
  }
  flight.aircraft.seconds = static_cast<uint16_t>(began + StartTransfer::kAutoTriesS);
  flight.sent(Message::Mode);
  CHECK((flight.refused() == Status::Transferring));
  CHECK((flight.start.state() == State::Leaving));

  Flown at = rover();  // other steps are not tried again
  at.goTo(StartStep::FirstItem);
  at.sent();
  CHECK((at.refused() == Status::CommandFailed));
  CHECK((leaving().start.state() == State::Leaving));
}

TEST_CASE("after a failure an aircraft that start() has armed is disarmed, once a heartbeat shows that it is armed") {
  Flown flight = disarming();
  CHECK(flight.isRepeated());
  CHECK((flight.accepted() == Status::Transferring));
  CHECK((flight.heartbeat() == Status::Transferring));
  CHECK((flight.start.state() == State::Disarming));
  CHECK((flight.heartbeat(false, flight.aircraft.mode) == Status::CommandFailed));
  CHECK((flight.start.arming() == StartArming::Disarmed));
}

TEST_CASE("an aircraft that has disarmed by itself, or that somebody else has taken, gets no command any more") {
  Flown disarmed = leaving();
  CHECK((disarmed.heartbeat(false, disarmed.aircraft.mode) == Status::CommandFailed));
  CHECK((disarmed.start.arming() == StartArming::Disarmed));
  for (Flown flight : {leaving(), disarming()}) {
    CHECK((flight.heartbeat(true, flight.other) == Status::CommandFailed));
    CHECK((flight.start.arming() == StartArming::Armed));
  }
}

TEST_CASE("PX4 that has begun after all is not disarmed") {
  Flown flight = px4();
  flight.goTo(StartStep::Begin);
  flight.sent();
  CHECK((flight.silent() == Status::Transferring));
  CHECK((flight.start.state() == State::Leaving));
  CHECK((flight.heartbeat(true, flight.aircraft.autoMode) == Status::NoAnswer));
  CHECK((flight.start.arming() == StartArming::Armed));
}

TEST_CASE("in leaving, silence and a refusal to disarm end with the first failure, the operation's time does not") {
  for (Flown flight : {leaving(), disarming()}) {
    CHECK((flight.silent(Status::TookTooLong) == Status::Transferring));
    CHECK((flight.current(1) == Status::Transferring));
    Flown other = flight;
    CHECK((flight.silent(Status::Unconfirmed) == Status::CommandFailed));
    if (other.start.state() == State::Disarming) CHECK((other.refused(Status::CommandDenied) == Status::CommandFailed));
  }
}

TEST_CASE("a step without an answer ends start(), and disarms what it has armed") {
  for (StartStep step :
       {StartStep::ReadyMode, StartStep::FirstItem, StartStep::Arm, StartStep::AutoMode, StartStep::Begin}) {
    Flown flight = copter();
    flight.goTo(step);
    flight.sent();
    const bool isEnd = step < StartStep::Arm;
    CHECK((flight.silent() == (isEnd ? Status::NoAnswer : Status::Transferring)));
    if (!isEnd) CHECK((flight.start.state() == State::Leaving));
  }
}

TEST_CASE("an autopilot that names another item than the one that was set ends start() with that") {
  Flown flight = px4();
  flight.goTo(StartStep::FirstItem);
  flight.sent();
  flight.current(2);
  CHECK((flight.silent() == Status::OtherItem));
  CHECK(flight.start.seen() == 2);
}

TEST_CASE("without confirmation start() is unconfirmed while the mode is AUTO, and disarms otherwise") {
  for (Status silence : {Status::NoAnswer, Status::TookTooLong}) {
    Flown flight = copter();
    flight.goTo(StartStep::Confirm);
    flight.sent(Message::AskCurrent);
    CHECK((flight.refused() == Status::Transferring));
    Flown shown = flight;
    CHECK((flight.silent(silence) == (silence == Status::NoAnswer ? Status::Unconfirmed : silence)));
    CHECK((shown.heartbeat() == Status::Transferring));
    CHECK((shown.start.state() == State::Shown));
    CHECK((shown.silent(silence) == (silence == Status::NoAnswer ? Status::Unconfirmed : silence)));
    Flown other = px4();
    other.goTo(StartStep::Confirm);
    other.aircraft.mode = other.number(FlightMode::Hold);
    CHECK((other.silent(silence) == Status::Transferring));
    CHECK((other.start.state() == State::Leaving));
    CHECK(
        (other.heartbeat(false, other.aircraft.mode) == (silence == Status::NoAnswer ? Status::Unconfirmed : silence)));
  }
}

// Somebody else

TEST_CASE("a mode that start() has not set is somebody else's, in every step") {
  for (StartStep step :
       {StartStep::ReadyMode, StartStep::FirstItem, StartStep::Arm, StartStep::Begin, StartStep::Confirm}) {
    for (bool isSent : {false, true}) {
      Flown flight = copter();
      flight.goTo(step);
      if (isSent) flight.sent();
      CHECK((flight.heartbeat(flight.aircraft.isArmed, flight.other) == Status::TakenOver));
    }
  }
}

TEST_CASE("an arming that was not sent before somebody else took over has not happened") {
  Flown flight = copter();
  flight.goTo(StartStep::Arm);
  CHECK((flight.heartbeat(false, flight.other) == Status::TakenOver));
  CHECK((flight.start.arming() == StartArming::Untouched));
  Flown sent = copter();
  sent.goTo(StartStep::Arm);
  sent.sent();
  CHECK((sent.heartbeat(false, sent.other) == Status::TakenOver));
  CHECK((sent.start.arming() == StartArming::Armed));
}

TEST_CASE("an arming that takes effect behind somebody else's mode is undone") {
  Flown flight = copter();
  flight.goTo(StartStep::Arm);
  flight.sent(Message::Arm);
  flight.aircraft.nowMs = static_cast<uint16_t>(flight.aircraft.nowMs - 990);
  CHECK((flight.heartbeat(false, flight.other) == Status::Transferring));  // it may still arrive
  CHECK((flight.start.state() == State::Yielding));
  CHECK(flight.asks());
  flight.aircraft.nowMs = static_cast<uint16_t>(flight.aircraft.nowMs - 900);
  CHECK((flight.heartbeat() == Status::Transferring));
  CHECK_FALSE(flight.sending.isDue());
  Flown never = flight, refused = flight, silent = flight;
  CHECK((never.heartbeat() == Status::TakenOver));
  CHECK((never.start.arming() == StartArming::Untouched));
  CHECK((refused.refused() == Status::TakenOver));
  CHECK((refused.start.arming() == StartArming::Untouched));
  CHECK((silent.silent() == Status::TakenOver));
  CHECK((silent.start.arming() == StartArming::Armed));  // it is not known

  CHECK((flight.heartbeat(true, flight.other) == Status::Transferring));
  CHECK_FALSE(flight.lacksHeartbeat(flight.aircraft.nowMs));  // at once
  flight.sent(Message::Disarm);
  CHECK((flight.accepted() == Status::Transferring));
  CHECK((flight.heartbeat() == Status::Transferring));
  Flown inTheAir = flight;
  CHECK((inTheAir.refused() == Status::TakenOver));
  CHECK((inTheAir.start.arming() == StartArming::Armed));
  CHECK((flight.heartbeat(false, flight.other) == Status::TakenOver));
  CHECK((flight.start.arming() == StartArming::Disarmed));
}

TEST_CASE("an aircraft that is armed when somebody sets another mode is his") {
  Flown flight = copter();
  flight.goTo(StartStep::Arm);
  flight.sent(Message::Arm);
  flight.aircraft.nowMs = static_cast<uint16_t>(flight.aircraft.nowMs - 990);
  CHECK((flight.heartbeat(true, flight.other) == Status::Transferring));
  CHECK((flight.start.state() == State::Steps));
  CHECK((flight.heartbeat(true, flight.other) == Status::TakenOver));
  CHECK((flight.start.arming() == StartArming::Armed));
}

TEST_CASE("a mode that an order undoes is set again, and start() ends when a heartbeat shows it, or another one") {
  for (StartStep step : {StartStep::ReadyMode, StartStep::AutoMode}) {
    Flown flight = rover();
    flight.goTo(step);
    const bool isArmed = step == StartStep::AutoMode;
    const uint16_t wanted = flight.start.modeToSet();
    flight.sent(Message::Mode);
    flight.aircraft.nowMs = static_cast<uint16_t>(flight.aircraft.nowMs - 990);
    CHECK((flight.heartbeat(isArmed, flight.other) == Status::Transferring));  // the order may still arrive
    CHECK(flight.asks());
    Flown stays = flight;
    CHECK((stays.heartbeat(isArmed, stays.other) == Status::TakenOver));
    CHECK((flight.heartbeat(isArmed, wanted) == Status::Transferring));
    CHECK((flight.start.state() == State::Restoring));
    CHECK(flight.start.modeToSet() == flight.other);
    CHECK_FALSE(flight.lacksHeartbeat(flight.aircraft.nowMs));  // at once
    flight.sent(Message::Mode);
    CHECK((flight.accepted() == Status::Transferring));
    CHECK((flight.heartbeat(isArmed, wanted) == Status::Transferring));
    Flown refused = flight, silent = flight, another = flight;
    CHECK((flight.heartbeat(isArmed, flight.other) == Status::TakenOver));
    CHECK((another.heartbeat(isArmed, another.number(FlightMode::Hold)) == Status::TakenOver));
    CHECK((refused.refused() == Status::Overruled));
    CHECK((silent.silent() == Status::Overruled));
  }
}

TEST_CASE("a mode that a pilot sets while his first one is set again is set again, too") {
  Flown flight = rover();
  flight.goTo(StartStep::AutoMode);
  const uint16_t second = flight.number(FlightMode::Hold);
  for (uint16_t mode : {flight.other, second}) {
    const uint16_t wanted = flight.start.modeToSet();
    flight.sent(Message::Mode);
    flight.aircraft.nowMs = static_cast<uint16_t>(flight.aircraft.nowMs - 990);
    CHECK((flight.heartbeat(true, mode) == Status::Transferring));
    CHECK((flight.heartbeat(true, wanted) == Status::Transferring));
    CHECK(flight.start.modeToSet() == mode);
  }
  CHECK((flight.heartbeat(true, second) == Status::TakenOver));
}

TEST_CASE("once AUTO was seen, a change back to the mode of before is somebody else's too") {
  Flown flight = rover();
  flight.goTo(StartStep::AutoMode);
  const uint16_t before = flight.aircraft.mode;
  CHECK((flight.heartbeat(true, before) == Status::Transferring));
  flight.goTo(StartStep::Confirm);
  CHECK((flight.heartbeat(true, before) == Status::TakenOver));

  Flown other = copter();  // AUTO has not been seen yet
  other.goTo(StartStep::Begin);
  other.sent();
  CHECK((other.heartbeat(true, other.aircraft.mode) == Status::Transferring));
}

TEST_CASE("another plan ends start() when two MISSION_CURRENTs have named it, behind what asked for them") {
  for (StartStep step : {StartStep::FirstItem, StartStep::Arm, StartStep::Begin, StartStep::Confirm}) {
    const bool asks = step == StartStep::FirstItem || step == StartStep::Confirm;
    Flown flight = copter();
    flight.goTo(step);
    const auto namesOther = [](Flown& one) { return one.start.onOtherNamed(one.aircraft, one.sending); };
    if (asks) {
      // What comes before the question may be older than our plan, however often.
      CHECK((namesOther(flight) == Status::Transferring));
      CHECK((namesOther(flight) == Status::Transferring));
    }
    flight.sent();
    CHECK((namesOther(flight) == Status::Transferring));
    // Only a question is sent again at once.
    CHECK((flight.sending.state() == CommandTransfer::State::Due) == asks);
    Flown cleared = flight;
    CHECK_FALSE((namesOther(flight) == Status::Transferring && !flight.start.isLeaving()));
    // One that names ours in between takes the doubt away.
    cleared.current(kNoItem - 1, false);
    CHECK((namesOther(cleared) == Status::Transferring));
    CHECK_FALSE(cleared.start.isLeaving());
  }
}

TEST_CASE("of an autopilot whose modes are not known no mode is another one") {
  Flown flight(Firmware::Other, kCopter);
  CHECK(flight.aircraft.autoMode == kNoMode);
  flight.goTo(StartStep::Confirm);
  CHECK((flight.heartbeat(true, 77) == Status::Transferring));
  CHECK(flight.isAt(StartStep::Confirm, State::Shown));
  CHECK((flight.current(0) == Status::Done));
}

TEST_CASE("behind its start() an aircraft that flies another plan is disarmed if start() has armed it, and else left") {
  struct Case {
    StartArming arming;
    bool isArmed, isInAuto;
    bool isDisarmed;
  };
  const Case cases[] = {
      {StartArming::Armed, true, true, true},
      {StartArming::Armed, true, false, false},  // somebody has it
      {StartArming::Armed, false, true, false},
      {StartArming::Untouched, true, true, false},
  };
  for (const Case& one : cases) {
    CAPTURE(one.isArmed);
    CAPTURE(one.isInAuto);
    Flown flight = copter();
    flight.aircraft.isArmed = true;
    flight.aircraft.mode = flight.aircraft.autoMode;
    const Status left = flight.start.leaveFlying(one.arming, flight.aircraft, flight.sending);
    const bool isOurs = one.arming == StartArming::Armed;
    CHECK((left == (isOurs ? Status::Transferring : Status::Unproven)));
    CHECK((flight.start.arming() == one.arming));
    CHECK((flight.start.step() == StartStep::Confirm));
    if (!isOurs) continue;
    CHECK(flight.start.isLeaving());
    CHECK(flight.asks());
    const Status shown = flight.heartbeat(one.isArmed, one.isInAuto ? flight.aircraft.autoMode : flight.other);
    CHECK((flight.start.state() == State::Disarming) == one.isDisarmed);
    CHECK((shown == (one.isDisarmed ? Status::Transferring : Status::Unproven)));
    if (!one.isArmed) CHECK((flight.start.arming() == StartArming::Disarmed));
    if (!one.isDisarmed) continue;
    flight.sent(Message::Disarm);
    CHECK((flight.heartbeat(false, flight.aircraft.autoMode) == Status::Unproven));
    CHECK((flight.start.arming() == StartArming::Disarmed));
  }
}
