// What the clients for comparison have in common: they find every undamaged frame in the bytes, and know messages.
#pragma once

#include "Client.h"
#include "Frames.h"

class PlainClient : public Client {
 public:
  explicit PlainClient(Firmwares firmware) : firmware_(firmware), items_(wireItems(firmware)) {}

  void hear(const Bytes& bytes, uint32_t nowMs) override;
  Bytes run(uint32_t nowMs, size_t room) override;
  bool hasEnded() const override { return !status_.empty(); }
  bool saysAccepted() const override { return status_ == "Accepted"; }
  std::string status() const override { return status_; }

 protected:
  virtual void hear(const Message& message, uint32_t nowMs) = 0;  // a mission message that is for us
  virtual void act(uint32_t nowMs) = 0;                           // each millisecond
  void send(Kind kind, uint16_t number = 0, uint8_t zerosBefore = 0);
  void end(const char* status) {
    if (status_.empty()) status_ = status;
  }
  const std::vector<uint8_t>& items() const { return items_; }
  bool isPx4() const { return firmware_ == Firmwares::Px4; }

 private:
  static constexpr uint32_t kHeartbeatMs = 1000, kSilenceMs = 20;

  const Firmwares firmware_;
  const std::vector<uint8_t> items_;
  ParserUnderTest parser_;
  Bytes out_;
  std::string status_;
  uint8_t sequence_ = 0;
  uint32_t heardMs_ = 0;
  uint32_t actedMs_ = 0xFFFFFFFF;
};
