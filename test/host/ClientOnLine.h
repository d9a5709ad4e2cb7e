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

  // `startMs`: what millis() says at the beginning; 0 is after a reset, when answers to what was before may come.
  explicit ClientOnLine(uint8_t autopilot, uint32_t startMs = 65000);

  uint32_t nowMs() const { return nowMs_; }

  // A frame of the peer's, the next by its sequence number: nothing was lost.
  void hear(FrameParts parts);

  // So many frames of the peer's are lost.
  void lose(uint8_t frames) { sequence_ = static_cast<uint8_t>(sequence_ + frames); }

  // An update() every `step` ms, of which `ms` is a multiple, and a heartbeat each second.
  void run(uint32_t ms, uint32_t step = 1);

  // Until a frame of this message has left; false if none does in that time. `sent` ends with it.
  bool runUntilSent(uint16_t messageId, uint32_t limitMs);

  // When the frames of this message left [ms, since `from`].
  std::vector<uint32_t> timesOf(uint16_t messageId, uint32_t from) const;

 private:
  // DO_VTOL_TRANSITION, which a vehicle that is no plane answers with UNSUPPORTED.
  bool isForVehicle(const FrameParts& parts);

  void note(const Bytes& bytes);

  uint8_t autopilot_;
  uint8_t sequence_ = 0;
  uint32_t nowMs_;
  FrameCutter cutter_;
};
