// For comparison, a client without retries, as most sketches have one. Its rule: COUNT is sent once; each request is
// answered by its item, a repeated one too; it ends by the first ACK, whatever that says, or when the autopilot's
// mission service has been silent for 10 s. (So it gains from every retry of the autopilot's.)
#include "PlainClient.h"

namespace {

class NoRetries : public PlainClient {
 public:
  explicit NoRetries(Firmwares firmware) : PlainClient(firmware) {}

 private:
  static constexpr uint32_t kSilenceMs = 10000;

  void hear(const Message& message, uint32_t nowMs) override {
    heardMs_ = nowMs;
    if (message.kind == Kind::Ack) return end(message.number == kAccepted ? "Accepted" : "Refused");
    send(Kind::Item, message.number);
  }

  void act(uint32_t nowMs) override {
    if (!isCountSent_) {
      send(Kind::Count, static_cast<uint16_t>(items().size()));
      heardMs_ = nowMs;
      isCountSent_ = true;
    }
    if (nowMs - heardMs_ >= kSilenceMs) end("TimedOut");
  }

  uint32_t heardMs_ = 0;
  bool isCountSent_ = false;
};

}  // namespace

std::unique_ptr<Client> makeNoRetries(Firmwares firmware) { return std::unique_ptr<Client>(new NoRetries(firmware)); }
