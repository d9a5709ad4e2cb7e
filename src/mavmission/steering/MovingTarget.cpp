// MovingTarget: follows a place that the sketch gives again and again.
//
//        start()              the mode is shown            stop(), or no renew() for a second
//   Off --------> Starting --------------------> Following -------------------------------> Holding
//    ^               | refused, or cancel()          | another mode, a failsafe,               | the hold is shown,
//    |               |                               | disarmed, or no autopilot               | or refused
//    +---------------+-------------------------------+-----------------------------------------+
//
// Starting and Holding are operations of the client, as Steering's; Following is none, so the client is free meanwhile.
#include "MovingTarget.h"

#include <Arduino.h>
#include <string.h>

#include "../base/Clock.h"
#include "../base/Flash.h"
#include "../base/FloatBits.h"
#include "../client/CommandPort.h"
#include "../link/Messages.h"
#include "../link/Sending.h"

namespace mavmission {
using namespace detail;
namespace {

const MessageKey kBeats[] PROGMEM = {MAVMISSION_LISTENER_KEY(HEARTBEAT)};

typedef mavlink_set_position_target_global_int_t Message;

// The place alone counts.
constexpr uint16_t kPlaceAlone = POSITION_TARGET_TYPEMASK_VX_IGNORE | POSITION_TARGET_TYPEMASK_VY_IGNORE |
                                 POSITION_TARGET_TYPEMASK_VZ_IGNORE | POSITION_TARGET_TYPEMASK_AX_IGNORE |
                                 POSITION_TARGET_TYPEMASK_AY_IGNORE | POSITION_TARGET_TYPEMASK_AZ_IGNORE |
                                 POSITION_TARGET_TYPEMASK_YAW_IGNORE | POSITION_TARGET_TYPEMASK_YAW_RATE_IGNORE;

}  // namespace

MovingTarget::MovingTarget(Steering& steering) : MovingTarget(steering, nullptr) {}

MovingTarget::MovingTarget(Steering& steering, Other other)
    : Listener(steering, kBeats, 1, take),
      steering_(steering),
      other_(other),
      renewedMs_(0),
      timeoutMs_(kTimeoutMs),
      sentMs_(0),
      beganMs_(0),
      blindMs_(0),
      askedMs_(0),
      mode_(kNoMode),
      at_(),
      heightCm_(0),
      frame_(CoordinateFrame::Global),
      status_(Status::Idle),
      toReturn_(Status::Idle),
      ending_(Status::Idle),
      stage_(Stage::Off),
      isBlind_(false),
      isStopped_(false),
      hasSent_(false),
      isOrdered_(false),
      isAimed_(false),
      isHere_(false),
      isWithdrawn_(true) {
  static_assert(
      sizeof(payload_) == sizeof(Message) && sizeof(Message) == MAVLINK_MSG_ID_SET_POSITION_TARGET_GLOBAL_INT_LEN,
      "the struct of a message must have the layout of its payload on the wire");
}

// --- What the sketch calls

Status MovingTarget::start(const LatLon& place, Altitude altitude) {
  if (stage_ != Stage::Off) return Status::Busy;
  const Status status = steering_.goTo(place, altitude);
  if (status == Status::Busy) return status;
  begin();
  renew(place, altitude);  // a number that cannot be meant is refused by the order, too
  return status;
}

// The same, with a target that is no place.
Status MovingTarget::startOther() {
  if (stage_ != Stage::Off) return Status::Busy;
  const Status status = steering_.begin(rowOf(Order::Stream));
  if (status != Status::Busy) begin();
  return status;
}

// The order of the Steering has begun.
void MovingTarget::begin() {
  takeOver();
  stage_ = Stage::Starting;
  status_ = Status::Transferring;
  toReturn_ = Status::Idle;
  frame_ = steering_.frame_;
  isBlind_ = isStopped_ = hasSent_ = isOrdered_ = isHere_ = false;
  isAimed_ = true;
  renewedMs_ = millis();
}

// Why no target is taken any more; Transferring: it is.
Status MovingTarget::whyClosed() const {
  if (stage_ == Stage::Off) return status_;
  if (stage_ == Stage::Holding) return ending_;
  if (isLate()) return isStopped_ ? Status::Cancelled : Status::NotRenewed;
  return Status::Transferring;
}

// The numbers are checked as those of goTo(), beside an order that may be running.
Status MovingTarget::renew(const LatLon& place, Altitude altitude) {
  const Status closed = whyClosed();
  if (closed != Status::Transferring) return closed;
  Steering& checks = steering_;
  if (modern(altitude.frame()) != frame_) return checks.refuseField(Status::BadFrame, ItemField::Reference);
  int32_t heightCm;
  Status status = checks.refuseHeight(altitude.metres(), &heightCm);
  if (status == Status::Transferring) status = checks.refusePlace(place, frame_);
  if (status != Status::Transferring) return status;
  at_ = place;
  heightCm_ = heightCm;
  renewedMs_ = millis();
  return status;
}

void MovingTarget::stop() { isStopped_ = true; }

Status MovingTarget::update() {
  const uint32_t exactMs = millis();
  const uint16_t nowMs = static_cast<uint16_t>(exactMs);
  look(exactMs);
  switch (stage_) {
    case Stage::Off: break;
    case Stage::Starting:
      // cancel(), or no autopilot in the time allowed: what else ends it comes by on().
      if (!isOperating()) {
        const Status ended = client_.outcome();
        finish(isEnd(ended) ? ended : Status::Cancelled);
      } else if (needsStream() && steering_.step_ == SteerStep::Mode && !client_.commands().sending().isUrgent()) {
        if (isLate()) aimHere();
        send(nowMs);
      }
      break;
    case Stage::Following: follow(nowMs); break;
    case Stage::Holding: keepHolding(nowMs); break;
  }
  const Status ended = toReturn_;
  toReturn_ = Status::Idle;
  if (ended != Status::Idle) return ended;
  return stage_ == Stage::Off ? Status::Idle : Status::Transferring;
}

// --- What it looks at

void MovingTarget::take(Listener& listener, const FrameParser& frame) {
  MovingTarget& self = static_cast<MovingTarget&>(listener);
  if (self.isFromAutopilot(frame) && self.client_.link().isCurrent()) self.isBlind_ = false;
}

// A loop() that has stood still, or has not heard the autopilot, knows neither where the aircraft is nor who has it.
// Both are asked for in time: PX4's failsafe comes 1 s after the last target.
void MovingTarget::look(uint32_t nowMs) {
  const uint16_t shortMs = static_cast<uint16_t>(nowMs);
  const uint16_t quietMs = client_.autopilot().quietMs(shortMs);
  const bool isCurrent = client_.link().isCurrentAt(nowMs);
  if (!isBlind_ && (!isCurrent || quietMs >= kBlindMs)) {
    isBlind_ = true;
    blindMs_ = shortMs;
    if (!isCurrent) withdraw();
  }
  if (stage_ != Stage::Off && (isBlind_ || quietMs >= kQuietMs)) ask(shortMs);
}

// The answer to it is not waited for. An operation of the client that is under way, or the next one, has to know that
// it will come.
void MovingTarget::ask(uint16_t nowMs) {
  if (since(askedMs_, nowMs) < kAskMs || !client_.autopilot().isFound() || !client_.link().canSend()) return;
  mavlink_command_long_t message = mavlink_command_long_t();
  message.command = MAV_CMD_REQUEST_MESSAGE;
  message.param1 = MAVLINK_MSG_ID_HEARTBEAT;
  client_.link().send(message);
  askedMs_ = nowMs;
  if (!client_.commands().isCommanding()) return;
  client_.commandLog().askedAside(nowMs);
  client_.commands().sending().asked(nowMs);
}

// 32 bits: a loop() that has stood still for a minute must not find that its target is fresh.
bool MovingTarget::isLate() const { return isStopped_ || millis() - renewedMs_ > timeoutMs_; }

// True while the client's operation is the beginning, or the hold.
bool MovingTarget::isOperating() const { return client_.commands().runs(on) && client_.commands().owner() == this; }

// True while the sketch has ordered something else of the Steering.
bool MovingTarget::isSteered() const { return steering_.isRunning() && !steering_.is(kAdjusts); }

bool MovingTarget::needsStream() const { return has(client_.autopilot().firmware(), kNeedsStream); }

// True while the sketch is in control, and in the mode in which it follows.
bool MovingTarget::mayFollow() const {
  return client_.autopilot().isArmed() && steering_.ownMode_ == mode_ && steering_.isOurs() &&
         client_.commands().shownMode() == mode_;
}

// If it is not: why, as the status with which we end.
Status MovingTarget::whoHasIt() const {
  if (!client_.autopilot().isFound()) return Status::NoAutopilot;
  const uint16_t own = steering_.ownMode_;
  if (own != kNoMode && own != mode_ && steering_.isOurs()) return Status::Cancelled;  // by the sketch
  if (!client_.autopilot().isArmed()) return Status::NotArmed;
  const Status others = steering_.otherHands();
  return others != Status::Transferring ? others : Status::PilotHasIt;
}

// --- The beginning

// The operation of the Steering that has just begun becomes ours: its events come here first.
void MovingTarget::takeOver() { client_.commands().takeOver(fill, on, this); }

void MovingTarget::fill(Client& client, FlightCommand& command) {
  static_cast<const MovingTarget*>(CommandPort::ownerOf(client))->steering_.fillStep(command);
}

Status MovingTarget::on(Client& client, CommandEvent event, Status status, const FrameParser*, uint16_t nowMs) {
  MovingTarget& self = *static_cast<MovingTarget*>(CommandPort::ownerOf(client));
  CommandPort& commands = CommandPort::of(client);
  if (!commands.isAskingVehicle()) return self.onEvent(event, status, nowMs);
  status = commands.onVehicle(event, status, fill);
  if (status != Status::Transferring) self.finish(status);
  return status;
}

Status MovingTarget::onEvent(CommandEvent event, Status status, uint16_t nowMs) {
  if (stage_ == Stage::Starting) {
    status = onStart(event, status, nowMs);
    if (status == Status::Done) {
      stage_ = Stage::Following;
      // One stream at a time: the one before goes over to this one without a gap.
      if (steering_.stream_ != nullptr && steering_.stream_ != this) steering_.stream_->finish(Status::Cancelled);
      steering_.stream_ = this;
    }
    if (status != Status::Transferring && status != Status::Done) finish(status);
    return status;
  }
  status = steering_.onEvent(event, status, nowMs);
  if (status != Status::Transferring) finish(status == Status::Done ? ending_ : status);
  return status;
}

// The steps of a goTo() as far as its command, in whose place a mode is set.
Status MovingTarget::onStart(CommandEvent event, Status status, uint16_t nowMs) {
  CommandTransfer& sending = client_.commands().sending();
  if (event == CommandEvent::Ready) {
    if (steering_.isPlane()) return Status::CommandUnsupported;
    const Status refusal = other_ == nullptr ? Status::Transferring : other_(*this, nullptr);
    if (refusal != Status::Transferring) return refusal;
    mode_ = client_.commands().numberOf(FlightMode::Guided);
  }
  // Before the mode has been ordered there is nothing to hold. (What is refused at once is refused for its own reason.)
  if (isLate() && !steering_.isOrdered_ && event != CommandEvent::Ready)
    return isStopped_ ? Status::Cancelled : Status::NotRenewed;
  status = steering_.onEvent(event, status, nowMs);
  if (status != Status::Transferring) return status;
  if (event == CommandEvent::Ready) steering_.lead(client_.commands().firstMode(), mode_);
  if (steering_.step_ == SteerStep::Command) {
    if (steering_.ownMode_ == mode_ && client_.commands().shownMode() == mode_) {
      steering_.forgetTarget();
      return Status::Done;
    }
    steering_.step_ = SteerStep::Mode;
  }
  if (steering_.step_ != SteerStep::Mode || sending.isUrgent()) return status;
  const bool isListening = sending.state() == CommandTransfer::State::Listening;
  // PX4 takes the mode after a second of targets.
  const bool isLed = hasSent_ && since(sentMs_, nowMs) < kBlindMs && since(beganMs_, nowMs) >= kLeadMs;
  if (needsStream() && !isLed) {
    if (!isListening) sending.listen(SteerRules::kConfirmMs, nowMs);
  } else if (isListening) {
    sending.next(true);
  }
  return status;
}

// --- Following, and its end

void MovingTarget::follow(uint16_t nowMs) {
  const bool isBlind = isBlind_ && isLate();
  if (!mayFollow() && !isBlind) return finish(whoHasIt());
  if (isSteered()) return hold(Status::Cancelled);
  if (isLate()) return hold(isStopped_ ? Status::Done : Status::NotRenewed);
  send(nowMs);
}

void MovingTarget::hold(Status ending) {
  stage_ = Stage::Holding;
  ending_ = ending;
  aimHere();
  // A velocity is flown on until it is replaced. (Another order of the sketch does that by itself.)
  if (other_ == nullptr || ending == Status::Cancelled) return;
  beganMs_ = static_cast<uint16_t>(millis());
  sentMs_ = static_cast<uint16_t>(beganMs_ - kEveryMs);
  send(beganMs_);
}

// PX4 would call a failsafe if the targets ended before its mode has changed: until then they name the place where the
// aircraft was when the hold began. ArduPilot gets that place while the client has something else to do.
void MovingTarget::keepHolding(uint16_t nowMs) {
  aimHere();
  if (isOperating()) {
    if (needsStream() && mayFollow()) send(nowMs);
    return;
  }
  if (isOrdered_) return finish(Status::Cancelled);
  if (isBlind_ && since(blindMs_, nowMs) < FinderRules::kLostMs) return;
  if (!mayFollow()) return finish(whoHasIt());
  if (isSteered()) {
    if (needsStream()) send(nowMs);
    return;
  }
  // The sketch has sent it to a place, in the same mode.
  if (steering_.target_.hasPlace) return finish(ending_);
  // A place that is held while it still moves is one to which it comes back: a rover in a loop.
  if (other_ != nullptr && since(beganMs_, nowMs) < kBrakeMs) return send(nowMs);
  if (steering_.pause() == Status::Busy) return send(nowMs);
  takeOver();
  isOrdered_ = true;
}

// From now on the target is where the aircraft is, as soon as that is known.
void MovingTarget::aimHere() {
  if (isHere_ && isAimed_) return;
  if (!isHere_) withdraw();
  isHere_ = true;
  if (other_ != nullptr) return;  // it stands still without a place
  const bool isAboveSea = has(client_.autopilot().firmware(), kAltitudesAreAboveSea);
  isAimed_ = !isBlind_ && steering_.isPositionKnown();
  at_ = steering_.here_;
  heightCm_ = isAboveSea ? steering_.seaCm_ : steering_.homeCm_;
  frame_ = isAboveSea ? CoordinateFrame::Global : CoordinateFrame::GlobalRelative;
}

// What is still going out is no longer true. (Twice would make it right again.)
void MovingTarget::withdraw() {
  if (!isWithdrawn_) client_.link().withdrawForeign(payload_);
  isWithdrawn_ = true;
}

void MovingTarget::finish(Status status) {
  withdraw();
  if (steering_.stream_ == this) steering_.stream_ = nullptr;
  stage_ = Stage::Off;
  status_ = toReturn_ = status;
}

void MovingTarget::send(uint16_t nowMs) {
  if (isBlind_ || !isAimed_ || (hasSent_ && since(sentMs_, nowMs) < kEveryMs) || !client_.link().canSend()) return;
  Message message = Message();
  message.time_boot_ms = millis();
  message.target_system = client_.autopilot().heartbeat().systemId;
  message.target_component = client_.autopilot().heartbeat().componentId;
  OutgoingMessage outgoing = {MAVLINK_MSG_ID_SET_POSITION_TARGET_GLOBAL_INT,
                              MAVLINK_MSG_ID_SET_POSITION_TARGET_GLOBAL_INT_CRC, sizeof(payload_),
                              MAVLINK_MSG_ID_SET_POSITION_TARGET_GLOBAL_INT_MIN_LEN, payload_};
  if (other_ == nullptr) {
    // PX4 looks at the frame of this message, and wants its older number.
    const bool isAboveHome = frame_ == CoordinateFrame::GlobalRelative;
    const bool isFromHome = isAboveHome && has(client_.autopilot().firmware(), kAltitudesAreAboveSea);
    float altitude = quotient(isFromHome ? heightCm_ + steering_.seaCm_ - steering_.homeCm_ : heightCm_, 1);
    multiply(&altitude, Times::Hundredth);
    message.lat_int = at_.latitude.e7();
    message.lon_int = at_.longitude.e7();
    message.alt = altitude;
    message.type_mask = kPlaceAlone;
    message.coordinate_frame =
        static_cast<uint8_t>(frame_ == CoordinateFrame::GlobalTerrain ? CoordinateFrame::GlobalTerrainInt
                             : isAboveHome && !isFromHome             ? CoordinateFrame::GlobalRelativeInt
                                                                      : CoordinateFrame::GlobalInt);
  }
  memcpy(payload_, &message, sizeof(payload_));
  if (other_ != nullptr) {
    other_(*this, payload_);
    outgoing.id = MAVLINK_MSG_ID_SET_POSITION_TARGET_LOCAL_NED;
    outgoing.crcExtra = MAVLINK_MSG_ID_SET_POSITION_TARGET_LOCAL_NED_CRC;
  }
  if (!client_.link().sendForeign(outgoing)) return;
  // A second of targets has no gap in it.
  if (!hasSent_ || since(sentMs_, nowMs) >= kBlindMs) beganMs_ = nowMs;
  hasSent_ = true;
  isWithdrawn_ = false;
  sentMs_ = nowMs;
}

}  // namespace mavmission
