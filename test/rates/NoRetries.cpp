// For comparison, a client without retries, as most sketches have one. Its rule: COUNT is sent once; each request is
// answered by its item, a repeated one too; it ends by the first ACK, whatever that says, or when the autopilot's
// mission service has been silent for 10 s. (So it gains from every retry of the autopilot's.)
#include "Client.h"

namespace {

class NoRetries : public Client {
 public:
  explicit NoRetries(Firmwares firmware) : items_(wireItems(firmware)) {}

  void hear(const Message& message, uint32_t nowMs) override {
    if (message.kind == Kind::Heartbeat) return;
    heardMs_ = nowMs;
    if (message.kind == Kind::Ack) end(message.number == kAccepted ? "Accepted" : "Refused");
    if (message.kind == Kind::Request && message.number < items_.size()) {
      answers_.push_back(::message(Kind::Item, message.number, items_[message.number]));
    }
  }

  void run(uint32_t nowMs, std::vector<Message>& sent) override {
    if (!isCountSent_) sent.push_back(message(Kind::Count, static_cast<uint16_t>(items_.size())));
    if (!isCountSent_) heardMs_ = nowMs;
    isCountSent_ = true;
    sent.insert(sent.end(), answers_.begin(), answers_.end());
    answers_.clear();
    if (nowMs - heardMs_ >= kSilenceMs) end("TimedOut");
  }

  bool hasEnded() const override { return !status_.empty(); }
  bool saysAccepted() const override { return status_ == "Accepted"; }
  std::string status() const override { return status_; }

 private:
  static constexpr uint32_t kSilenceMs = 10000;

  void end(const char* status) {
    if (status_.empty()) status_ = status;
  }

  const std::vector<uint8_t> items_;
  std::vector<Message> answers_;
  uint32_t heardMs_ = 0;
  bool isCountSent_ = false;
  std::string status_;
};

}  // namespace

std::unique_ptr<Client> makeNoRetries(Firmwares firmware) { return std::unique_ptr<Client>(new NoRetries(firmware)); }
