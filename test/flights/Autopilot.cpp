#include "Autopilot.h"

#include <algorithm>

namespace {

constexpr int32_t kLatitudeE7 = -353632621, kLongitudeE7 = 1491652374, kHomeMm = 584000;
constexpr uint32_t kHeartbeatMs = 1000, kMoveMs = 100;
constexpr int32_t kClimbCm = 20, kSinkCm = 20;  // in each kMoveMs
constexpr uint32_t kDisarmMs = 2000;            // it disarms so long after it has landed

bool canTell(uint32_t id) {
  return id == MAVLINK_MSG_ID_HEARTBEAT || id == MAVLINK_MSG_ID_MISSION_CURRENT ||
         id == MAVLINK_MSG_ID_GLOBAL_POSITION_INT || id == MAVLINK_MSG_ID_EXTENDED_SYS_STATE ||
         id == MAVLINK_MSG_ID_HOME_POSITION;
}

}  // namespace

Autopilot::Autopilot(Kind which, uint8_t system, Witness& witness, uint32_t firstBeatMs)
    : kind(which),
      systemId(system),
      mode(modeOf(which, which == Kind::Px4 ? Means::Hold : Means::First)),
      witness_(witness) {
  setStream(MAVLINK_MSG_ID_HEARTBEAT, kHeartbeatMs, firstBeatMs);
  if (isPx4()) setStream(MAVLINK_MSG_ID_MISSION_CURRENT, kHeartbeatMs, firstBeatMs + 420);
  if (which != Kind::Rover) setStream(MAVLINK_MSG_ID_ATTITUDE, 200, firstBeatMs + 57);
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

void Autopilot::actorDisarms() {
  by_ = By::Actor;
  heightCm = 0;
  setArmed(false);
  by_ = By::Itself;
}

// --- What it hears

void Autopilot::hear(const FrameParts& message, uint32_t nowMs) {
  by_ = By::Order;
  switch (message.messageId) {
    case MAVLINK_MSG_ID_COMMAND_LONG:
      hearCommand(messageIn<mavlink_command_long_t>(message.payload), false, nowMs);
      break;
    case MAVLINK_MSG_ID_COMMAND_INT: {
      const mavlink_command_int_t given = messageIn<mavlink_command_int_t>(message.payload);
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
      if (!canTell(id) || (isPx4() && id == MAVLINK_MSG_ID_MISSION_CURRENT)) {
        result = MAV_RESULT_DENIED;
        break;
      }
      result = MAV_RESULT_ACCEPTED;
      // PX4 sends the message before its answer, ArduPilot after it.
      sendFresh(id, isPx4() ? answerMs - 1 : answerMs + 1);
      break;
    case MAV_CMD_SET_MESSAGE_INTERVAL:
      result = isPx4() && id == MAVLINK_MSG_ID_MISSION_CURRENT ? MAV_RESULT_FAILED : MAV_RESULT_ACCEPTED;
      if (result == MAV_RESULT_ACCEPTED) {
        const uint32_t everyMs = static_cast<uint32_t>(given.param2) / 1000;
        setStream(id, everyMs, nowMs + everyMs);
      }
      break;
    case MAV_CMD_DO_SET_MODE:
      result = orderMode(
          static_cast<uint16_t>(static_cast<uint32_t>(given.param2) | static_cast<uint32_t>(given.param3) << 8), nowMs);
      break;
    default: result = command(given, isInt, nowMs);
  }
  // Two of PX4's parts answer, the first one too soon.
  if (isPx4() && given.command == MAV_CMD_DO_SET_MODE)
    send(commandAckParts(given.command, MAV_RESULT_ACCEPTED, systemId), answerMs - 4);
  send(commandAckParts(given.command, result, systemId), answerMs);
}

// --- What it sends

void Autopilot::send(const FrameParts& message, uint32_t atMs) {
  const Sending sending = {atMs, message};
  const auto later = [](const Sending& a, const Sending& b) { return a.atMs < b.atMs; };
  sending_.insert(std::upper_bound(sending_.begin(), sending_.end(), sending, later), sending);
}

void Autopilot::setStream(uint32_t id, uint32_t everyMs, uint32_t nextMs) {
  const auto isBefore = [](const Stream& one, uint32_t other) { return one.id < other; };
  const auto at = std::lower_bound(streams_.begin(), streams_.end(), id, isBefore);
  if (at == streams_.end() || at->id != id) {
    streams_.insert(at, Stream{id, everyMs, nextMs});
  } else if (at->everyMs != everyMs) {
    *at = Stream{id, everyMs, nextMs};
  }
}

FrameParts Autopilot::composed(uint32_t id) const {
  switch (id) {
    case MAVLINK_MSG_ID_MISSION_CURRENT: {
      const uint16_t total = plan.empty() && isPx4() ? 65535 : static_cast<uint16_t>(plan.size());
      const bool isFlown = is(Means::Mission) && isArmed;
      const uint8_t flown = isFlown ? MISSION_STATE_ACTIVE : MISSION_STATE_NOT_STARTED;
      return currentParts(current_, total, plan.empty() ? uint8_t{MISSION_STATE_NO_MISSION} : flown, planId());
    }
    case MAVLINK_MSG_ID_GLOBAL_POSITION_INT: {
      mavlink_global_position_int_t message = mavlink_global_position_int_t();
      message.lat = kLatitudeE7;
      message.lon = kLongitudeE7;
      message.relative_alt = heightCm * 10;
      message.alt = kHomeMm + heightCm * 10;
      return FrameParts(id, message);
    }
    case MAVLINK_MSG_ID_EXTENDED_SYS_STATE: {
      mavlink_extended_sys_state_t message = mavlink_extended_sys_state_t();
      message.landed_state = isAirborne() ? MAV_LANDED_STATE_IN_AIR : MAV_LANDED_STATE_ON_GROUND;
      return FrameParts(id, message);
    }
    case MAVLINK_MSG_ID_HOME_POSITION: {
      mavlink_home_position_t message = mavlink_home_position_t();
      message.latitude = kLatitudeE7;
      message.longitude = kLongitudeE7;
      message.altitude = kHomeMm;
      return FrameParts(id, message);
    }
    case MAVLINK_MSG_ID_HEARTBEAT: {
      const uint8_t type = kind == Kind::Rover ? MAV_TYPE_GROUND_ROVER : MAV_TYPE_QUADROTOR;
      const uint8_t autopilot = isPx4() ? MAV_AUTOPILOT_PX4 : MAV_AUTOPILOT_ARDUPILOTMEGA;
      return heartbeatParts(autopilot, isArmed ? 1 | 128 : 1, customMode(), type, state());
    }
    default: return FrameParts(MAVLINK_MSG_ID_ATTITUDE, mavlink_attitude_t());
  }
}

std::vector<FrameParts> Autopilot::takeSent() {
  std::vector<FrameParts> sent;
  sent.swap(sent_);
  return sent;
}

// --- Time

uint32_t Autopilot::nextMs() const {
  uint32_t next = movedMs_ + kMoveMs;
  if (!sending_.empty()) next = std::min(next, sending_.front().atMs);
  for (const Stream& stream : streams_) {
    if (stream.everyMs != 0) next = std::min(next, stream.nextMs);
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
    const FrameParts message = sending_.front().message;
    sending_.erase(sending_.begin());
    sent_.push_back(message.payload.empty() ? composed(message.messageId) : message);
  }
  for (Stream& stream : streams_) {
    if (stream.everyMs == 0 || stream.nextMs > nowMs) continue;
    stream.nextMs += stream.everyMs;
    sent_.push_back(composed(stream.id));
  }
}
