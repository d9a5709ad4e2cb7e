#include "Conversation.h"

#include <stdlib.h>
#include <string.h>

#include <algorithm>
#include <functional>
#include <map>
#include <stdexcept>

#include "Px4Checksum.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;

namespace {

const char* const kCommandResults[] = {"accepted",    "rejected",  "denied",    "unsupported", "failed",
                                       "in progress", "cancelled", "long only", "int only",    "frame"};
const char* const kTypes[] = {"mission", "fence", "rally"};

template <size_t N>
int indexOf(const std::string& word, const char* const (&words)[N]) {
  const auto found = std::find(words, words + N, word);
  return found == words + N ? -1 : static_cast<int>(found - words);
}

template <typename Value>
Value valueAt(const SentFrame& frame, size_t at) {
  return messageIn<Value>(Bytes(frame.payload.begin() + static_cast<long>(at), frame.payload.end()));
}

std::string textOf(double value) {
  char text[40];
  snprintf(text, sizeof(text), "%.10g", value);
  return text;
}

// Takes the word and what follows it off the end; what followed.
std::string cutOff(std::string& event, const std::string& word) {
  const size_t at = event.find(word);
  if (at == std::string::npos) return "";
  const std::string rest = event.substr(at + word.size());
  event.resize(at);
  return rest;
}

// "ITEM 3": 3; -1 without a number there.
int numberAtEnd(const std::string& word) {
  const size_t at = word.find_last_of(' ');
  return at == std::string::npos || word.find_first_not_of("0123456789", at + 1) != std::string::npos
             ? -1
             : static_cast<int>(strtol(word.c_str() + at, nullptr, 10));
}

// "ITEM 4" after "ITEM 3".
bool isNext(const std::string& word, const std::string& next) {
  return (word.compare(0, 5, "ITEM ") == 0 || word.compare(0, 8, "REQUEST ") == 0) && numberAtEnd(word) >= 0 &&
         next == word.substr(0, word.find(' ') + 1) + std::to_string(numberAtEnd(word) + 1);
}

bool begins(const std::string& text, const std::string& with) { return text.compare(0, with.size(), with) == 0; }

uint32_t numberIn(const std::string& text) { return static_cast<uint32_t>(strtoul(text.c_str(), nullptr, 10)); }

// "20 ms", "9 s"; false if it is no time.
bool isTime(const std::string& text, uint32_t& ms) {
  char* end;
  ms = static_cast<uint32_t>(strtoul(text.c_str(), &end, 10));
  if (end == text.c_str()) return false;
  if (strcmp(end, " s") == 0) ms *= 1000;
  return strcmp(end, " s") == 0 || strcmp(end, " ms") == 0;
}

}  // namespace

Conversation::Conversation(uint8_t autopilot, uint32_t startMs, uint32_t aloneMs)
    : ClientOnLine(autopilot, startMs), kind_(autopilot) {
  beats = false;
  client.onEnd(noteEnd, this);
  client.onProgress(noteProgress, this);
  pass(aloneMs);
  forget();
}

Conversation& Conversation::isAbout(const ItemSource& source, PlanType is) {
  plan = source;
  type = is;
  held.clear();
  if (isArduPilot() && is == PlanType::Mission) held.push_back(homeItem());
  for (uint16_t index = 0; index < source.count; ++index) {
    MissionItem item;
    source.read(source.context, index, item);
    if (isArduPilot() && item.param4 != item.param4) item.param4 = 0;
    held.push_back(item);
  }
  return *this;
}

void Conversation::noteEnd(void* context, Status status) {
  static_cast<Conversation*>(context)->told.push_back(status);
}

void Conversation::noteProgress(void* context, uint16_t done, uint16_t total) {
  static_cast<Conversation*>(context)->progress += std::to_string(done) + "/" + std::to_string(total) + " ";
}

