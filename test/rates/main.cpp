// rates: uploads of a plan on a line that loses frames or bytes at random, and takes its time, one line of output each.
// See usage().
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <deque>
#include <map>

#include "../../simulation/hearing/Hearing.h"
#include "../explorer/Autopilot.h"
#include "../explorer/Plans.h"
#include "Arguments.h"
#include "Client.h"

using mavmission::Aboard;

namespace {

constexpr uint32_t kStepUs = 250;  // how often a client runs
constexpr uint32_t kMs = 1000;     // [us]
constexpr uint32_t kHeartbeatMs = 1000;
constexpr uint32_t kGivesUpMs = 600000;  // an upload that has not ended then never will
constexpr unsigned kBaud = 57600;
// From a message to the answer, without the line: seen.
constexpr uint32_t kArduPilotUs = 6000, kPx4Us = 500;
constexpr size_t kTransmitBuffer = 800;
constexpr unsigned kPx4Telemetry = 1100;  // [bytes/s], unasked

// Who sends, and what: the n-th frame of each, or the n-th byte of a direction, is lost or not by the seed alone,
// whichever client runs.
enum Channel { kFromClient, kFromAutopilot, kUnasked, kBytesUp, kBytesDown, kChannels };

// What is lost: numbers that depend on nothing but seed, channel and position (SplitMix64).
class Losses {
 public:
  Losses(unsigned percent, unsigned seed) : percent_(percent), seed_(seed) {}
  bool isNextLost(Channel channel) {
    uint64_t x = (uint64_t(seed_) << 38) ^ (uint64_t(channel) << 32) ^ next_[channel]++;
    x += 0x9E3779B97F4A7C15u;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return (x ^ (x >> 31)) % 100 < percent_;
  }

 private:
  const unsigned percent_, seed_;
  uint32_t next_[kChannels] = {0, 0, 0, 0, 0};
};

// One direction: what is put in follows what is on its way, and comes out when its last byte has left.
class Way {
 public:
  Way(unsigned baud, unsigned latencyMs) : byteUs_(10e6 / baud), latencyUs_(latencyMs * 1e3) {}
  // `length`: of what was sent, which takes its time also where it is lost.
  void put(const Bytes& bytes, size_t length, uint32_t nowUs) {
    freeUs_ = (freeUs_ > nowUs ? freeUs_ : nowUs) + byteUs_ * static_cast<double>(length);
    pieces_.push_back(Piece{freeUs_ + latencyUs_, bytes});
  }
  bool take(uint32_t nowUs, Bytes& bytes) {
    if (pieces_.empty() || pieces_.front().comesUs > nowUs) return false;
    bytes = pieces_.front().bytes;
    pieces_.pop_front();
    return true;
  }
  // How many bytes have not left yet.
  size_t waiting(uint32_t nowUs) const {
    return freeUs_ > nowUs ? static_cast<size_t>((freeUs_ - nowUs) / byteUs_ + 0.999) : 0;
  }

 private:
  struct Piece {
    double comesUs;
    Bytes bytes;
  };
  const double byteUs_, latencyUs_;
  double freeUs_ = 0;
  std::deque<Piece> pieces_;
};

uint32_t idOf(const Bytes& frame) { return static_cast<uint32_t>(frame[7] | frame[8] << 8 | frame[9] << 16); }

class Upload {
 public:
  Upload(Firmwares firmware, Proven proven, bool byBytes, unsigned percent, unsigned seed, unsigned baud,
         unsigned loopMs, unsigned telemetryPerSecond, unsigned latencyMs, uint16_t items)
      : items_(items),
        client_(firmware, proven, items),
        losses_(percent, seed),
        byBytes_(byBytes),
        heartbeatMs_(seed * 37 % kHeartbeatMs),
        telemetryUs_(seed * 1237 % 30000),
        loopUs_(loopMs != 0 ? loopMs * kMs : kStepUs),
        telemetryPerSecond_(telemetryPerSecond),
        hearing_(firmware == Firmwares::Px4 ? HeardBy::Px4 : HeardBy::ArduPilot),
        up_(baud, latencyMs),
        down_(baud, latencyMs) {
    autopilot_.begin(firmware, kMission);
    autopilot_.hold(kOldPlan, items);
    before_ = autopilot_;
  }

