// What an autopilot does when it is ordered to, and how it moves: ArduPilot and PX4 differ here.
#include <math.h>

#include "Autopilot.h"
#include "Px4Checksum.h"

namespace {

constexpr int32_t kTakeOffCm = 1000, kHomeCm = 58400;
constexpr uint32_t kTargetMs = 1000, kGoneMs = 1140;  // without a target OFFBOARD ends after kGoneMs

}  // namespace

uint8_t Autopilot::arm(bool arms) {
  const bool mayNotArm = is(Means::Return) || is(Means::Land) || (is(Means::Mission) && (!isPx4() || plan.empty()));
  if (isArmed && arms) return MAV_RESULT_ACCEPTED;
  if (arms ? mayNotArm : isAirborne()) return refusal();
  setArmed(arms);
  return MAV_RESULT_ACCEPTED;
}

// PX4 looks at whether it can fly a mode only when it is armed.
uint8_t Autopilot::orderMode(uint16_t wanted, uint32_t nowMs) {
  const bool hasStream = streamedMs_ != 0 && nowMs - streamedMs_ <= kTargetMs;
  const bool canBeFlown = (wanted != modeOf(kind, Means::Mission) || !plan.empty()) &&
                          (wanted != modeOf(kind, Means::Offboard) || hasStream);
  if (!canBeFlown && (isArmed || !isPx4())) return refusal();
  hasLostStream_ = false;  // this holds even if it flies that mode already
  setMode(wanted, nowMs);
  return MAV_RESULT_ACCEPTED;
}

uint8_t Autopilot::startMission(float first, uint32_t nowMs) {
  if (!isPx4()) {
    const uint8_t result = orderMode(modeOf(kind, Means::Mission), nowMs);
    if (result == MAV_RESULT_ACCEPTED && isArmed) mayClimb_ = true;
    return result;
  }
  if (plan.empty() || first >= static_cast<float>(plan.size())) return MAV_RESULT_DENIED;
  // It sets the mode, and then checks whether it may be armed: it may not in a mode that lands.
  const bool canArm = isArmed || !(is(Means::Return) || is(Means::Land));
  current_ = static_cast<uint16_t>(first);
  setMode(modeOf(kind, Means::Mission), nowMs);
  if (!canArm) return refusal();
  setArmed(true);
  return MAV_RESULT_ACCEPTED;
}

uint8_t Autopilot::takeOff(float height, uint32_t nowMs) {
  if (kind == Kind::Rover) return MAV_RESULT_UNSUPPORTED;
  if (isPx4()) {
    setMode(modeOf(kind, Means::TakeOff), nowMs);
    goalCm_ = isnan(height) ? 250 : static_cast<int32_t>(height * 100) - kHomeCm;
    return MAV_RESULT_ACCEPTED;
  }
  if (!is(Means::Guided) || !isArmed || isAirborne()) return refusal();
  goalCm_ = static_cast<int32_t>(height * 100);
  return MAV_RESULT_ACCEPTED;
}

uint8_t Autopilot::command(const mavlink_command_long_t& given, bool isInt, uint32_t nowMs) {
  switch (given.command) {
    case MAV_CMD_COMPONENT_ARM_DISARM: return arm(given.param1 == 1);
    case MAV_CMD_MISSION_START: return startMission(given.param1, nowMs);
    case MAV_CMD_NAV_TAKEOFF: return takeOff(given.param7, nowMs);
    case MAV_CMD_DO_REPOSITION: {
      const bool setsMode = given.param2 == 1;
      if (isPx4() ? !setsMode : !isInt) return MAV_RESULT_UNSUPPORTED;
      if (!setsMode && !is(Means::Guided)) return MAV_RESULT_DENIED;
      setMode(modeOf(kind, isPx4() ? Means::Hold : Means::Guided), nowMs);
      return MAV_RESULT_ACCEPTED;
    }
    case MAV_CMD_DO_CHANGE_SPEED: return MAV_RESULT_ACCEPTED;
    default: return MAV_RESULT_UNSUPPORTED;
  }
}

