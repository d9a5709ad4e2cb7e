// MissionClient's start(): the steps that each autopilot needs in order to fly the plan that is aboard.
//
//   New -> Looking ---> Steps: ReadyMode -> FirstItem -> Arm -> AutoMode -> Begin -> Confirm
//                         |                                                            | a heartbeat shows it
//                         | a refusal or a timeout, if start() has armed               v
//                         v                                                          Shown -> Judging -> Done
//                       Leaving ---> Disarming ---> the refusal                                       or OtherItem
#include <Arduino.h>

#include "../MissionClient.h"
#include "../base/FloatBits.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;
namespace {

constexpr uint8_t kCannotLook = 100;  // of items looked at: that many, and it is given up; or they are not at hand

// True for a command that the autopilot flies, and that stays its current item for a while. The other commands are
// carried out on the way.
bool isFlown(uint16_t command) {
  switch (command) {
    case MAV_CMD_NAV_ROI: return false;
    case MAV_CMD_NAV_SET_YAW_SPEED:
    case 42702:  // NAV_SCRIPT_TIME and NAV_ATTITUDE_TIME, of ArduPilot's own dialect
    case 42703: return true;
    default: return command <= MAV_CMD_NAV_LAST;
  }
}

// True for a negative number, which in a jump's repeats means "for ever".
bool isNegative(float number) {
  uint8_t bytes[sizeof(number)];
  memcpy(bytes, &number, sizeof(number));
  return (bytes[3] & 0x80) != 0;
}

bool isRover(uint8_t vehicleType) {
  return vehicleType == MAV_TYPE_GROUND_ROVER || vehicleType == MAV_TYPE_SURFACE_BOAT;
}

}  // namespace

Status MissionClient::start(uint16_t item) {
  const Status status = beginCommand(fillFirst, onStart);
  if (status == Status::Busy) return status;
  setStartStep(StartStep::None);
  setStartArming(StartArming::Untouched);
  commanding_.start.first = item;
  return status;
}

Status Client::onStart(Client& client, CommandEvent event, Status status, const FrameParser* frame, uint16_t nowMs) {
  switch (event) {
    case CommandEvent::Ready: return client.readyToStart(nowMs);
    case CommandEvent::Accepted: {
      // The other steps are confirmed by the change that they cause in the heartbeat or in MISSION_CURRENT.
      const StartStep step = client.startStep();
      const bool isStep = client.commanding_.start.phase == Start::Phase::Steps;
      const bool isConfirmed = isStep && (step == StartStep::Arm || step == StartStep::Begin);
      return isConfirmed ? client.nextStartStep(nowMs) : Status::Transferring;
    }
    case CommandEvent::Refused: return client.onStartRefused(status, nowMs);
    case CommandEvent::Silent: return client.onStartSilent(status, nowMs);
    case CommandEvent::Heartbeat: return client.onStartHeartbeat(nowMs);
    case CommandEvent::Current: return client.onStartCurrent(*frame, nowMs);
    case CommandEvent::Time: break;
  }
  const Start::Phase phase = client.commanding_.start.phase;
  const bool isJudging = phase == Start::Phase::Judging || phase == Start::Phase::JudgingNext;
  return isJudging ? client.judgeStart() : status;
}