std::string Conversation::plays(const std::string& events) {
  forget();
  isTimed_ = false;
  for (size_t at = 0; at < events.size();) {
    if (events[at] == ' ' || events[at] == ',') {
      ++at;
    } else if (events[at] == '|') {
      said_.push_back({"|", {}});
      ++at;
    } else {
      size_t end = std::min(events.find_first_of(",|", at), events.size());
      const size_t next = end;
      while (events[end - 1] == ' ') --end;
      happens(events.substr(at, end - at));
      at = next;
    }
  }
  std::string text;
  for (size_t i = 0; i < said_.size(); ++i) {
    const Said& one = said_[i];
    const bool isBar = one.word == "|";
    if (!text.empty()) text += isBar || text.back() == '|' ? " " : ", ";
    text += one.word;
    if (isTimed_ && !one.atMs.empty()) {
      text += " @";
      for (const uint32_t ms : one.atMs) text += (text.back() == '@' ? "" : " ") + std::to_string(ms - clockMs_);
    } else if (one.atMs.size() > 1) {
      text += " x" + std::to_string(one.atMs.size());
    } else {
      const size_t first = i;
      while (i + 1 < said_.size() && isNext(said_[i].word, said_[i + 1].word) && said_[i + 1].atMs.size() == 1) ++i;
      if (i != first) text += "-" + std::to_string(numberAtEnd(said_[i].word));
    }
  }
  return text;
}

void Conversation::happens(const std::string& whole) {
  uint32_t ms;
  std::string event = whole;
  if (isTime(event, ms)) return pass(ms);
  if (begins(event, "until ")) {
    const size_t at = event.find_last_of(' ', event.size() - 4);
    if (at != std::string::npos && at > 5 && isTime(event.substr(at + 1), ms))
      return until(event.substr(6, at - 6), ms);
    return until(event.substr(6), 20000);
  }
  if (isCall(event) || isOfTheLine(event) || isHeartbeat(event)) return;
  const std::string name = cutOff(event, " named "), ofType = cutOff(event, " of ");
  const int typed = indexOf(ofType, kTypes);
  const PlanType of = typed < 0 ? type : static_cast<PlanType>(typed);
  const uint32_t named = name == "ours" ? checksum() : numberIn(name);
  const int result = indexOf(event, kMissionResults);
  if (result >= 0) {
    return tell(ackParts(static_cast<uint8_t>(result), 1, 191, static_cast<uint8_t>(of), named));
  }
  if (isOfThePlan(event, of, named)) return;
  if (begins(event, "answer ")) {
    const size_t at = event.find(' ', 7);
    const std::string word = event.substr(at + 1);
    const int known = indexOf(word, kCommandResults);
    const uint16_t command = static_cast<uint16_t>(numberIn(event.substr(7)));
    return tell(commandAckParts(command, static_cast<uint8_t>(known < 0 ? static_cast<int>(numberIn(word)) : known)));
  }
  if (begins(event, "current ")) {
    const uint16_t item = static_cast<uint16_t>(numberIn(event.substr(8)));
    return tell(currentParts(item, static_cast<uint16_t>(numberIn(ofType))));
  }
  throw std::invalid_argument("there is no event \"" + whole + "\"");
}

bool Conversation::isCall(const std::string& event) {
  typedef std::function<Status()> Call;
  const std::map<std::string, Call> calls = {
      {"upload", [this] { return client.upload(plan, type); }},
      {"upload unread", [this] { return client.uploadWithoutReadback(plan, type); }},
      {"upload always", [this] { return client.upload(plan, type, Readback::Always); }},
      {"again", [this] { return client.uploadAgain(); }},
      {"verify", [this] { return client.verify(plan, type); }},
      {"ensure", [this] { return client.ensure(plan, type); }},
      {"ensure always", [this] { return client.ensure(plan, type, Readback::Always); }},
      {"clear", [this] { return client.clear(type); }},
      {"download", [this] { return client.download(toFunction(take, nullptr), type); }},
      {"send", [this] { return client.send(command); }},
      {"arm", [this] { return client.arm(); }},
      {"disarm", [this] { return client.disarm(); }},
  };
  if (event == "cancel") client.cancel();
  const auto call = calls.find(event);
  if (call == calls.end()) return event == "cancel";
  const Status status = call->second();
  if (status == Status::Busy) say("Busy");
  return true;
}

