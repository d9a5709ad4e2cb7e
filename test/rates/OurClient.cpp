// The library's own MissionClient as a Client: frames become the bytes that its stream gives, and what it writes
// becomes messages again. A frame that is not as it must be ends the program.
#include <Arduino.h>
#include <stdio.h>
#include <stdlib.h>

#include "../explorer/Plans.h"
#include "Client.h"
#include "MavMission.h"
#include "MemoryStream.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

constexpr size_t kAround = 12;             // header and checksum of a MAVLink 2 frame
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
  OurClient(Firmwares firmware, bool byAnswer) : firmware_(firmware), client_(begun(stream_)) {
    const ItemSource plan = inRam(sketchPlan(kPlan), kItems);
    if (byAnswer) {
      client_.uploadWithoutReadback(plan);
    } else {
      client_.upload(plan);
    }
  }

  void hear(const Message& message, uint32_t) override { stream_.bring(frameOf(message, firmware_)); }

  void run(uint32_t nowMs, std::vector<Message>& sent) override {
    setMillis(kStartMs + nowMs);
    const Status status = client_.update();
    if (isEnd(status)) status_ = nameOf(status);
    std::vector<uint8_t>& bytes = stream_.written;
    while (bytes.size() >= kAround && bytes.size() >= kAround + bytes[1]) {
      const size_t length = kAround + bytes[1];
      const bool isHeartbeat = bytes[7] == 0 && bytes[8] == 0 && bytes[9] == 0;
      Message message = ::message(Kind::Heartbeat);
      const char* const wrong = isHeartbeat ? nullptr : decode(bytes.data(), length, firmware_, message);
      if (wrong != nullptr) {
        fprintf(stderr, "%s\n", wrong);
        exit(3);
      }
      sent.push_back(message);
      bytes.erase(bytes.begin(), bytes.begin() + static_cast<long>(length));
    }
  }

  bool hasEnded() const override { return !status_.empty(); }
  bool saysAccepted() const override { return status_ == "Accepted"; }
  std::string status() const override { return status_; }
  std::string aboard() const override { return nameOf(client_.aboard()); }

 private:
  static MemoryStream& begun(MemoryStream& stream) {
    setMillis(kStartMs);
    return stream;
  }

  const Firmwares firmware_;
  MemoryStream stream_;
  MissionClient client_;
  std::string status_;
};

}  // namespace

std::unique_ptr<::Client> makeMissionClient(Firmwares firmware, bool byAnswer) {
  return std::unique_ptr<::Client>(new OurClient(firmware, byAnswer));
}
