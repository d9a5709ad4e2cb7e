// For comparison, a client with the rule that is usual among ground stations and libraries, and that MAVLink's guide
// gives for timeouts and retries. Its rule: COUNT is sent every 1500 ms, 5 times at most, until the first request; each
// request is answered by its item, a repeated one too; then it waits 1500 ms for the next request or the final ACK, 5
// times at most, and says that the upload failed when nothing has come. ACCEPTED ends it well, any other ACK badly.
// What became of a final ACK that was lost it does not find out.
#include "PlainClient.h"

namespace {

class UsualRule : public PlainClient {
 public:
  explicit UsualRule(Firmwares firmware) : PlainClient(firmware) {}

 private:
  static constexpr uint32_t kWaitMs = 1500;
  static constexpr int kTries = 5;

  void hear(const Message& message, uint32_t nowMs) override {
    if (message.kind == Kind::Ack) return end(message.number == kAccepted ? "Accepted" : "Refused");
    isAsked_ = true;
    waits_ = 0;
    waitingMs_ = nowMs;
    send(Kind::Item, message.number);
  }

  void act(uint32_t nowMs) override {
    if (waits_ != 0 && nowMs - waitingMs_ < kWaitMs) return;
    if (waits_ == kTries) return end("TimedOut");
    ++waits_;
    if (!isAsked_) send(Kind::Count, static_cast<uint16_t>(items().size()));
    // The first wait behind a request began with it.
    if (!isAsked_ || waits_ > 1) waitingMs_ = nowMs;
  }

  uint32_t waitingMs_ = 0;
  int waits_ = 0;  // that have begun since something was heard
  bool isAsked_ = false;
};

}  // namespace

std::unique_ptr<Client> makeUsualRule(Firmwares firmware) { return std::unique_ptr<Client>(new UsualRule(firmware)); }