// Decides whether the plan may be flown, and from which item on. Returns Checking until that is known.
Status Client::readyToStart(uint16_t nowMs) {
  Start& start = commanding_.start;
  if (start.phase == Start::Phase::New) {
    if (isArmed() && !rest_.armedAllowed) return Status::Armed;
    if (aboard() != Aboard::OurPlan) return Status::Unproven;
    if (rest_.infeasible) return Status::Infeasible;
    const uint16_t item = start.first;
    if (!hasItem(item)) return Status::NoSuchItem;
    plan_.begin(firmware(), link_.finder().heartbeat().vehicleType, PlanType::Mission, rest_.raw);
    // ArduPilot's item 0 is home. When home is set as the current item, ArduPilot resets its jump counters and begins
    // with item 1.
    if (item != 0) start.first = item + homeBefore();
    lookFromFirst();
    if (rest_.planType != PlanType::Mission) start.looked = kCannotLook;  // plan_ is no mission any more
    start.phase = Start::Phase::Looking;
  }
  const Status looked = lookAtItem();
  if (looked == Status::Transferring) return Status::Checking;
  if (looked == Status::NothingToFly) return looked;
  if (looked != Status::Done) {
    start.looked = kCannotLook;
    state_.next = kNoItem;
  }
  start.phase = Start::Phase::Steps;
  start.mode = shownMode();
  // An aircraft that flies its mission already would fly to a newly set current item at once: skip these steps.
  if (isArmed() && shownMode() == numberOf(FlightMode::Auto)) setStartStep(StartStep::Begin);
  return nextStartStep(nowMs);
}

// The wire item with which the flight begins, which is never home.
uint16_t Client::firstItem() const {
  const uint16_t first = commanding_.start.first;
  return first == 0 && plan_.has(kHomeIsItem0) ? 1 : first;
}

void Client::lookFromFirst() {
  Start& start = commanding_.start;
  state_.next = firstItem();
  start.jump = kNoItem;
  start.looked = 0;
}

// Looks at one item on the way from the first item to the one that will be flown first. Returns Transferring to
// continue, Done when state_.next is the item that will be flown, SourceRefused if that item cannot be determined.
Status Client::lookAtItem() {
  Start& start = commanding_.start;
  if (start.looked == kCannotLook) return Status::SourceRefused;
  if (state_.next >= plan_.wireCount()) return Status::NothingToFly;
  if (!link_.canSend() || !claimHeavyWork()) return Status::Transferring;
  const Status read = checkItem(state_.next);
  if (read == Status::Checking) return Status::Transferring;
  if (read != Status::Accepted) return Status::SourceRefused;
  const MissionItem& item = *static_cast<const MissionItem*>(link_.draft());
  ++start.looked;
  if (isFlown(item.command)) return Status::Done;
  if (item.command == MAV_CMD_DO_JUMP_TAG) return Status::SourceRefused;
  if (item.command == kDoJump && wholeNumber(item.param2) != 0) {
    // In a loop with nothing to fly, a jump "for ever" never gets out. Any other jump is followed once here, and passed
    // by the second time.
    if (start.jump == state_.next && isNegative(item.param2)) return Status::NothingToFly;
    if (start.jump != state_.next) {
      start.jump = state_.next;
      state_.next = static_cast<uint16_t>(wholeNumber(item.param1));
      return Status::Transferring;
    }
  }
  ++state_.next;
  return Status::Transferring;
}

// Continues with the next step that this vehicle needs.
Status Client::nextStartStep(uint16_t nowMs) {
  do {
    ++rest_.startStep;
  } while (!beginStartStep(nowMs));
  return Status::Transferring;
}

