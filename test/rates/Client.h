// The library's own MissionClient that puts a plan aboard, as the measurement drives it: bytes and time in, bytes out.
// Its stream is a hardware serial port's, with a ring of its own.
#pragma once

#include <string>

#include "../explorer/Plans.h"
#include "MavMission.h"
#include "MemoryStream.h"
#include "Names.h"

constexpr uint8_t kPlan = 1, kOldPlan = 0;  // of explorer/Plans.h: meant, and aboard before
constexpr size_t kRing = 63;                // bytes that a serial port of the client's holds, each way

// upload(), uploadWithoutReadback(), or upload(plan, Readback::Always).
enum class Proven : uint8_t { InDoubt, ByAnswer, Always };

class Client {
 public:
  Client(Firmwares firmware, Proven proven, uint16_t items) : client_(begun(stream_)) {
    // These say "generic" in their heartbeats, as many devices do: they have to be named.
    if (isGeneric(firmware)) client_.setTargetIds(1, 1);
    const mavmission::ItemSource plan = mavmission::inRam(sketchPlan(kPlan, kMission), items);
    switch (proven) {
      case Proven::ByAnswer: client_.uploadWithoutReadback(plan); return;
      case Proven::InDoubt: client_.upload(plan); return;
      case Proven::Always: client_.upload(plan, mavmission::Readback::Always); return;
    }
  }

  // Bytes that have arrived. What there is no room for is lost.
  void hear(const Bytes& bytes) {
    const size_t room = kRing - stream_.toRead.size();
    stream_.bring(bytes.size() <= room ? bytes : Bytes(bytes.begin(), bytes.begin() + static_cast<long>(room)));
  }
  // Called some times in each millisecond; the bytes that it sends, `room` at most. Not called any more when it has
  // ended.
  Bytes run(uint32_t nowMs, size_t room) {
    setMillis(kStartMs + nowMs);
    stream_.room = static_cast<int>(room);
    const mavmission::Status status = client_.update();
    if (isEnd(status)) status_ = nameOf(status);
    return stream_.takeWritten();
  }

  bool hasEnded() const { return !status_.empty(); }
  // In a word; "" until it has ended.
  std::string status() const { return status_; }
  mavmission::Aboard aboard() const { return client_.aboard(); }

 private:
  static constexpr uint32_t kStartMs = 0xFFFFF000;  // millis() wraps soon, in 16 bits and in 32
  static MemoryStream& begun(MemoryStream& stream) {
    setMillis(kStartMs);
    return stream;
  }

  MemoryStream stream_;
  mavmission::MissionClient client_;
  std::string status_;
};
