#include "mavmission/transfer/StartTransfer.h"

#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>
#include <string>
#include <vector>

#include "Script.h"
#include "mavmission/autopilot/FlightMode.h"
#include "mavmission/item/MissionItem.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

typedef StartTransfer::State State;
typedef StartTransfer::Message Message;
typedef std::vector<MissionItem> Plan;

constexpr uint8_t kCopter = 2, kPlane = 1, kRover = 10;  // MAV_TYPE
constexpr uint16_t kJumpTag = 601;
constexpr uint16_t kNoItem = 0xFFFF;

MissionItem fly() { return waypoint(-35.36_deg, 149.16_deg, 20_m); }
MissionItem speed() { return changeSpeed(5_mps); }

const struct {
  const char* name;
  FlightMode mode;
} kModes[] = {
    {"hold", FlightMode::Hold},  // in which it stands before start()
    {"guided", FlightMode::Guided}, {"manual", FlightMode::Manual},
    {"auto", FlightMode::Auto},     {"rtl", FlightMode::ReturnToLaunch},  // nobody has asked for this one
};

// start() on an aircraft, as the client runs it, with a plan of wire items.
struct Flown {
  StartTransfer start;
  CommandTransfer sending;
  Aircraft aircraft;
  Plan plan;

  Flown(Firmware firmware, uint8_t vehicleType, Plan items = {fly(), fly(), speed(), fly()}) : plan(items) {
    memset(static_cast<void*>(&start), 0, sizeof(start));
    memset(static_cast<void*>(&sending), 0, sizeof(sending));
    aircraft = Aircraft{firmware, vehicleType, false, 0, modeNumber(FlightMode::Auto, firmware, vehicleType), 0, 65000};
    aircraft.mode = number(FlightMode::Hold);
  }
  Flown& inFlight() {
    aircraft.isArmed = true;
    aircraft.mode = aircraft.autoMode;
    return *this;
  }

  // The messages that leave, the steps and other states that begin, "asks" where it begins to ask for a heartbeat, and
  // how it ends, "(armed)" or "(disarmed)" by start(), when this happens:
  // begins N: from item N of the mission that is aboard; begins unseen: that is not the plan which can be looked at
  // sent: the line takes the message that is due; wait N: N ms pass; no answer: as many as it waits for one
  // shows [armed, disarmed] [mode]: the next heartbeat, a second later; soon shows: 10 ms later
  // current N: MISSION_CURRENT, idle at N: when nothing is flown; other plan: it names another plan
  // accepted, refused, denied; silence, unconfirmed, too long: the answer to the message, or the lack of one
  // looks: takes the items that it wants
  std::string plays(const std::string& script) {
    said_ = Transcript();
    Status status = Status::Transferring;
    for (const Event& event : eventsOf(script)) {
      const State stateBefore = start.state();
      const StartStep stepBefore = start.step();
      const bool askedBefore = asks() && event.what.find("shows") == std::string::npos;  // a heartbeat ends that
      status = happens(event);
      if (start.step() != stepBefore || start.state() != stateBefore) said_.note(nameOfState());
      if (asks() && !askedBefore) said_.note("asks");
      if (status == Status::Transferring) continue;
      const char* const kArming[] = {"", " (armed)", " (disarmed)"};
      said_.note(nameOf(status) + std::string(kArming[static_cast<uint8_t>(start.arming())]));
      break;
    }
    return said_.text();
  }

  // The same as an autopilot leads it to this step that does what it is told; nothing of the step was sent.
  std::string flies(StartStep step = StartStep::Confirm, const std::string& begins = "begins 0") {
    std::string all;
    const auto obeys = [&](const std::string& script) {
      const std::string said = plays(script);
      if (!all.empty() && !said.empty()) all += ", ";
      all += said;
    };
    if (start.state() == State::New) obeys(begins);
    while (start.step() < step) {
      switch (const StartStep now = start.step()) {
        case StartStep::FirstItem:
          if (has(aircraft.firmware, kNamesFlownItems)) obeys("sent, current " + std::to_string(start.next()));
          obeys("sent, current " + std::to_string(start.first()));
          break;
        case StartStep::Arm: obeys("sent, accepted, shows armed"); break;
        case StartStep::Begin:
          obeys("sent, accepted");
          inFlight();
          break;
        default: REQUIRE((now == StartStep::ReadyMode || now == StartStep::AutoMode)); obeys("sent, shows wanted");
      }
    }
    return all;
  }

  uint16_t number(FlightMode mode) const { return modeNumber(mode, aircraft.firmware, aircraft.vehicleType); }

