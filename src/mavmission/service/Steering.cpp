#include "../Steering.h"

#include <Arduino.h>
#include <string.h>

#include "../MissionClient.h"
#include "../base/FloatBits.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;
namespace {

const MessageKey kSteered[] PROGMEM = {
    MAVMISSION_LISTENER_KEY(HEARTBEAT),
    MAVMISSION_LISTENER_KEY(GLOBAL_POSITION_INT),
    MAVMISSION_LISTENER_KEY(POSITION_TARGET_GLOBAL_INT),
    MAVMISSION_LISTENER_KEY(EXTENDED_SYS_STATE),
};

constexpr float kPositionUs = 500000;
constexpr int32_t kMostHeightCm = 1000000;
constexpr int32_t kMostSpeedCm = 10000;
constexpr uint8_t kSameE7 = 2;   // PX4 cuts the last digit of a target
constexpr uint8_t kSameCm = 10;  // and gives its altitude as a float

// PX4's mode while it takes off, in the numbers of modeNumber(); it goes over to HOLD by itself.
constexpr uint16_t kPx4TakeOff = 4 | 2 << 8;

// A number of metres in centimetres; 0 if it does not fit.
int32_t centimetres(float metres) {
  int32_t bits;
  memcpy(&bits, &metres, sizeof(bits));
  return timesWhole(bits, 100);
}

bool isNear(int32_t a, int32_t b, int32_t within) {
  const int32_t apart = a - b;
  return apart <= within && apart >= -within;
}

// True for a finite number of 2^17 and more, or of -2^17 and less.
bool isHuge(float value) {
  uint8_t bytes[sizeof(value)];
  memcpy(bytes, &value, sizeof(value));
  return static_cast<uint8_t>(bytes[3] << 1 | bytes[2] >> 7) >= 127 + 17;
}

}  // namespace

Steering::Steering(MissionClient& client) : Listener(client, kSteered, sizeof(kSteered) / sizeof(kSteered[0]), take) {
  // A global object is zero already; so is this one wherever it lies.
  target_ = wanted_ = Place{LatLon(), 0, Above::Nothing, false};
  seaCm_ = homeCm_ = 0;
  value_ = 0;
  ownMode_ = oldMode_ = wantedMode_ = kNoMode;
  beganS_ = 0;
  order_ = Order::TakeOff;
  frame_ = Frame::Global;
  step_ = SteerStep::None;
  refusal_ = Status::Idle;
  landedState_ = MAV_LANDED_STATE_UNDEFINED;
  positionAge_ = targetAge_ = 255;
  seenDisarmed_ = hasArmed_ = isModeSeen_ = isHeard_ = isAnswered_ = isTargetSame_ = false;
}

// --- What the sketch calls

Status Steering::begin(Order order) {
  const Status status = client_.beginCommand(fill, on);
  if (status == Status::Busy) return status;
  client_.commanding_.owner = this;
  order_ = order;
  step_ = SteerStep::None;
  hasArmed_ = isModeSeen_ = false;
  return status;
}

Status Steering::takeOff(Metres aboveHome) {
  const Status status = begin(Order::TakeOff);
  if (status == Status::Busy) return status;
  value_ = aboveHome.value;
  frame_ = Frame::GlobalRelative;
  wanted_.hasPlace = false;
  return status;
}

Status Steering::goTo(const LatLon& place, Altitude altitude) {
  const Status status = begin(Order::GoTo);
  if (status == Status::Busy) return status;
  value_ = altitude.metres();
  frame_ = modern(altitude.frame());
  wanted_.at = place;
  wanted_.hasPlace = true;
  return status;
}

Status Steering::pause() { return begin(Order::Pause); }
Status Steering::resume() { return begin(Order::Resume); }
Status Steering::returnHome() { return begin(Order::ReturnHome); }
Status Steering::landNow() { return begin(Order::Land); }

Status Steering::setSpeed(MetresPerSecond speed) {
  const Status status = begin(Order::Speed);
  if (status != Status::Busy) value_ = speed.value;
  return status;
}

