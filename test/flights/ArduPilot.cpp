#include "ArduPilot.h"

namespace {
constexpr int32_t kTakeOffCm = 1000;
}

uint8_t ArduPilot::arm(bool arms) {
  if (!arms) {
    if (isAirborne()) return MAV_RESULT_FAILED;
    setArmed(false);
    return MAV_RESULT_ACCEPTED;
  }
  if (isArmed) return MAV_RESULT_ACCEPTED;
  if (is(Means::Mission) || is(Means::Return) || is(Means::Land)) return MAV_RESULT_FAILED;  // "Mode not armable"
  setArmed(true);
  return MAV_RESULT_ACCEPTED;
}

uint8_t ArduPilot::orderMode(uint16_t wanted, uint32_t nowMs) {
  if (wanted == modeOf(kind, Means::Mission) && plan.empty()) return MAV_RESULT_FAILED;
  setMode(wanted, nowMs);
  return MAV_RESULT_ACCEPTED;
}

uint8_t ArduPilot::command(const mavlink_command_long_t& given, bool isInt, uint32_t nowMs) {
  switch (given.command) {
    case MAV_CMD_COMPONENT_ARM_DISARM: return arm(given.param1 == 1);
    case MAV_CMD_MISSION_START: {
      const uint8_t result = orderMode(modeOf(kind, Means::Mission), nowMs);
      if (result == MAV_RESULT_ACCEPTED && isArmed) mayClimb_ = true;
      return result;
    }
    case MAV_CMD_NAV_TAKEOFF:
      if (kind == Kind::Rover) return MAV_RESULT_UNSUPPORTED;
      if (!is(Means::Guided) || !isArmed || isAirborne()) return MAV_RESULT_FAILED;
      goalCm_ = static_cast<int32_t>(given.param7 * 100);
      return MAV_RESULT_ACCEPTED;
    case MAV_CMD_DO_REPOSITION:
      if (!isInt) return MAV_RESULT_UNSUPPORTED;
      if (!is(Means::Guided) && given.param2 != 1) return MAV_RESULT_DENIED;
      setMode(modeOf(kind, Means::Guided), nowMs);
      return MAV_RESULT_ACCEPTED;
    case MAV_CMD_DO_CHANGE_SPEED: return MAV_RESULT_ACCEPTED;
    default: return MAV_RESULT_UNSUPPORTED;
  }
}

// The answer names the number that was asked for, though 0 means the same as 1.
void ArduPilot::hearSetCurrent(uint16_t item, uint32_t nowMs) {
  if (item > plan.size()) return;
  current_ = item == 0 && !plan.empty() ? 1 : item;
  send(currentParts(item, static_cast<uint16_t>(plan.size()), MISSION_STATE_NOT_STARTED), nowMs + 5);
}

uint8_t ArduPilot::state() const {
  if (isInFailsafe_) return MAV_STATE_CRITICAL;
  return isArmed && isAirborne() ? MAV_STATE_ACTIVE : MAV_STATE_STANDBY;
}

FrameParts ArduPilot::itemToRead(uint16_t item) const {
  if (item == 0) return itemParts(0, homeItem(), mavmission::PlanType::Mission, systemId);
  mavlink_mission_item_int_t message = messageIn<mavlink_mission_item_int_t>(plan[item - 1u]);
  message.seq = item;
  message.target_system = systemId;
  message.target_component = 191;
  return FrameParts(MAVLINK_MSG_ID_MISSION_ITEM_INT, message);
}

int32_t ArduPilot::heightGoal() const {
  if (kind == Kind::Rover) return 0;
  if (is(Means::Return) || is(Means::Land)) return 0;
  if (is(Means::Mission) && mayClimb_ && heightCm < kTakeOffCm) return kTakeOffCm;
  return is(Means::Guided) && goalCm_ >= 0 ? goalCm_ : heightCm;
}

void ArduPilot::atHeight(uint32_t) {
  if (is(Means::Mission)) current_ = 2;
}