  // True if it asks for a heartbeat.
  bool asks() const { return sending.isAskDue(static_cast<uint16_t>(aircraft.nowMs + 100), 100); }

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

 private:
  Transcript said_;

  Status happens(const Event& event) {
    const uint16_t item = static_cast<uint16_t>(event.number);
    if (event.is("begins")) return begin(item, true);
    if (event.is("begins unseen")) return begin(0, false);
    if (event.is("sent")) return sent();
    if (event.is("wait")) return pass(event.number);
    if (event.is("no answer")) return pass(CommandTransfer::kAnswerMs);
    if (event.is("current") || event.is("idle at"))
      return start.onCurrent(item, event.is("current"), aircraft, sending);
    if (event.is("other plan")) return start.onOtherNamed(aircraft, sending);
    if (event.is("accepted")) return start.onAccepted(aircraft, sending);
    if (event.is("refused")) return start.onRefused(Status::CommandFailed, aircraft, sending);
    if (event.is("denied")) return start.onRefused(Status::CommandDenied, aircraft, sending);
    if (event.is("silence")) return start.onSilent(Status::NoAnswer, aircraft, sending);
    if (event.is("unconfirmed")) return start.onSilent(Status::Unconfirmed, aircraft, sending);
    if (event.is("too long")) return start.onSilent(Status::TookTooLong, aircraft, sending);
    if (event.is("looks")) return look();
    return heartbeat(event);
  }
  Status begin(uint16_t first, bool isMission) {
    start.setFirst(static_cast<uint16_t>(first + 7));  // by the sketch's number
    CHECK(start.first() == first + 7);
    start.begin(first, isMission, aircraft.firmware);
    CHECK((start.state() == State::Looking));
    return look();
  }
  Status sent() {
    REQUIRE(sending.isDue());
    const char* const kNames[] = {"mode", "first item", "arm", "start", "ask current", "disarm"};
    std::string said = kNames[static_cast<uint8_t>(start.message())];
    if (start.message() == Message::Mode) said += " " + nameOfMode(start.modeToSet());
    // The client's gate lets an order leave right after a heartbeat alone, and any other message without one.
    const bool isOrder = start.message() != Message::FirstItem && start.message() != Message::AskCurrent;
    if (isOrder) sending.guard();
    CHECK(sending.lacksHeartbeat(static_cast<uint16_t>(aircraft.nowMs + 50)) == isOrder);
    said_.note(said);
    sending.sent(aircraft.nowMs);
    return Status::Transferring;
  }
  Status pass(uint32_t ms) {
    aircraft.nowMs = static_cast<uint16_t>(aircraft.nowMs + ms);
    const bool wasDue = sending.isDue();
    CHECK((sending.onTime(0, aircraft.nowMs) == Status::Transferring));
    if (!wasDue && sending.isDue()) said_.note("due again");
    return Status::Transferring;
  }
  Status heartbeat(const Event& event) {
    const auto hasWord = [&](const char* word) { return (" " + event.what + " ").find(word) != std::string::npos; };
    event.known(hasWord(" shows "));
    if (hasWord(" armed ")) aircraft.isArmed = true;
    if (hasWord(" disarmed ")) aircraft.isArmed = false;
    if (hasWord(" wanted ")) aircraft.mode = start.modeToSet();
    if (event.number != 0) aircraft.mode = static_cast<uint16_t>(event.number);
    for (const auto& mode : kModes) {
      if (hasWord((" " + std::string(mode.name) + " ").c_str())) aircraft.mode = number(mode.mode);
    }
    aircraft.nowMs = static_cast<uint16_t>(aircraft.nowMs + (hasWord("soon ") ? 10 : 1000));
    ++aircraft.seconds;
    sending.onHeartbeat(aircraft.nowMs);
    return start.onHeartbeat(aircraft, sending);
  }
  std::string nameOfState() const {
    const char* const kSteps[] = {"None", "ReadyMode", "FirstItem", "Arm", "AutoMode", "Begin", "Confirm"};
    const char* const kStates[] = {"New",         "Looking", "Steps",     "Asking",    "Shown",   "Judging",
                                   "JudgingNext", "Leaving", "Disarming", "Restoring", "Yielding"};
    const uint8_t state = static_cast<uint8_t>(start.state()), step = static_cast<uint8_t>(start.step());
    return start.state() == State::Steps ? kSteps[step] : kStates[state];
  }
  std::string nameOfMode(uint16_t number) const {
    for (const auto& mode : kModes) {
      if (this->number(mode.mode) == number) return mode.name;
    }
    return std::to_string(number);
  }
};