bool Conversation::isOfTheLine(const std::string& event) {
  if (event == "broken") {
    Bytes frame = packed(heartbeatParts(kind_));
    frame[12] = static_cast<uint8_t>(frame[12] ^ 1);
    line.bring(frame);
    pass(60);
  } else if (event == "lost" || event == "twice") {
    lose(event == "lost" ? 1 : 255);
  } else if (event == "full") {
    line.room = 0;
    pass(1200);
  } else if (event == "free") {
    line.room = line.kAlwaysRoom;
  } else if (event == "clock") {
    isTimed_ = true;
    clockMs_ = nowMs();
  } else {
    return false;
  }
  return true;
}

bool Conversation::isHeartbeat(const std::string& event) {
  if (event == "silence" || event == "heartbeats") {
    beatsBySecond = event == "heartbeats";
    return true;
  }
  if (event == "armed") {
    baseMode = static_cast<uint8_t>(baseMode | 128);
  } else if (event == "disarmed") {
    baseMode = static_cast<uint8_t>(baseMode & 127);
  } else if (begins(event, "mode ")) {
    mode = numberIn(event.substr(5));
  } else if (event != "beat") {
    return false;
  }
  beat();
  pass(5);
  return true;
}

bool Conversation::isOfThePlan(const std::string& event, PlanType of, uint32_t named) {
  const size_t at = event.find_first_of("0123456789");
  const uint16_t number = at == std::string::npos ? 0 : static_cast<uint16_t>(numberIn(event.substr(at)));
  if (begins(event, "count")) {
    tell(countParts(at == std::string::npos ? static_cast<uint16_t>(held.size()) : number, of, named));
  } else if (event == "items") {
    for (size_t seq = 0; seq < held.size(); ++seq) tell(itemParts(static_cast<uint16_t>(seq), held[seq], of));
  } else if (begins(event, "item ")) {
    tell(itemParts(number, held[number], of));
  } else if (begins(event, "float item ")) {
    const MissionItem& item = held[number];
    tell(floatItemParts(number, item, static_cast<float>(item.x) / 1e7f, static_cast<float>(item.y) / 1e7f));
  } else if (begins(event, "ask ")) {
    tell(requestParts(number, 1, 191, static_cast<uint8_t>(of)));
  } else if (begins(event, "asks ")) {
    const size_t dash = event.find('-');
    const uint32_t end = event == "asks all"         ? static_cast<uint32_t>(held.size())
                         : dash == std::string::npos ? number + 1u
                                                     : numberIn(event.substr(dash + 1)) + 1;
    for (uint32_t item = number; item < end; ++item) {
      hear(requestParts(static_cast<uint16_t>(item), 1, 191, static_cast<uint8_t>(of)));
      until("ITEM " + std::to_string(item), 50);
    }
  } else {
    return false;
  }
  return true;
}

void Conversation::until(const std::string& word, uint32_t limitMs) {
  size_t before = 0;
  const auto times = [&] {
    size_t all = 0;
    for (const Said& one : said_) {
      if (begins(one.word, word)) all += one.atMs.size();
    }
    return all;
  };
  before = times();
  for (uint32_t at = 0; at < limitMs; ++at) {
    one();
    if (times() != before) return;
  }
  say("no " + word);
}

void Conversation::say(const std::string& word) {
  if (said_.empty() || said_.back().word != word) said_.push_back({word, {}});
  said_.back().atMs.push_back(nowMs());
}

void Conversation::pass(uint32_t ms) {
  for (; ms != 0; --ms) one();
}

