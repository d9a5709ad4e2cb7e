#include "FlightStages.h"

namespace mavmission {
namespace detail {

bool FlightStages::takeNews() {
  const bool wasNew = isNew_;
  isNew_ = false;
  return wasNew;
}

void FlightStages::change(FlightState state) {
  if (state_ != state) sinceMs_ = nowMs_;
  state_ = state;
  isNew_ = true;
}

void FlightStages::end(EndedBy who, Status why) {
  endedBy_ = who;
  why_ = why;
  order_ = FlightOrder::None;
  change(who == EndedBy::Itself ? FlightState::Landed : FlightState::Ended);
}

// Somebody else has it: who, its mode says.
void FlightStages::endBy(const FlightSight& sight, Status why) {
  const bool isFailsafe = sight.hands == FlightHands::Failsafe || sight.hands == FlightHands::Unclear;
  end(isFailsafe ? EndedBy::Failsafe : EndedBy::Pilot, why);
}

// --- What the sketch wants

Status FlightStages::begin(FlightOrder first) {
  if (isUnderWay() || running_ != FlightOrder::None) return Status::Busy;
  if (state_ == FlightState::Ended) return why_;
  order_ = first;
  after_ = FlightOrder::None;
  tries_ = 0;
  endedBy_ = EndedBy::Nobody;
  why_ = Status::Idle;
  wasSilent_ = isSilent_ = isGivenUp_ = false;
  beganMs_ = nowMs_;
  change(FlightState::Preparing);
  return Status::Transferring;
}

Status FlightStages::take(FlightOrder what) {
  const Status status = begin(what);
  if (status == Status::Transferring) change(FlightState::Flying);
  return status;
}

void FlightStages::forget() {
  if (isUnderWay() || state_ == FlightState::Idle) return;
  hasHeard_ = seenDisarmed_ = knowsRest_ = false;
  change(FlightState::Idle);
}

Status FlightStages::order(FlightOrder what) {
  const bool comesDown = what == FlightOrder::Home || what == FlightOrder::Land;
  if (isWaiting() && comesDown) {
    giveUp(what);
    return Status::Transferring;
  }
  if (!isInFlight()) return state_ == FlightState::Ended ? why_ : Status::NotFlying;
  order_ = what;
  tries_ = 0;
  change(FlightState::Flying);
  return Status::Transferring;
}

void FlightStages::giveUp(FlightOrder ifItFlies) {
  if (!isWaiting()) return;
  isGivenUp_ = true;
  after_ = ifItFlies;
  // What may have armed it already is not broken off: its end tells whether it flies.
  if (!setsModes()) end(EndedBy::Sketch, Status::Cancelled);
}

// --- What happens

void FlightStages::look(const FlightSight& sight, bool isBeat) {
  if (sight.isHeard) heardMs_ = static_cast<uint16_t>(nowMs_);
  switch (state_) {
    case FlightState::Idle:
    case FlightState::Ended: return;
    case FlightState::Preparing:
    case FlightState::NotReady:
    case FlightState::Landed: return lookAtGround(sight);
    case FlightState::Flying:
    case FlightState::AtStop:
      if (!sight.isHeard) wasSilent_ = isSilent_ = true;
      if (!sight.isHeard || !isBeat) return;
      lookInFlight(sight);
      isSilent_ = false;
  }
}

// Whoever arms it, sets another mode or pulls the cable stands beside it: so nothing is armed any more.
void FlightStages::lookAtGround(const FlightSight& sight) {
  if (!sight.isHeard) {
    // What may have armed it already is not broken off.
    const bool isGone =
        !sight.isLossy || static_cast<uint16_t>(static_cast<uint16_t>(nowMs_) - heardMs_) >= kLossySilenceMs;
    if (isGone && hasHeard_ && !(setsModes() && sight.isArmed)) return end(EndedBy::Silence, Status::NoAutopilot);
  } else if (setsModes()) {
    return;  // the end of that operation tells
  } else {
    hasHeard_ = true;
    if (sight.isArmed) return end(seenDisarmed_ ? EndedBy::Pilot : EndedBy::Refusal, Status::Armed);
    seenDisarmed_ = true;
    const bool isSame = sight.mode == restModes_[0] || sight.mode == restModes_[1] || sight.mayRest;
    if (knowsRest_ && !isSame) return endBy(sight, Status::TakenOver);
  }
  const uint32_t limitS = limitS_ != 0 ? limitS_ : kReadyS;
  if (state_ == FlightState::Landed || running_ != FlightOrder::None || nowMs_ - beganMs_ < limitS * 1000) return;
  end(EndedBy::Refusal, why_ != Status::Idle ? why_ : Status::NoAutopilot);
}

void FlightStages::lookInFlight(const FlightSight& sight) {
  if (!sight.isArmed) {
    if (wasSilent_) return end(EndedBy::Silence, Status::NoAutopilot);
    if (!sight.isOver) return end(EndedBy::Pilot, Status::NotArmed);
    restModes_[0] = restModes_[1] = sight.mode;
    knowsRest_ = true;
    return end(EndedBy::Itself, Status::Done);
  }
  // An order in the air looks itself who has the aircraft, after newer heartbeats.
  if (running_ != FlightOrder::None && running_ != FlightOrder::Disarm) return;
  if (sight.isOtherPlan) return end(EndedBy::OtherStation, Status::Unproven);
  switch (sight.hands) {
    // After a silence nobody knows whose mode it is.
    case FlightHands::Pilot: return end(isSilent_ ? EndedBy::Silence : EndedBy::Pilot, Status::PilotHasIt);
    case FlightHands::Failsafe: return end(EndedBy::Failsafe, Status::FailsafeHasIt);
    case FlightHands::Unclear:
      if (++beats_ > kUnclearBeats) end(EndedBy::Failsafe, Status::FailsafeHasIt);
      return;
    case FlightHands::Own: break;
  }
  if (!sight.staysArmed) {
    beats_ = 0;
  } else if (order_ == FlightOrder::None && running_ == FlightOrder::None && ++beats_ > kArrivedBeats) {
    order_ = FlightOrder::Disarm;
    tries_ = 0;
  }
}

void FlightStages::fly() {
  why_ = Status::Done;
  beats_ = 0;
  tries_ = 0;
  order_ = after_;
  change(FlightState::Flying);
}

void FlightStages::onEnd(Status status, const FlightSight& sight, bool hasArmed) {
  const FlightOrder what = running_;
  running_ = FlightOrder::None;
  if (state_ == FlightState::Ended) return;
  switch (what) {
    case FlightOrder::None: return;
    case FlightOrder::Upload:
      if (status != Status::Accepted && status != Status::AlreadyAboard) break;
      order_ = FlightOrder::Start;
      tries_ = 0;
      return;
    case FlightOrder::Start:
    case FlightOrder::TakeOff: {
      restModes_[1] = sight.mode;
      knowsRest_ = true;
      // It flies, if not from its first item on, or without saying so: what follows is seen by its heartbeats.
      const bool mayFly = status == Status::Done || status == Status::OtherItem || status == Status::Unconfirmed;
      if (mayFly && sight.isArmed) return fly();
      break;
    }
    case FlightOrder::GoTo:
    case FlightOrder::Home:
    case FlightOrder::Land:
      if (status != Status::Done) break;
      why_ = status;
      return;
    case FlightOrder::Disarm:
      if (status == Status::Done) return;  // the heartbeat that shows it ends the flight
  }
  onRefused(what, status, sight, hasArmed);
}

void FlightStages::onRefused(FlightOrder what, Status status, const FlightSight& sight, bool hasArmed) {
  switch (status) {
    case Status::PilotHasIt: return end(EndedBy::Pilot, status);
    case Status::FailsafeHasIt: return end(EndedBy::Failsafe, status);
    case Status::FliesOtherPlan: return end(EndedBy::OtherStation, status);
    case Status::TakenOver:
    case Status::Overruled: return endBy(sight, status);
    case Status::Armed: return end(seenDisarmed_ ? EndedBy::Pilot : EndedBy::Refusal, status);
    case Status::NotArmed:
      if (isInFlight()) return;  // the next heartbeat tells why
      return end(EndedBy::Pilot, status);
    default: break;
  }
  if (sight.isOtherPlan) return end(EndedBy::OtherStation, status);
  // PX4 denies the start of a plan that it has only just taken. Its current item may be asked for in vain.
  const bool isEarly = status == Status::CommandDenied && what == FlightOrder::Start && tries_ == 1;
  const bool isAgain = isWorthRetry(status) || status == Status::NoHome || status == Status::OtherItem || isEarly;
  triedMs_ = nowMs_;
  if (isInFlight()) {
    if (isAgain && tries_ < kOrderTries) {
      order_ = what;
      return;
    }
    why_ = status;
    return change(FlightState::AtStop);
  }
  // The line was lost while it took off: it may be in the air, and then it has to be brought down.
  if (what == FlightOrder::TakeOff && sight.isArmed && isAgain) return fly();
  if (isGivenUp_) return end(EndedBy::Sketch, Status::Cancelled);
  if (!isAgain || hasArmed || sight.isArmed) return end(EndedBy::Refusal, status);
  order_ = what;
  if (state_ != FlightState::NotReady || why_ != status) {
    why_ = status;
    change(FlightState::NotReady);
  }
}

// --- What to do

FlightOrder FlightStages::due(bool isHeard) const {
  if (running_ != FlightOrder::None || order_ == FlightOrder::None || !isHeard) return FlightOrder::None;
  if (isWaiting() && !seenDisarmed_) return FlightOrder::None;
  const bool isUnproven = order_ == FlightOrder::Upload && why_ == Status::Unconfirmed;
  const uint16_t pauseMs = isInFlight() ? kOrderAgainMs : isUnproven ? kProvenAgainMs : kReadyAgainMs;
  return tries_ == 0 || nowMs_ - triedMs_ >= pauseMs ? order_ : FlightOrder::None;
}

void FlightStages::begun(uint16_t mode) {
  running_ = order_;
  order_ = FlightOrder::None;
  if (tries_ != 255) ++tries_;
  triedMs_ = nowMs_;
  if (setsModes()) restModes_[0] = mode;
}

bool FlightStages::takeBreak() {
  const bool isBroken = running_ != FlightOrder::None && running_ != FlightOrder::Upload;
  if (state_ != FlightState::Ended || !isBroken) return false;
  running_ = FlightOrder::None;
  return true;
}

}  // namespace detail
}  // namespace mavmission