Flown copter() { return Flown(Firmware::ArduPilot, kCopter); }
Flown rover() { return Flown(Firmware::ArduPilot, kRover); }
Flown px4() { return Flown(Firmware::Px4, kCopter); }

Flown at(StartStep step, Flown flight) {
  flight.flies(step);
  return flight;
}

// Has armed, was refused, and waits for a heartbeat.
Flown leaving() {
  Flown flight = at(StartStep::Begin, copter());
  CHECK(flight.plays("sent, refused") == "start, Leaving, asks");
  CHECK((flight.sending.state() == CommandTransfer::State::Listening));
  CHECK(flight.sending.tries() == 0);  // nothing can be answered
  return flight;
}

Flown disarming() {
  Flown flight = leaving();
  CHECK(flight.plays("shows, sent") == "Disarming, disarm");
  return flight;
}

std::string string(unsigned number) { return std::to_string(number); }

}  // namespace

// New --> Looking --> Steps

TEST_CASE("the item that is flown first is the first navigation command on the way over DO commands and jumps") {
  const struct {
    Plan plan;  // without home
    unsigned first, flown;
  } kWays[] = {
      {{fly(), fly()}, 1, 1},
      {{fly(), fly()}, 2, 2},
      {{fly(), fly()}, 0, 1},  // home is not looked at
      {{speed(), speed(), fly()}, 1, 3},
      {{jump(3, 1), fly(), speed(), fly()}, 1, 4},
      {{jump(1, 2), fly()}, 1, 2},  // into itself: followed once, and passed
      {{jump(1, 1), fly()}, 1, 2},
      {{jump(3, -1), speed(), fly()}, 1, 3},  // for ever, but to something that is flown
      {{jump(2, 0), speed(), fly()}, 1, 3},   // no times at all: not followed
      {{anyCommand(201), fly()}, 1, 2},
  };
  for (const auto& way : kWays) {
    Plan plan = {fly()};
    plan.insert(plan.end(), way.plan.begin(), way.plan.end());
    Flown flight(Firmware::ArduPilot, kCopter, plan);
    CHECK(flight.plays("begins " + string(way.first)) == "ReadyMode");
    CHECK(flight.start.next() == way.flown);
  }
}

TEST_CASE("scripts and speeds of turning are flown, a region of interest among the navigation commands is not") {
  const uint16_t kFlown[][2] = {{213, 0}, {42702, 0}, {42703, 0}, {95, 0}, {80, 1}, {96, 1}, {112, 1}, {178, 1}};
  for (const auto& row : kFlown) {
    Flown flight(Firmware::Px4, kCopter, {anyCommand(row[0]), fly()});
    CHECK(flight.plays("begins 0") == "FirstItem");
    CHECK(flight.start.next() == row[1]);
  }
}

TEST_CASE("a plan in which nothing is flown ends start() before the first step") {
  for (const Plan& plan : {Plan{speed(), speed()}, Plan{speed(), jump(0, -1)}, Plan{}}) {
    CHECK(Flown(Firmware::Px4, kCopter, plan).plays("begins 0") == "Looking, NothingToFly");
  }
}

TEST_CASE("a way that cannot be followed does not hinder the steps, and no item is expected then") {
  Flown fence = copter();
  CHECK(fence.plays("begins unseen") == "ReadyMode");
  CHECK(fence.start.next() == kNoItem);

  Flown tag(Firmware::Px4, kCopter, {anyCommand(kJumpTag), fly()});
  CHECK(tag.plays("begins 0") == "FirstItem");
  CHECK(tag.start.next() == kNoItem);

  Flown source = px4();
  source.start.begin(0, true, Firmware::Px4);
  CHECK((source.start.onItem(Status::SourceRefused, nullptr, source.aircraft, source.sending) == Status::Transferring));
  CHECK(source.start.next() == kNoItem);

  for (size_t others : {99u, 100u}) {
    Plan plan(others, speed());
    plan.push_back(fly());
    Flown flight(Firmware::Px4, kCopter, plan);
    CHECK(flight.plays("begins 0") == "FirstItem");
    CHECK(flight.start.next() == (others == 99 ? 99 : kNoItem));
  }
}

// The steps

