// A MissionClient on a stream in memory, in simulated time, and what it sends frame by frame. The test is the peer.
#pragma once

#include <MavMission.h>

#include <vector>

#include "Frames.h"
#include "MemoryStream.h"

struct SentFrame {
  uint32_t atMs;
  uint16_t messageId;
  Bytes payload;  // with what MAVLink 2 left out
  Bytes frame;    // as it left
};

class ClientOnLine {
 public:
  // As in HEARTBEAT.autopilot. `kOther` is neither: MAV_AUTOPILOT_GENERIC_MISSION_FULL.
  enum : uint8_t { kOther = 7, kArduPilot = 3, kPx4 = 12 };
  // Ids of messages.
  enum : uint16_t { kRequest = 40, kRequestList = 43, kCount = 44, kAck = 47, kRequestInt = 51, kItemInt = 73 };

  MemoryStream line;
  mavmission::MissionClient client;
  std::vector<SentFrame> sent;                          // until it is emptied
  mavmission::Status ended = mavmission::Status::Idle;  // what update() returned of the last end
  std::vector<mavmission::Status> returned;             // what update() returned, each change
  std::vector<mavmission::Status> ends;                 // and each end

  bool beats = true;        // whether the peer sends heartbeats
  bool saysVehicle = true;  // whether it answers, as a vehicle that is no plane, when it is asked which one it is

  // `startMs`: what millis() says at the beginning; 0 is behind a reset, when answers to what was before may come.
  explicit ClientOnLine(uint8_t autopilot, uint32_t startMs = 65000)
      : client(line), autopilot_(autopilot), nowMs_(startMs) {
    setMillis(nowMs_);
  }

  uint32_t nowMs() const { return nowMs_; }

  // A frame of the peer's, the next by its sequence number: nothing was lost.
  void hear(FrameParts parts) {
    parts.sequence = sequence_++;
    if (autopilot_ == kArduPilot && parts.messageId == kRequestInt) {  // it asks by MISSION_REQUEST
      parts.messageId = kRequest;
      parts.crcExtra = 230;
    }
    line.bring(packed(parts));
  }

  // So many frames of the peer's are lost.
  void lose(uint8_t frames) { sequence_ = static_cast<uint8_t>(sequence_ + frames); }

  // An update() every `step` ms, of which `ms` is a multiple, and a heartbeat each second.
  void run(uint32_t ms, uint32_t step = 1) {
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

  // Until a frame of this message has left; false if none does in that time. `sent` ends with it.
  bool runUntilSent(uint16_t messageId, uint32_t limitMs) {
    for (uint32_t end = nowMs_ + limitMs; nowMs_ != end;) {
      const size_t before = sent.size();
      run(1);
      for (size_t i = before; i < sent.size(); ++i) {
        if (sent[i].messageId == messageId) return true;
      }
    }
    return false;
  }

  // When the frames of this message left [ms, since `from`].
  std::vector<uint32_t> timesOf(uint16_t messageId, uint32_t from) const {
    std::vector<uint32_t> times;
    for (const SentFrame& frame : sent) {
      if (frame.messageId == messageId) times.push_back(frame.atMs - from);
    }
    return times;
  }

 private:
  // DO_VTOL_TRANSITION, which a vehicle that is no plane answers with UNSUPPORTED.
  bool isForVehicle(uint16_t id, const Bytes& payload) {
    const uint8_t low = 3000 & 255, high = 3000 >> 8;
    if (id != 76 || payload[28] != low || payload[29] != high) return false;
    hear(FrameParts(77, {low, high, 3, 0, 0, 0, 0, 0, 1, 191}, 143));
    return true;
  }

  void note(const Bytes& bytes) {
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

  uint8_t autopilot_;
  uint8_t sequence_ = 0;
  uint32_t nowMs_;
  Bytes unread_;
};