  void run() {
    while (!client_.hasEnded() && nowUs_ / kMs < kGivesUpMs) step();
  }

  void print(unsigned seed) const {
    const std::string status = client_.hasEnded() ? client_.status() : "never";
    printf("%u %s %d %s %d %u %u %u %u %u %u %u\n", seed, status.c_str(), isAboard(), nameOf(client_.aboard()),
           isTrue(client_.aboard()), (nowUs_ - countedUs_) / kMs, sent_, unasked_, zeros_, repeated_, telemetry_,
           leftOut_);
  }

 private:
  void step() {
    nowUs_ += kStepUs;
    if (nowUs_ % kMs == 0) {
      autopilot_.pass(1);
      if (nowUs_ / kMs % kHeartbeatMs == heartbeatMs_) say(message(Kind::Heartbeat), nowUs_);
    }
    Bytes bytes;
    while (up_.take(nowUs_, bytes)) {
      for (uint8_t byte : bytes) {
        if (hearing_.take(byte)) hear();
      }
    }
    while (autopilot_.nextMs() == 0) {
      Answers answers;
      autopilot_.act(answers);
      answer(answers, nowUs_);
    }
    sendTelemetry();
    while (!answers_.empty() && answers_.front().first <= nowUs_) {
      say(answers_.front().second, nowUs_);
      answers_.pop_front();
    }
    while (down_.take(nowUs_, bytes)) client_.hear(bytes);
    if (nowUs_ % loopUs_ != 0) return;
    const size_t waiting = up_.waiting(nowUs_);
    take(client_.run(nowUs_ / kMs, waiting < kRing ? kRing - waiting : 0));
  }

  // What the autopilot's parser has found.
  void hear() {
    uint8_t bytes[MAVLINK_MAX_PACKET_LEN];
    const Bytes frame(bytes, bytes + hearing_.bytesOf(bytes));
    Message message;
    // (Damage that the checksum does not find is as good as none: it is another message than those that we know.)
    if (hearing_.heard().msgid == MAVLINK_MSG_ID_HEARTBEAT) return;
    const char* const wrong = decode(frame, autopilot_.firmware, message);
    if (wrong != nullptr) {
      if (byBytes_) return;
      fprintf(stderr, "%s\n", wrong);
      exit(3);
    }
    Answers answers;
    autopilot_.hear(message, answers);
    answer(answers, nowUs_ + (autopilot_.firmware == Firmwares::Px4 ? kPx4Us : kArduPilotUs));
  }

  void answer(const Answers& answers, uint32_t atUs) {
    for (int i = 0; i < answers.count; ++i) answers_.push_back(std::make_pair(atUs, answers.messages[i]));
  }

  void say(const Message& message, uint32_t nowUs) {
    if (message.kind == Kind::Request) ++requests_[message.number];
    put(partsOf(message, autopilot_.firmware), message.kind == Kind::Heartbeat ? kUnasked : kFromAutopilot, nowUs);
  }

  // Something goes out of the autopilot: with its running number, and without the zeros at the end of its payload.
  void put(FrameParts parts, Channel channel, uint32_t nowUs) {
    while (parts.payload.size() > 1 && parts.payload.back() == 0) parts.payload.pop_back();
    parts.sequence = sequence_++;
    const Bytes bytes = packed(parts);
    const bool isLost = !byBytes_ && losses_.isNextLost(channel);
    down_.put(isLost ? Bytes() : byBytes_ ? damaged(bytes, kBytesDown) : bytes, bytes.size(), nowUs);
  }