TEST_CASE("each vehicle gets the steps that it needs, in their order") {
  const struct {
    Firmware firmware;
    uint8_t type;
    bool isArmed;
    const char* steps;
  } kVehicles[] = {
      // A copter is armed in GUIDED and begins by MISSION_START, a rover is armed in MANUAL and drives in AUTO.
      {Firmware::ArduPilot, kCopter, false,
       "ReadyMode, mode guided, FirstItem, first item, Asking, ask current, Arm, arm, asks, Begin, start, Confirm, "
       "asks"},
      {Firmware::ArduPilot, kRover, false,
       "ReadyMode, mode manual, FirstItem, first item, Asking, ask current, Arm, arm, asks, AutoMode, mode auto, "
       "Shown"},
      {Firmware::ArduPilot, kPlane, false,
       "FirstItem, first item, Asking, ask current, Arm, arm, asks, AutoMode, mode auto, Shown"},
      {Firmware::ArduPilot, kCopter, true, "FirstItem, first item, Asking, ask current, Begin, start, Confirm, asks"},
      {Firmware::ArduPilot, kRover, true, "FirstItem, first item, Asking, ask current, AutoMode, mode auto, Shown"},
      {Firmware::Px4, kCopter, false, "FirstItem, first item, Begin, start, Confirm, asks"},
      {Firmware::Px4, kCopter, true, "FirstItem, first item, Begin, start, Confirm, asks"},
  };
  for (const auto& vehicle : kVehicles) {
    Flown flight(vehicle.firmware, vehicle.type);
    flight.aircraft.isArmed = vehicle.isArmed;
    CHECK(flight.flies() == vehicle.steps);
    CHECK((flight.sending.state() != CommandTransfer::State::Sent));
    CHECK((flight.start.arming() == (vehicle.isArmed ? StartArming::Untouched : StartArming::Armed)));
  }
}

TEST_CASE("an aircraft that flies its mission already gets no command, and is only asked what it flies") {
  for (Flown flight : {copter(), px4()}) {
    CHECK(flight.inFlight().plays("begins 0") == "Confirm");
    CHECK((flight.start.message() == Message::AskCurrent));
  }
}

TEST_CASE("a mode that is there already is not set, and no other order takes its place") {
  Flown flight = copter();
  flight.aircraft.mode = flight.number(FlightMode::Guided);
  CHECK(flight.plays("begins 0") == "FirstItem");
  CHECK(copter().plays("begins 0, shows guided") == "ReadyMode, FirstItem");
}

TEST_CASE("a mode is set when a heartbeat shows it, which is asked for when the order was accepted") {
  CHECK(at(StartStep::ReadyMode, rover()).plays("sent, accepted, shows manual") == "mode manual, asks, FirstItem");
  CHECK(at(StartStep::AutoMode, rover()).plays("sent, accepted, shows auto") == "mode auto, asks, Shown");
}

TEST_CASE("ArduPilot is asked for its current item when it has answered, PX4's MISSION_CURRENT suffices") {
  // What comes before the command left, or unasked, is no answer. MISSION_CURRENT may come unasked when it is refused.
  Flown flight = at(StartStep::FirstItem, copter());
  CHECK(flight.plays("shows, current 1, sent, current 3, accepted, current 0") == "first item, asks, Asking");
  CHECK(flight.start.seen() == kNoItem);
  CHECK(flight.plays("sent, no answer, sent, refused, shows, current 3, current 1") ==
        "ask current, due again, ask current, Arm");
  CHECK(at(StartStep::FirstItem, px4()).plays("current 0, sent, current 2, current 0") == "first item, Begin");
}

TEST_CASE("ArduPilot may name home, the first item, or the one that will be flown first") {
  for (unsigned named : {0, 1, 2}) {
    Flown flight = at(StartStep::FirstItem, Flown(Firmware::ArduPilot, kCopter, {fly(), speed(), fly(), fly()}));
    CHECK(flight.plays("sent, current 2, sent, current " + string(named)) == "first item, Asking, ask current, Arm");
  }
  Flown second = copter();  // home is no item to begin with in the middle
  second.flies(StartStep::FirstItem, "begins 3");
  CHECK(second.plays("sent, current 3, sent, current 0") == "first item, Asking, ask current");
}

TEST_CASE("where the plan cannot be looked at, the item that ArduPilot names is the one that is flown first") {
  Flown flight = copter();
  flight.flies(StartStep::FirstItem, "begins unseen");
  CHECK(flight.plays("sent, current 0, sent, current 0") == "first item, Asking, ask current");  // home is no answer
  CHECK(flight.plays("current 3") == "Arm");
  CHECK(flight.start.next() == 3);
}

TEST_CASE("arming is confirmed by a heartbeat, which is asked for when it was accepted") {
  Flown flight = at(StartStep::Arm, copter());
  CHECK(flight.plays("sent, shows disarmed, accepted, shows armed") == "arm, asks, Begin");
  CHECK((flight.start.arming() == StartArming::Armed));
}

