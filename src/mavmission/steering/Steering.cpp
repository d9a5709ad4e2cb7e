// Steering: what the sketch calls, and what is heard. What is refused is in SteeringRefusals.cpp, the steps of an order
// in SteeringSteps.cpp.
#include "Steering.h"

#include <Arduino.h>

#include "../base/Flash.h"
#include "../client/CommandPort.h"
#include "../link/Messages.h"
#include "SteeringNumbers.h"

namespace mavmission {
using namespace detail;
namespace {

const MessageKey kSteered[] PROGMEM = {
    MAVMISSION_LISTENER_KEY(HEARTBEAT),
    MAVMISSION_LISTENER_KEY(GLOBAL_POSITION_INT),
    MAVMISSION_LISTENER_KEY(POSITION_TARGET_GLOBAL_INT),
    MAVMISSION_LISTENER_KEY(EXTENDED_SYS_STATE),
};

// A long time without a wrap [1.024 s].
uint16_t secondsNow() { return static_cast<uint16_t>(millis() >> 10); }

constexpr uint8_t kSameE7 = 2;   // PX4 cuts the last digit of a target
constexpr uint8_t kSameCm = 10;  // and gives its altitude as a float

}  // namespace

Steering::Steering(MissionClient& client) : Listener(client, kSteered, sizeof(kSteered) / sizeof(kSteered[0]), take) {
  // A global object is zero already; so is this one wherever it lies.
  target_ = wanted_ = Place{LatLon(), 0, Above::Nothing, false};
  seaCm_ = homeCm_ = 0;
  value_ = 0;
  ownMode_ = oldMode_ = kNoMode;
  change_.begin(kNoMode, kNoMode);
  beganS_ = 0;
  row_ = OrderRow();
  frame_ = CoordinateFrame::Global;
  step_ = SteerStep::None;
  refusal_ = Status::Idle;
  landedState_ = MAV_LANDED_STATE_UNDEFINED;
  targetAge_ = 255;
  knowledge_ = 0;
  positionS_ = 0x8000;
  beatS_ = 0;
  stream_ = nullptr;
  seenDisarmed_ = hasArmed_ = isModeSeen_ = isHeard_ = isAnswered_ = isTargetSame_ = false;
  isOrdered_ = isDenied_ = canHover_ = hadControl_ = wasArmed_ = isRequested_ = false;
}

// --- What the sketch calls

Status Steering::begin(OrderRow row) {
  const Status status = client_.commands().beginCommands(fill, on, this);
  if (status == Status::Busy) return status;
  row_ = row;
  step_ = SteerStep::None;
  hasArmed_ = isModeSeen_ = isOrdered_ = isDenied_ = false;
  return status;
}

Status Steering::takeOff(Metres aboveHome) {
  const Status status = begin(rowOf(Order::TakeOff));
  if (status == Status::Busy) return status;
  value_ = aboveHome.value;
  frame_ = CoordinateFrame::GlobalRelative;
  wanted_.hasPlace = false;
  return status;
}

Status Steering::goTo(const LatLon& place, Altitude altitude) {
  const Status status = begin(rowOf(Order::GoTo));
  if (status == Status::Busy) return status;
  value_ = altitude.metres();
  frame_ = modern(altitude.frame());
  wanted_.at = place;
  wanted_.hasPlace = true;
  return status;
}

Status Steering::pause() { return begin(rowOf(Order::Pause)); }
Status Steering::resume() { return begin(rowOf(Order::Resume)); }
Status Steering::returnHome() { return begin(rowOf(Order::ReturnHome)); }
Status Steering::landNow() { return begin(rowOf(Order::Land)); }

Status Steering::setSpeed(MetresPerSecond speed) {
  const Status status = begin(rowOf(Order::Speed));
  if (status != Status::Busy) value_ = speed.value;
  return status;
}

bool Steering::isRunning() const { return client_.commands().runs(on); }

bool Steering::hasArrived(uint16_t withinCm) const {
  if (!isPositionKnown() || !client_.link().isCurrentAt(millis()) || isRunning()) return false;
  if (ownMode_ == kNoMode || ownMode_ == kPx4TakeOff) return false;  // an order would meet PX4's change to HOLD
  if (target_.above == Above::Home && !isNear(homeCm_, target_.heightCm, withinCm)) return false;
  if (target_.above == Above::Sea && !isNear(seaCm_, target_.heightCm, withinCm)) return false;
  if (!target_.hasPlace) return target_.above != Above::Nothing;
  const LatLon edge = moved(target_.at, withinCm, withinCm);
  return isNear(here_.latitude.e7(), target_.at.latitude.e7(), (edge.latitude - target_.at.latitude).e7()) &&
         isNearInLongitude(here_.longitude.e7(), target_.at.longitude.e7(),
                           (edge.longitude - target_.at.longitude).e7());
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
      self.canHover_ =
          frame.payloadByte(offsetof(mavlink_extended_sys_state_t, vtol_state)) != MAV_VTOL_STATE_UNDEFINED;
      if (step == SteerStep::AskLanded || step == SteerStep::Confirm) self.isHeard_ = true;
  }
}