bool Steering::isMissionMode() const {
  const uint16_t mission = client_.numberOf(FlightMode::Auto);
  return mission != kNoMode && client_.shownMode() == mission;
}

// PX4 says CRITICAL while a failsafe flies, in whatever mode: HOLD, which is ours as well, is one of them. ArduPilot
// says so for each failsafe, also for one that it is set to ignore; there the mode tells who flies.
bool Steering::isFailsafe() const {
  return has(client_.firmware(), kAltitudesAreAboveSea) &&
         client_.link_.finder().heartbeat().state >= MAV_STATE_CRITICAL;
}

bool Steering::maySteer() const {
  if (!client_.hasAutopilot() || isFailsafe()) return false;
  return isMissionMode() || (ownMode_ != kNoMode && client_.shownMode() == ownMode_);
}

bool Steering::isRunning() const {
  return client_.isBusy() && client_.rest_.isCommanding && client_.commanding_.fill == fill;
}

bool Steering::hasArrived(uint16_t withinCm) const {
  const bool isKnown = positionAge_ <= kFreshBeats && client_.hasAutopilot();
  if (!isKnown || isRunning() || ownMode_ == kNoMode) return false;
  if (target_.above == Above::Home && !isNear(homeCm_, target_.heightCm, withinCm)) return false;
  if (target_.above == Above::Sea && !isNear(seaCm_, target_.heightCm, withinCm)) return false;
  if (!target_.hasPlace) return target_.above != Above::Nothing;
  const LatLon edge = moved(target_.at, withinCm, withinCm);
  return isNear(here_.latitude.e7(), target_.at.latitude.e7(), (edge.latitude - target_.at.latitude).e7()) &&
         isNear(here_.longitude.e7(), target_.at.longitude.e7(), (edge.longitude - target_.at.longitude).e7());
}

// --- What is heard

void Steering::take(Listener& listener, const FrameParser& frame) {
  Steering& self = static_cast<Steering&>(listener);
  if (!self.isFromAutopilot(frame)) return;
  const SteerStep step = self.step_;
  switch (frame.messageId()) {
    case MAVLINK_MSG_ID_HEARTBEAT: return self.takeHeartbeat();
    case MAVLINK_MSG_ID_GLOBAL_POSITION_INT: return self.takePosition(frame);
    case MAVLINK_MSG_ID_POSITION_TARGET_GLOBAL_INT: return self.takeTarget(frame);
    default:
      self.landedState_ = frame.payloadByte(offsetof(mavlink_extended_sys_state_t, landed_state));
      if (step == SteerStep::AskLanded || step == SteerStep::Confirm) self.isHeard_ = true;
  }
}

void Steering::takeHeartbeat() {
  if (positionAge_ != 255) ++positionAge_;
  if (targetAge_ != 255) ++targetAge_;
  const uint16_t shown = client_.shownMode();
  if (!client_.isArmed()) seenDisarmed_ = true;
  // The sketch's own setMode() is about to end.
  const Client::Commanding& running = client_.commanding_;
  const bool isSetting = client_.isBusy() && client_.rest_.isCommanding && running.fill == Client::fillMode;
  if (isSetting && running.transfer.tries() != 0 && running.mode.number == shown) ownMode_ = shown;
  if (shown == ownMode_ && !isFailsafe()) return;
  const bool hasClimbed = ownMode_ == kPx4TakeOff && shown == client_.numberOf(FlightMode::Hold) && !isFailsafe();
  ownMode_ = hasClimbed ? shown : kNoMode;
}

void Steering::takePosition(const FrameParser& frame) {
  typedef mavlink_global_position_int_t Position;
  here_.latitude = Degrees::fromE7(static_cast<int32_t>(frame.payloadLong(offsetof(Position, lat))));
  here_.longitude = Degrees::fromE7(static_cast<int32_t>(frame.payloadLong(offsetof(Position, lon))));
  seaCm_ = static_cast<int32_t>(frame.payloadLong(offsetof(Position, alt))) / 10;
  homeCm_ = static_cast<int32_t>(frame.payloadLong(offsetof(Position, relative_alt))) / 10;
  positionAge_ = 0;
  if (step_ == SteerStep::AskPosition) isHeard_ = true;
}