TEST_CASE("an aircraft that somebody else arms first was not armed by start()") {
  Flown flight = at(StartStep::Arm, copter());
  CHECK(flight.plays("shows armed") == "Begin");
  CHECK((flight.start.arming() == StartArming::Untouched));
}

TEST_CASE("what somebody disarms ends start(), which says so") {
  CHECK(at(StartStep::Begin, copter()).plays("shows disarmed") == "NotArmed (disarmed)");
  CHECK(at(StartStep::Confirm, copter()).plays("shows disarmed") == "NotArmed (disarmed)");
  // It has accepted MISSION_START, which arms, and no heartbeat has shown it armed.
  CHECK(at(StartStep::Confirm, px4()).plays("soon shows disarmed, shows") == "asks, NotArmed (disarmed)");
  CHECK(copter().inFlight().plays("begins 0, shows disarmed") == "Confirm, NotArmed");  // armed before start()
}

TEST_CASE("the order that begins is answered, or a heartbeat shows what it does") {
  for (Flown flight : {copter(), px4()}) {
    flight.flies(StartStep::Begin);
    const bool isPx4 = flight.aircraft.firmware == Firmware::Px4;
    Flown answered = flight;
    if (isPx4) CHECK(flight.plays("shows disarmed") == "");
    CHECK(flight.plays("sent, shows armed auto") == "start, Shown");
    CHECK(answered.plays("sent, accepted") == "start, Confirm, asks");
    CHECK((answered.sending.state() == (isPx4 ? CommandTransfer::State::Listening : CommandTransfer::State::Due)));
  }
}

TEST_CASE("a PX4 that is armed in the mode of before is somebody else's, since it sets the mode before it arms") {
  const Flown flight = at(StartStep::Begin, px4());
  CHECK(Flown(flight).plays("sent, soon shows armed") == "start, asks");  // the mode may follow
  CHECK(Flown(flight).plays("sent, shows armed") == "start, TakenOver (armed)");
  CHECK(Flown(flight).plays("sent, accepted, shows armed") == "start, Confirm, asks, TakenOver (armed)");
}

// Confirm --> Shown --> Judging, JudgingNext --> the end

TEST_CASE("start() is done by a heartbeat and a MISSION_CURRENT, in either order") {
  CHECK(at(StartStep::Confirm, copter()).plays("shows armed auto, idle at 1, current 1") == "Shown, Done (armed)");
  CHECK(at(StartStep::Confirm, copter()).plays("current 1, shows armed auto") == "Shown, Done (armed)");
  CHECK(at(StartStep::Confirm, px4()).plays("shows armed auto, idle at 0, current 0") == "Shown, Done (armed)");
  CHECK(at(StartStep::Confirm, px4()).plays("current 0, shows armed auto") == "Shown, Done (armed)");
  // The heartbeat that shows AUTO is there.
  CHECK(at(StartStep::Confirm, rover()).plays("shows, idle at 1, current 1") == "Done (armed)");
}

TEST_CASE("PX4 may name each command on the way to the item that is flown first, and no other") {
  const Plan plan = {speed(), jump(3, 2), fly(), speed(), fly(), fly()};
  for (unsigned named : {0, 1, 2, 3, 4, 5}) {
    Flown flight = at(StartStep::Confirm, Flown(Firmware::Px4, kCopter, plan));
    const bool isOnTheWay = named == 0 || named == 1 || named == 3 || named == 4;
    // Judged is the one that was named first.
    CHECK(flight.plays("shows armed auto, current " + string(named) + ", current 5, looks") ==
          (named == 0   ? "Shown, Done (armed)"
           : isOnTheWay ? "Shown, Judging, Done (armed)"
                        : "Shown, Judging, OtherItem (armed)"));
    CHECK(flight.start.seen() == named);
  }
  Plan longWay(60, speed());  // is followed twice, each time with all its looks
  longWay.push_back(fly());
  CHECK(at(StartStep::Confirm, Flown(Firmware::Px4, kCopter, longWay)).plays("shows armed auto, current 59, looks") ==
        "Shown, Judging, Done (armed)");
}