void Steering::takeHeartbeat() {
  if (targetAge_ != 255) ++targetAge_;
  // Its other messages may have come meanwhile: they do not show its mode.
  const uint16_t nowS = secondsNow();
  const bool isGap = static_cast<uint16_t>(nowS - beatS_) >= kForgetS;
  beatS_ = nowS;
  if (isGap || knowledge_ != client_.autopilot().knowledge()) forgetShown();
  const uint16_t shown = shownMode();
  const bool isArmed = client_.autopilot().isArmed();
  const bool isInMission = ownMode_ == kNoMode || ownMode_ == kPx4TakeOff;
  if (!isArmed) {
    // (After a standstill it may have come before the sketch has named this aircraft.)
    if (!client_.link().isOld()) seenDisarmed_ = true;
    if (wasArmed_) ownMode_ = kNoMode;  // whoever arms it now may set that mode, too
  }
  wasArmed_ = isArmed;
  // The sketch's own setMode() is about to end.
  if (client_.commands().isSetting(shown) || isRequested_) ownMode_ = shown;
  isRequested_ = false;
  if (shown != ownMode_ || isFailsafe()) {
    if (!mayHaveClimbed()) ownMode_ = ownMode_ == kPx4TakeOff && hasClimbed() ? shown : kNoMode;
  }
  // What an order of the sketch's own sees, it judges by itself: who had control before is looked at when it has ended.
  if (client_.running() != Status::Idle && client_.commands().isCommanding()) return;
  const bool hasControl = isOurs();
  if (hadControl_ && isArmed && !hasControl) {
    if (isInMission && mayBeOfPlan()) return;  // the next mode tells
    client_.noteTaken(whoFlies());
  }
  hadControl_ = isArmed && hasControl;
}

// What was shown before counts no more.
void Steering::forgetShown() {
  const uint8_t now = client_.autopilot().knowledge();
  // (Whoever has the same aircraft after a gap has taken it from the sketch, if the sketch had it before.)
  if (!AutopilotFinder::isSame(knowledge_, now)) seenDisarmed_ = hadControl_ = false;
  knowledge_ = now;
  ownMode_ = kNoMode;
  landedState_ = MAV_LANDED_STATE_UNDEFINED;
  targetAge_ = 255;
  positionS_ = static_cast<uint16_t>(secondsNow() + 0x8000);
  canHover_ = false;
  forgetTarget();
}

uint16_t Steering::positionAgeS() const { return static_cast<uint16_t>(secondsNow() - positionS_); }

bool Steering::isPositionKnown() const { return positionAgeS() <= kFreshS; }

void Steering::requestControl() {
  client_.noteTaken(Status::Idle);
  seenDisarmed_ = true;
  ownMode_ = shownMode();
  isRequested_ = client_.autopilot().heartbeat().baseMode == 0;  // none was heard
}

bool Steering::isInHoldAloft() const {
  return shownMode() == client_.commands().numberOf(FlightMode::Hold) && !isFailsafe() && isInAir();
}

// At the top of its takeoff PX4 goes over to HOLD by itself. Lower than that, it is a pilot's.
bool Steering::hasClimbed() const {
  const Place& top = is(kFromGround) ? wanted_ : target_;
  return isInHoldAloft() && isPositionKnown() &&
         isNear(top.above == Above::Sea ? seaCm_ : homeCm_, top.heightCm, kTopCm);
}

// The last position came while it climbed: the next one tells.
bool Steering::mayHaveClimbed() const {
  return ownMode_ == kPx4TakeOff && isInHoldAloft() && !hasClimbed() && positionAgeS() <= kTopS;
}

void Steering::takePosition(const FrameParser& frame) {
  if (client_.link().isOld()) return;
  typedef mavlink_global_position_int_t Position;
  here_.latitude = Degrees::fromE7(static_cast<int32_t>(frame.payloadLong(offsetof(Position, lat))));
  here_.longitude = Degrees::fromE7(static_cast<int32_t>(frame.payloadLong(offsetof(Position, lon))));
  seaCm_ = static_cast<int32_t>(frame.payloadLong(offsetof(Position, alt))) / 10;
  homeCm_ = static_cast<int32_t>(frame.payloadLong(offsetof(Position, relative_alt))) / 10;
  positionS_ = secondsNow();
  if (ownMode_ == kPx4TakeOff && isInHoldAloft()) ownMode_ = hasClimbed() ? shownMode() : kNoMode;
  if (step_ == SteerStep::AskPosition) isHeard_ = true;
}

void Steering::takeTarget(const FrameParser& frame) {
  typedef mavlink_position_target_global_int_t Target;
  targetAge_ = 0;
  if (!is(kTakesPlace)) return;
  const int32_t latitude = static_cast<int32_t>(frame.payloadLong(offsetof(Target, lat_int)));
  const int32_t longitude = static_cast<int32_t>(frame.payloadLong(offsetof(Target, lon_int)));
  float altitude;
  const uint32_t bits = frame.payloadLong(offsetof(Target, alt));
  memcpy(&altitude, &bits, sizeof(altitude));
  // ArduPilot gives its target's altitude as it was told, whatever that is measured from.
  const bool isHeight = !has(client_.autopilot().firmware(), kAltitudesAreAboveSea) ||
                        isNear(centimetres(altitude), wanted_.heightCm, kSameCm);
  isTargetSame_ = isHeight && isNear(latitude, wanted_.at.latitude.e7(), kSameE7) &&
                  isNearInLongitude(longitude, wanted_.at.longitude.e7(), kSameE7);
}

}  // namespace mavmission
