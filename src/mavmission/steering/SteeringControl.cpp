// Steering: somebody else may take the aircraft while an order is under way.
//
// MAVLink has no command that changes a mode only if it is still the one that was seen. So what changes the mode leaves
// right after a heartbeat (CommandTransfer::guard()), and what each heartbeat shows is judged here (ModeOrder).
#include "../client/CommandPort.h"
#include "Steering.h"
#include "SteeringNumbers.h"

namespace mavmission {
using namespace detail;

// True if the step's order takes the aircraft out of the mode in which it was.
bool Steering::changesMode() const {
  return step_ == SteerStep::Mode || (step_ == SteerStep::Command && oldMode_ != change_.wanted());
}

// To be called before each event is looked at: the client sends after them.
void Steering::noteSent() {
  if (client_.commands().sending().tries() == 0) return;
  if (step_ == SteerStep::Arm) hasArmed_ = true;
  if (changesMode()) isOrdered_ = true;
  // From now on it may fly elsewhere.
  if (step_ == SteerStep::Mode || (step_ == SteerStep::Command && !is(kAdjusts))) forgetTarget();
}

Status Steering::onHeartbeat(uint16_t nowMs) {
  CommandTransfer& sending = client_.commands().sending();
  if (step_ == SteerStep::Disarm) return client_.autopilot().isArmed() ? Status::Transferring : refusal_;
  const uint16_t shown = shownMode();
  const bool isUnderWay = isOrdered_ && sending.mayBeUnderWay(nowMs);
  // What the takeoff has armed, or has found armed, somebody has disarmed. (The arming may only have been answered.)
  const bool wasArmed = step_ > SteerStep::Arm || (step_ == SteerStep::Arm && isAnswered_ && sending.isDue());
  const bool isDisarmed = client_.commands().hasBeenDisarmed() || (wasArmed && !client_.autopilot().isArmed());
  if (is(kFromGround) && isDisarmed && step_ != SteerStep::GiveBack) {
    client_.noteTaken(Status::PilotHasIt);
    return Status::NotArmed;
  }
  if (isFailsafe() && (!isUnderWay || shown == change_.wanted())) return leaveTo(Status::FailsafeHasIt);
  const bool hasTakenOff = change_.wanted() == kPx4TakeOff && hasClimbed();
  // An order that begins at the top waits for the position that tells whose HOLD it is.
  if (mayHaveClimbed()) {
    sending.doubt();
    return Status::Transferring;
  }
  if (oldMode_ == kPx4TakeOff && ownMode_ == shown && !isOrdered_) lead(shown, change_.wanted());
  switch (change_.onHeartbeat(hasTakenOff ? kPx4TakeOff : shown, isOrdered_, isUnderWay)) {
    case ModeOrder::Sight::Before:
      // It has taken the order, and left that mode by itself: again would be the same.
      if (step_ == SteerStep::Mode && isAnswered_ && sending.isDue()) return leave(Status::Unconfirmed);
      break;
    case ModeOrder::Sight::Wanted:
      if (change_.isRestoring()) return leaveTo(whoFlies());
      // Not by this order: somebody else has set its mode.
      if (!isOrdered_ && oldMode_ != change_.wanted()) return leaveTo(whoFlies());
      if (!sending.isOld()) return onOwnMode(nowMs);
      sending.ask();
      return Status::Transferring;
    case ModeOrder::Sight::Doubtful:
      isModeSeen_ = false;
      sending.doubt();
      return Status::Transferring;
    case ModeOrder::Sight::Foreign: return leaveTo(whoFlies());
    case ModeOrder::Sight::Undone: return giveBack();
  }
  const bool isArmed = step_ == SteerStep::Arm && sending.tries() != 0 && client_.autopilot().isArmed();
  return isArmed ? nextStep(nowMs) : Status::Transferring;
}

// The mode of the order is shown.
Status Steering::onOwnMode(uint16_t nowMs) {
  if (isDenied_) return refusal_;
  isModeSeen_ = true;
  ownMode_ = shownMode();
  hadControl_ = client_.autopilot().isArmed();
  // PX4 takes off in a mode that its takeoff command alone sets: that mode stands for the acceptance, and no repeat is
  // sent.
  const bool isTakingOff = isOrdered_ && step_ == SteerStep::Command && ownMode_ == kPx4TakeOff;
  if (step_ == SteerStep::Mode || isTakingOff) return nextStep(nowMs);
  const bool isArmed =
      step_ == SteerStep::Arm && client_.commands().sending().tries() != 0 && client_.autopilot().isArmed();
  return isArmed ? nextStep(nowMs) : Status::Transferring;
}

// The aircraft is somebody else's. If this operation has armed it, and it stands on the ground, it is disarmed first:
// in the air autopilots refuse that.
Status Steering::leaveTo(Status other) {
  client_.noteTaken(other);
  if (!hasArmed_ || isInAir()) return other;
  refusal_ = other;
  step_ = SteerStep::Disarm;
  client_.commands().sending().next(true);
  return Status::Transferring;
}

Status Steering::giveBack() {
  CommandTransfer& sending = client_.commands().sending();
  step_ = SteerStep::GiveBack;
  ownMode_ = kNoMode;
  forgetTarget();
  sending.restore();  // a heartbeat has just come: it leaves at once
  return Status::Transferring;
}

}  // namespace mavmission
