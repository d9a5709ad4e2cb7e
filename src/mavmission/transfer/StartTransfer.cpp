#include "StartTransfer.h"

#include <string.h>

#include "../autopilot/FlightMode.h"
#include "../autopilot/VehicleKind.h"
#include "../base/FloatBits.h"
#include "../base/MavlinkHeaders.h"
#include "../plan/ItemNumbers.h"

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

bool isVehicle(const Aircraft& aircraft, Vehicle vehicle) { return vehicleOf(aircraft.vehicleType) == vehicle; }

}  // namespace

void StartTransfer::begin(uint16_t first, bool isMission, Firmware firmware) {
  first_ = first;
  lookFromFirst(firmware);
  if (!isMission) looked_ = kCannotLook;
  setState(State::Looking);
}

// The wire item with which the flight begins, which is never home.
uint16_t StartTransfer::firstItem(Firmware firmware) const { return ItemNumbers::firstFlown(first_, firmware); }

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
  if (item.command == kDoJump && wholeNumber(&item.param2) != 0) {
    // In a loop with nothing to fly, a jump "for ever" never gets out. Any other jump is followed once here, and passed
    // by the second time.
    if (jump_ == next_ && isNegative(item.param2)) return Status::NothingToFly;
    if (jump_ != next_) {
      jump_ = next_;
      next_ = static_cast<uint16_t>(wholeNumber(&item.param1));
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
    order_.begin(aircraft.mode, aircraft.autoMode == kNoMode ? kNoMode : aircraft.mode);
    // An aircraft that flies its mission already would fly to a newly set current item at once: skip these steps.
    wasFlying_ = aircraft.isArmed && aircraft.mode == aircraft.autoMode;
    isArmedSeen_ = aircraft.isArmed;
    if (wasFlying_ != 0) setStep(StartStep::Begin);
    return nextStep(aircraft, sending);
  }
  if (found != Status::Done) return Status::OtherItem;
  if (isThere) return Status::Done;
  // The first item may be completed at once, if a rover or a submarine is there already or an aircraft in the air need
  // not climb.
  const bool isLow = isVehicle(aircraft, Vehicle::Rover) || isVehicle(aircraft, Vehicle::Submarine);
  const bool mayBeThrough = isLow || arming() != StartArming::Armed;
  if (state() == State::JudgingNext || !mayBeThrough || wasFlying_ != 0) return Status::OtherItem;
  setState(State::JudgingNext);
  ++next_;
  return Status::Transferring;
}

// Continues with the next step that this vehicle needs.
Status StartTransfer::nextStep(const Aircraft& aircraft, CommandTransfer& sending) {
  setState(State::Steps);
  do {
    ++step_;
  } while (!beginStep(aircraft, sending));
  return Status::Transferring;
}

// The mode in which it is armed: a rover in MANUAL, a copter, which refuses to be armed in AUTO, in GUIDED, and any
// other vehicle in its current mode.
uint16_t StartTransfer::readyMode(const Aircraft& aircraft) const {
  const bool isRover = isVehicle(aircraft, Vehicle::Rover);
  const bool isReady = !has(aircraft.firmware, kFliesByMode) || !(isRover || isVehicle(aircraft, Vehicle::Copter));
  if (isReady) return aircraft.mode;
  return modeNumber(isRover ? FlightMode::Manual : FlightMode::Guided, aircraft.firmware, aircraft.vehicleType);
}

// False if this vehicle does not need this step.
bool StartTransfer::beginStep(const Aircraft& aircraft, CommandTransfer& sending) {
  const Firmware firmware = aircraft.firmware;
  const bool armsByMissionStart = has(firmware, kArmsByMissionStart);
  // MISSION_START sets AUTO by itself. A copter on the ground needs it to take off, and gets nothing else: each order
  // may undo what a pilot has set. The others fly by the mode alone.
  const bool fliesByModeAlone = has(firmware, kFliesByMode) && !isVehicle(aircraft, Vehicle::Copter);
  switch (step()) {
    case StartStep::None:  // comes before the first step
    case StartStep::ReadyMode: {
      const uint16_t ready = readyMode(aircraft);
      if (aircraft.isArmed || aircraft.mode == ready) return false;
      order_.begin(aircraft.mode, ready);
      break;
    }
    case StartStep::FirstItem: seen_ = kNoItem; break;
    case StartStep::Arm:
      if (armsByMissionStart || aircraft.isArmed) return false;
      setArming(StartArming::Armed);
      break;
    case StartStep::AutoMode:
      if (!fliesByModeAlone) return false;
      beganS_ = aircraft.seconds;
      order_.begin(order_.wanted(), aircraft.autoMode);
      break;
    case StartStep::Begin:
      if (fliesByModeAlone) return false;
      if (armsByMissionStart && !aircraft.isArmed) setArming(StartArming::Armed);
      order_.begin(order_.wanted(), aircraft.autoMode);
      break;
    case StartStep::Confirm: seen_ = kNoItem; break;
  }
  const uint16_t nowMs = aircraft.nowMs;
  sending.next(true);
  if (step() == StartStep::Confirm) {
    if (has(firmware, kSaysCurrentUnasked)) sending.listen(kConfirmMs, nowMs);
  } else if (step() != StartStep::FirstItem) {
    if (step() != StartStep::Arm) isSent_ = 0;
  }
  return true;
}

