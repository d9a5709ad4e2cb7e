// MissionClient's commands: one at a time, each confirmed by COMMAND_ACK. MAVLink guide, Command Protocol.
#include <Arduino.h>

#include "Clock.h"
#include "Messages.h"
#include "MissionClient.h"
#include "Sending.h"

namespace mavmission {
namespace {

constexpr uint16_t kNextAnswerMs = UploadTransfer::kAnswerMs + 100;  // from an answer to that to the next sending
constexpr uint16_t kProgressMs = 5000;  // the wait after IN_PROGRESS, and for a command that is sent only once

Status fromCommandResult(uint8_t result) {
  switch (result) {
    case MAV_RESULT_ACCEPTED:
      return Status::Done;
    case MAV_RESULT_TEMPORARILY_REJECTED:
      return Status::CommandRejected;
    case MAV_RESULT_DENIED:
      return Status::CommandDenied;
    case MAV_RESULT_UNSUPPORTED:
      return Status::CommandUnsupported;
    case MAV_RESULT_FAILED:
      return Status::CommandFailed;
    default:
      return Status::CommandRefused;
  }
}

}  // namespace

Status MissionClient::beginCommand(void (*fill)(MissionClient&, FlightCommand&), uint32_t argument) {
  if (state_.operation != nullptr) return Status::Busy;
  startOperation(commandStep);
  // What the command before leaves to sendCommand(); if it was another operation, any numbers, and at worst a short wait.
  const uint16_t id = commanding_.id, sentMs = commanding_.sentMs, waitMs = commanding_.waitMs;
  memset(&commanding_, 0, sizeof(commanding_));
  commanding_.id = id;
  commanding_.sentMs = sentMs;
  commanding_.waitMs = waitMs < kProgressMs ? waitMs : kProgressMs;
  commanding_.argument = argument;
  nextCommand(fill);
  return state_.status;
}

void MissionClient::nextCommand(void (*fill)(MissionClient&, FlightCommand&)) {
  commanding_.fill = fill;
  commanding_.tries = 0;
  commanding_.isDue = true;
  commanding_.repeats = true;
}

void MissionClient::commandStep(MissionClient& client, const FrameParser* frame, uint16_t nowMs) {
  State& state = client.state_;
  Commanding& commanding = client.commanding_;
  if (frame != nullptr) {
    if (state.status == Status::Transferring) client.takeCommandFrame(*frame, nowMs);
    return;
  }
  if (state.status == Status::WaitingForAutopilot) {
    client.waitForAutopilot();
    if (state.status != Status::Checking) return;
    const Status ready = commanding.prepare != nullptr ? commanding.prepare(client) : Status::Transferring;
    if (ready != Status::Transferring) return client.end(ready);
    state.status = Status::Transferring;
    client.beginSeconds(nowMs);
  }
  if (state.isLate) return client.end(Status::TookTooLong);
  if (!commanding.isDue && since(commanding.sentMs, nowMs) >= commanding.waitMs) {
    // It may have been heard and its answer lost: what must not happen twice is not sent again.
    if (!commanding.repeats) return client.end(Status::Unconfirmed);
    if (commanding.tries == UploadTransfer::kTries) return client.end(Status::NoAnswer);
    commanding.isDue = true;
  }
  if (commanding.isDue && client.link_.canSend() && client.isHeavyAllowed()) client.sendCommand(nowMs);
}

void MissionClient::sendCommand(uint16_t nowMs) {
  FlightCommand command = flightCommand(0);
  commanding_.fill(*this, command);
  // COMMAND_ACK does not say which sending it answers. One that was sent twice may be answered twice: the same one with
  // another meaning, and a step of start(), waits until the second answer should have come.
  const bool isAlike = commanding_.id == command.id || commanding_.accepted != nullptr;
  if (commanding_.tries == 0 && isAlike && since(commanding_.sentMs, nowMs) < commanding_.waitMs) return;
  commanding_.id = command.id;
  if (commanding_.byMessage) {
    mavlink_mission_set_current_t message = mavlink_mission_set_current_t();
    message.seq = static_cast<uint16_t>(commanding_.argument);
    link_.send(message);
  } else if (command.hasPlace) {
    mavlink_command_int_t message = mavlink_command_int_t();
    message.param1 = command.param1;
    message.param2 = command.param2;
    message.param3 = command.param3;
    message.param4 = command.param4;
    message.x = command.x;
    message.y = command.y;
    message.z = command.param7;
    message.command = command.id;
    message.frame = static_cast<uint8_t>(command.frame);
    link_.send(message);
  } else {
    mavlink_command_long_t message = mavlink_command_long_t();
    message.param1 = command.param1;
    message.param2 = command.param2;
    message.param3 = command.param3;
    message.param4 = command.param4;
    message.param5 = command.param5;
    message.param6 = command.param6;
    message.param7 = command.param7;
    message.command = command.id;
    message.confirmation = commanding_.tries;
    link_.send(message);
  }
  ++commanding_.tries;
  commanding_.isDue = false;
  commanding_.sentMs = nowMs;
  commanding_.waitMs = commanding_.repeats ? UploadTransfer::kAnswerMs : kProgressMs;
}

void MissionClient::takeCommandFrame(const FrameParser& frame, uint16_t nowMs) {
  Status status;
  if (frame.messageId() == MAVLINK_MSG_ID_COMMAND_ACK && !commanding_.byMessage) {
    const mavlink_command_ack_t ack = messageFrom<mavlink_command_ack_t>(frame);
    if (ack.command != commanding_.id || commanding_.tries == 0) return;
    rest_.lastResult = ack.result;
    if (ack.result == MAV_RESULT_IN_PROGRESS) {
      commanding_.sentMs = nowMs;
      commanding_.waitMs = kProgressMs;
      commanding_.isDue = false;
      return;
    }
    status = fromCommandResult(ack.result);
    // The others come as long behind this one as they were sent behind the first.
    commanding_.sentMs = nowMs;
    commanding_.waitMs = (commanding_.tries - 1) * kNextAnswerMs;
  } else if (frame.messageId() == MAVLINK_MSG_ID_MISSION_CURRENT && commanding_.byMessage) {
    // The older message has no answer of its own: what is current now is the answer. Another item is none.
    const mavlink_mission_current_t current = messageFrom<mavlink_mission_current_t>(frame);
    if (current.seq != static_cast<uint16_t>(commanding_.argument) || commanding_.tries == 0) return;
    status = Status::Done;
  } else if (frame.messageId() == MAVLINK_MSG_ID_HEARTBEAT && commanding_.fill == nullptr && isArmed()) {
    status = Status::Done;  // start(): its last step was accepted before
  } else {
    return;
  }
  if (status == Status::CommandUnsupported && commanding_.unsupported != nullptr) {
    status = commanding_.unsupported(*this);
  } else if (status == Status::Done && commanding_.accepted != nullptr) {
    status = commanding_.accepted(*this);
  }
  if (status != Status::Transferring) end(status);
}

Status MissionClient::send(const FlightCommand& command, Repeat repeat) {
  const Status status = beginCommand(fillOwn, 0);
  if (status == Status::Busy) return status;
  commanding_.own = &command;
  commanding_.prepare = prepareOwn;
  commanding_.repeats = repeat == Repeat::Always || !isOnceOnly(command.id);
  return status;
}

Status MissionClient::prepareOwn(MissionClient& client) {
  // It would arm.
  const bool arms = client.commanding_.own->id == MAV_CMD_MISSION_START && client.firmware() == Firmware::Px4;
  return arms && !client.isArmed() ? Status::NotArmed : Status::Transferring;
}

void MissionClient::fillOwn(MissionClient& client, FlightCommand& command) {
  command = *client.commanding_.own;
  if (command.id == MAV_CMD_COMPONENT_ARM_DISARM) command.param2 = 0;  // never forced
}

Status MissionClient::arm() { return beginCommand(fillArm, 1); }

Status MissionClient::disarm() { return beginCommand(fillArm, 0); }

void MissionClient::fillArm(MissionClient& client, FlightCommand& command) {
  command.id = MAV_CMD_COMPONENT_ARM_DISARM;
  command.param1 = client.commanding_.argument != 0 ? 1 : 0;  // param2 stays 0: never forced
}

bool MissionClient::setModeNumbers(FlightMode mode) {
  return modeNumbers(mode, firmware(), link_.finder().heartbeat().vehicleType, commanding_.mainMode,
                     commanding_.subMode);
}

bool MissionClient::isInMode(FlightMode mode) const {
  const Heartbeat& heartbeat = link_.finder().heartbeat();
  return mavmission::isInMode(mode, firmware(), heartbeat.vehicleType, heartbeat.customMode);
}

Status MissionClient::setMode(FlightMode mode) {
  const Status status = beginCommand(fillMode, static_cast<uint32_t>(mode));
  if (status != Status::Busy) commanding_.prepare = prepareMode;
  return status;
}

Status MissionClient::prepareMode(MissionClient& client) {
  const FlightMode mode = static_cast<FlightMode>(client.commanding_.argument);
  return client.setModeNumbers(mode) ? Status::Transferring : Status::NoSuchMode;
}

void MissionClient::fillMode(MissionClient& client, FlightCommand& command) {
  command.id = MAV_CMD_DO_SET_MODE;
  command.param1 = MAV_MODE_FLAG_CUSTOM_MODE_ENABLED;
  command.param2 = client.commanding_.mainMode;
  command.param3 = client.commanding_.subMode;
}

Status MissionClient::setCustomMode(uint32_t customMode) {
  const Status status = beginCommand(fillMode, 0);
  if (status == Status::Busy) return status;
  const bool isPx4s = customMode > 0xFFFF;  // PX4 has main and sub mode in the upper half
  commanding_.mainMode = static_cast<uint8_t>(isPx4s ? customMode >> 16 : customMode);
  commanding_.subMode = static_cast<uint8_t>(isPx4s ? customMode >> 24 : 0);
  return status;
}

Status MissionClient::setCurrentItem(uint16_t item) {
  const Status status = beginCommand(fillCurrent, item);
  if (status == Status::Busy) return status;
  commanding_.prepare = prepareCurrent;
  commanding_.unsupported = currentUnsupported;
  return status;
}

// The sketch's item becomes the autopilot's.
Status MissionClient::prepareCurrent(MissionClient& client) {
  if (client.firmware() == Firmware::ArduPilot && !client.rest_.raw) ++client.commanding_.argument;
  return Status::Transferring;
}

void MissionClient::fillCurrent(MissionClient& client, FlightCommand& command) {
  command.id = MAV_CMD_DO_SET_MISSION_CURRENT;
  command.param1 = client.commanding_.argument;
}

Status MissionClient::currentUnsupported(MissionClient& client) {
  client.nextCommand(fillCurrent);
  client.commanding_.byMessage = true;
  return Status::Transferring;
}

Status MissionClient::setMessageInterval(uint16_t messageId, int32_t intervalUs) {
  const Status status = beginCommand(fillInterval, static_cast<uint32_t>(intervalUs));
  if (status != Status::Busy) state_.next = messageId;
  return status;
}

void MissionClient::fillInterval(MissionClient& client, FlightCommand& command) {
  command.id = MAV_CMD_SET_MESSAGE_INTERVAL;
  command.param1 = client.state_.next;
  command.param2 = static_cast<float>(static_cast<int32_t>(client.commanding_.argument));
}

uint16_t MissionClient::itemFromWire(uint16_t wireItem) const {
  const uint8_t home = firmware() == Firmware::ArduPilot && !rest_.raw ? 1 : 0;
  return wireItem < home ? kNoItem : wireItem - home;
}

void MissionClient::noteInfeasible() {
  if (state_.status == Status::Infeasible || aboard() != Aboard::OurPlan) return;
  if (state_.operation != nullptr && state_.operation != commandStep) return;
  rest_.infeasible = true;
  end(Status::Infeasible);
}

}  // namespace mavmission
