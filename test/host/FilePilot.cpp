#include "FilePilot.h"

FilePilot::FilePilot(uint8_t autopilot) : ClientOnLine(autopilot), files(client), isPx4_(autopilot == kPx4) {
  beats = false;
}

void FilePilot::pass(uint32_t ms) {
  for (; ms != 0; --ms) one();
}

mavmission::Status FilePilot::end(uint32_t limitMs) {
  ended = mavmission::Status::Idle;
  const uint32_t beganMs = nowMs();
  for (; limitMs != 0 && ended == mavmission::Status::Idle; --limitMs) one();
  tookMs = nowMs() - beganMs;
  return ended;
}

bool FilePilot::passUntil(const std::string& words, uint32_t limitMs) {
  for (; limitMs != 0; --limitMs) {
    const size_t before = said_.size();
    one();
    for (size_t i = before; i < said_.size(); ++i) {
      if (said_[i].compare(0, words.size(), words) == 0) return true;
    }
  }
  return false;
}

std::string FilePilot::said() {
  std::string text;
  for (const std::string& one : said_) text += (text.empty() ? "" : ", ") + one;
  said_.clear();
  saidMs.clear();
  return text;
}

void FilePilot::hold(const std::vector<mavmission::MissionItem>& plan) {
  plans[0].assign(1, home());
  for (const mavmission::MissionItem& item : plan) {
    plans[0].push_back(bytesOf(item, static_cast<uint16_t>(plans[0].size())));
  }
}

Bytes FilePilot::bytesOf(mavmission::MissionItem item, uint16_t seq) const {
  for (float* number : {&item.param1, &item.param2, &item.param3, &item.param4}) {
    if (*number != *number) *number = 0;
  }
  Bytes bytes = itemParts(seq, item, static_cast<mavmission::PlanType>(type)).payload;
  bytes[offsetof(mavlink_mission_item_int_t, target_component)] = 1;
  return bytes;
}

mavlink_mission_item_int_t FilePilot::itemAboard(size_t number) const {
  mavlink_mission_item_int_t message;
  memcpy(&message, plans[type].at(number).data(), sizeof(message));
  return message;
}

Bytes FilePilot::home() const {
  mavmission::MissionItem item =
      mavmission::waypoint(mavmission::Degrees::fromE7(-353632621), mavmission::Degrees::fromE7(1491652374),
                           mavmission::aboveSeaLevel(mavmission::Metres(584)));
  return bytesOf(item, 0);
}

void FilePilot::beat() {
  FrameParts parts = heartbeatParts(isPx4_ ? kPx4 : kArduPilot, baseMode);
  parts.version = version;
  hear(parts);
}

void FilePilot::reply(uint16_t number, uint8_t inSession, uint8_t opcode, uint8_t requested, uint32_t offset,
                      const Bytes& data, bool isComplete) {
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

void FilePilot::one() {
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

uint32_t FilePilot::longAt(const Bytes& bytes, size_t at) {
  return static_cast<uint32_t>(bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16) |
         static_cast<uint32_t>(bytes[at + 3]) << 24;
}

void FilePilot::react(const Bytes& request) {
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

Bytes FilePilot::file() const {
  const std::vector<Bytes>& aboard = plans[type];
  Bytes whole = {
      0x3D, 0x76, type, 0, 0, 0, 0, 0, static_cast<uint8_t>(aboard.size()), static_cast<uint8_t>(aboard.size() >> 8)};
  for (const Bytes& item : aboard) whole = whole + item;
  return whole;
}

Bytes FilePilot::part(uint32_t offset, uint8_t size) const {
  const Bytes whole = file();
  if (offset >= whole.size()) return Bytes();
  const size_t end = offset + size < whole.size() ? offset + size : whole.size();
  return Bytes(whole.begin() + static_cast<long>(offset), whole.begin() + static_cast<long>(end));
}

void FilePilot::burst(uint16_t number, uint32_t offset) {
  uint32_t ms = delayMs;
  const size_t end = file().size();
  for (; offset < end; offset += 38, ms += 5) {
    if (offset != 10u + 38u * lostItem) in(ms, {number, session, 128, kBurst, offset, part(offset, 38), false});
    ++number;
  }
  lostItem = 0xFFFF;
  in(ms, {number, session, 129, kBurst, offset, {6}, false});  // MAV_FTP_ERR_EOF
}

void FilePilot::store() {
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