StartTransfer::Message StartTransfer::message() const {
  if (state() == State::Disarming || state() == State::Yielding) return Message::Disarm;
  if (state() == State::Restoring) return Message::Mode;
  if (state() == State::Asking || step() == StartStep::Confirm) return Message::AskCurrent;
  // No switch: avr-gcc makes a table of it, in RAM.
  if (step() == StartStep::FirstItem) return Message::FirstItem;
  if (step() == StartStep::Arm) return Message::Arm;
  if (step() == StartStep::Begin) return Message::Start;
  return Message::Mode;
}

// Every step but Begin is confirmed by the change that it causes in the heartbeat or in MISSION_CURRENT.
Status StartTransfer::onAccepted(const Aircraft& aircraft, CommandTransfer& sending) {
  const bool isConfirmed = state() == State::Steps && step() == StartStep::Begin;
  if (!isConfirmed) {
    // What shows it disarmed from now on, somebody has done.
    if (message() == Message::Arm) isArmedSeen_ = 1;
    if (message() != Message::AskCurrent) sending.ask();
    return Status::Transferring;
  }
  isSent_ = 1;
  nextStep(aircraft, sending);
  sending.ask();
  return Status::Transferring;
}

// What start() does when the autopilot refuses: it tries again, ends, or leaves.
Status StartTransfer::onRefused(Status refusal, const Aircraft& aircraft, CommandTransfer& sending) {
  if (state() == State::Disarming) return refusal_;
  if (state() == State::Yielding) {
    if (isArmedSeen_ == 0) setArming(StartArming::Untouched);  // the arming was refused
    return refusal_;
  }
  if (state() == State::Restoring) return notRestored();
  if (message() == Message::AskCurrent) return Status::Transferring;  // MISSION_CURRENT may come unasked
  const bool isTriedAgain = step() == StartStep::AutoMode && isVehicle(aircraft, Vehicle::Rover) &&
                            static_cast<uint16_t>(aircraft.seconds - beganS_) < kAutoTriesS;
  if (isTriedAgain) {
    sending.next(true);
    sending.pause(kAutoAgainMs, aircraft.nowMs);
    return Status::Transferring;
  }
  const bool wasFirst = isArmingStep(aircraft.firmware) && sending.tries() == 1;
  if (wasFirst && !aircraft.isArmed) setArming(StartArming::Untouched);
  return leave(refusal, aircraft, sending);
}

Status StartTransfer::onSilent(Status silence, const Aircraft& aircraft, CommandTransfer& sending) {
  if (isLeaving() && silence == Status::TookTooLong) return Status::Transferring;
  if (state() == State::Restoring) return notRestored();
  if (isLeaving()) return refusal_;
  if (step() == StartStep::FirstItem && seen_ != kNoItem) return Status::OtherItem;
  if (step() == StartStep::Confirm) {
    if (silence == Status::NoAnswer) silence = Status::Unconfirmed;
    if (aircraft.mode == aircraft.autoMode) return silence;  // the aircraft may be flying: do not disarm
  }
  return leave(silence, aircraft, sending);
}

bool StartTransfer::isArmingStep(Firmware firmware) const {
  return step() == StartStep::Arm || (step() == StartStep::Begin && has(firmware, kArmsByMissionStart));
}

// Ends a start() that cannot succeed. If start() has armed the vehicle, the vehicle is disarmed first, once a heartbeat
// shows that it is armed and that nobody else has taken over. A PX4 that refuses to begin may have changed its mode all
// the same: a heartbeat shows that, too.
Status StartTransfer::leave(Status refusal, const Aircraft& aircraft, CommandTransfer& sending) {
  const bool mayHaveChanged = step() == StartStep::Begin && has(aircraft.firmware, kArmsByMissionStart);
  if (arming() != StartArming::Armed && !mayHaveChanged) return refusal;
  refusal_ = refusal;
  setState(State::Leaving);
  sending.rest();
  sending.listen(FinderRules::kLostMs, aircraft.nowMs);
  sending.ask();
  return Status::Transferring;
}