void Steering::takeTarget(const FrameParser& frame) {
  typedef mavlink_position_target_global_int_t Target;
  targetAge_ = 0;
  if (!is(Order::GoTo)) return;
  const int32_t latitude = static_cast<int32_t>(frame.payloadLong(offsetof(Target, lat_int)));
  const int32_t longitude = static_cast<int32_t>(frame.payloadLong(offsetof(Target, lon_int)));
  float altitude;
  const uint32_t bits = frame.payloadLong(offsetof(Target, alt));
  memcpy(&altitude, &bits, sizeof(altitude));
  // ArduPilot gives its target's altitude as it was told, whatever that is measured from.
  const bool isHeight =
      !has(client_.firmware(), kAltitudesAreAboveSea) || isNear(centimetres(altitude), wanted_.heightCm, kSameCm);
  isTargetSame_ = isHeight && isNear(latitude, wanted_.at.latitude.e7(), kSameE7) &&
                  isNear(longitude, wanted_.at.longitude.e7(), kSameE7);
}

// --- What is refused before anything is sent

Status Steering::refuseField(Status status, ItemField field) {
  client_.rest_.field = field;
  return status;
}

Status Steering::refuseNumbers() {
  const bool hasHeight = is(Order::TakeOff) || is(Order::GoTo);
  if (!hasHeight && !is(Order::Speed)) return Status::Transferring;
  const ItemField field = hasHeight ? ItemField::Height : ItemField::Param2;
  const FloatKind kind = kindOf(&value_);
  if (kind == FloatKind::NotANumber) return refuseField(Status::NotANumber, field);
  if (kind == FloatKind::Infinite) return refuseField(Status::NotFinite, field);
  const int32_t cm = centimetres(value_);
  if (is(Order::Speed)) {
    const bool isSpeed = !isHuge(value_) && cm > 0 && cm <= kMostSpeedCm;
    return isSpeed ? Status::Transferring : refuseField(Status::BadSpeed, field);
  }
  const bool isOut = isHuge(value_) || !isNear(cm, 0, kMostHeightCm) || (is(Order::TakeOff) && cm <= 0);
  if (isOut) return refuseField(Status::BadAltitude, field);
  wanted_.heightCm = cm;
  if (is(Order::TakeOff)) return Status::Transferring;
  const int32_t latitude = wanted_.at.latitude.e7(), longitude = wanted_.at.longitude.e7();
  if (!isNear(latitude, 0, 900000000)) return refuseField(Status::BadLatitude, ItemField::Latitude);
  if (longitude < -1800000000 || longitude > 1800000000) {
    return refuseField(Status::BadLongitude, ItemField::Longitude);
  }
  // ArduPilot refuses 0 N 0 E, and PX4 flies there.
  if (latitude == 0 && longitude == 0) return refuseField(Status::NeedsCoordinates, ItemField::Latitude);
  const bool isTerrain = frame_ == Frame::GlobalTerrain;
  const bool isTaken = isTerrain ? !has(client_.firmware(), kAltitudesAreAboveSea)
                                 : frame_ == Frame::Global || frame_ == Frame::GlobalRelative;
  return isTaken ? Status::Transferring : refuseField(Status::BadFrame, ItemField::Reference);
}

// Who has the aircraft, as a status; Transferring: this sketch, or the mission.
Status Steering::otherHands() const {
  if (maySteer()) return Status::Transferring;
  const uint16_t shown = client_.shownMode();
  const bool isFailsafe = client_.link_.finder().heartbeat().state >= MAV_STATE_CRITICAL ||
                          shown == client_.numberOf(FlightMode::ReturnToLaunch) ||
                          shown == client_.numberOf(FlightMode::Land);
  return isFailsafe ? Status::FailsafeHasIt : Status::PilotHasIt;
}

