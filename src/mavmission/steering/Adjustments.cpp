#include "Adjustments.h"

#include <string.h>

#include "../base/FloatBits.h"
#include "../base/MavlinkHeaders.h"
#include "../client/CommandPort.h"

namespace mavmission {
using namespace detail;
namespace {

constexpr float kMostDegrees = 360, kMostSpeed = 20;
constexpr float kLeastSpeed = __FLT_DENORM_MIN__;  // above 0

// Without the sign, as bits: larger numbers have larger ones.
int32_t sizeOf(float value) {
  int32_t bits;
  memcpy(&bits, &value, sizeof(bits));
  return bits & 0x7FFFFFFF;
}

bool isBelowZero(float value) {
  int32_t bits;
  memcpy(&bits, &value, sizeof(bits));
  return bits < 0 && sizeOf(value) != 0;
}

// In hundredths.
int32_t hundredths(float value) {
  int32_t bits;
  memcpy(&bits, &value, sizeof(bits));
  return timesWhole(bits, 100);
}

}  // namespace

Status Adjustments::begin(Kind kind, float value, float turn) {
  const Status status = steering_.begin(rowOf(Order::Adjust));
  if (status == Status::Busy) return status;
  steering_.client_.commands().takeOver(fill, on, this);
  kind_ = kind;
  value_ = value;
  turn_ = turn;
  return status;
}

Status Adjustments::turnTo(Yaw heading, DegreesPerSecond turn) {
  return begin(Kind::Heading, heading.inDegrees(), turn.value);
}

Status Adjustments::setClimbSpeed(MetresPerSecond speed) { return begin(Kind::Climb, speed.value, 0); }
Status Adjustments::setDescentSpeed(MetresPerSecond speed) { return begin(Kind::Descent, speed.value, 0); }

Status Adjustments::refuseNumber(float value, float least, float most, Status range, ItemField field) {
  const FloatKind kind = kindOf(&value);
  if (kind == FloatKind::NotANumber) return steering_.refuseField(Status::NotANumber, field);
  if (kind == FloatKind::Infinite) return steering_.refuseField(Status::NotFinite, field);
  const bool isWithin = sizeOf(value) >= sizeOf(least) && sizeOf(value) <= sizeOf(most);
  return isWithin ? Status::Transferring : steering_.refuseField(range, field);
}

Status Adjustments::refuse() {
  const bool isKnown = has(steering_.client_.autopilot().firmware(), kModesByVehicle);
  if (!isKnown || steering_.vehicle() != detail::Vehicle::Copter) return Status::CommandUnsupported;
  if (isBelowZero(kind_ == Kind::Heading ? turn_ : value_)) {
    return steering_.refuseField(kind_ == Kind::Heading ? Status::BadRange : Status::BadSpeed, ItemField::Param2);
  }
  if (kind_ != Kind::Heading) {
    return refuseNumber(value_, kLeastSpeed, kMostSpeed, Status::BadSpeed, ItemField::Param2);
  }
  const Status refusal = refuseNumber(value_, 0, kMostDegrees, Status::BadRange, ItemField::Param1);
  if (refusal != Status::Transferring) return refusal;
  return refuseNumber(turn_, 0, kMostDegrees, Status::BadRange, ItemField::Param2);
}

Status Adjustments::on(Client& client, CommandEvent event, Status status, const FrameParser*, uint16_t nowMs) {
  Adjustments& self = *static_cast<Adjustments*>(CommandPort::ownerOf(client));
  CommandPort& commands = CommandPort::of(client);
  if (commands.isAskingVehicle()) return commands.onVehicle(event, status, fill);
  if (event == CommandEvent::Ready) {
    const Status refusal = self.refuse();
    if (refusal != Status::Transferring) return refusal;
  }
  return self.steering_.onEvent(event, status, nowMs);
}

void Adjustments::fill(Client& client, FlightCommand& command) {
  const Adjustments& self = *static_cast<const Adjustments*>(CommandPort::ownerOf(client));
  if (self.steering_.step() != SteerStep::Command) return self.steering_.fillStep(command);
  if (self.kind_ != Kind::Heading) {
    command.id = MAV_CMD_DO_CHANGE_SPEED;
    command.param1 = self.kind_ == Kind::Climb ? SPEED_TYPE_CLIMB_SPEED : SPEED_TYPE_DESCENT_SPEED;
    command.param2 = self.value_;
    command.param3 = -1;
    return;
  }
  // ArduCopter takes 0 to 360 degrees alone. A turn by so much, and not to a heading, would be done twice by a repeat.
  const int32_t cdeg = hundredths(self.value_);
  command.id = MAV_CMD_CONDITION_YAW;
  command.param1 = quotient(cdeg < 0 ? cdeg + 36000 : cdeg, 100);
  command.param2 = self.turn_;
}

}  // namespace mavmission