// Sets the mode order_.wanted(), which a step has undone, at once; start() ends with `refusal` then.
Status StartTransfer::restore(Status refusal, CommandTransfer& sending) {
  refusal_ = refusal;
  setState(State::Restoring);
  sending.restore();
  return Status::Transferring;
}

Status StartTransfer::notRestored() const { return refusal_ == Status::TakenOver ? Status::Overruled : refusal_; }

Status StartTransfer::onHeartbeatLeaving(const Aircraft& aircraft, CommandTransfer& sending) {
  const bool armsByMissionStart = has(aircraft.firmware, kArmsByMissionStart);
  const bool isWanted = aircraft.mode == order_.wanted() || aircraft.autoMode == kNoMode;
  const bool isTaken = !isWanted && !order_.isFrom(aircraft.mode);
  // It began after all; but another plan than ours is not left to it.
  const bool hasBegun = armsByMissionStart && isWanted && aircraft.isArmed && refusal_ != Status::Unproven;
  const bool isOurArming = arming() == StartArming::Armed;
  if (isOurArming && !aircraft.isArmed) {
    const bool wasArmed = state() == State::Disarming || isArmedSeen_ != 0 || !isArmingStep(aircraft.firmware);
    setArming(wasArmed ? StartArming::Disarmed : StartArming::Untouched);
  }
  if (armsByMissionStart && !aircraft.isArmed && isWanted && !order_.isFrom(order_.wanted())) {
    order_.turn();
    return restore(refusal_, sending);
  }
  if (!aircraft.isArmed || !isOurArming || isTaken || hasBegun) return refusal_;
  if (state() == State::Leaving) {
    setState(State::Disarming);
    sending.next(true);
  }
  return Status::Transferring;
}

// Somebody has set another mode before the arming, which is on its way. If it comes about all the same, nobody but
// start() has armed the aircraft: it is disarmed.
Status StartTransfer::giveWay(const Aircraft& aircraft, CommandTransfer& sending) {
  refusal_ = Status::TakenOver;
  isArmedSeen_ = 0;
  setState(State::Yielding);
  sending.rest();
  sending.listen(FinderRules::kLostMs, aircraft.nowMs);
  sending.askLater();
  return Status::Transferring;
}

Status StartTransfer::onHeartbeatYielding(const Aircraft& aircraft, CommandTransfer& sending) {
  if (!aircraft.isArmed) {
    const bool mayCome = isArmedSeen_ == 0 && sending.mayBeUnderWay(aircraft.nowMs);
    if (!mayCome) {
      setArming(isArmedSeen_ != 0 ? StartArming::Disarmed : StartArming::Untouched);
      return refusal_;
    }
    sending.askLater();
  } else if (isArmedSeen_ == 0) {
    isArmedSeen_ = 1;
    sending.next(true);
  }
  return Status::Transferring;
}

Status StartTransfer::onHeartbeat(const Aircraft& aircraft, CommandTransfer& sending) {
  if (state() == State::Yielding) return onHeartbeatYielding(aircraft, sending);
  if (state() == State::Leaving || state() == State::Disarming) return onHeartbeatLeaving(aircraft, sending);
  const bool isRestoring = state() == State::Restoring;
  const bool isSent = sending.tries() != 0;
  const bool setsMode = step() == StartStep::ReadyMode || step() == StartStep::AutoMode || step() == StartStep::Begin;
  if (setsMode && isSent) isSent_ = 1;
  if (aircraft.isArmed) {
    // Somebody else has armed it.
    if (step() == StartStep::Arm && !isSent) setArming(StartArming::Untouched);
    isArmedSeen_ = 1;
  } else if (arming() == StartArming::Armed) {
    // PX4 has accepted MISSION_START, which arms: somebody has disarmed it before a heartbeat has shown it.
    if (step() == StartStep::Confirm && !sending.mayBeUnderWay(aircraft.nowMs)) isArmedSeen_ = 1;
    if (isArmedSeen_ != 0) setArming(StartArming::Disarmed);
  }
  const bool mayBeArmed =
      step() == StartStep::Arm && !isRestoring && isSent && !aircraft.isArmed && sending.mayBeUnderWay(aircraft.nowMs);
  switch (
      order_.onHeartbeat(aircraft.mode, isRestoring ? isSent : isSent_ != 0, sending.mayBeUnderWay(aircraft.nowMs))) {
    case ModeOrder::Sight::Foreign:
      if (isRestoring) return refusal_;
      if (mayBeArmed) return giveWay(aircraft, sending);
      if (isArmingStep(aircraft.firmware) && !isSent && isArmedSeen_ == 0) setArming(StartArming::Untouched);
      return Status::TakenOver;
    case ModeOrder::Sight::Doubtful:
      if (mayBeArmed) return giveWay(aircraft, sending);
      sending.doubt();
      return Status::Transferring;
    case ModeOrder::Sight::Undone: return restore(Status::TakenOver, sending);
    case ModeOrder::Sight::Wanted:
      if (isRestoring) return refusal_;
      return onOwnMode(true, aircraft, sending);
    case ModeOrder::Sight::Before: break;
  }
  return isRestoring ? Status::Transferring : onOwnMode(false, aircraft, sending);
}