bool Steering::isGround() const {
  const uint8_t type = client_.link_.finder().heartbeat().vehicleType;
  return type == MAV_TYPE_GROUND_ROVER || type == MAV_TYPE_SURFACE_BOAT;
}

// ArduPilot's heartbeat says ACTIVE in the air only; PX4's does as soon as it is armed.
bool Steering::isInAir() const {
  if (has(client_.firmware(), kIsActiveInAir)) {
    return client_.isArmed() && client_.link_.finder().heartbeat().state >= MAV_STATE_ACTIVE;
  }
  return landedState_ >= MAV_LANDED_STATE_IN_AIR;
}

// Whether the order fits an aircraft that flies, or one that stands.
Status Steering::judgeFlight() {
  if (is(Order::TakeOff)) return isInAir() ? Status::Armed : Status::Transferring;
  return isGround() || isInAir() ? Status::Transferring : Status::NotFlying;
}

Status Steering::refuse() {
  const Status numbers = refuseNumbers();
  if (numbers != Status::Transferring) return numbers;
  const bool isTakeOff = is(Order::TakeOff);
  if (modeFor(order_) == kNoMode) return Status::NoSuchMode;
  if (client_.isArmed()) {
    if (!seenDisarmed_ && !client_.rest_.armedAllowed) return Status::Armed;
    const Status others = otherHands();
    if (others != Status::Transferring) return others;
  } else if (!isTakeOff) {
    return Status::NotArmed;
  }
  // ArduPilot's rovers and planes have no such command.
  if (isTakeOff && has(client_.firmware(), kFliesByMode) && client_.numberOf(FlightMode::Land) == kNoMode) {
    return Status::CommandUnsupported;
  }
  return has(client_.firmware(), kIsActiveInAir) ? judgeFlight() : Status::Transferring;
}

// The mode that the order leads to.
uint16_t Steering::modeFor(Order order) const {
  switch (order) {
    case Order::Resume: return client_.numberOf(FlightMode::Auto);
    case Order::ReturnHome: return client_.numberOf(FlightMode::ReturnToLaunch);
    case Order::Land: return client_.numberOf(FlightMode::Land);
    case Order::Speed: return client_.shownMode();
    case Order::TakeOff:
    case Order::GoTo:
    case Order::Pause: break;
  }
  if (!has(client_.firmware(), kAltitudesAreAboveSea)) return client_.numberOf(FlightMode::Guided);
  return is(Order::TakeOff) ? kPx4TakeOff : client_.numberOf(FlightMode::Hold);
}

// --- The steps

Status Steering::on(Client& client, Client::CommandEvent event, Status status, const FrameParser*, uint16_t nowMs) {
  return static_cast<Steering*>(client.commanding_.owner)->onEvent(event, status, nowMs);
}

Status Steering::onEvent(Client::CommandEvent event, Status status, uint16_t nowMs) {
  switch (event) {
    case Client::CommandEvent::Ready: {
      const Status refusal = refuse();
      if (refusal != Status::Transferring) return refusal;
      oldMode_ = client_.shownMode();
      wantedMode_ = modeFor(order_);
      return nextStep(nowMs);
    }
    case Client::CommandEvent::Accepted:
      switch (step_) {
        case SteerStep::Arm:
        case SteerStep::AskHome: return nextStep(nowMs);
        case SteerStep::Command: return is(Order::Speed) ? done() : nextStep(nowMs);
        case SteerStep::Disarm: return refusal_;
        case SteerStep::AskPosition:
          if (!wantsPosition()) return nextStep(nowMs);
          client_.commanding_.transfer.listen(kConfirmMs, nowMs);
          break;
        default: isAnswered_ = true;
      }
      return Status::Transferring;
    case Client::CommandEvent::Refused: return onRefused(status, nowMs);
    case Client::CommandEvent::Silent: return onSilent(status);
    case Client::CommandEvent::Heartbeat: return onHeartbeat(nowMs);
    case Client::CommandEvent::Time: return onTime(nowMs);
    case Client::CommandEvent::Current: break;
  }
  return status;
}