TEST_CASE("a rover, and an aircraft that was in the air, may have finished the first item already, but not the next") {
  const struct {
    uint8_t type;
    bool wasArmed;
    unsigned items, named;
    const char* ends;
  } kCases[] = {
      {kRover, false, 4, 2, "Judging, JudgingNext, Done (armed)"},
      {kRover, false, 4, 3, "Judging, JudgingNext, OtherItem (armed)"},
      {kRover, false, 2, 3, "Judging, JudgingNext, OtherItem (armed)"},  // after the last item there is no next one
      {kCopter, true, 4, 2, "Shown, Judging, JudgingNext, Done"},
      {kCopter, true, 4, 3, "Shown, Judging, JudgingNext, OtherItem"},
      {kCopter, false, 4, 2, "Shown, Judging, OtherItem (armed)"},
  };
  for (const auto& one : kCases) {
    Flown flight(Firmware::ArduPilot, one.type, Plan(one.items, fly()));
    flight.aircraft.isArmed = one.wasArmed;
    flight.flies();
    CHECK(flight.plays("shows armed auto, current " + string(one.named) + ", looks") == one.ends);
  }
  // An aircraft that was flying its mission before start() must be at the first item itself.
  CHECK(copter().inFlight().plays("begins 0, shows, current 2, looks") == "Confirm, Shown, Judging, OtherItem");
}

TEST_CASE("where the plan cannot be looked at, only the expected item is right") {
  Flown flight = px4();
  flight.flies(StartStep::Confirm, "begins unseen");
  CHECK(flight.plays("shows armed auto, current 1") == "Shown, OtherItem (armed)");
  Flown tag = at(StartStep::Confirm, Flown(Firmware::Px4, kCopter, {anyCommand(kJumpTag), fly()}));
  CHECK(tag.plays("shows armed auto, current 1") == "Shown, OtherItem (armed)");
  // It was asked for no item, and none is known.
  CHECK(copter().inFlight().plays("begins unseen, shows, current 1") == "Confirm, Shown, Unconfirmed");
}

// A refusal, or silence

TEST_CASE("a refusal or silence before anything was armed is the end; after that, what start() has armed is disarmed") {
  const struct {
    Flown flight;
    const char *script, *leads;
  } kRows[] = {
      {at(StartStep::ReadyMode, copter()), "sent, denied", "mode guided, CommandDenied"},
      {at(StartStep::FirstItem, copter()), "sent, denied", "first item, CommandDenied"},
      {at(StartStep::Arm, copter()), "sent, denied", "arm, CommandDenied"},
      {at(StartStep::ReadyMode, copter()), "sent, silence", "mode guided, NoAnswer"},
      {at(StartStep::FirstItem, copter()), "sent, silence", "first item, NoAnswer"},
      {at(StartStep::Arm, copter()), "sent, silence", "arm, Leaving, asks"},
      {at(StartStep::Begin, copter()), "sent, silence", "start, Leaving, asks"},
      // Once a heartbeat shows that it is armed. PX4 that has begun after all is not disarmed.
      {disarming(), "no answer, accepted, shows, shows disarmed", "due again, asks, CommandFailed (disarmed)"},
      {at(StartStep::Begin, px4()), "sent, silence, shows armed auto", "start, Leaving, asks, NoAnswer (armed)"},
      // One that has disarmed by itself, or that somebody else has taken, gets no command any more.
      {leaving(), "shows disarmed", "CommandFailed (disarmed)"},
      {leaving(), "shows rtl", "CommandFailed (armed)"},
      {disarming(), "shows rtl", "CommandFailed (armed)"},
      // Silence and a refusal to disarm end it with the first failure, the operation's time does not.
      {leaving(), "too long, current 1, unconfirmed", "CommandFailed (armed)"},
      {disarming(), "too long, current 1, unconfirmed", "CommandFailed (armed)"},
      {disarming(), "too long, current 1, denied", "CommandFailed (armed)"},
  };
  for (auto row : kRows) CHECK(row.flight.plays(row.script) == row.leads);
}

TEST_CASE("where PX4 refuses to begin, its mode may have changed all the same: it is set back") {
  Flown flight = at(StartStep::Begin, px4());
  CHECK(flight.plays("sent, refused") == "start, Leaving, asks");
  CHECK(Flown(flight).plays("shows disarmed") == "CommandFailed");
  CHECK(flight.plays("shows disarmed auto, sent") == "Restoring, mode hold");
  CHECK(Flown(flight).plays("shows auto, shows hold") == "CommandFailed");
  CHECK(flight.plays("denied") == "CommandFailed");
}

TEST_CASE("a refusal of a repeated arming, or one that a heartbeat contradicts, leaves it in doubt") {
  CHECK(at(StartStep::Arm, copter()).plays("sent, no answer, sent, refused, shows disarmed") ==
        "arm, due again, asks, arm, Leaving, CommandFailed");
  Flown armed = at(StartStep::Arm, copter());
  armed.plays("sent");
  armed.aircraft.isArmed = true;
  CHECK(armed.plays("refused") == "Leaving, asks");
  CHECK((armed.start.arming() == StartArming::Armed));
  CHECK(armed.plays("shows, shows disarmed") == "Disarming, CommandFailed (disarmed)");
}