  void sendTelemetry() {
    if (telemetryPerSecond_ == 0 || nowUs_ < telemetryUs_) return;
    telemetryUs_ += static_cast<uint32_t>(1000000 * telemetry().size() / telemetryPerSecond_);
    ++telemetry_;
    if (down_.waiting(nowUs_) > kTransmitBuffer) {
      ++leftOut_;  // it has no room for this one
      return;
    }
    put(frameAt(telemetry()).parts, kUnasked, nowUs_);
  }

  Bytes damaged(const Bytes& bytes, Channel channel) {
    Bytes left;
    for (uint8_t byte : bytes) {
      if (!losses_.isNextLost(channel)) left.push_back(byte);
    }
    return left;
  }

  // What is a repeat, and what of it nobody asked for.
  void note() {
    if (begun_[0] != MAVLINK_STX) {
      zeros_ += static_cast<unsigned>(begun_.size());
      repeated_ += static_cast<unsigned>(begun_.size());
      return;
    }
    const uint32_t id = idOf(begun_);
    if (id == MAVLINK_MSG_ID_HEARTBEAT) return;
    Message sent = message(Kind::Ack);
    if (decode(begun_, autopilot_.firmware, sent) != nullptr) return;
    const int often = ++sentOften_[std::make_pair(id, sent.number)];
    if (often > 1) repeated_ += static_cast<unsigned>(begun_.size());
    if (sent.kind == Kind::Item && often > requests_[sent.number]) ++unasked_;
    if (sent.kind == Kind::Count && often > 1) ++unasked_;
  }

  // What the client has written: frames, and the bytes between them.
  void take(const Bytes& bytes) {
    for (uint8_t byte : bytes) {
      begun_.push_back(byte);
      if (countedUs_ != 0) ++sent_;
      const bool isFrame = begun_[0] == MAVLINK_STX;
      if (isFrame && (begun_.size() < 12 || begun_.size() < begun_[1] + 12u)) continue;
      if (isFrame && countedUs_ == 0 && idOf(begun_) == MAVLINK_MSG_ID_MISSION_COUNT) {
        countedUs_ = nowUs_;
        sent_ = static_cast<unsigned>(begun_.size());
      }
      const bool isHeartbeat = isFrame && idOf(begun_) == MAVLINK_MSG_ID_HEARTBEAT;
      const bool isLost = !byBytes_ && isFrame && losses_.isNextLost(isHeartbeat ? kUnasked : kFromClient);
      note();
      up_.put(isLost ? Bytes() : byBytes_ ? damaged(begun_, kBytesUp) : begun_, begun_.size(), nowUs_);
      begun_.clear();
    }
  }

  bool isAboard() const { return autopilot_.holds(kPlan, items_); }

  // Our items as far as they came, the older ones behind them. (Both plans are of the same length.)
  bool isMixture() const {
    if (autopilot_.heldCount != before_.heldCount) return false;
    uint16_t taken = 0;
    const auto meant = [&] { return wireItem(kPlan, taken, autopilot_.firmware, kMission); };
    while (taken < before_.heldCount && autopilot_.held[taken] == meant()) ++taken;
    return memcmp(autopilot_.held + taken, before_.held + taken, before_.heldCount - taken) == 0;
  }

  bool isTrue(Aboard aboard) const {
    switch (aboard) {
      case Aboard::OurPlan: return isAboard();
      case Aboard::AsBefore: return autopilot_.holdsAs(before_);
      case Aboard::Mixture: return isMixture();
      default: return aboard == Aboard::NotKnown;
    }
  }

