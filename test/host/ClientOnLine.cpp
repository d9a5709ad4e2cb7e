#include "ClientOnLine.h"

#include "PlanFrames.h"
#include "mavmission/base/MavlinkHeaders.h"

ClientOnLine::ClientOnLine(uint8_t autopilot, uint32_t startMs) : client(line), autopilot_(autopilot), nowMs_(startMs) {
  setMillis(nowMs_);
}

void ClientOnLine::hear(FrameParts parts) {
  parts.sequence = sequence_++;
  if (autopilot_ == kArduPilot && parts.messageId == kRequestInt) {  // it asks by MISSION_REQUEST
    parts.messageId = kRequest;
    parts.crcExtra = 230;
  }
  line.bring(packed(parts));
}

void ClientOnLine::run(uint32_t ms, uint32_t step) {
  for (uint32_t end = nowMs_ + ms; nowMs_ != end;) {
    if (beats && nowMs_ % 1000 < step) hear(heartbeatParts(autopilot_));
    setMillis(nowMs_ += step);
    const mavmission::Status status = client.update();
    if (returned.empty() || returned.back() != status) returned.push_back(status);
    if (status != mavmission::Status::Idle && !client.isBusy()) ended = status;
    if (isEnd(status)) ends.push_back(status);
    if (!line.written.empty()) note(line.takeWritten());
  }
}

bool ClientOnLine::runUntilSent(uint16_t messageId, uint32_t limitMs) {
  for (uint32_t end = nowMs_ + limitMs; nowMs_ != end;) {
    const size_t before = sent.size();
    run(1);
    for (size_t i = before; i < sent.size(); ++i) {
      if (sent[i].messageId == messageId) return true;
    }
  }
  return false;
}

std::vector<uint32_t> ClientOnLine::timesOf(uint16_t messageId, uint32_t from) const {
  std::vector<uint32_t> times;
  for (const SentFrame& frame : sent) {
    if (frame.messageId == messageId) times.push_back(frame.atMs - from);
  }
  return times;
}

bool ClientOnLine::isForVehicle(const FrameParts& parts) {
  const mavlink_command_long_t command = messageIn<mavlink_command_long_t>(parts.payload);
  if (parts.messageId != MAVLINK_MSG_ID_COMMAND_LONG || command.command != MAV_CMD_DO_VTOL_TRANSITION) return false;
  hear(commandAckParts(command.command, MAV_RESULT_UNSUPPORTED));
  return true;
}

void ClientOnLine::note(const Bytes& bytes) {
  for (const FrameIn& frame : cutter_.take(bytes)) {
    if (saysVehicle && isForVehicle(frame.parts)) continue;
    sent.push_back({nowMs_, static_cast<uint16_t>(frame.parts.messageId), frame.parts.payload, frame.bytes});
  }
}