// False if this vehicle does not need this step.
bool Client::beginStartStep(uint16_t nowMs) {
  const bool armsByMissionStart = plan_.has(kArmsByMissionStart);
  Start& start = commanding_.start;
  switch (startStep()) {
    case StartStep::None: return false;
    case StartStep::ReadyMode: {
      // Copter refuses to be armed in AUTO: it is armed in GUIDED. A rover is armed in MANUAL, a plane in its current
      // mode.
      const uint8_t vehicleType = link_.finder().heartbeat().vehicleType;
      if (!plan_.has(kFliesByMode) || isArmed() || vehicleType == MAV_TYPE_FIXED_WING) return false;
      commanding_.mode = numberOf(isRover(vehicleType) ? FlightMode::Manual : FlightMode::Guided);
      nextCommand(fillMode, nowMs);
      return true;
    }
    case StartStep::FirstItem:
      start.mode = shownMode();
      start.seen = kNoItem;
      nextCommand(fillFirst, nowMs);
      return true;
    case StartStep::Arm:
      if (armsByMissionStart || isArmed()) return false;
      setStartArming(StartArming::Armed);
      nextCommand(fillArm, nowMs);
      return true;
    case StartStep::AutoMode:
      if (!plan_.has(kFliesByMode)) return false;
      start.seen = kNoItem;
      start.beganS = static_cast<uint8_t>(state_.seconds);
      commanding_.mode = numberOf(FlightMode::Auto);
      nextCommand(fillMode, nowMs);
      return true;
    case StartStep::Begin:
      if (armsByMissionStart && !isArmed()) setStartArming(StartArming::Armed);
      nextCommand(fillStart, nowMs);
      return true;
    case StartStep::Confirm:
      start.seen = kNoItem;
      nextCommand(fillAskCurrent, nowMs);
      if (plan_.has(kSaysCurrentUnasked)) commanding_.transfer.listen(StartRules::kConfirmMs, nowMs);
      return true;
  }
  return true;
}

// What start() does when the autopilot refuses: it tries again, ends, or leaves (leaveStart()).
Status Client::onStartRefused(Status status, uint16_t nowMs) {
  Start& start = commanding_.start;
  CommandTransfer& transfer = commanding_.transfer;
  if (start.phase == Start::Phase::Disarming) return start.refusal;
  const StartStep step = startStep();
  if (commanding_.fill == fillAskCurrent) return Status::Transferring;  // MISSION_CURRENT may come unasked
  const bool isTriedAgain = step == StartStep::AutoMode && isRover(link_.finder().heartbeat().vehicleType) &&
                            static_cast<uint8_t>(state_.seconds - start.beganS) < StartRules::kAutoTriesS;
  if (isTriedAgain) {
    transfer.next(true, nowMs);
    transfer.pause(StartRules::kAutoAgainMs, nowMs);
    return Status::Transferring;
  }
  if (isArmingStep() && transfer.tries() == 1 && !isArmed()) setStartArming(StartArming::Untouched);
  return leaveStart(status, nowMs);
}

Status Client::onStartSilent(Status status, uint16_t nowMs) {
  Start& start = commanding_.start;
  if (start.phase == Start::Phase::Leaving || start.phase == Start::Phase::Disarming) {
    return status == Status::TookTooLong ? Status::Transferring : start.refusal;
  }
  if (startStep() == StartStep::FirstItem && start.seen == Start::kOther) {
    setAboard(PlanType::Mission, Aboard::OtherPlan);
    return Status::Unproven;
  }
  if (startStep() == StartStep::FirstItem && start.seen != kNoItem) return otherItem();
  if (startStep() == StartStep::Confirm) {
    if (status == Status::NoAnswer) status = Status::Unconfirmed;
    if (shownMode() == numberOf(FlightMode::Auto)) return status;  // the aircraft may be flying: do not disarm
  }
  return leaveStart(status, nowMs);
}

bool Client::isArmingStep() const {
  return startStep() == StartStep::Arm || (startStep() == StartStep::Begin && plan_.has(kArmsByMissionStart));
}

// Ends a start() that cannot succeed. If start() has armed the vehicle, the vehicle is disarmed first, once a heartbeat
// shows that it is armed and that nobody else has taken over.
Status Client::leaveStart(Status status, uint16_t nowMs) {
  Start& start = commanding_.start;
  if (startArming() != StartArming::Armed) return status;
  start.refusal = status;
  start.phase = Start::Phase::Leaving;
  commanding_.transfer.next(true, nowMs);
  commanding_.transfer.listen(AutopilotFinder::kLostMs, nowMs);
  return Status::Transferring;
}

Status Client::otherItem() {
  state_.failedItem = ownItem(commanding_.start.seen);
  return Status::OtherItem;
}

