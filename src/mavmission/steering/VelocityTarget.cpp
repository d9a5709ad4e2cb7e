// VelocityTarget: a MovingTarget whose target is a velocity. Here is only what a velocity is in the numbers of each
// vehicle; when it is sent, and who has the aircraft, is decided in MovingTarget.cpp.
#include "VelocityTarget.h"

#include <Arduino.h>
#include <string.h>

#include "../base/FloatBits.h"
#include "../client/Port.h"
#include "../payload/OutgoingFields.h"

namespace mavmission {
using namespace detail;
namespace {

typedef mavlink_set_position_target_local_ned_t Message;

constexpr float kMostSpeed = 100, kMostTurn = 360;

// The velocity counts, and of the heading what the vehicle takes.
constexpr uint16_t kVelocityAlone = POSITION_TARGET_TYPEMASK_X_IGNORE | POSITION_TARGET_TYPEMASK_Y_IGNORE |
                                    POSITION_TARGET_TYPEMASK_Z_IGNORE | POSITION_TARGET_TYPEMASK_AX_IGNORE |
                                    POSITION_TARGET_TYPEMASK_AY_IGNORE | POSITION_TARGET_TYPEMASK_AZ_IGNORE |
                                    POSITION_TARGET_TYPEMASK_YAW_IGNORE | POSITION_TARGET_TYPEMASK_YAW_RATE_IGNORE;

// Without the sign.
uint32_t sizeOf(float value) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof(bits));
  return bits & 0x7FFFFFFF;
}

bool isZero(float value) { return sizeOf(value) == 0; }

constexpr Velocity still() { return BodyVelocity(MetresPerSecond(0)); }

}  // namespace

VelocityTarget::VelocityTarget(Steering& steering) : MovingTarget(steering, onOther), velocity_(still()) {
  static_assert(sizeof(payload_) == sizeof(Message) && offsetof(Message, target_system) == 50 &&
                    offsetof(mavlink_set_position_target_global_int_t, target_system) == 50,
                "both messages have their target where MovingTarget writes it");
}

Status VelocityTarget::start(const Velocity& velocity) {
  const Status status = startOther();
  if (status != Status::Busy) velocity_ = velocity;  // what cannot be meant ends it when the vehicle is known
  return status;
}

Status VelocityTarget::renew(const Velocity& velocity) {
  const Status closed = whyClosed();
  if (closed != Status::Transferring) return closed;
  const Status refusal = refuse(velocity, steering_.step() != SteerStep::None);
  if (refusal != Status::Transferring) return refusal;
  velocity_ = velocity;
  renewedMs_ = millis();
  return Status::Transferring;
}

Status VelocityTarget::onOther(const MovingTarget& target, uint8_t* payload) {
  const VelocityTarget& self = static_cast<const VelocityTarget&>(target);
  if (payload == nullptr) return self.refuse(self.velocity_, true);
  self.fill(payload);
  return Status::Transferring;
}

bool VelocityTarget::drives() const { return vehicleOf(client_.autopilot().vehicleType()) == detail::Vehicle::Rover; }

// A number of the velocity that is not possible.
Status VelocityTarget::refuseNumber(float value, float most, ItemField field) const {
  const FloatKind kind = kindOf(&value);
  if (kind == FloatKind::NotANumber) return blame(Status::NotANumber, field);
  if (kind == FloatKind::Infinite) return blame(Status::NotFinite, field);
  return sizeOf(value) > sizeOf(most) ? blame(Status::BadSpeed, field) : Status::Transferring;
}

Status VelocityTarget::refuse(const Velocity& velocity, bool isVehicleKnown) const {
  const float numbers[] = {velocity.x_, velocity.y_, velocity.up_};
  for (uint8_t i = 0; i < 3; ++i) {
    const ItemField field = static_cast<ItemField>(static_cast<uint8_t>(ItemField::Param1) + i);
    const Status refusal = refuseNumber(numbers[i], kMostSpeed, field);
    if (refusal != Status::Transferring) return refusal;
  }
  const bool hasHeading = kindOf(&velocity.heading_) != FloatKind::NotANumber;
  const Status turns = refuseNumber(hasHeading ? velocity.heading_ : velocity.turn_, kMostTurn, ItemField::Param4);
  if (turns != Status::Transferring || !isVehicleKnown) return turns;
  if (vehicleOf(client_.autopilot().vehicleType()) == detail::Vehicle::Copter) return Status::Transferring;
  // PX4's other vehicles have not been tried.
  if (!drives() || has(client_.autopilot().firmware(), kNeedsStream)) return Status::CommandUnsupported;
  if (!isZero(velocity.up_)) return blame(Status::CommandUnsupported, ItemField::Param3);
  if (velocity.isOfAircraft_) {
    return isZero(velocity.y_) ? Status::Transferring : blame(Status::CommandUnsupported, ItemField::Param2);
  }
  const bool looksElsewhere = hasHeading || !isZero(velocity.turn_);
  return looksElsewhere ? blame(Status::CommandUnsupported, ItemField::Param4) : Status::Transferring;
}

void VelocityTarget::fill(uint8_t* payload) const {
  // A rover that is told to stand still over the ground would turn to the north.
  const bool isStanding = drives() && !velocity_.isOfAircraft_ && isZero(velocity_.x_) && isZero(velocity_.y_);
  const Velocity it = isHere_ || isStanding ? still() : velocity_;
  uint16_t mask = kVelocityAlone;
  float heading = it.heading_, turn = it.turn_;
  if (kindOf(&heading) != FloatKind::NotANumber) {
    multiply(&heading, Times::Radian);
    put(payload, offsetof(Message, yaw), heading);
    mask &= static_cast<uint16_t>(~POSITION_TARGET_TYPEMASK_YAW_IGNORE);
  } else if (it.isOfAircraft_ || !drives()) {
    // Without it a copter would look where it flies, and a rover would not drive backwards.
    multiply(&turn, Times::Radian);
    put(payload, offsetof(Message, yaw_rate), turn);
    mask &= static_cast<uint16_t>(~POSITION_TARGET_TYPEMASK_YAW_RATE_IGNORE);
  }
  put(payload, offsetof(Message, vx), it.x_);
  put(payload, offsetof(Message, vy), it.y_);
  put(payload, offsetof(Message, vz), isZero(it.up_) ? 0.0f : -it.up_);
  put(payload, offsetof(Message, type_mask), mask);
  put(payload, offsetof(Message, coordinate_frame),
      static_cast<uint8_t>(it.isOfAircraft_ ? MAV_FRAME_BODY_NED : MAV_FRAME_LOCAL_NED));
}

}  // namespace mavmission
