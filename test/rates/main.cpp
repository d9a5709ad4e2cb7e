// rates: uploads of a plan of five items on a line that loses frames at random, one line of output each. See usage().
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../explorer/Autopilot.h"
#include "../explorer/Line.h"
#include "../explorer/Plans.h"
#include "Client.h"

namespace {

constexpr uint32_t kHeartbeatMs = 1000;
constexpr uint32_t kGivesUpMs = 600000;  // an upload that has not ended then never will

[[noreturn]] void usage(const char* problem) {
  fprintf(
      stderr,
      "%s\n"
      "usage: rates AUTOPILOT CLIENT PERCENT SEEDS\n"
      "  AUTOPILOT  ArduPilot, LateArduPilot (its final ACK comes 700 ms late) or PX4\n"
      "  CLIENT     upload, upload-by-answer (the library's), no-retries or usual-rule (for comparison)\n"
      "  PERCENT    of the frames that are lost, in both directions: 0 to 100\n"
      "  SEEDS      uploads: those of the seeds 0 to SEEDS - 1\n"
      "Prints a line for each: the seed, how it ended, whether the plan is aboard then (1) or not (0), what the "
      "client\n"
      "says is aboard, whether that is true, and the time from the first COUNT to the end [ms]. An upload that does\n"
      "not end has `never` in the place of how it ended.\n",
      problem);
  exit(2);
}

unsigned number(const char* text, unsigned long most) {
  char* end;
  const unsigned long value = strtoul(text, &end, 10);
  if (*text == 0 || *end != 0 || value > most) usage("a number is missing or too large");
  return static_cast<unsigned>(value);
}

// Who sends, and what: the n-th frame of each is lost or not by the seed alone, whichever client runs.
enum Channel { kFromClient, kFromAutopilot, kHeartbeats, kChannels };

// Which frames are lost: numbers that depend on nothing but seed, channel and position (SplitMix64).
class Losses {
 public:
  Losses(unsigned percent, unsigned seed) : percent_(percent), seed_(seed) {}
  bool isNextLost(Channel channel) {
    uint64_t x = (uint64_t(seed_) << 34) ^ (uint64_t(channel) << 32) ^ next_[channel]++;
    x += 0x9E3779B97F4A7C15u;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return (x ^ (x >> 31)) % 100 < percent_;
  }

 private:
  const unsigned percent_, seed_;
  uint32_t next_[kChannels] = {0, 0, 0};
};

bool isSent(Line& line, const Message& message) {
  if (line.send(message)) return true;
  fprintf(stderr, "more frames are on the line than it has room for\n");
  exit(3);
}

class Upload {
 public:
  Upload(Firmwares firmware, std::unique_ptr<Client> client, unsigned percent, unsigned seed)
      : client_(std::move(client)), losses_(percent, seed), heartbeatMs_(seed * 37 % kHeartbeatMs) {
    memset(static_cast<void*>(&autopilot_), 0, sizeof(autopilot_));
    memset(static_cast<void*>(&up_), 0, sizeof(up_));
    memset(static_cast<void*>(&down_), 0, sizeof(down_));
    autopilot_.firmware = firmware;
    autopilot_.asksInMs = autopilot_.givesUpInMs = autopilot_.acceptsInMs = autopilot_.bootsInMs = kNever;
    autopilot_.hold(kOldPlan, kItems);
    before_ = autopilot_;
  }

  void run() {
    while (!client_->hasEnded() && nowMs_ < kGivesUpMs) step();
  }

  void print(unsigned seed) const {
    const std::string status = client_->hasEnded() ? client_->status() : "never";
    printf("%u %s %d %s %d %u\n", seed, status.c_str(), isAboard(), client_->aboard().c_str(),
           isTrue(client_->aboard()), nowMs_ - countedMs_);
  }