Status Client::onStartHeartbeat(uint16_t nowMs) {
  Start& start = commanding_.start;
  const StartStep step = startStep();
  const uint16_t mode = shownMode();
  const uint16_t autoMode = numberOf(FlightMode::Auto);
  const bool isAuto = mode == autoMode || autoMode == kNoMode;
  const bool isSent = commanding_.transfer.tries() != 0;
  const StartStep asksForAuto = plan_.has(kArmsByMissionStart) ? StartStep::Begin : StartStep::AutoMode;
  const bool isAskedFor = step > asksForAuto || (step == asksForAuto && isSent);
  if (isAskedFor && mode == autoMode) start.isAutoSeen = 1;
  // Once AUTO has been seen, a change back to the mode in which start() began is somebody else's choice as well.
  const bool isTaken = !isAuto && (start.isAutoSeen != 0 || mode != start.mode);
  const bool isFlying = isArmed() && isAuto;
  const bool isJudging = start.phase == Start::Phase::Judging || start.phase == Start::Phase::JudgingNext;
  if (start.phase == Start::Phase::Leaving || start.phase == Start::Phase::Disarming) {
    const bool wasArmed = start.phase == Start::Phase::Disarming || !isArmingStep();
    if (!isArmed()) setStartArming(wasArmed ? StartArming::Disarmed : StartArming::Untouched);
    const bool hasBegun = step >= StartStep::Begin && plan_.has(kArmsByMissionStart) && isFlying;  // began after all
    if (!isArmed() || isTaken || hasBegun) return start.refusal;
    if (start.phase == Start::Phase::Leaving) {
      start.phase = Start::Phase::Disarming;
      nextCommand(fillDisarm, nowMs);
    }
    return Status::Transferring;
  }
  if (step != StartStep::ReadyMode && isTaken) {
    // AUTO has been requested: the next heartbeat may show AUTO, and the aircraft is then flying.
    if (step == StartStep::AutoMode && isSent && start.seen != mode) {
      start.seen = mode;
      return Status::Transferring;
    }
    if (isArmingStep() && !isSent) setStartArming(StartArming::Untouched);
    return Status::TakenOver;
  }
  bool isDone = false;
  switch (step) {
    case StartStep::ReadyMode:
    case StartStep::AutoMode: isDone = isSent && mode == commanding_.mode; break;
    case StartStep::Arm: isDone = isSent && isArmed(); break;
    case StartStep::Begin: isDone = isSent && plan_.has(kArmsByMissionStart) && isFlying; break;
    case StartStep::Confirm:
      if (!isFlying) start.phase = Start::Phase::Steps;
      if (isFlying && !isJudging) start.phase = Start::Phase::Shown;
      return confirmStart();
    case StartStep::None:
    case StartStep::FirstItem: break;
  }
  return isDone ? nextStartStep(nowMs) : Status::Transferring;
}

Status Client::onStartCurrent(const FrameParser& frame, uint16_t nowMs) {
  Start& start = commanding_.start;
  const mavlink_mission_current_t current = messageFrom<mavlink_mission_current_t>(frame);
  const uint16_t item = current.seq;
  if (startStep() == StartStep::FirstItem) {
    if (commanding_.transfer.tries() == 0) return Status::Transferring;
    // The message may be older than our plan: it is no answer then, and the step ends as Unproven if no other comes.
    if (namesOther(frame)) {
      start.seen = Start::kOther;
      return Status::Transferring;
    }
    start.seen = item;
    if (!plan_.has(kNamesFlownItems)) {
      return item == start.first ? nextStartStep(nowMs) : Status::Transferring;
    }
    if (commanding_.fill == fillFirst) {
      // ArduPilot's answer names the item as it was set, or is a message that came unasked: request MISSION_CURRENT to
      // learn the actual item.
      if (item != start.first && item != state_.next) return Status::Transferring;
      start.seen = kNoItem;
      nextCommand(fillAskCurrent, nowMs);
      return Status::Transferring;
    }
    if (state_.next == kNoItem && item != 0) state_.next = item;
    // On the ground, the current item may still be the first of the commands that are carried out before the first item
    // that is flown. It may also be home, from which ArduPilot begins with its first item.
    const bool isAtHome = item == 0 && start.first == 0 && state_.next != kNoItem;
    return isAtHome || item == state_.next || item == firstItem() ? nextStartStep(nowMs) : Status::Transferring;
  }
  if (startStep() != StartStep::Confirm) return Status::Transferring;
  if (current.mission_state != MISSION_STATE_UNKNOWN && current.mission_state != MISSION_STATE_ACTIVE) {
    return Status::Transferring;
  }
  if (start.phase <= Start::Phase::Shown) start.seen = item;
  return confirmStart();
}