Status Steering::nextStep(uint16_t nowMs) {
  do {
    step_ = static_cast<SteerStep>(static_cast<uint8_t>(step_) + 1);
    if (step_ > SteerStep::Confirm) return done();
  } while (!beginStep(nowMs));
  return Status::Transferring;
}

// PX4 takes each altitude as above the sea.
bool Steering::needsHome() const {
  const bool hasHeight = is(Order::TakeOff) || is(Order::GoTo);
  return hasHeight && isRelative() && has(client_.firmware(), kAltitudesAreAboveSea);
}

// An aircraft that pauses stops by another mode, or, where it flies in that mode already, by a place.
bool Steering::stopsByPlace() const {
  return is(Order::Pause) && (oldMode_ == wantedMode_ || has(client_.firmware(), kAltitudesAreAboveSea));
}

bool Steering::hasCommand() const {
  return is(Order::TakeOff) || is(Order::GoTo) || is(Order::Speed) || stopsByPlace();
}

// True if the command is made of the present position. (PX4 knows by itself where it is.)
bool Steering::wantsPosition() const {
  return needsHome() || (stopsByPlace() && !has(client_.firmware(), kAltitudesAreAboveSea));
}

// False if the order does not need this step on this autopilot.
bool Steering::beginStep(uint16_t nowMs) {
  CommandTransfer& sending = client_.commanding_.transfer;
  const bool isHeartbeatEnough = has(client_.firmware(), kIsActiveInAir);
  const bool isTakeOff = is(Order::TakeOff);
  const bool isFresh = positionAge_ <= kFreshBeats;
  switch (step_) {
    case SteerStep::AskLanded:
      if (isHeartbeatEnough || is(Order::Speed)) return false;
      break;
    case SteerStep::AskHome:
      if (!needsHome()) return false;
      break;
    case SteerStep::AskPosition:
      if (!wantsPosition() && (isFresh || !(isTakeOff || is(Order::GoTo)))) return false;
      break;
    case SteerStep::Mode: {
      const bool isReady = !has(client_.firmware(), kFliesByMode) || client_.shownMode() == wantedMode_;
      if (isTakeOff ? isReady : hasCommand()) return false;
      forgetTarget();
      break;
    }
    case SteerStep::Arm:
      if (!isTakeOff || client_.isArmed()) return false;
      hasArmed_ = true;
      break;
    case SteerStep::Command:
      if (!hasCommand()) return false;
      findWanted();
      if (!is(Order::Speed)) forgetTarget();  // from now on it may fly elsewhere
      break;
    case SteerStep::Confirm:
      if (!hasCommand()) return false;
      break;
    default: break;
  }
  isHeard_ = isAnswered_ = isTargetSame_ = false;
  isModeSeen_ = isModeSeen_ && step_ != SteerStep::Confirm;
  // The first command of an operation may have to wait for late answers to the operation before.
  if (sending.tries() != 0 || sending.state() != CommandTransfer::State::Due) sending.next(true, nowMs);
  if (step_ == SteerStep::AskPosition && isFresh) sending.listen(kConfirmMs, nowMs);  // the next one comes by itself
  if (step_ == SteerStep::Confirm && (isHeartbeatEnough || !isTakeOff)) {
    sending.listen(isTakeOff ? kTakeOffS * 1000u : kConfirmMs, nowMs);
  }
  if (waitsForHeartbeat()) sending.listen(kConfirmMs, nowMs);
  beganS_ = client_.state_.seconds;
  return true;
}

// PX4 tells its mode once a second, ArduPilot as soon as it changes. So what would take PX4 out of a pilot's hands
// leaves right behind a heartbeat. Only a pause, and an aircraft on the ground, do not wait for one.
bool Steering::waitsForHeartbeat() const {
  if (has(client_.firmware(), kIsActiveInAir) || is(Order::Pause) || is(Order::TakeOff)) return false;
  return step_ == SteerStep::Mode || step_ == SteerStep::Command;
}