TEST_CASE("a copter whose start is refused is disarmed, though a heartbeat shows AUTO, or shows it disarmed first") {
  CHECK(leaving().plays("shows armed auto") == "Disarming");
  Flown other = at(StartStep::Begin, copter());
  other.plays("sent");
  other.aircraft.isArmed = false;
  CHECK(other.plays("refused") == "Leaving, asks");
}

TEST_CASE("AUTO is tried again for 15 s on a rover, a second after each refusal, and not on a copter") {
  Flown flight = rover();
  flight.aircraft.seconds = 65530;
  flight.flies(StartStep::AutoMode);
  for (uint16_t second = 0; second < StartTransfer::kAutoTriesS; ++second) {
    CHECK(flight.plays("sent, refused, wait 999") == "mode auto");
    CHECK(flight.plays("wait 1") == "due again");
    Flown silent = flight;
    CHECK(silent.plays("sent, no answer") == "mode auto, due again, asks");
    CHECK(silent.sending.lacksHeartbeat(silent.aircraft.nowMs));
    ++flight.aircraft.seconds;
  }
  CHECK(flight.plays("sent, refused") == "mode auto, Leaving, asks");
  CHECK(at(StartStep::FirstItem, rover()).plays("sent, refused") == "first item, CommandFailed");  // no other step is
}

TEST_CASE("an autopilot that names another item than the one that was set ends start() with that") {
  Flown flight = at(StartStep::FirstItem, px4());
  CHECK(flight.plays("sent, current 2, silence") == "first item, OtherItem");
  CHECK(flight.start.seen() == 2);
}

TEST_CASE("without confirmation start() is unconfirmed while the mode is AUTO, and disarms otherwise") {
  const std::string kEnds[][2] = {{"silence", "Unconfirmed"}, {"too long", "TookTooLong"}};
  for (const auto& end : kEnds) {
    const Flown flight = at(StartStep::Confirm, copter());
    CHECK(Flown(flight).plays("sent, refused, " + end[0]) == "ask current, " + end[1] + " (armed)");
    CHECK(Flown(flight).plays("sent, refused, shows, " + end[0]) == "ask current, Shown, " + end[1] + " (armed)");
    Flown other = at(StartStep::Confirm, px4());
    other.aircraft.mode = other.number(FlightMode::Hold);
    CHECK(other.plays(end[0] + ", shows disarmed") == "Leaving, " + end[1] + " (disarmed)");
  }
}

// Somebody else

TEST_CASE("a mode that start() has not set is somebody else's, in every step") {
  for (StartStep step :
       {StartStep::ReadyMode, StartStep::FirstItem, StartStep::Arm, StartStep::Begin, StartStep::Confirm}) {
    // An arming that was not sent before somebody else took over has not happened.
    const bool isArmed = step > StartStep::Arm;
    CHECK(at(step, copter()).plays("shows rtl") == (isArmed ? "TakenOver (armed)" : "TakenOver"));
    Flown sent = at(step, copter());
    sent.plays("sent");
    CHECK(sent.plays("shows rtl") == (isArmed || step == StartStep::Arm ? "TakenOver (armed)" : "TakenOver"));
  }
}

TEST_CASE("an arming that takes effect after somebody else's mode is undone") {
  Flown flight = at(StartStep::Arm, copter());
  CHECK(flight.plays("sent, soon shows rtl, soon shows") == "arm, Yielding, asks (2 times)");  // it may still arrive
  CHECK_FALSE(flight.sending.isDue());
  CHECK(Flown(flight).plays("shows") == "TakenOver");
  CHECK(Flown(flight).plays("refused") == "TakenOver");
  CHECK(Flown(flight).plays("silence") == "TakenOver (armed)");  // it is not known
  flight.plays("shows armed");
  CHECK_FALSE(flight.sending.lacksHeartbeat(flight.aircraft.nowMs));  // at once
  CHECK(flight.plays("sent, accepted, shows") == "disarm, asks");
  CHECK(Flown(flight).plays("refused") == "TakenOver (armed)");
  CHECK(flight.plays("shows disarmed") == "TakenOver (disarmed)");
}

TEST_CASE("an aircraft that is armed when somebody sets another mode is his") {
  CHECK(at(StartStep::Arm, copter()).plays("sent, soon shows armed rtl, shows") == "arm, asks, TakenOver (armed)");
}

