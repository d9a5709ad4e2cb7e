// A client that puts a plan aboard, as the measurement drives it: bytes and time in, bytes out.
#pragma once

#include <stdint.h>

#include <memory>
#include <string>
#include <vector>

#include "../explorer/Message.h"

constexpr uint8_t kPlan = 1, kOldPlan = 0;  // of explorer/Plans.h: meant, and aboard before
// How many items the plan has, as a sketch counts them: 5, unless main() is told otherwise.
extern uint16_t itemsOfPlan;

// The items as they go over the wire: ArduPilot's begin with home.
std::vector<uint8_t> wireItems(Firmwares firmware);

class Client {
 public:
  virtual ~Client() = default;
  // Bytes that have arrived.
  virtual void hear(const Bytes& bytes, uint32_t nowMs) = 0;
  // Called some times in each millisecond; the bytes that it sends, `room` at most. Not called any more when it has
  // ended.
  virtual Bytes run(uint32_t nowMs, size_t room) = 0;
  virtual bool hasEnded() const = 0;
  // Once it has ended: its status in a word, and what it says is aboard.
  virtual std::string status() const = 0;
  virtual std::string aboard() const = 0;
};

// MissionClient with upload(), with uploadWithoutReadback(), or with upload(plan, Readback::Always).
enum class Proven : uint8_t { ByAnswer, InDoubt, Always };
std::unique_ptr<Client> makeMissionClient(Firmwares firmware, Proven proven);