// What wanted_ is in the numbers of this autopilot.
void Steering::findWanted() {
  if (is(Order::TakeOff)) wanted_.at = LatLon();
  if (is(Order::Pause)) {
    wanted_.at = here_;
    wanted_.heightCm = homeCm_;
    wanted_.hasPlace = true;
    frame_ = Frame::GlobalRelative;
  }
  const bool isAboveSea = frame_ == Frame::Global || needsHome();
  wanted_.above = isGround() || frame_ == Frame::GlobalTerrain ? Above::Nothing : isAboveSea ? Above::Sea : Above::Home;
  if (needsHome()) wanted_.heightCm += seaCm_ - homeCm_;
}

void Steering::fill(Client& client, FlightCommand& command) {
  const Steering& self = *static_cast<const Steering*>(client.commanding_.owner);
  command.id = MAV_CMD_REQUEST_MESSAGE;
  switch (self.step_) {
    case SteerStep::AskHome: command.param1 = MAVLINK_MSG_ID_HOME_POSITION; return;
    case SteerStep::AskPosition:
      command.id = MAV_CMD_SET_MESSAGE_INTERVAL;
      command.param1 = MAVLINK_MSG_ID_GLOBAL_POSITION_INT;
      command.param2 = kPositionUs;
      return;
    case SteerStep::Mode: return Client::fillModeNumber(command, self.wantedMode_);
    case SteerStep::Arm: return Client::fillArm(client, command);
    case SteerStep::Disarm: return Client::fillDisarm(client, command);
    case SteerStep::Command: return self.fillCommand(command);
    default: command.param1 = MAVLINK_MSG_ID_EXTENDED_SYS_STATE;
  }
}

void Steering::fillCommand(FlightCommand& command) const {
  const bool isAboveSea = has(client_.firmware(), kAltitudesAreAboveSea);
  const float unset = Yaw().inDegrees();  // NaN: as it flies
  float height = value_;
  if (needsHome() || is(Order::Pause)) {
    height = quotient(wanted_.heightCm, 1);
    multiply(&height, Times::Hundredth);
  }
  command.param1 = -1;
  command.param4 = unset;
  switch (order_) {
    case Order::Speed:
      command.id = MAV_CMD_DO_CHANGE_SPEED;
      command.param1 = SPEED_TYPE_GROUNDSPEED;
      command.param2 = value_;
      command.param3 = -1;
      command.param4 = 0;
      return;
    case Order::TakeOff:
      command.id = MAV_CMD_NAV_TAKEOFF;
      command.param7 = height;
      if (!isAboveSea) {
        command.param1 = command.param4 = 0;
      } else {
        command.param5 = command.param6 = unset;  // where it stands
      }
      return;
    default: break;
  }
  command.id = MAV_CMD_DO_REPOSITION;
  command.param2 = MAV_DO_REPOSITION_FLAGS_CHANGE_MODE;
  if (isAboveSea && is(Order::Pause)) {  // PX4: stop here
    command.param5 = command.param6 = command.param7 = unset;
    return;
  }
  command.hasPlace = true;
  command.x = wanted_.at.latitude.e7();
  command.y = wanted_.at.longitude.e7();
  command.param7 = height;
  // The numbers that were recorded with ArduPilot; PX4 looks at none.
  command.frame = frame_ == Frame::GlobalTerrain           ? Frame::GlobalTerrainInt
                  : frame_ == Frame::Global || needsHome() ? Frame::Global
                                                           : Frame::GlobalRelativeInt;
}

void Steering::forgetTarget() {
  target_.hasPlace = false;
  target_.above = Above::Nothing;
}

Status Steering::done() {
  if (is(Order::TakeOff) || is(Order::GoTo)) target_ = wanted_;
  return Status::Done;
}

// If a takeoff has armed and cannot go on, the aircraft is disarmed, while it is in our hands.
Status Steering::leave(Status refusal, uint16_t nowMs) {
  const uint16_t shown = client_.shownMode();
  if (!hasArmed_ || (shown != wantedMode_ && shown != oldMode_)) return refusal;
  refusal_ = refusal;
  step_ = SteerStep::Disarm;
  client_.commanding_.transfer.next(true, nowMs);
  return Status::Transferring;
}