// OFFBOARD is still what was ordered: it is flown again when targets come.
void Autopilot::hearTarget(uint32_t nowMs) {
  streamedMs_ = nowMs;
  if (hasLostStream_) setMode(modeOf(kind, Means::Offboard), nowMs);
}

// ArduPilot's answer names the number that was asked for, though 0 means the same as 1.
void Autopilot::hearSetCurrent(uint16_t item, uint32_t nowMs) {
  if (item >= plan.size() + firstItem()) return;
  current_ = isPx4() || plan.empty() ? item : std::max<uint16_t>(item, 1);
  if (!isPx4()) send(currentParts(item, static_cast<uint16_t>(plan.size()), MISSION_STATE_NOT_STARTED), nowMs + 5);
}

// ArduPilot sends a heartbeat at each change of the mode and none at arming; PX4 tells its mode once a second and on
// request.
void Autopilot::modeChanged(uint32_t nowMs) {
  hasLostStream_ = false;
  if (!isPx4()) sendFresh(MAVLINK_MSG_ID_HEARTBEAT, nowMs + 3);
}

void Autopilot::disarmed() {
  hasLostStream_ = false;
  if (!isPx4()) {
    current_ = 0;
  } else if (is(Means::Return) || is(Means::Land) || is(Means::TakeOff)) {
    mode = modeOf(kind, Means::Hold);
  }
}

uint8_t Autopilot::state() const {
  const bool isFlying = isArmed && (isPx4() || isAirborne());
  if (isInFailsafe_ && (isArmed || !isPx4())) return MAV_STATE_CRITICAL;
  return isFlying ? MAV_STATE_ACTIVE : MAV_STATE_STANDBY;
}

uint32_t Autopilot::customMode() const {
  return isPx4() ? static_cast<uint32_t>(mode & 0xFF) << 16 | static_cast<uint32_t>(mode >> 8) << 24 : mode;
}

FrameParts Autopilot::itemToRead(uint16_t item) const {
  if (item < firstItem()) return itemParts(0, homeItem(), mavmission::PlanType::Mission, systemId);
  mavlink_mission_item_int_t message = messageIn<mavlink_mission_item_int_t>(plan[item - firstItem()]);
  message.seq = item;
  message.target_system = systemId;
  message.target_component = 191;
  if (isPx4()) message.current = item == 0;
  if (isPx4() && message.frame == MAV_FRAME_GLOBAL_RELATIVE_ALT) message.frame = MAV_FRAME_GLOBAL_RELATIVE_ALT_INT;
  return FrameParts(MAVLINK_MSG_ID_MISSION_ITEM_INT, message);
}

// PX4 names its plan by a checksum.
uint32_t Autopilot::planId() const {
  uint32_t sum = 0;
  if (!isPx4()) return sum;
  for (const Bytes& item : plan) sum = px4Checksum(sum, messageIn<mavlink_mission_item_int_t>(item));
  return sum;
}

int32_t Autopilot::heightGoal() const {
  if (kind == Kind::Rover || is(Means::Return) || is(Means::Land)) return 0;
  if (is(Means::Mission) && (isPx4() || mayClimb_) && heightCm < kTakeOffCm) return kTakeOffCm;
  return is(isPx4() ? Means::TakeOff : Means::Guided) && goalCm_ >= 0 ? goalCm_ : heightCm;
}

void Autopilot::atHeight(uint32_t nowMs) {
  if (is(Means::Mission)) current_ = static_cast<uint16_t>(firstItem() + 1);
  if (is(Means::TakeOff)) setMode(modeOf(kind, Means::Hold), nowMs);
}

void Autopilot::beat(uint32_t nowMs) {
  if (!isArmed || !is(Means::Offboard) || nowMs - streamedMs_ < kGoneMs) return;
  setMode(modeOf(kind, Means::Return), nowMs);
  isInFailsafe_ = hasLostStream_ = true;
}
