#include "AnsweringPeer.h"

using mavmission::Status;

Status AnsweringPeer::end(uint32_t limitMs) {
  ended = Status::Idle;
  beganMs = nowMs();
  for (; limitMs != 0 && ended == Status::Idle; --limitMs) one();
  tookMs = nowMs() - beganMs;
  return ended;
}

bool AnsweringPeer::passUntil(const std::string& words, size_t from, uint32_t limitMs) {
  for (size_t next = said_.size(); limitMs != 0; --limitMs) {
    one();
    for (; next < said_.size(); ++next) {
      if (said_[next].compare(from, words.size(), words) == 0) return true;
    }
  }
  return false;
}

bool AnsweringPeer::passUntilSent(uint16_t messageId, uint32_t limitMs) {
  for (sent.clear(); limitMs != 0; --limitMs) {
    one();
    if (!timesOf(messageId, 0).empty()) return true;
  }
  return false;
}

std::string AnsweringPeer::said() {
  std::string text;
  for (const std::string& one : said_) text += (text.empty() ? "" : ", ") + one;
  said_.clear();
  saidMs.clear();
  return text;
}

void AnsweringPeer::say(const std::string& words) {
  said_.push_back(words);
  saidMs.push_back(nowMs());
}

void AnsweringPeer::passDue() {
  for (auto due = due_.begin(); due != due_.end() && due->first <= nowMs(); due = due_.erase(due)) due->second();
}

int AnsweringPeer::resultOf(int request) {
  const auto next = once.find(request);
  if (next == once.end()) return gives.count(request) != 0 ? gives[request] : 0;
  const int result = next->second;
  once.erase(next);
  return result;
}

Bytes AnsweringPeer::packedAgain(const SentFrame& frame, uint8_t crcExtra) {
  FrameParts parts = frameAt(frame.frame).parts;
  parts.payload.resize(frame.frame[1]);
  parts.crcExtra = crcExtra;
  return packed(parts);
}
