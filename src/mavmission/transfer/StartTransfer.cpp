#include "StartTransfer.h"

#include <string.h>

#include "../FlightMode.h"
#include "../base/FloatBits.h"
#include "../base/MavlinkHeaders.h"

namespace mavmission {
namespace detail {
namespace {

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
  uint8_t bytes[sizeof(number)] = {};
  memcpy(bytes, &number, sizeof(number));
  return (bytes[3] & 0x80) != 0;
}

bool isRover(const Aircraft& aircraft) {
  return aircraft.vehicleType == MAV_TYPE_GROUND_ROVER || aircraft.vehicleType == MAV_TYPE_SURFACE_BOAT;
}

}  // namespace

void StartTransfer::begin(uint16_t first, bool isMission, Firmware firmware) {
  first_ = first;
  lookFromFirst(firmware);
  if (!isMission) looked_ = kCannotLook;
  state_ = State::Looking;
}

// The wire item with which the flight begins, which is never home.
uint16_t StartTransfer::firstItem(Firmware firmware) const {
  return first_ == 0 && has(firmware, kHomeIsItem0) ? 1 : first_;
}

void StartTransfer::lookFromFirst(Firmware firmware) {
  next_ = firstItem(firmware);
  jump_ = kNoItem;
  looked_ = 0;
}

// Decides about a look at an item. ArduPilot names only items that are flown, PX4 also the commands on the way to them.
Status StartTransfer::wantsItem(uint16_t items, Firmware firmware) const {
  if (isJudging() && seen_ == next_ && !has(firmware, kNamesFlownItems)) return Status::Done;
  if (looked_ == kCannotLook) return Status::SourceRefused;
  return next_ >= items ? Status::NothingToFly : Status::Accepted;
}

// Follows the way from the first item to the one that will be flown first. Returns Transferring to continue with item
// next_, Done when next_ is the item that will be flown, SourceRefused if that item cannot be determined.
Status StartTransfer::follow(const MissionItem& item) {
  ++looked_;
  if (isFlown(item.command)) return Status::Done;
  if (item.command == MAV_CMD_DO_JUMP_TAG) return Status::SourceRefused;
  if (item.command == kDoJump && wholeNumber(item.param2) != 0) {
    // In a loop with nothing to fly, a jump "for ever" never gets out. Any other jump is followed once here, and passed
    // by the second time.
    if (jump_ == next_ && isNegative(item.param2)) return Status::NothingToFly;
    if (jump_ != next_) {
      jump_ = next_;
      next_ = static_cast<uint16_t>(wholeNumber(item.param1));
      return Status::Transferring;
    }
  }
  ++next_;
  return Status::Transferring;
}

Status StartTransfer::onItem(Status read, const MissionItem* item, const Aircraft& aircraft, CommandTransfer& sending) {
  const bool isThere = seen_ == next_;
  const Status found = read == Status::Accepted ? follow(*item) : read;
  if (found == Status::Transferring) return found;
  if (isLooking()) {
    if (found == Status::NothingToFly) return found;
    if (found != Status::Done) {
      looked_ = kCannotLook;
      next_ = kNoItem;
    }
    mode_ = aircraft.mode;
    // An aircraft that flies its mission already would fly to a newly set current item at once: skip these steps.
    if (aircraft.isArmed && aircraft.mode == aircraft.autoMode) setStep(StartStep::Begin);
    return nextStep(aircraft, sending);
  }
  if (found != Status::Done) return Status::OtherItem;
  if (isThere) return Status::Done;
  // The first item may be completed at once, if a rover already stands there or an aircraft in the air need not climb.
  const bool mayBeThrough = isRover(aircraft) || arming() != StartArming::Armed;
  const bool wasSetBack = mode_ != aircraft.autoMode;
  if (state_ == State::JudgingNext || !mayBeThrough || !wasSetBack) return Status::OtherItem;
  state_ = State::JudgingNext;
  ++next_;
  return Status::Transferring;
}

// Continues with the next step that this vehicle needs.
Status StartTransfer::nextStep(const Aircraft& aircraft, CommandTransfer& sending) {
  state_ = State::Steps;
  do {
    ++step_;
  } while (!beginStep(aircraft, sending));
  return Status::Transferring;
}

// False if this vehicle does not need this step.
bool StartTransfer::beginStep(const Aircraft& aircraft, CommandTransfer& sending) {
  const Firmware firmware = aircraft.firmware;
  const bool armsByMissionStart = has(firmware, kArmsByMissionStart);
  switch (step()) {
    case StartStep::None:  // comes before the first step
    case StartStep::ReadyMode:
      // Copter refuses to be armed in AUTO: it is armed in GUIDED. A rover is armed in MANUAL, a plane in its current
      // mode.
      if (!has(firmware, kFliesByMode) || aircraft.isArmed || aircraft.vehicleType == MAV_TYPE_FIXED_WING) return false;
      break;
    case StartStep::FirstItem:
      mode_ = aircraft.mode;
      seen_ = kNoItem;
      break;
    case StartStep::Arm:
      if (armsByMissionStart || aircraft.isArmed) return false;
      setArming(StartArming::Armed);
      break;
    case StartStep::AutoMode:
      if (!has(firmware, kFliesByMode)) return false;
      seen_ = kNoItem;
      beganS_ = aircraft.seconds;
      break;
    case StartStep::Begin:
      if (armsByMissionStart && !aircraft.isArmed) setArming(StartArming::Armed);
      break;
    case StartStep::Confirm: seen_ = kNoItem; break;
  }
  sending.next(true, aircraft.nowMs);
  if (step() == StartStep::Confirm && has(firmware, kSaysCurrentUnasked)) sending.listen(kConfirmMs, aircraft.nowMs);
  return true;
}

StartTransfer::Message StartTransfer::message() const {
  if (state_ == State::Disarming) return Message::Disarm;
  if (state_ == State::Asking || step() == StartStep::Confirm) return Message::AskCurrent;
  // No switch: avr-gcc makes a table of it, in RAM.
  if (step() == StartStep::FirstItem) return Message::FirstItem;
  if (step() == StartStep::Arm) return Message::Arm;
  if (step() == StartStep::Begin) return Message::Start;
  return Message::Mode;
}

uint16_t StartTransfer::modeToSet(const Aircraft& aircraft) const {
  if (step() == StartStep::AutoMode) return aircraft.autoMode;
  return modeNumber(isRover(aircraft) ? FlightMode::Manual : FlightMode::Guided, aircraft.firmware,
                    aircraft.vehicleType);
}

// The other steps are confirmed by the change that they cause in the heartbeat or in MISSION_CURRENT.
Status StartTransfer::onAccepted(const Aircraft& aircraft, CommandTransfer& sending) {
  const bool isConfirmed = state_ == State::Steps && (step() == StartStep::Arm || step() == StartStep::Begin);
  return isConfirmed ? nextStep(aircraft, sending) : Status::Transferring;
}

// What start() does when the autopilot refuses: it tries again, ends, or leaves.
Status StartTransfer::onRefused(Status refusal, const Aircraft& aircraft, CommandTransfer& sending) {
  if (state_ == State::Disarming) return refusal_;
  if (message() == Message::AskCurrent) return Status::Transferring;  // MISSION_CURRENT may come unasked
  const bool isTriedAgain = step() == StartStep::AutoMode && isRover(aircraft) &&
                            static_cast<uint16_t>(aircraft.seconds - beganS_) < kAutoTriesS;
  if (isTriedAgain) {
    sending.next(true, aircraft.nowMs);
    sending.pause(kAutoAgainMs, aircraft.nowMs);
    return Status::Transferring;
  }
  const bool wasFirst = isArmingStep(aircraft.firmware) && sending.tries() == 1;
  if (wasFirst && !aircraft.isArmed) setArming(StartArming::Untouched);
  return leave(refusal, aircraft.nowMs, sending);
}

Status StartTransfer::onSilent(Status silence, const Aircraft& aircraft, CommandTransfer& sending) {
  if (state_ >= State::Leaving) return silence == Status::TookTooLong ? Status::Transferring : refusal_;
  if (step() == StartStep::FirstItem && seen_ == kOtherPlan) return Status::Unproven;
  if (step() == StartStep::FirstItem && seen_ != kNoItem) return Status::OtherItem;
  if (step() == StartStep::Confirm) {
    if (silence == Status::NoAnswer) silence = Status::Unconfirmed;
    if (aircraft.mode == aircraft.autoMode) return silence;  // the aircraft may be flying: do not disarm
  }
  return leave(silence, aircraft.nowMs, sending);
}

bool StartTransfer::isArmingStep(Firmware firmware) const {
  return step() == StartStep::Arm || (step() == StartStep::Begin && has(firmware, kArmsByMissionStart));
}

// Ends a start() that cannot succeed. If start() has armed the vehicle, the vehicle is disarmed first, once a heartbeat
// shows that it is armed and that nobody else has taken over.
Status StartTransfer::leave(Status refusal, uint16_t nowMs, CommandTransfer& sending) {
  if (arming() != StartArming::Armed) return refusal;
  refusal_ = refusal;
  state_ = State::Leaving;
  sending.rest(nowMs);
  sending.listen(FinderRules::kLostMs, nowMs);
  return Status::Transferring;
}

Status StartTransfer::onHeartbeat(const Aircraft& aircraft, CommandTransfer& sending) {
  const Firmware firmware = aircraft.firmware;
  const bool armsByMissionStart = has(firmware, kArmsByMissionStart);
  const uint16_t mode = aircraft.mode;
  const uint16_t autoMode = aircraft.autoMode;
  const bool isAuto = mode == autoMode || autoMode == kNoMode;
  const bool isSent = sending.tries() != 0;
  const StartStep asksForAuto = armsByMissionStart ? StartStep::Begin : StartStep::AutoMode;
  const bool isAskedFor = step() > asksForAuto || (step() == asksForAuto && isSent);
  if (isAskedFor && mode == autoMode) isAutoSeen_ = 1;
  // Once AUTO has been seen, a change back to the mode in which start() began is somebody else's choice as well.
  const bool isTaken = !isAuto && (isAutoSeen_ != 0 || mode != mode_);
  const bool isFlying = aircraft.isArmed && isAuto;
  if (state_ >= State::Leaving) {
    const bool wasArmed = state_ == State::Disarming || !isArmingStep(firmware);
    if (!aircraft.isArmed) setArming(wasArmed ? StartArming::Disarmed : StartArming::Untouched);
    const bool hasBegun = armsByMissionStart && isFlying;  // began after all
    if (!aircraft.isArmed || isTaken || hasBegun) return refusal_;
    if (state_ == State::Leaving) {
      state_ = State::Disarming;
      sending.next(true, aircraft.nowMs);
    }
    return Status::Transferring;
  }
  if (step() != StartStep::ReadyMode && isTaken) {
    // AUTO has been requested: the next heartbeat may show AUTO, and the aircraft is then flying.
    if (step() == StartStep::AutoMode && isSent && seen_ != mode) {
      seen_ = mode;
      return Status::Transferring;
    }
    if (isArmingStep(firmware) && !isSent) setArming(StartArming::Untouched);
    return Status::TakenOver;
  }
  bool isDone = false;
  switch (step()) {
    case StartStep::ReadyMode:
    case StartStep::AutoMode: isDone = isSent && mode == modeToSet(aircraft); break;
    case StartStep::Arm: isDone = isSent && aircraft.isArmed; break;
    case StartStep::Begin: isDone = isSent && armsByMissionStart && isFlying; break;
    case StartStep::Confirm:
      if (!isFlying) state_ = State::Steps;
      if (isFlying && !isJudging()) state_ = State::Shown;
      return confirm(firmware);
    case StartStep::None:
    case StartStep::FirstItem: break;
  }
  return isDone ? nextStep(aircraft, sending) : Status::Transferring;
}

Status StartTransfer::onCurrent(uint16_t item, bool isUnderWay, const Aircraft& aircraft, CommandTransfer& sending) {
  if (step() == StartStep::FirstItem) {
    if (sending.tries() == 0) return Status::Transferring;
    seen_ = item;
    // The message may be older than our plan, and no answer then.
    if (item == kOtherPlan) return Status::Transferring;
    if (!has(aircraft.firmware, kNamesFlownItems)) {
      return item == first_ ? nextStep(aircraft, sending) : Status::Transferring;
    }
    if (state_ != State::Asking) {
      // ArduPilot's answer names the item as it was set, or is a message that came unasked: request MISSION_CURRENT to
      // learn the actual item.
      if (item != first_ && item != next_) return Status::Transferring;
      seen_ = kNoItem;
      state_ = State::Asking;
      sending.next(true, aircraft.nowMs);
      return Status::Transferring;
    }
    if (next_ == kNoItem && item != 0) next_ = item;
    // On the ground, the current item may still be the first of the commands that are carried out before the first item
    // that is flown. It may also be home, from which ArduPilot begins with its first item.
    const bool isAtHome = item == 0 && first_ == 0 && next_ != kNoItem;
    const bool isFirst = isAtHome || item == next_ || item == firstItem(aircraft.firmware);
    return isFirst ? nextStep(aircraft, sending) : Status::Transferring;
  }
  if (step() != StartStep::Confirm || !isUnderWay) return Status::Transferring;
  if (!isJudging()) seen_ = item;
  return confirm(aircraft.firmware);
}

// Confirms the start, once a heartbeat has shown that the aircraft flies and MISSION_CURRENT has named its item.
Status StartTransfer::confirm(Firmware firmware) {
  if (state_ != State::Shown || seen_ == kNoItem) return Status::Transferring;
  const bool namesFlownItems = has(firmware, kNamesFlownItems);
  if (seen_ == (namesFlownItems ? next_ : first_)) return Status::Done;
  if (looked_ == kCannotLook) return namesFlownItems && next_ == kNoItem ? Status::Unconfirmed : Status::OtherItem;
  state_ = State::Judging;
  lookFromFirst(firmware);
  return Status::Transferring;
}

}  // namespace detail
}  // namespace mavmission
