// Steering: the steps of an order, one after the other, and what each event leads to.
#include "Steering.h"

#include "../client/CommandPort.h"
#include "../link/Messages.h"
#include "SteeringNumbers.h"

namespace mavmission {
using namespace detail;
namespace {

constexpr float kPositionUs = 500000;

}  // namespace

Status Steering::on(Client& client, CommandEvent event, Status status, const FrameParser*, uint16_t nowMs) {
  CommandPort& commands = CommandPort::of(client);
  if (commands.isAskingVehicle()) return commands.onVehicle(event, status, fill);
  return static_cast<Steering*>(CommandPort::ownerOf(client))->onEvent(event, status, nowMs);
}

Status Steering::onEvent(CommandEvent event, Status status, uint16_t nowMs) {
  noteSent();
  switch (event) {
    case CommandEvent::Ready: {
      const Status refusal = refuse();
      if (refusal != Status::Transferring || client_.commands().asksVehicle()) return refusal;
      lead(client_.commands().counted(client_.commands().firstMode()), wantedMode());
      if (is(kStopsHere) && isGround() && wantsPosition()) {
        lead(change_.wanted(), client_.commands().numberOf(FlightMode::Hold));
      }
      const Status begun = nextStep(nowMs);
      beganS_ = 0;  // after this event the seconds begin anew
      return begun;
    }
    case CommandEvent::Accepted:
      switch (step_) {
        case SteerStep::Arm:
        case SteerStep::AskHome: return nextStep(nowMs);
        case SteerStep::Mode:
        case SteerStep::GiveBack:
          isAnswered_ = true;
          client_.commands().sending().ask();
          break;
        case SteerStep::Command: return is(kAdjusts) ? done() : nextStep(nowMs);
        case SteerStep::Disarm: return refusal_;
        case SteerStep::AskPosition:
          if (!wantsPosition()) return nextStep(nowMs);
          client_.commands().sending().listen(kConfirmMs, nowMs);
          isAnswered_ = true;
          break;
        default: isAnswered_ = true;
      }
      return Status::Transferring;
    case CommandEvent::Refused: return onRefused(status, nowMs);
    case CommandEvent::Silent: return onSilent(status);
    case CommandEvent::Heartbeat: return onHeartbeat(nowMs);
    case CommandEvent::Time: return onTime(nowMs);
    case CommandEvent::Current: break;
  }
  return status;
}

Status Steering::nextStep(uint16_t nowMs) {
  do {
    step_ = static_cast<SteerStep>(static_cast<uint8_t>(step_) + 1);
    if (step_ > SteerStep::Confirm) {
      if (!is(kStopsHere) || change_.wanted() == wantedMode()) return done();
      lead(change_.wanted(), wantedMode());  // a rover that has been stopped by HOLD
      isOrdered_ = false;
      step_ = SteerStep::Mode;
    }
  } while (!beginStep(nowMs));
  return Status::Transferring;
}

// PX4 takes each altitude as above the sea.
bool Steering::needsHome() const {
  return is(kTakesHeight) && isRelative() && has(client_.autopilot().firmware(), kAltitudesAreAboveSea);
}

// An aircraft that pauses stops by another mode, or, where it flies in that mode already, by a place. (A rover that is
// sent to the place where it is drives on for 18 m at 5 m/s until it can stop, turns, and comes back. So it is set to
// HOLD, and then to GUIDED again, where it stays.)
bool Steering::stopsByPlace() const {
  return is(kStopsHere) && (oldMode_ == change_.wanted() || has(client_.autopilot().firmware(), kUnsetPlaceIsHere));
}

bool Steering::hasCommand() const { return is(kStopsHere) ? stopsByPlace() : row_.command() != OrderCommand::None; }

// True if the command is made of the present position. (PX4 knows by itself where it is.)
bool Steering::wantsPosition() const {
  return needsHome() || (stopsByPlace() && !has(client_.autopilot().firmware(), kUnsetPlaceIsHere));
}

// False if the order does not need this step on this autopilot.
bool Steering::beginStep(uint16_t nowMs) {
  CommandTransfer& sending = client_.commands().sending();
  const bool isHeartbeatEnough = isToldByHeartbeat();
  const bool isTakeOff = is(kFromGround);
  const bool isFresh = isPositionKnown();
  switch (step_) {
    case SteerStep::AskLanded:
      if ((isHeartbeatEnough && !(isTakeOff && isPlane())) || is(kAdjusts)) return false;
      break;
    case SteerStep::AskHome:
      if (!needsHome()) return false;
      break;
    case SteerStep::AskPosition:
      if (!wantsPosition() && (isFresh || !is(kTakesHeight))) return false;
      break;
    case SteerStep::Mode: {
      const uint16_t shown = shownMode();
      // PX4 that is armed in its mission's mode, or in that of a takeoff, takes off at once, and in OFFBOARD, without
      // targets, its failsafe flies it: so not in these.
      const bool isFirstHeld = isTakeOff && !has(client_.autopilot().firmware(), kFliesByMode) &&
                               (shown == client_.commands().numberOf(FlightMode::Auto) || shown == kPx4TakeOff ||
                                shown == client_.commands().numberOf(FlightMode::Guided));
      if (isFirstHeld) lead(shown, client_.commands().numberOf(FlightMode::Hold));
      const bool isReady = !has(client_.autopilot().firmware(), kFliesByMode) || shown == change_.wanted();
      if (isTakeOff ? isReady && !isFirstHeld : hasCommand()) return false;
      break;
    }
    case SteerStep::Arm:
      if (!isTakeOff || client_.autopilot().isArmed()) return false;
      break;
    case SteerStep::Command:
      if (!hasCommand()) return false;
      findWanted();
      if (isTakeOff && change_.wanted() != wantedMode()) {  // it has been made to hold first
        lead(change_.wanted(), wantedMode());
        isOrdered_ = false;
      }
      break;
    case SteerStep::Confirm:
      if (!hasCommand()) return false;
      break;
    default: break;
  }
  isHeard_ = isAnswered_ = isTargetSame_ = false;
  isModeSeen_ = isDenied_ = false;
  // The first command of an operation may have to wait for late answers to the operation before.
  if (sending.tries() != 0 || sending.state() != CommandTransfer::State::Due) sending.next(true);
  if (step_ == SteerStep::AskPosition && isFresh) sending.listen(kConfirmMs, nowMs);  // the next one comes by itself
  if (step_ == SteerStep::Confirm && (isHeartbeatEnough || !isTakeOff)) {
    sending.listen(isTakeOff ? kTakeOffS * 1000u : kConfirmMs, nowMs);
  }
  if (step_ == SteerStep::Confirm) sending.ask();
  beganS_ = client_.seconds();
  return true;
}

// What wanted_ is in the numbers of this autopilot.
void Steering::findWanted() {
  if (is(kFromGround)) wanted_.at = LatLon();
  if (is(kStopsHere)) {
    wanted_.at = here_;
    wanted_.heightCm = homeCm_;
    wanted_.hasPlace = true;
    frame_ = CoordinateFrame::GlobalRelative;
  }
  const bool isAboveSea = frame_ == CoordinateFrame::Global || needsHome();
  wanted_.above = isGround() || frame_ == CoordinateFrame::GlobalTerrain ? Above::Nothing
                  : isAboveSea                                           ? Above::Sea
                                                                         : Above::Home;
  if (needsHome()) wanted_.heightCm += seaCm_ - homeCm_;
}

void Steering::fill(Client& client, FlightCommand& command) {
  static_cast<const Steering*>(CommandPort::ownerOf(client))->fillStep(command);
}

void Steering::fillStep(FlightCommand& command) const {
  command.id = MAV_CMD_REQUEST_MESSAGE;
  switch (step_) {
    case SteerStep::AskHome: command.param1 = MAVLINK_MSG_ID_HOME_POSITION; return;
    case SteerStep::AskPosition:
      command.id = MAV_CMD_SET_MESSAGE_INTERVAL;
      command.param1 = MAVLINK_MSG_ID_GLOBAL_POSITION_INT;
      command.param2 = kPositionUs;
      return;
    case SteerStep::Mode:
    case SteerStep::GiveBack: return CommandPort::fillModeNumber(command, change_.wanted());
    case SteerStep::Arm:
    case SteerStep::Disarm: return CommandPort::fillArming(command, step_ == SteerStep::Arm);
    case SteerStep::Command: return fillCommand(command);
    default: command.param1 = MAVLINK_MSG_ID_EXTENDED_SYS_STATE;
  }
}

void Steering::fillCommand(FlightCommand& command) const {
  const bool isUnsetHere = has(client_.autopilot().firmware(), kUnsetPlaceIsHere);
  const float unset = Yaw().inDegrees();  // NaN: as it flies
  float height = value_;
  if (needsHome() || is(kStopsHere)) {
    height = quotient(wanted_.heightCm, 1);
    multiply(&height, Times::Hundredth);
  }
  command.param1 = -1;
  command.param4 = unset;
  switch (row_.command()) {
    case OrderCommand::ChangeSpeed:
      command.id = MAV_CMD_DO_CHANGE_SPEED;
      command.param1 = SPEED_TYPE_GROUNDSPEED;
      command.param2 = value_;
      command.param3 = -1;
      command.param4 = 0;
      return;
    case OrderCommand::TakeOff:
      command.id = MAV_CMD_NAV_TAKEOFF;
      command.param7 = height;
      if (isUnsetHere) {
        command.param5 = command.param6 = unset;  // where it stands
      } else {
        command.param1 = command.param4 = 0;
      }
      return;
    case OrderCommand::None:
    case OrderCommand::Other: command.id = 0; return;  // nobody has filled it: CommandUnsupported
    case OrderCommand::Reposition: break;
  }
  command.id = MAV_CMD_DO_REPOSITION;
  // Without the flag, ArduPilot refuses it in another mode than GUIDED, and PX4 does nothing in another mode than HOLD:
  // so it cannot take control from anybody.
  if (shownMode() != change_.wanted()) command.param2 = MAV_DO_REPOSITION_FLAGS_CHANGE_MODE;
  if (isUnsetHere && is(kStopsHere)) {  // stop here
    command.param5 = command.param6 = command.param7 = unset;
    return;
  }
  command.hasPlace = true;
  command.x = wanted_.at.latitude.e7();
  command.y = wanted_.at.longitude.e7();
  command.param7 = height;
  // The numbers that were recorded with ArduPilot; PX4 looks at none.
  command.frame = frame_ == CoordinateFrame::GlobalTerrain           ? CoordinateFrame::GlobalTerrainInt
                  : frame_ == CoordinateFrame::Global || needsHome() ? CoordinateFrame::Global
                                                                     : CoordinateFrame::GlobalRelativeInt;
}

void Steering::lead(uint16_t from, uint16_t wanted) {
  oldMode_ = from;
  change_.begin(from, wanted);
}

void Steering::forgetTarget() {
  target_.hasPlace = false;
  target_.above = Above::Nothing;
}

Status Steering::done() {
  if (is(kTakesHeight)) target_ = wanted_;
  return Status::Done;
}

// If a takeoff has armed and cannot go on, the aircraft is disarmed, while the sketch is in control. (If it flies all
// the same, autopilots refuse that.)
Status Steering::leave(Status refusal) {
  const uint16_t shown = shownMode();
  if (!hasArmed_ || isInAir() || (shown != change_.wanted() && shown != oldMode_)) return refusal;
  refusal_ = refusal;
  step_ = SteerStep::Disarm;
  client_.commands().sending().next(true);
  return Status::Transferring;
}

Status Steering::onRefused(Status refusal, uint16_t nowMs) {
  switch (step_) {
    case SteerStep::AskHome: return Status::NoHome;
    case SteerStep::AskPosition: return wantsPosition() ? refusal : nextStep(nowMs);
    case SteerStep::Arm: hasArmed_ = false; return refusal;
    case SteerStep::Command:
      // A repeated takeoff is refused by an aircraft that is taking off already.
      if (is(kFromGround) && client_.commands().sending().tries() > 1) return nextStep(nowMs);
      if (row_.command() != OrderCommand::Reposition || shownMode() != change_.wanted()) return leave(refusal);
      if (refusal == Status::CommandUnsupported && has(client_.autopilot().firmware(), kRefusesAndRepositions)) {
        return nextStep(nowMs);
      }
      // Its place, or another mode by now: the next heartbeat tells.
      isDenied_ = true;
      refusal_ = refusal;
      client_.commands().sending().listen(kConfirmMs, nowMs);
      client_.commands().sending().ask();
      return Status::Transferring;
    case SteerStep::Confirm: return Status::Transferring;
    case SteerStep::Disarm: return refusal_;
    case SteerStep::GiveBack: return Status::Overruled;
    default: return refusal;
  }
}

Status Steering::onSilent(Status silence) {
  if (step_ == SteerStep::GiveBack) return Status::Overruled;
  if (silence == Status::TookTooLong) return step_ == SteerStep::Disarm ? Status::Transferring : leave(silence);
  if (isDenied_) return refusal_;
  switch (step_) {
    case SteerStep::Disarm: return refusal_;
    case SteerStep::AskPosition: return needsHome() && isAnswered_ ? Status::NoHome : silence;
    case SteerStep::Confirm: return leave(Status::Unconfirmed);
    case SteerStep::Mode: return isAnswered_ ? Status::Unconfirmed : silence;
    default: return leave(silence);
  }
}

uint16_t Steering::secondsOfStep() const { return static_cast<uint16_t>(client_.seconds() - beganS_); }

Status Steering::onTime(uint16_t nowMs) {
  CommandTransfer& sending = client_.commands().sending();
  switch (step_) {
    case SteerStep::AskLanded: {
      // Without the answer, it would be taken for that to the next question. An autopilot that accepts the question,
      // and never tells, would be asked again and again on a lossy link.
      if (!isHeard_ || !isAnswered_) return secondsOfStep() >= kLandedS ? Status::NoAnswer : Status::Transferring;
      if (is(kFromGround) && isPlane() && !canHover_) return Status::CommandUnsupported;
      const Status flight = judgeFlight();
      return flight == Status::Transferring ? nextStep(nowMs) : flight;
    }
    case SteerStep::AskPosition: return isHeard_ ? nextStep(nowMs) : Status::Transferring;
    case SteerStep::Confirm: {
      if (sending.isOld()) {
        isModeSeen_ = false;
        sending.ask();
        break;
      }
      if (is(kFromGround)) {
        if (!isToldByHeartbeat()) {
          if (sending.state() == CommandTransfer::State::Listening && !isInAir()) sending.next(true);
          // On the ground still, or it does not say.
          if (!isInAir() && secondsOfStep() >= kTakeOffS) return leave(Status::Unconfirmed);
          if (isHeard_) {
            isHeard_ = false;
            sending.next(true);
            if (isInAir()) {  // and who is in control?
              isModeSeen_ = false;
              sending.listen(kConfirmMs, nowMs);
              sending.ask();
              break;
            }
            sending.pause(kAskAgainMs, nowMs);  // then it is asked again
          }
        }
        if (isInAir() && isModeSeen_) return done();
        break;
      }
      const bool isTargetKnown = is(kTakesPlace) && targetAge_ <= kTargetBeats;
      if (isModeSeen_ && (isTargetSame_ || !isTargetKnown)) return done();
      break;
    }
    default: break;
  }
  return Status::Transferring;
}

}  // namespace mavmission