// A heartbeat that shows the wanted mode, or the one before.
Status StartTransfer::onOwnMode(bool isWanted, const Aircraft& aircraft, CommandTransfer& sending) {
  if (sending.isOld()) {
    sending.ask();
    return Status::Transferring;
  }
  const bool isSent = sending.tries() != 0;
  const bool isFlying = aircraft.isArmed && isWanted;
  if (!aircraft.isArmed && isArmedSeen_ != 0) return Status::NotArmed;
  // PX4 sets the mode before it arms: armed in the mode of before, it is somebody else's.
  const bool isOdd =
      aircraft.isArmed && !isWanted && arming() == StartArming::Armed && has(aircraft.firmware, kArmsByMissionStart);
  const bool isPutBack = isOdd && !sending.mayBeUnderWay(aircraft.nowMs);
  bool isDone = false;
  switch (step()) {
    case StartStep::ReadyMode:
    case StartStep::AutoMode: isDone = isWanted; break;
    case StartStep::Arm: isDone = aircraft.isArmed; break;
    case StartStep::Begin:
      isDone = isSent && isFlying;
      if (isSent && isPutBack) return Status::TakenOver;
      if (isSent && isOdd) sending.askLater();
      break;
    case StartStep::Confirm:
      if (isPutBack) return Status::TakenOver;
      if (!isFlying) {
        setState(State::Steps);
        sending.askLater();
      } else if (!isJudging()) {
        setState(State::Shown);
      }
      return confirm(aircraft.firmware);
    case StartStep::None:
    case StartStep::FirstItem: break;
  }
  if (!isDone) return Status::Transferring;
  nextStep(aircraft, sending);
  if (step() == StartStep::Confirm) setState(State::Shown);
  return Status::Transferring;
}

Status StartTransfer::onOtherNamed(const Aircraft& aircraft, CommandTransfer& sending) {
  const bool asks = step() == StartStep::FirstItem || step() == StartStep::Confirm;
  if (isLeaving() || (asks && sending.tries() == 0 && isDoubted_ == 0)) return Status::Transferring;
  if (isDoubted_ != 0) return onOther(aircraft, sending);
  // The message may be older than our plan: a second one decides.
  isDoubted_ = 1;
  if (asks && sending.state() == CommandTransfer::State::Sent) sending.next(true);
  return Status::Transferring;
}

Status StartTransfer::onOther(const Aircraft& aircraft, CommandTransfer& sending) {
  return leave(Status::Unproven, aircraft, sending);
}

Status StartTransfer::leaveFlying(StartArming arming, const Aircraft& aircraft, CommandTransfer& sending) {
  setState(State::Steps);
  setStep(StartStep::Confirm);
  setArming(arming);
  isArmedSeen_ = 1;
  order_.begin(aircraft.autoMode, aircraft.autoMode);  // any other mode is somebody else's
  return onOther(aircraft, sending);
}

Status StartTransfer::onCurrent(uint16_t item, bool isUnderWay, const Aircraft& aircraft, CommandTransfer& sending) {
  isDoubted_ = 0;
  if (step() == StartStep::FirstItem) {
    if (sending.tries() == 0) return Status::Transferring;
    seen_ = item;
    if (!has(aircraft.firmware, kNamesFlownItems)) {
      return item == first_ ? nextStep(aircraft, sending) : Status::Transferring;
    }
    if (state() != State::Asking) {
      // ArduPilot's answer names the item as it was set, or is a message that came unasked: request MISSION_CURRENT to
      // learn the actual item.
      if (item != first_ && item != next_) return Status::Transferring;
      seen_ = kNoItem;
      setState(State::Asking);
      sending.next(true);
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
  if (state() != State::Shown || seen_ == kNoItem) return Status::Transferring;
  const bool namesFlownItems = has(firmware, kNamesFlownItems);
  if (seen_ == (namesFlownItems ? next_ : first_)) return Status::Done;
  if (looked_ == kCannotLook) return namesFlownItems && next_ == kNoItem ? Status::Unconfirmed : Status::OtherItem;
  setState(State::Judging);
  lookFromFirst(firmware);
  return Status::Transferring;
}

}  // namespace detail
}  // namespace mavmission
