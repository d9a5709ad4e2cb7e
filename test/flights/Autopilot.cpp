#include "Autopilot.h"

#include <algorithm>

namespace {

constexpr int32_t kLatitudeE7 = -353632621, kLongitudeE7 = 1491652374, kHomeMm = 584000;
constexpr uint32_t kBeatMs = 1000, kMoveMs = 100;
constexpr int32_t kClimbCm = 20, kSinkCm = 20;  // in each kMoveMs
constexpr uint32_t kDisarmMs = 2000;            // it disarms so long after it has landed

}  // namespace

Autopilot::Autopilot(Kind which, uint8_t system, Witness& witness, uint32_t firstBeatMs)
    : kind(which),
      systemId(system),
      mode(modeOf(which, which == Kind::Px4 ? Means::Hold : Means::First)),
      witness_(witness) {
  streams_[MAVLINK_MSG_ID_HEARTBEAT] = {kBeatMs, firstBeatMs};
  if (isPx4()) {
    streams_[MAVLINK_MSG_ID_MISSION_CURRENT] = {kBeatMs, firstBeatMs + 420};
  }
  if (which != Kind::Rover) streams_[MAVLINK_MSG_ID_ATTITUDE] = {200, firstBeatMs + 57};
}

// --- Changes

void Autopilot::setMode(uint16_t wanted, uint32_t nowMs) {
  if (wanted == mode) return;
  mode = wanted;
  isInFailsafe_ = false;
  goalCm_ = -1;
  mayClimb_ = false;
  witness_.modeSet(wanted, by_);
  modeChanged(nowMs);
}

void Autopilot::setArmed(bool is) {
  if (is == isArmed) return;
  isArmed = is;
  if (!is) {
    mayClimb_ = false;
    goalCm_ = -1;
    isInFailsafe_ = false;
    disarmed();
  }
  witness_.armed(is, by_);
}

void Autopilot::putInAir(uint32_t nowMs) {
  by_ = By::Itself;
  setArmed(true);
  setMode(modeOf(kind, Means::Mission), nowMs);
  mayClimb_ = true;
  heightCm = kind == Kind::Rover ? 0 : 1000;
  current_ = static_cast<uint16_t>(firstItem() + 1);
}

void Autopilot::actorSetsMode(uint16_t wanted, bool isFailsafe, uint32_t nowMs) {
  if (mode == wanted) return;
  by_ = By::Actor;
  setMode(wanted, nowMs);
  isInFailsafe_ = isFailsafe;
  by_ = By::Itself;
}

void Autopilot::actorDisarms(uint32_t) {
  by_ = By::Actor;
  heightCm = 0;
  setArmed(false);
  by_ = By::Itself;
}

// --- What it hears

void Autopilot::hear(const Message& message, uint32_t nowMs) {
  by_ = By::Order;
  switch (message.id) {
    case MAVLINK_MSG_ID_COMMAND_LONG: hearCommand(read<mavlink_command_long_t>(message), false, nowMs); break;
    case MAVLINK_MSG_ID_COMMAND_INT: {
      const mavlink_command_int_t given = read<mavlink_command_int_t>(message);
      mavlink_command_long_t asLong = mavlink_command_long_t();
      asLong.command = given.command;
      asLong.param1 = given.param1;
      asLong.param2 = given.param2;
      asLong.param7 = given.z;
      hearCommand(asLong, true, nowMs);
      break;
    }
    case MAVLINK_MSG_ID_SET_POSITION_TARGET_GLOBAL_INT: hearTarget(nowMs); break;
    default: hearMission(message, nowMs);
  }
  by_ = By::Itself;
}

void Autopilot::hearCommand(const mavlink_command_long_t& given, bool isInt, uint32_t nowMs) {
  const uint32_t answerMs = nowMs + (isPx4() ? 8 : 4);
  const uint32_t id = static_cast<uint32_t>(given.param1);
  uint8_t result;
  switch (given.command) {
    case MAV_CMD_REQUEST_MESSAGE:
      result = canTell(id) ? static_cast<uint8_t>(MAV_RESULT_ACCEPTED) : static_cast<uint8_t>(MAV_RESULT_DENIED);
      if (isPx4() && id == MAVLINK_MSG_ID_MISSION_CURRENT) result = MAV_RESULT_DENIED;
      // PX4 sends the message before its answer, ArduPilot after it.
      if (result == MAV_RESULT_ACCEPTED) sendFresh(id, isPx4() ? answerMs - 1 : answerMs + 1);
      break;
    case MAV_CMD_SET_MESSAGE_INTERVAL:
      result = isPx4() && id == MAVLINK_MSG_ID_MISSION_CURRENT ? static_cast<uint8_t>(MAV_RESULT_FAILED)
                                                               : static_cast<uint8_t>(MAV_RESULT_ACCEPTED);
      if (result == MAV_RESULT_ACCEPTED) setStream(id, static_cast<uint32_t>(given.param2) / 1000, nowMs);
      break;
    case MAV_CMD_DO_SET_MODE:
      result = orderMode(
          static_cast<uint16_t>(static_cast<uint32_t>(given.param2) | static_cast<uint32_t>(given.param3) << 8), nowMs);
      break;
    default: result = command(given, isInt, nowMs);
  }
  mavlink_command_ack_t ack = mavlink_command_ack_t();
  ack.command = given.command;
  ack.target_system = systemId;
  ack.target_component = 191;
  if (isPx4() && given.command == MAV_CMD_DO_SET_MODE) {  // two of its parts answer, the first one too soon
    ack.result = MAV_RESULT_ACCEPTED;
    send(messageOf(MAVLINK_MSG_ID_COMMAND_ACK, ack), answerMs - 4);
  }
  ack.result = result;
  send(messageOf(MAVLINK_MSG_ID_COMMAND_ACK, ack), answerMs);
}