Status Steering::onRefused(Status refusal, uint16_t nowMs) {
  switch (step_) {
    case SteerStep::AskHome: return Status::NoHome;
    case SteerStep::AskPosition: return wantsPosition() ? refusal : nextStep(nowMs);
    case SteerStep::Arm: hasArmed_ = false; return refusal;
    case SteerStep::Command:
      // A repeated takeoff is refused by an aircraft that is taking off already.
      if (is(Order::TakeOff) && client_.commanding_.transfer.tries() > 1) return nextStep(nowMs);
      return leave(refusal, nowMs);
    case SteerStep::Confirm: return Status::Transferring;
    case SteerStep::Disarm: return refusal_;
    default: return refusal;
  }
}

Status Steering::onSilent(Status silence) {
  if (silence == Status::TookTooLong) return silence;
  const bool isAnswered = client_.rest_.lastResult == MAV_RESULT_ACCEPTED;
  switch (step_) {
    case SteerStep::Disarm: return refusal_;
    case SteerStep::AskPosition: return needsHome() ? Status::NoHome : silence;
    case SteerStep::Confirm: return Status::Unconfirmed;
    case SteerStep::Mode: return isAnswered ? Status::Unconfirmed : silence;
    default: return silence;
  }
}

Status Steering::onHeartbeat(uint16_t nowMs) {
  const uint16_t shown = client_.shownMode();
  const bool isSent = client_.commanding_.transfer.tries() != 0 || step_ == SteerStep::Confirm;
  const bool hasClimbed = wantedMode_ == kPx4TakeOff && shown == client_.numberOf(FlightMode::Hold) && isInAir();
  const bool isWanted = shown == wantedMode_ || hasClimbed;
  if (step_ == SteerStep::Disarm) return client_.isArmed() ? Status::Transferring : refusal_;
  if (isFailsafe()) return Status::FailsafeHasIt;
  if (isWanted && isSent && step_ >= SteerStep::Mode) {
    isModeSeen_ = true;
    ownMode_ = shown;
  }
  if (!isWanted && (shown != oldMode_ || (isModeSeen_ && step_ != SteerStep::Confirm))) {
    // A mode that nobody here has set. (While it is confirmed, a heartbeat of before may still come.)
    const Status others = otherHands();
    if (others != Status::Transferring) return others;
  }
  CommandTransfer& sending = client_.commanding_.transfer;
  if (waitsForHeartbeat() && sending.state() == CommandTransfer::State::Listening) sending.next(true, nowMs);
  if (step_ == SteerStep::Mode && isSent && isWanted) return nextStep(nowMs);
  if (step_ == SteerStep::Arm && isSent && client_.isArmed()) return nextStep(nowMs);
  return Status::Transferring;
}

Status Steering::onTime(uint16_t nowMs) {
  CommandTransfer& sending = client_.commanding_.transfer;
  switch (step_) {
    case SteerStep::AskLanded: {
      if (!isHeard_ || !isAnswered_) break;  // without the answer, it would be taken for that to the next question
      const Status flight = judgeFlight();
      return flight == Status::Transferring ? nextStep(nowMs) : flight;
    }
    case SteerStep::AskPosition: return isHeard_ ? nextStep(nowMs) : Status::Transferring;
    case SteerStep::Confirm: {
      if (is(Order::TakeOff)) {
        if (isInAir() && isModeSeen_) return done();
        if (isHeard_ && !has(client_.firmware(), kIsActiveInAir)) {  // on the ground still: ask again
          if (static_cast<uint16_t>(client_.state_.seconds - beganS_) >= kTakeOffS) return Status::Unconfirmed;
          isHeard_ = false;
          sending.next(true, nowMs);
          sending.pause(kAskAgainMs, nowMs);
        }
        break;
      }
      const bool isTargetKnown = is(Order::GoTo) && targetAge_ <= kTargetBeats;
      if (isModeSeen_ && (isTargetSame_ || !isTargetKnown)) return done();
      break;
    }
    default: break;
  }
  return Status::Transferring;
}

}  // namespace mavmission
