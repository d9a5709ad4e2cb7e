#include "ClientOnLine.h"

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
    note(line.takeWritten());
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

bool ClientOnLine::isForVehicle(uint16_t id, const Bytes& payload) {
  const uint8_t low = 3000 & 255, high = 3000 >> 8;
  if (id != 76 || payload[28] != low || payload[29] != high) return false;
  hear(FrameParts(77, {low, high, 3, 0, 0, 0, 0, 0, 1, 191}, 143));
  return true;
}

void ClientOnLine::note(const Bytes& bytes) {
  unread_ = unread_ + bytes;
  while (unread_.size() > 2) {
    if (unread_[0] == 0) {  // what fills before a repeat
      unread_.erase(unread_.begin());
      continue;
    }
    const bool isV2 = unread_[0] == 0xFD;
    const size_t header = isV2 ? 10 : 6;
    const size_t length = header + unread_[1] + 2;
    if (unread_.size() < length) return;
    const uint16_t id = static_cast<uint16_t>(isV2 ? unread_[7] | unread_[8] << 8 : unread_[5]);
    Bytes payload(unread_.begin() + static_cast<long>(header), unread_.begin() + static_cast<long>(length - 2));
    payload.resize(255);
    if (!(saysVehicle && isForVehicle(id, payload))) {
      const Bytes frame(unread_.begin(), unread_.begin() + static_cast<long>(length));
      sent.push_back({nowMs_, id, payload, frame});
    }
    unread_.erase(unread_.begin(), unread_.begin() + static_cast<long>(length));
  }
}
