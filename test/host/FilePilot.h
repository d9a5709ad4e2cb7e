// An ArduPilot on a line in memory that gives and takes its plans as files, and what it is asked for word by word.
#pragma once

#include <string.h>

#include <map>
#include <string>

#include "ClientOnLine.h"
#include "PlanFrames.h"
#include "mavmission/base/MavlinkHeaders.h"

class FilePilot : public ClientOnLine {
 public:
  enum : uint8_t { kTerminate = 1, kOpen = 4, kRead = 5, kCreate = 6, kWrite = 7, kBurst = 15 };  // MAV_FTP_OPCODE
  enum : int { kFail = 1, kInvalidSession = 4, kFileNotFound = 10 };                              // MAV_FTP_ERR
  enum : int { kSilent = -1, kUnheard = -2 };  // it is done without an answer; not even that

  mavmission::PlanFiles files;
  std::vector<Bytes> plans[3];  // by MAV_MISSION_TYPE: the items, of a mission with home, as MISSION_ITEM_INT
  uint8_t type = 0;             // of the file that was opened last
  uint8_t baseMode = 0;
  uint8_t version = 2;         // of MAVLink
  std::map<int, int> gives;    // by opcode: the error, or what becomes of it; 0: it is done
  std::map<int, int> once;     // the same for the next one alone
  uint16_t lostItem = 0xFFFF;  // of a burst, this one is lost
  uint32_t delayMs = 5;
  uint32_t stored = 0;  // how often a plan has been stored
  Bytes header;         // of the file that was stored last

  // The last request.
  uint16_t sequence = 0;
  uint8_t session = 0;

  explicit FilePilot(uint8_t autopilot = kArduPilot)
      : ClientOnLine(autopilot), files(client), isPx4_(autopilot == kPx4) {
    beats = false;
  }

  void pass(uint32_t ms) {
    for (; ms != 0; --ms) one();
  }
  mavmission::Status end(uint32_t limitMs = 60000) {
    ended = mavmission::Status::Idle;
    const uint32_t beganMs = nowMs();
    for (; limitMs != 0 && ended == mavmission::Status::Idle; --limitMs) one();
    tookMs = nowMs() - beganMs;
    return ended;
  }
  // Until this has been asked for; false if it is not.
  bool passUntil(const std::string& words, uint32_t limitMs = 20000) {
    for (; limitMs != 0; --limitMs) {
      const size_t before = said_.size();
      one();
      for (size_t i = before; i < said_.size(); ++i) {
        if (said_[i].compare(0, words.size(), words) == 0) return true;
      }
    }
    return false;
  }
  std::string said() {
    std::string text;
    for (const std::string& one : said_) text += (text.empty() ? "" : ", ") + one;
    said_.clear();
    saidMs.clear();
    return text;
  }
  std::vector<uint32_t> saidMs;
  uint32_t tookMs = 0;

  // The plan that an earlier upload has left aboard.
  void hold(const std::vector<mavmission::MissionItem>& plan) {
    plans[0].assign(1, home());
    for (const mavmission::MissionItem& item : plan) {
      plans[0].push_back(bytesOf(item, static_cast<uint16_t>(plans[0].size())));
    }
  }
  // An item of a file; what is not set is 0 in it.
  Bytes bytesOf(mavmission::MissionItem item, uint16_t seq) const {
    for (float* number : {&item.param1, &item.param2, &item.param3, &item.param4}) {
      if (*number != *number) *number = 0;
    }
    Bytes bytes = itemParts(seq, item, static_cast<mavmission::PlanType>(type)).payload;
    bytes[offsetof(mavlink_mission_item_int_t, target_component)] = 1;
    return bytes;
  }
  mavlink_mission_item_int_t itemAboard(size_t number) const {
    mavlink_mission_item_int_t message;
    memcpy(&message, plans[type].at(number).data(), sizeof(message));
    return message;
  }
  Bytes home() const {
    mavmission::MissionItem item =
        mavmission::waypoint(mavmission::Degrees::fromE7(-353632621), mavmission::Degrees::fromE7(1491652374),
                             mavmission::aboveSeaLevel(mavmission::Metres(584)));
    return bytesOf(item, 0);
  }
  void beat() {
    FrameParts parts = heartbeatParts(isPx4_ ? kPx4 : kArduPilot, baseMode);
    parts.version = version;
    hear(parts);
  }
  // A reply of its own making.
  void reply(uint16_t number, uint8_t inSession, uint8_t opcode, uint8_t requested, uint32_t offset, const Bytes& data,
             bool isComplete = false) {
    Bytes payload = {0,
                     1,
                     191,
                     static_cast<uint8_t>(number),
                     static_cast<uint8_t>(number >> 8),
                     inSession,
                     opcode,
                     static_cast<uint8_t>(data.size()),
                     requested,
                     static_cast<uint8_t>(isComplete ? 1 : 0),
                     0};
    for (int shift = 0; shift < 32; shift += 8) payload.push_back(static_cast<uint8_t>(offset >> shift));
    hear(FrameParts(110, payload + data, 84));
  }
  void refuse(uint16_t number, uint8_t requested, uint8_t error) { reply(number, session, 129, requested, 0, {error}); }