void Conversation::one() {
  if (beatsBySecond && nowMs() % 1000 == 0) beat();
  if (sent.size() < sent_) sent_ = 0;
  run(1);
  bool isAsked = false;
  for (; sent_ < sent.size(); ++sent_) {
    const std::string word = wordFor(sent[sent_]);
    isAsked = isAsked || word == "BEAT?";
    if (!word.empty() && (word != "BEAT?" || !beatsWhenAsked)) say(word);
  }
  if (isAsked && beatsWhenAsked) beat();
  for (; ends_ < ends.size(); ++ends_) {
    std::string word = std::string("-> ") + nameOf(ends[ends_]);
    const bool hasItem = client.failedItem() != MissionClient::kNoItem;
    if (hasItem) word += " at " + std::to_string(client.failedItem());
    if (client.differingField() != ItemField::None) word += std::string(" in ") + nameOf(client.differingField());
    say(word + " (" + nameOf(client.aboard(type)) + ")");
  }
}

void Conversation::tell(const FrameParts& parts) {
  hear(parts);
  pass(5);
}

void Conversation::beat() {
  FrameParts parts = heartbeatParts(kind_, baseMode, mode, vehicle, MAV_STATE_ACTIVE);
  parts.version = mavlinkVersion;
  hear(parts);
}

std::string Conversation::wordFor(const SentFrame& frame) const {
  const auto number = [&](size_t at) { return " " + std::to_string(valueAt<uint16_t>(frame, at)); };
  const auto ofType = [&](size_t at) {
    return frame.payload[at] == 0 ? std::string() : std::string(" of ") + kTypes[frame.payload[at] % 3];
  };
  const auto floats = [&](size_t count) {
    while (count != 0 && valueAt<float>(frame, 4 * (count - 1)) == 0) --count;
    std::string text;
    for (size_t i = 0; i < count; ++i) text += " " + textOf(double{valueAt<float>(frame, 4 * i)});
    return text;
  };
  // Where it is not for the autopilot.
  const auto to = [&](size_t at) {
    const uint8_t system = frame.payload[at], component = frame.payload[at + 1];
    if (system == 1 && component == 1) return std::string();
    return " to " + std::to_string(system) + "/" + std::to_string(component);
  };
  switch (frame.messageId) {
    case 0: return "";
    case 38: return "PART" + number(0) + "-" + std::to_string(valueAt<uint16_t>(frame, 2)) + ofType(6) + to(4);
    case 39: return "FLOAT ITEM" + number(28) + ofType(37) + to(32);
    case kRequest: return "OLD REQUEST" + number(0) + ofType(4) + to(2);
    case 41: return "CURRENT" + number(0) + to(2);
    case kRequestList: return "LIST" + ofType(2) + to(0);
    case kCount: return "COUNT" + number(0) + ofType(4) + to(2);
    case 45: return "CLEAR" + ofType(2) + to(0);
    case kAck: {
      const uint8_t result = frame.payload[2];
      return std::string("ACK ") + (result < 16 ? kMissionResults[result] : "?") + ofType(3) + to(0);
    }
    case kRequestInt: return "REQUEST" + number(0) + ofType(4) + to(2);
    case kItemInt: return "ITEM" + number(28) + ofType(37) + to(32);
    case 75:
      return "INT" + number(28) + " frame " + std::to_string(frame.payload[32]) + floats(4) + " at " +
             std::to_string(valueAt<int32_t>(frame, 16)) + " " + std::to_string(valueAt<int32_t>(frame, 20)) + " " +
             textOf(double{valueAt<float>(frame, 24)}) + (valueAt<uint16_t>(frame, 33) == 0 ? "" : " current") + to(30);
    case 76:
      if (number(28) == " 512" && valueAt<float>(frame, 0) == 0) return "BEAT?" + floats(7) + to(30);
      return "LONG" + number(28) + floats(7) + to(30) +
             (frame.payload[32] == 0 ? "" : " #" + std::to_string(frame.payload[32]));
    default: return "message " + std::to_string(frame.messageId);
  }
}

size_t Conversation::readInOne(const Bytes& bytes) {
  line.bring(bytes);
  const size_t before = line.bytesRead;
  pass(1);
  const size_t read = line.bytesRead - before;
  pass(60);
  return read;
}

uint32_t Conversation::checksum() const { return px4Checksum(held.data(), static_cast<uint16_t>(held.size())); }