 private:
  void step() {
    ++nowMs_;
    autopilot_.pass(1);
    up_.pass(1);
    down_.pass(1);
    for (int due = up_.first(); due >= 0 && up_.frames[due].dueMs == 0; due = up_.first()) {
      Answers answers;
      const Message message = up_.take(due, Fate::Delivered);
      autopilot_.hear(message, answers);
      answer(answers);
    }
    while (autopilot_.nextMs() == 0) {
      Answers answers;
      autopilot_.act(answers);
      answer(answers);
    }
    if (nowMs_ % kHeartbeatMs == heartbeatMs_ && !losses_.isNextLost(kHeartbeats)) {
      isSent(down_, message(Kind::Heartbeat));
    }
    for (int due = down_.first(); due >= 0 && down_.frames[due].dueMs == 0; due = down_.first()) {
      client_->hear(down_.take(due, Fate::Delivered), nowMs_);
    }
    std::vector<Message> sent;
    client_->run(nowMs_, sent);
    for (const Message& one : sent) {
      if (one.kind == Kind::Heartbeat) continue;  // it moves nothing in an autopilot
      if (one.kind == Kind::Count && countedMs_ == 0) countedMs_ = nowMs_;
      if (!losses_.isNextLost(kFromClient)) isSent(up_, one);
    }
  }

  void answer(const Answers& answers) {
    for (int i = 0; i < answers.count; ++i) {
      if (!losses_.isNextLost(kFromAutopilot)) isSent(down_, answers.messages[i]);
    }
  }

  bool isAboard() const {
    const std::vector<uint8_t> meant = wireItems(autopilot_.firmware);
    return autopilot_.heldCount == meant.size() && memcmp(autopilot_.held, meant.data(), meant.size()) == 0;
  }

  // Our items as far as they came, the older ones behind them. (Both plans are of the same length.)
  bool isMixture() const {
    const std::vector<uint8_t> meant = wireItems(autopilot_.firmware);
    if (autopilot_.heldCount != meant.size()) return false;
    size_t taken = 0;
    while (taken < meant.size() && autopilot_.held[taken] == meant[taken]) ++taken;
    return memcmp(autopilot_.held + taken, before_.held + taken, meant.size() - taken) == 0;
  }

  bool isTrue(const std::string& aboard) const {
    if (aboard == "OurPlan") return isAboard();
    if (aboard == "AsBefore") return memcmp(autopilot_.held, before_.held, sizeof(before_.held)) == 0;
    if (aboard == "Mixture") return isMixture();
    return aboard == "NotKnown";
  }

  const std::unique_ptr<Client> client_;
  Losses losses_;
  const uint32_t heartbeatMs_;
  Autopilot autopilot_;
  Autopilot before_;
  Line up_, down_;
  uint32_t nowMs_ = 0;
  uint32_t countedMs_ = 0;
};

std::unique_ptr<Client> makeClient(const char* name, Firmwares firmware) {
  if (strcmp(name, "upload") == 0) return makeMissionClient(firmware, false);
  if (strcmp(name, "upload-by-answer") == 0) return makeMissionClient(firmware, true);
  if (strcmp(name, "no-retries") == 0) return makeNoRetries(firmware);
  if (strcmp(name, "usual-rule") == 0) return makeUsualRule(firmware);
  usage("no such client");
}

Firmwares firmwareNamed(const char* name) {
  if (strcmp(name, "ArduPilot") == 0) return Firmwares::ArduPilot;
  if (strcmp(name, "LateArduPilot") == 0) return Firmwares::LateArduPilot;
  if (strcmp(name, "PX4") == 0) return Firmwares::Px4;
  usage("no such autopilot");
}

}  // namespace

std::vector<uint8_t> wireItems(Firmwares firmware) {
  std::vector<uint8_t> items;
  if (firmware != Firmwares::Px4) items.push_back(kHome);
  for (uint8_t i = 0; i < kItems; ++i) items.push_back(itemOf(kPlan, i));
  return items;
}

int main(int argc, char** argv) {
  if (argc != 5) usage("four arguments are wanted");
  const Firmwares firmware = firmwareNamed(argv[1]);
  const unsigned percent = number(argv[3], 100);
  const unsigned seeds = number(argv[4], 1000000);
  for (unsigned seed = 0; seed < seeds; ++seed) {
    Upload upload(firmware, makeClient(argv[2], firmware), percent, seed);
    upload.run();
    upload.print(seed);
  }
  return 0;
}
