// Steering: who has the aircraft, and what is refused before anything is sent.
#include "Steering.h"

#include <Arduino.h>

#include "../client/CommandPort.h"
#include "../link/Messages.h"
#include "SteeringNumbers.h"

namespace mavmission {
using namespace detail;
namespace {

constexpr int32_t kMostHeightCm = 1000000;
constexpr int32_t kMostSpeed = 0x42C80000;  // 100 m/s, as the bits of a float

// True for a finite number of 2^17 and more, or of -2^17 and less.
bool isHuge(float value) {
  uint8_t bytes[sizeof(value)];
  memcpy(bytes, &value, sizeof(value));
  return static_cast<uint8_t>(bytes[3] << 1 | bytes[2] >> 7) >= 127 + 17;
}

}  // namespace

bool Steering::isMissionMode() const {
  const uint16_t mission = client_.commands().numberOf(FlightMode::Auto);
  return mission != kNoMode && shownMode() == mission;
}

// PX4 says CRITICAL while a failsafe flies, in whatever mode: HOLD, which is ours as well, is one of them. ArduPilot
// says so for each failsafe, also for one that it is set to ignore; there the mode tells who flies.
bool Steering::isFailsafe() const {
  return has(client_.autopilot().firmware(), kCriticalInFailsafe) &&
         client_.autopilot().heartbeat().state >= MAV_STATE_CRITICAL;
}

bool Steering::maySteer() const { return client_.link().isCurrentAt(millis()) && isOurs(); }

// As the last heartbeat has shown it, however old that is.
bool Steering::isOurs() const {
  if (!client_.autopilot().isFound() || isFailsafe()) return false;
  return isMissionMode() || (ownMode_ != kNoMode && shownMode() == ownMode_);
}

// In a mode in which an aircraft flies by itself where a plan or an order has sent it: nobody is seen to fly it by
// hand.
bool Steering::isFlownByOrders() const {
  const CommandPort& commands = client_.commands();
  const uint16_t shown = shownMode();
  const bool waitsInHold = has(client_.autopilot().firmware(), kFliesToPlacesInHold);
  return !isFailsafe() && (isMissionMode() || shown == commands.numberOf(FlightMode::Guided) ||
                           (waitsInHold && shown == commands.numberOf(FlightMode::Hold)));
}

Status Steering::refuseField(Status status, ItemField field) {
  client_.blame(field);
  return status;
}

Status Steering::refuseNumber(float value, ItemField field) {
  const FloatKind kind = kindOf(&value);
  if (kind == FloatKind::NotANumber) return refuseField(Status::NotANumber, field);
  if (kind == FloatKind::Infinite) return refuseField(Status::NotFinite, field);
  return Status::Transferring;
}

Status Steering::refuseHeight(float metres, int32_t* cm) {
  const Status refusal = refuseNumber(metres, ItemField::Height);
  if (refusal != Status::Transferring) return refusal;
  *cm = centimetres(metres);
  const bool isOut = isHuge(metres) || !isNear(*cm, 0, kMostHeightCm);
  return isOut ? refuseField(Status::BadAltitude, ItemField::Height) : Status::Transferring;
}

Status Steering::refusePlace(const LatLon& at, CoordinateFrame frame) {
  const int32_t latitude = at.latitude.e7(), longitude = at.longitude.e7();
  if (!isNear(latitude, 0, 900000000)) return refuseField(Status::BadLatitude, ItemField::Latitude);
  if (longitude < -1800000000 || longitude > 1800000000) {
    return refuseField(Status::BadLongitude, ItemField::Longitude);
  }
  // ArduPilot refuses 0 N 0 E, and PX4 flies there.
  if (latitude == 0 && longitude == 0) return refuseField(Status::NeedsCoordinates, ItemField::Latitude);
  const bool isTerrain = frame == CoordinateFrame::GlobalTerrain;
  const bool isTaken = isTerrain ? has(client_.autopilot().firmware(), kTakesTerrainFrames)
                                 : frame == CoordinateFrame::Global || frame == CoordinateFrame::GlobalRelative;
  return isTaken ? Status::Transferring : refuseField(Status::BadFrame, ItemField::Reference);
}

Status Steering::refuseNumbers() {
  if (row_.command() == OrderCommand::ChangeSpeed) {
    const Status refusal = refuseNumber(value_, ItemField::Param2);
    if (refusal != Status::Transferring) return refusal;
    // As bits larger numbers are larger, and those below 0 are below 0.
    int32_t bits;
    memcpy(&bits, &value_, sizeof(bits));
    return bits > 0 && bits <= kMostSpeed ? Status::Transferring : refuseField(Status::BadSpeed, ItemField::Param2);
  }
  if (!is(kTakesHeight)) return Status::Transferring;
  const Status refusal = refuseHeight(value_, &wanted_.heightCm);
  if (refusal != Status::Transferring) return refusal;
  if (is(kTakesPlace)) return refusePlace(wanted_.at, frame_);
  return wanted_.heightCm > 0 ? Status::Transferring : refuseField(Status::BadAltitude, ItemField::Height);
}

// Who has the aircraft, as a status; Transferring: this sketch, or the mission.
Status Steering::otherHands() const { return isOurs() ? Status::Transferring : whoFlies(); }

// The same of a mode that somebody else has set, the mission's included.
Status Steering::whoFlies() const {
  const uint16_t shown = shownMode();
  const bool isFailsafe = client_.autopilot().heartbeat().state >= MAV_STATE_CRITICAL ||
                          client_.commands().isReturn(shown) || shown == client_.commands().numberOf(FlightMode::Land);
  return isFailsafe ? Status::FailsafeHasIt : Status::PilotHasIt;
}

bool Steering::isGround() const { return vehicle() == Vehicle::Rover; }

// True for ArduPilot's.
bool Steering::isPlane() const {
  return has(client_.autopilot().firmware(), kModesByVehicle) && detail::isPlane(client_.autopilot().vehicleType());
}

uint16_t Steering::shownMode() const { return client_.commands().counted(client_.commands().shownMode()); }

// True if the heartbeat tells whether it is in the air. ArduPilot's says ACTIVE in the air only, and CRITICAL in the
// air and on the ground; PX4's says ACTIVE as soon as it is armed.
bool Steering::isToldByHeartbeat() const {
  return has(client_.autopilot().firmware(), kIsActiveInAir) &&
         client_.autopilot().heartbeat().state < MAV_STATE_CRITICAL;
}

// Where the heartbeat does not tell, the autopilot has been asked.
bool Steering::isInAir() const {
  if (!isToldByHeartbeat()) return landedState_ >= MAV_LANDED_STATE_IN_AIR;
  return client_.autopilot().isArmed() && client_.autopilot().heartbeat().state == MAV_STATE_ACTIVE;
}

// The plan of a plane, and that of a PX4, may end in the mode RTL or HOLD, which a pilot may have set, too: in RTL it
// is not steered, but it counts as taken by nobody.
bool Steering::mayBeOfPlan() const {
  const uint16_t shown = shownMode();
  const CommandPort& commands = client_.commands();
  if (client_.autopilot().heartbeat().state >= MAV_STATE_CRITICAL) return false;
  if (has(client_.autopilot().firmware(), kFliesByMode)) {
    return isPlane() && shown == commands.numberOf(FlightMode::ReturnToLaunch);
  }
  return shown == commands.numberOf(FlightMode::ReturnToLaunch) || shown == commands.numberOf(FlightMode::Hold);
}

// Whether the order fits an aircraft that flies, or one that stands.
Status Steering::judgeFlight() {
  if (is(kFromGround)) return isInAir() ? Status::Armed : Status::Transferring;
  return isGround() || isInAir() ? Status::Transferring : Status::NotFlying;
}

Status Steering::refuse() {
  const Status numbers = refuseNumbers();
  if (numbers != Status::Transferring) return numbers;
  const bool isTakeOff = is(kFromGround);
  if (isTakeOff && client_.takenBy() != Status::Idle) return client_.takenBy();
  if (isTakeOff && client_.commands().hasBeenDisarmed()) {
    client_.noteTaken(Status::PilotHasIt);
    return Status::NotArmed;
  }
  if (wantedMode() == kNoMode) return Status::NoSuchMode;
  if (client_.autopilot().isArmed()) {
    if (!seenDisarmed_ && !client_.isAllowedWhileArmed()) return Status::Armed;
    const Status others = otherHands();
    if (others != Status::Transferring) return others;
  } else if (!isTakeOff) {
    return Status::NotArmed;
  }
  // Of ArduPilot's, only a copter and a plane that can hover have such a command: a plane is asked. PX4 would arm what
  // drives, too.
  const bool isKnown = has(client_.autopilot().firmware(), kModesByVehicle);
  const bool cannotFly = isGround() || vehicle() == Vehicle::Submarine;
  if (isTakeOff && (isKnown ? vehicle() != Vehicle::Copter && !isPlane() : cannotFly)) {
    return Status::CommandUnsupported;
  }
  return isToldByHeartbeat() ? judgeFlight() : Status::Transferring;
}

// The mode that the order leads to.
uint16_t Steering::wantedMode() const {
  const bool isInHold = has(client_.autopilot().firmware(), kFliesToPlacesInHold);
  switch (row_.mode) {
    case TargetMode::None: break;
    case TargetMode::AsShown: return shownMode();
    case TargetMode::TakingOff:
      if (has(client_.autopilot().firmware(), kTakesOffInOwnMode)) return kPx4TakeOff;
      return client_.commands().numberOf(FlightMode::Guided);
    case TargetMode::FlyingTo: return client_.commands().numberOf(isInHold ? FlightMode::Hold : FlightMode::Guided);
    case TargetMode::Mission: return client_.commands().numberOf(FlightMode::Auto);
    case TargetMode::Returning: return client_.commands().numberOf(FlightMode::ReturnToLaunch);
    case TargetMode::LandingHere:
      // A plane that has said that it can hover may call itself a plane all the same.
      return isPlane() && canHover_ ? kQLand : client_.commands().numberOf(FlightMode::Land);
  }
  return kNoMode;
}

}  // namespace mavmission