// --- What it sends

void Autopilot::send(const Message& message, uint32_t atMs) {
  const Sending sending = {atMs, message};
  const auto later = [](const Sending& a, const Sending& b) { return a.atMs < b.atMs; };
  sending_.insert(std::upper_bound(sending_.begin(), sending_.end(), sending, later), sending);
}

void Autopilot::setStream(uint32_t id, uint32_t everyMs, uint32_t nowMs) {
  if (streams_.count(id) == 0 || streams_[id].first != everyMs) streams_[id] = {everyMs, nowMs + everyMs};
}

bool Autopilot::canTell(uint32_t id) const {
  return id == MAVLINK_MSG_ID_HEARTBEAT || id == MAVLINK_MSG_ID_MISSION_CURRENT ||
         id == MAVLINK_MSG_ID_GLOBAL_POSITION_INT || id == MAVLINK_MSG_ID_EXTENDED_SYS_STATE ||
         id == MAVLINK_MSG_ID_HOME_POSITION;
}

Message Autopilot::composed(uint32_t id) const {
  switch (id) {
    case MAVLINK_MSG_ID_MISSION_CURRENT: {
      mavlink_mission_current_t message = mavlink_mission_current_t();
      message.seq = current_;
      message.total = plan.empty() && isPx4() ? 65535 : static_cast<uint16_t>(plan.size());
      const bool isFlown = is(Means::Mission) && isArmed;
      message.mission_state = plan.empty() ? MISSION_STATE_NO_MISSION
                              : isFlown    ? MISSION_STATE_ACTIVE
                                           : MISSION_STATE_NOT_STARTED;
      message.mission_id = planId();
      return messageOf(id, message);
    }
    case MAVLINK_MSG_ID_GLOBAL_POSITION_INT: {
      mavlink_global_position_int_t message = mavlink_global_position_int_t();
      message.lat = kLatitudeE7;
      message.lon = kLongitudeE7;
      message.relative_alt = heightCm * 10;
      message.alt = kHomeMm + heightCm * 10;
      return messageOf(id, message);
    }
    case MAVLINK_MSG_ID_EXTENDED_SYS_STATE: {
      mavlink_extended_sys_state_t message = mavlink_extended_sys_state_t();
      message.landed_state = isAirborne() ? MAV_LANDED_STATE_IN_AIR : MAV_LANDED_STATE_ON_GROUND;
      return messageOf(id, message);
    }
    case MAVLINK_MSG_ID_HOME_POSITION: {
      mavlink_home_position_t message = mavlink_home_position_t();
      message.latitude = kLatitudeE7;
      message.longitude = kLongitudeE7;
      message.altitude = kHomeMm;
      return messageOf(id, message);
    }
    case MAVLINK_MSG_ID_HEARTBEAT: {
      mavlink_heartbeat_t message = mavlink_heartbeat_t();
      message.custom_mode = customMode();
      message.type = kind == Kind::Rover ? MAV_TYPE_GROUND_ROVER : MAV_TYPE_QUADROTOR;
      message.autopilot = isPx4() ? MAV_AUTOPILOT_PX4 : MAV_AUTOPILOT_ARDUPILOTMEGA;
      message.base_mode =
          static_cast<uint8_t>(MAV_MODE_FLAG_CUSTOM_MODE_ENABLED | (isArmed ? MAV_MODE_FLAG_SAFETY_ARMED : 0));
      message.system_status = state();
      message.mavlink_version = 3;
      return messageOf(id, message);
    }
    default: return messageOf(MAVLINK_MSG_ID_ATTITUDE, mavlink_attitude_t());
  }
}

std::vector<Message> Autopilot::takeSent() {
  std::vector<Message> sent;
  sent.swap(sent_);
  return sent;
}

// --- Time

uint32_t Autopilot::nextMs() const {
  uint32_t next = movedMs_ + kMoveMs;
  if (!sending_.empty()) next = std::min(next, sending_.front().atMs);
  for (const auto& stream : streams_) {
    if (stream.second.first != 0) next = std::min(next, stream.second.second);
  }
  return next;
}

void Autopilot::pass(uint32_t nowMs) {
  while (nowMs - movedMs_ >= kMoveMs) {
    movedMs_ += kMoveMs;
    beat(movedMs_);
    if (isReceiving_) lookForItem(movedMs_);
    if (!isArmed) {
      heightCm = 0;
      landedMs_ = movedMs_;
      continue;
    }
    const int32_t goal = heightGoal(), before = heightCm;
    if (goal > heightCm) heightCm = std::min(goal, heightCm + kClimbCm);
    if (goal < heightCm) heightCm = std::max(goal, heightCm - kSinkCm);
    if (heightCm == goal && before != goal) atHeight(movedMs_);
    const bool isLanding = is(Means::Return) || is(Means::Land);
    if (heightCm != 0 || !isLanding || kind == Kind::Rover) {
      landedMs_ = movedMs_;
    } else if (movedMs_ - landedMs_ >= kDisarmMs) {
      setArmed(false);
    }
  }
  while (!sending_.empty() && sending_.front().atMs <= nowMs) {
    const Message message = sending_.front().message;
    sending_.erase(sending_.begin());
    sent_.push_back(message.payload.empty() ? composed(message.id) : message);
  }
  for (auto& stream : streams_) {
    if (stream.second.first == 0 || stream.second.second > nowMs) continue;
    stream.second.second += stream.second.first;
    sent_.push_back(composed(stream.first));
  }
}
