// The library's own MissionClient as a Client: its stream is a hardware serial port's, with a ring of its own.
#include <Arduino.h>

#include "../explorer/Plans.h"
#include "Client.h"
#include "MavMission.h"
#include "MemoryStream.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

constexpr size_t kRing = 63;               // of a Mega's serial port
constexpr uint32_t kStartMs = 0xFFFFF000;  // millis() wraps soon, in 16 bits and in 32

const char* nameOf(Status status) {
  static const char* const names[] = {
#define MAVMISSION_NAME(name, text) #name,
      MAVMISSION_STATUSES(MAVMISSION_NAME)
#undef MAVMISSION_NAME
  };
  return names[static_cast<int>(status)];
}

const char* nameOf(Aboard aboard) {
  static const char* const names[] = {
#define MAVMISSION_NAME(name, text) #name,
      MAVMISSION_ABOARD(MAVMISSION_NAME)
#undef MAVMISSION_NAME
  };
  return names[static_cast<int>(aboard)];
}

class OurClient : public ::Client {
 public:
  OurClient(Firmwares firmware, Proven proven) : client_(begun(stream_)) {
    // These say "generic" in their heartbeats, as many devices do: they have to be named.
    if (isGeneric(firmware)) client_.setTargetIds(1, 1);
    const ItemSource plan = inRam(sketchPlan(kPlan, kMission), itemsOfPlan);
    switch (proven) {
      case Proven::ByAnswer: client_.uploadWithoutReadback(plan); return;
      case Proven::InDoubt: client_.upload(plan); return;
      case Proven::Always: client_.upload(plan, Readback::Always); return;
    }
  }

  // What there is no room for is lost.
  void hear(const Bytes& bytes, uint32_t) override {
    const size_t room = kRing - stream_.toRead.size();
    stream_.bring(bytes.size() <= room ? bytes : Bytes(bytes.begin(), bytes.begin() + static_cast<long>(room)));
  }

  Bytes run(uint32_t nowMs, size_t room) override {
    setMillis(kStartMs + nowMs);
    stream_.room = static_cast<int>(room);
    const Status status = client_.update();
    if (isEnd(status)) status_ = nameOf(status);
    return stream_.takeWritten();
  }

  bool hasEnded() const override { return !status_.empty(); }
  std::string status() const override { return status_; }
  std::string aboard() const override { return nameOf(client_.aboard()); }

 private:
  static MemoryStream& begun(MemoryStream& stream) {
    setMillis(kStartMs);
    return stream;
  }

  MemoryStream stream_;
  MissionClient client_;
  std::string status_;
};

}  // namespace

std::unique_ptr<::Client> makeMissionClient(Firmwares firmware, Proven proven) {
  return std::unique_ptr<::Client>(new OurClient(firmware, proven));
}