  const uint16_t items_;
  Client client_;
  Losses losses_;
  const bool byBytes_;
  const uint32_t heartbeatMs_;
  uint32_t telemetryUs_;
  const uint32_t loopUs_;
  const unsigned telemetryPerSecond_;
  Autopilot autopilot_;
  Autopilot before_;
  Hearing hearing_;
  Way up_, down_;
  std::deque<std::pair<uint32_t, Message>> answers_;
  Bytes begun_;
  uint8_t sequence_ = 0;
  uint32_t nowUs_ = 0;
  uint32_t countedUs_ = 0;
  unsigned sent_ = 0;
  unsigned unasked_ = 0, zeros_ = 0, repeated_ = 0;
  unsigned telemetry_ = 0, leftOut_ = 0;                    // frames of the autopilot's
  std::map<uint16_t, int> requests_;                        // of the autopilot's, by item
  std::map<std::pair<uint32_t, uint16_t>, int> sentOften_;  // by message, and item if it is one
};

const char* const kProven[] = {"upload", "upload-by-answer", "upload-verified"};
const char* const kLost[] = {"frames", "bytes"};

}  // namespace

void usage(const char* problem) {
  fprintf(
      stderr,
      "%s\n"
      "usage: rates AUTOPILOT CLIENT LOST PERCENT SEEDS [BAUD [LOOP [TELEMETRY [LATENCY [ITEMS]]]]]\n"
      "  AUTOPILOT  ArduPilot, LateArduPilot (its final ACK comes 700 ms late) PX4, MAVSDK,\n"
      "             Betaflight or iNav (servers of a firmware that the library does not know)\n"
      "  CLIENT     upload, upload-by-answer or upload-verified\n"
      "  LOST       frames or bytes\n"
      "  PERCENT    of them that are lost, in both directions: 0 to 100\n"
      "  SEEDS      uploads: those of the seeds 0 to SEEDS - 1\n"
      "  BAUD       of the line; 57600 if it is not given\n"
      "  LOOP       how seldom the client runs [ms]; by default four times in each\n"
      "  TELEMETRY  what the autopilot sends unasked [bytes/s]; by default 1100 from PX4 and none from ArduPilot\n"
      "  LATENCY    of the line, each way [ms]; 0 if it is not given\n"
      "  ITEMS      of the plan; 5 if it is not given\n"
      "Prints a line for each: the seed, how it ended, whether the plan is aboard then (1) or not (0), what the "
      "client\n"
      "says is aboard, whether that is true, the time from the first COUNT to the end [ms], and how many bytes the\n"
      "client has sent from COUNT on; how many COUNTs and items it has sent that nobody asked for, how many zeros "
      "between\n"
      "frames, and how many bytes of zeros and of what was sent before; how many frames of telemetry the autopilot "
      "had\n"
      "to send, and how many of them it has left out, since the line was full. An upload that does not end has "
      "`never` in the place of how it ended.\n",
      problem);
  exit(2);
}

int main(int argc, char** argv) {
  if (argc < 6 || argc > 11) usage("five to ten arguments are wanted");
  const Firmwares firmware = static_cast<Firmwares>(nameAmong(kFirmwares, argv[1], "no such autopilot"));
  const Proven proven = static_cast<Proven>(nameAmong(kProven, argv[2], "no such client"));
  const bool byBytes = nameAmong(kLost, argv[3], "frames or bytes are lost") != 0;
  const unsigned percent = static_cast<unsigned>(number(argv[4], 100));
  const unsigned seeds = number(argv[5], 1000000);
  const unsigned baud = argc > 6 ? number(argv[6], 10000000) : kBaud;
  const unsigned loopMs = argc > 7 ? number(argv[7], 10000) : 0;
  const unsigned telemetry = argc > 8 ? number(argv[8], 1000000) : firmware == Firmwares::Px4 ? kPx4Telemetry : 0;
  const unsigned latencyMs = argc > 9 ? number(argv[9], 10000) : 0;
  const uint16_t items = static_cast<uint16_t>(argc > 10 ? number(argv[10], kMostItems) : 5);
  if (baud == 0) usage("a number is missing or too large");
  for (unsigned seed = 0; seed < seeds; ++seed) {
    Upload upload(firmware, proven, byBytes, percent, seed, baud, loopMs, telemetry, latencyMs, items);
    upload.run();
    upload.print(seed);
  }
  return 0;
}