TEST_CASE("a mode that an order undoes is set again, and start() ends when a heartbeat shows it, or another one") {
  for (StartStep step : {StartStep::ReadyMode, StartStep::AutoMode}) {
    const std::string end = step == StartStep::AutoMode ? " (armed)" : "";
    Flown flight = at(step, rover());
    flight.plays("sent");
    CHECK(flight.plays("soon shows rtl") == "asks");  // the order may still arrive
    CHECK(Flown(flight).plays("shows") == "TakenOver" + end);
    CHECK(flight.plays("shows wanted") == "Restoring");
    CHECK_FALSE(flight.sending.lacksHeartbeat(flight.aircraft.nowMs));  // at once
    CHECK(flight.plays("sent, accepted") == "mode rtl, asks");
    CHECK(flight.plays(step == StartStep::AutoMode ? "shows auto" : "shows manual") == "");
    CHECK(Flown(flight).plays("shows rtl") == "TakenOver" + end);
    CHECK(Flown(flight).plays("shows hold") == "TakenOver" + end);
    CHECK(Flown(flight).plays("refused") == "Overruled" + end);
    CHECK(Flown(flight).plays("silence") == "Overruled" + end);
  }
}

TEST_CASE("a mode that a pilot sets while his first one is set again is set again, too") {
  Flown flight = at(StartStep::AutoMode, rover());
  CHECK(flight.plays("sent, soon shows rtl, shows auto") == "mode auto, asks, Restoring");
  CHECK(flight.plays("sent, soon shows hold, shows rtl, sent") == "mode rtl, asks, mode hold");
  CHECK(flight.plays("shows hold") == "TakenOver (armed)");
}

TEST_CASE("once AUTO was seen, a change back to the mode of before is somebody else's too") {
  Flown flight = at(StartStep::AutoMode, rover());
  CHECK(flight.plays("shows manual") == "");
  flight.flies(StartStep::Confirm);
  CHECK(flight.plays("shows manual") == "TakenOver (armed)");
  CHECK(at(StartStep::Begin, copter()).plays("sent, shows") == "start");  // AUTO has not been seen yet
}

TEST_CASE("another plan ends start() when two MISSION_CURRENTs have named it, after what asked for them") {
  for (StartStep step : {StartStep::FirstItem, StartStep::Arm, StartStep::Begin, StartStep::Confirm}) {
    const bool asks = step == StartStep::FirstItem || step == StartStep::Confirm;
    Flown flight = at(step, copter());
    // What comes before the question may be older than our plan, however often.
    if (asks) CHECK(flight.plays("other plan, other plan") == "");
    flight.plays("sent, other plan");
    // Only a question is sent again.
    CHECK((flight.sending.state() == CommandTransfer::State::Due) == asks);
    // One that names ours in between takes the doubt away.
    CHECK(Flown(flight).plays("idle at 65534, other plan") == "");
    CHECK(flight.plays("other plan") == (step == StartStep::FirstItem ? "Unproven" : "Leaving, asks"));
  }
}

TEST_CASE("of an autopilot whose modes are not known no mode is another one") {
  Flown flight(Firmware::Other, kCopter);
  CHECK(flight.aircraft.autoMode == kNoMode);
  flight.flies(StartStep::Confirm);
  CHECK(flight.plays("shows armed 77, current 0") == "Shown, Done (armed)");
}

TEST_CASE("after its start() an aircraft that flies another plan is disarmed if start() has armed it, and else left") {
  const struct {
    const char *script, *leads;
  } kCases[] = {
      {"shows", "Disarming"},
      {"shows, sent, shows disarmed", "Disarming, disarm, Unproven (disarmed)"},
      {"shows rtl", "Unproven (armed)"},  // somebody has it
      {"shows disarmed", "Unproven (disarmed)"},
  };
  for (const auto& one : kCases) {
    Flown flight = copter().inFlight();
    CHECK((flight.start.leaveFlying(StartArming::Armed, flight.aircraft, flight.sending) == Status::Transferring));
    CHECK((flight.start.step() == StartStep::Confirm));
    CHECK(flight.start.isLeaving());
    CHECK(flight.asks());
    CHECK(flight.plays(one.script) == one.leads);
  }
  Flown left = copter().inFlight();
  CHECK((left.start.leaveFlying(StartArming::Untouched, left.aircraft, left.sending) == Status::Unproven));
  CHECK((left.start.arming() == StartArming::Untouched));
  CHECK((left.start.step() == StartStep::Confirm));
}
