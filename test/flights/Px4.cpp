#include "Px4.h"

#include <math.h>

#include "Px4Checksum.h"

namespace {

constexpr int32_t kTakeOffCm = 1000, kHomeCm = 58400;
constexpr uint32_t kStreamMs = 1000, kGoneMs = 1140;  // without a target OFFBOARD ends after kGoneMs

}  // namespace

bool Px4::hasStream(uint32_t nowMs) const { return streamedMs_ != 0 && nowMs - streamedMs_ <= kStreamMs; }

uint8_t Px4::arm(bool arms) {
  if (!arms) {
    if (isAirborne()) return MAV_RESULT_TEMPORARILY_REJECTED;
    setArmed(false);
    return MAV_RESULT_ACCEPTED;
  }
  if (isArmed) return MAV_RESULT_ACCEPTED;
  const bool isDenied = is(Means::Return) || is(Means::Land) || (is(Means::Mission) && plan.empty());
  if (isDenied) return MAV_RESULT_TEMPORARILY_REJECTED;
  setArmed(true);
  return MAV_RESULT_ACCEPTED;
}

uint8_t Px4::orderMode(uint16_t wanted, uint32_t nowMs) {
  if (isArmed && wanted == modeOf(kind, Means::Mission) && plan.empty()) return MAV_RESULT_TEMPORARILY_REJECTED;
  if (isArmed && wanted == modeOf(kind, Means::Offboard) && !hasStream(nowMs)) return MAV_RESULT_TEMPORARILY_REJECTED;
  hasLostStream_ = false;  // this holds even if it flies that mode already
  setMode(wanted, nowMs);
  return MAV_RESULT_ACCEPTED;
}

uint8_t Px4::command(const mavlink_command_long_t& given, bool, uint32_t nowMs) {
  switch (given.command) {
    case MAV_CMD_COMPONENT_ARM_DISARM: return arm(given.param1 == 1);
    case MAV_CMD_MISSION_START: {
      if (plan.empty() || given.param1 >= static_cast<float>(plan.size())) return MAV_RESULT_DENIED;
      // It sets the mode, and then checks whether it may be armed: it may not in a mode that lands.
      const bool canArm = isArmed || !(is(Means::Return) || is(Means::Land));
      current_ = static_cast<uint16_t>(given.param1);
      setMode(modeOf(kind, Means::Mission), nowMs);
      if (!canArm) return MAV_RESULT_TEMPORARILY_REJECTED;
      setArmed(true);
      return MAV_RESULT_ACCEPTED;
    }
    case MAV_CMD_NAV_TAKEOFF:
      setMode(modeOf(kind, Means::TakeOff), nowMs);
      goalCm_ = isnan(given.param7) ? 250 : static_cast<int32_t>(given.param7 * 100) - kHomeCm;
      return MAV_RESULT_ACCEPTED;
    case MAV_CMD_DO_REPOSITION:
      if (given.param2 != 1) return MAV_RESULT_UNSUPPORTED;
      setMode(modeOf(kind, Means::Hold), nowMs);
      return MAV_RESULT_ACCEPTED;
    case MAV_CMD_DO_CHANGE_SPEED: return MAV_RESULT_ACCEPTED;
    default: return MAV_RESULT_UNSUPPORTED;
  }
}

// OFFBOARD is still what was ordered: it is flown again when targets come.
void Px4::hearTarget(uint32_t nowMs) {
  streamedMs_ = nowMs;
  if (!hasLostStream_) return;
  setMode(modeOf(kind, Means::Offboard), nowMs);
}

void Px4::hearSetCurrent(uint16_t item, uint32_t) {
  if (item < plan.size()) current_ = item;
}

void Px4::disarmed() {
  hasLostStream_ = false;
  if (is(Means::Return) || is(Means::Land) || is(Means::TakeOff)) mode = modeOf(kind, Means::Hold);
}

uint8_t Px4::state() const {
  if (!isArmed) return MAV_STATE_STANDBY;
  return isInFailsafe_ ? MAV_STATE_CRITICAL : MAV_STATE_ACTIVE;
}

uint32_t Px4::customMode() const {
  return static_cast<uint32_t>(mode & 0xFF) << 16 | static_cast<uint32_t>(mode >> 8) << 24;
}

FrameParts Px4::itemToRead(uint16_t item) const {
  mavlink_mission_item_int_t message = messageIn<mavlink_mission_item_int_t>(plan[item]);
  message.seq = item;
  if (message.frame == MAV_FRAME_GLOBAL_RELATIVE_ALT) message.frame = MAV_FRAME_GLOBAL_RELATIVE_ALT_INT;
  message.current = item == 0;
  message.target_system = systemId;
  message.target_component = 191;
  return FrameParts(MAVLINK_MSG_ID_MISSION_ITEM_INT, message);
}

uint32_t Px4::planId() const {
  uint32_t sum = 0;
  for (const Bytes& item : plan) sum = px4Checksum(sum, messageIn<mavlink_mission_item_int_t>(item));
  return sum;
}

int32_t Px4::heightGoal() const {
  if (is(Means::Return) || is(Means::Land)) return 0;
  if (is(Means::Mission) && heightCm < kTakeOffCm) return kTakeOffCm;
  return is(Means::TakeOff) && goalCm_ >= 0 ? goalCm_ : heightCm;
}

void Px4::atHeight(uint32_t nowMs) {
  if (is(Means::Mission)) current_ = 1;
  if (is(Means::TakeOff)) setMode(modeOf(kind, Means::Hold), nowMs);
}

void Px4::beat(uint32_t nowMs) {
  if (!isArmed || !is(Means::Offboard) || nowMs - streamedMs_ < kGoneMs) return;
  setMode(modeOf(kind, Means::Return), nowMs);
  isInFailsafe_ = hasLostStream_ = true;
}
