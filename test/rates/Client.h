// A client that puts a plan of five items aboard, as the measurement drives it: messages and time in, messages out.
#pragma once

#include <stdint.h>

#include <memory>
#include <string>
#include <vector>

#include "../explorer/Message.h"

constexpr uint8_t kPlan = 1, kOldPlan = 0;  // of explorer/Plans.h: meant, and aboard before
constexpr uint8_t kItems = 5;

// The items as they go over the wire: ArduPilot's begin with home.
std::vector<uint8_t> wireItems(Firmwares firmware);

class Client {
 public:
  virtual ~Client() = default;
  // A frame that was not lost.
  virtual void hear(const Message& message, uint32_t nowMs) = 0;
  // Called each millisecond; adds what it sends. Not called any more when it has ended.
  virtual void run(uint32_t nowMs, std::vector<Message>& sent) = 0;
  virtual bool hasEnded() const = 0;
  // Once it has ended: whether it says that the plan is aboard, its status in a word, and what it says is aboard
  // ("NotKnown" where it says nothing).
  virtual bool saysAccepted() const = 0;
  virtual std::string status() const = 0;
  virtual std::string aboard() const { return "NotKnown"; }
};

// MissionClient with upload(), or with uploadWithoutReadback().
std::unique_ptr<Client> makeMissionClient(Firmwares firmware, bool byAnswer);
std::unique_ptr<Client> makeNoRetries(Firmwares firmware);
std::unique_ptr<Client> makeUsualRule(Firmwares firmware);