 private:
  struct Due {
    uint16_t number;
    uint8_t session, opcode, requested;
    uint32_t offset;
    Bytes data;
    bool isComplete;
  };

  void one() {
    if (nowMs() % 1000 == 0) beat();
    while (!due_.empty() && due_.begin()->first <= nowMs()) {
      const Due due = due_.begin()->second;
      due_.erase(due_.begin());
      reply(due.number, due.session, due.opcode, due.requested, due.offset, due.data, due.isComplete);
    }
    const size_t before = sent.size();
    run(1);
    for (size_t i = before; i < sent.size(); ++i) {
      if (sent[i].messageId == 110) react(sent[i].payload);
    }
  }
  void in(uint32_t ms, const Due& due) { due_.insert({nowMs() + ms, due}); }

  static uint32_t longAt(const Bytes& bytes, size_t at) {
    return static_cast<uint32_t>(bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16) |
           static_cast<uint32_t>(bytes[at + 3]) << 24;
  }

  void react(const Bytes& request) {
    sequence = static_cast<uint16_t>(request[3] | request[4] << 8);
    session = request[5];
    const uint8_t opcode = request[6], size = request[7];
    const uint32_t offset = longAt(request, 11);
    const Bytes data(request.begin() + 15, request.begin() + 15 + size);
    const std::string range = std::to_string(offset) + "+" + std::to_string(size);
    std::string words;
    switch (opcode) {
      case kTerminate: words = "close"; break;
      case kOpen: words = "open " + std::string(data.begin(), data.end()); break;
      case kCreate: words = "create " + std::string(data.begin(), data.end()); break;
      case kRead: words = "read " + range; break;
      case kBurst: words = "burst " + range; break;
      case kWrite: words = "write " + range; break;
      default: words = "?";
    }
    const bool isClean = request[0] == 0 && request[8] == 0 && request[9] == 0 && request[10] == 0;
    if (request[1] != 1 || request[2] != 1 || !isClean) words += " !";
    if (opcode == kOpen || opcode == kCreate) type = data[9] == 'm' ? 0 : data[9] == 'f' ? 1 : 2;
    said_.push_back(words);
    saidMs.push_back(nowMs());
    int result = gives.count(opcode) != 0 ? gives[opcode] : 0;
    if (once.count(opcode) != 0) {
      result = once[opcode];
      once.erase(opcode);
    }
    if (result == kUnheard) return;
    const uint16_t number = static_cast<uint16_t>(sequence + 1);
    if (result > 0) {
      in(delayMs, {number, session, 129, opcode, offset, {static_cast<uint8_t>(result)}, false});
      return;
    }
    Bytes answer;
    switch (opcode) {
      case kOpen: answer = {0, 0, 0, 0}; break;
      case kCreate: written_.clear(); break;
      case kWrite:
        if (written_.size() < offset + size) written_.resize(offset + size);
        std::copy(data.begin(), data.end(), written_.begin() + static_cast<long>(offset));
        break;
      case kTerminate: store(); break;
      case kRead: answer = part(offset, size); break;
      case kBurst:
        if (result != kSilent) burst(number, offset);
        return;
      default: break;
    }
    if (result != kSilent) in(delayMs, {number, session, 128, opcode, offset, answer, false});
  }

  Bytes file() const {
    const std::vector<Bytes>& aboard = plans[type];
    Bytes whole = {
        0x3D, 0x76, type, 0, 0, 0, 0, 0, static_cast<uint8_t>(aboard.size()), static_cast<uint8_t>(aboard.size() >> 8)};
    for (const Bytes& item : aboard) whole = whole + item;
    return whole;
  }
  Bytes part(uint32_t offset, uint8_t size) const {
    const Bytes whole = file();
    if (offset >= whole.size()) return Bytes();
    const size_t end = offset + size < whole.size() ? offset + size : whole.size();
    return Bytes(whole.begin() + static_cast<long>(offset), whole.begin() + static_cast<long>(end));
  }
  void burst(uint16_t number, uint32_t offset) {
    uint32_t ms = delayMs;
    const size_t end = file().size();
    for (; offset < end; offset += 38, ms += 5) {
      if (offset != 10u + 38u * lostItem) in(ms, {number, session, 128, kBurst, offset, part(offset, 38), false});
      ++number;
    }
    lostItem = 0xFFFF;
    in(ms, {number, session, 129, kBurst, offset, {6}, false});  // MAV_FTP_ERR_EOF
  }
  void store() {
    if (written_.size() < 10 || written_[0] != 0x3D || written_[1] != 0x76) return;
    std::vector<Bytes>& aboard = plans[type];
    aboard.clear();
    for (size_t at = 10; at + 38 <= written_.size(); at += 38) {
      aboard.push_back(Bytes(written_.begin() + static_cast<long>(at), written_.begin() + static_cast<long>(at) + 38));
    }
    if (type == 0 && !aboard.empty()) aboard[0] = home();  // its own, whatever is given
    header.assign(written_.begin(), written_.begin() + 10);
    ++stored;
    written_.clear();
  }

  bool isPx4_;
  Bytes written_;
  std::multimap<uint32_t, Due> due_;
  std::vector<std::string> said_;
};