// Confirms the start, once a heartbeat has shown that the aircraft flies and MISSION_CURRENT has named its item.
Status Client::confirmStart() {
  Start& start = commanding_.start;
  if (start.phase != Start::Phase::Shown || start.seen == kNoItem) return Status::Transferring;
  const bool namesFlownItems = plan_.has(kNamesFlownItems);
  if (start.seen == (namesFlownItems ? state_.next : start.first)) return Status::Done;
  if (start.looked == kCannotLook) return namesFlownItems && state_.next == kNoItem ? Status::Unconfirmed : otherItem();
  start.phase = Start::Phase::Judging;
  lookFromFirst();
  return Status::Transferring;
}

// Decides whether the current item is the one to begin with. ArduPilot names only items that are flown, PX4 also the
// commands on the way to them.
Status Client::judgeStart() {
  Start& start = commanding_.start;
  const bool isThere = start.seen == state_.next;
  if (isThere && !plan_.has(kNamesFlownItems)) return Status::Done;
  const Status looked = lookAtItem();
  if (looked == Status::Transferring) return looked;
  if (looked != Status::Done) return otherItem();
  if (isThere) return Status::Done;
  // The first item may be completed at once, if a rover already stands there or an aircraft in the air need not climb.
  const bool mayBeThrough = isRover(link_.finder().heartbeat().vehicleType) || startArming() != StartArming::Armed;
  const bool wasSetBack = start.mode != numberOf(FlightMode::Auto);
  if (start.phase == Start::Phase::JudgingNext || !mayBeThrough || !wasSetBack) return otherItem();
  start.phase = Start::Phase::JudgingNext;
  ++state_.next;
  return Status::Transferring;
}

void Client::fillFirst(Client& client, FlightCommand& command) {
  command.x = client.commanding_.start.first;  // MISSION_SET_CURRENT
}

void Client::fillAskCurrent(Client&, FlightCommand& command) {
  command.id = MAV_CMD_REQUEST_MESSAGE;
  command.param1 = MAVLINK_MSG_ID_MISSION_CURRENT;
}

void Client::fillStart(Client& client, FlightCommand& command) {
  command.id = MAV_CMD_MISSION_START;  // ArduPilot wants parameters of 0; PX4 begins with the item in param1
  if (client.plan_.has(kArmsByMissionStart)) command.param1 = client.commanding_.start.first;
}

void Client::fillBegin(Client&, FlightCommand& command) { command.id = MAV_CMD_MISSION_START; }

Status MissionClient::startMission() { return beginCommand(fillBegin, onStartMission); }

Status Client::onStartMission(Client& client, CommandEvent event, Status status, const FrameParser* frame,
                              uint16_t nowMs) {
  const bool arms = has(client.firmware(), kArmsByMissionStart);
  if (event != CommandEvent::Ready) return arms ? onMode(client, event, status, frame, nowMs) : status;
  if (!client.isArmed()) return Status::NotArmed;
  if (arms) {
    // MAV_CMD_MISSION_START, which would arm, is not sent: an armed aircraft flies its mission by the mode alone.
    client.commanding_.mode = client.numberOf(FlightMode::Auto);
    client.commanding_.fill = fillMode;
  }
  return status;
}

}  // namespace mavmission
