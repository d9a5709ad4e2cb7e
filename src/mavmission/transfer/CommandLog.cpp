#include "CommandLog.h"

namespace mavmission {
namespace detail {

// True if late answers to the operation's command with this id may come.
bool CommandLog::awaits(uint16_t id, uint16_t nowMs) {
  if (id != id_) return false;
  if (isUnderWay_ == 0 && static_cast<int16_t>(untilMs_ - nowMs) <= 0) id_ = kNoCommand;
  return id_ != kNoCommand;
}

void CommandLog::begin(Before before, uint16_t nowMs) {
  isUnderWay_ = 0;
  onHeartbeat();
  if (before == Before::Command) return;
  asksOpen_ = 0;
  if (before == Before::Nothing) id_ = kNoCommand;
  untilMs_ = nowMs + kAnswerMs;
}

bool CommandLog::maySend(uint16_t id, uint16_t nowMs) {
  if (isUnderWay_ != 0) return true;
  if (awaits(id, nowMs)) return false;
  return id != kSetMessageInterval || !isOpen(nowMs);
}

void CommandLog::sent(uint16_t id, uint16_t answerMs, uint16_t nowMs) {
  // On a lossy link it is sent again sooner; its answer may still come after the usual time.
  if (answerMs < kAnswerMs) answerMs = kAnswerMs;
  untilMs_ = nowMs + answerMs;
  id_ = id;
  isUnderWay_ = 1;
  if (id == kSetMessageInterval) settle();  // what a listener has asked for is not answered any more
}

void CommandLog::ended(uint8_t tries, uint16_t nowMs) {
  if (isUnderWay_ == 0) return;
  if (tries < 2) return forget();
  isUnderWay_ = 0;
  // Every repetition of the command may be answered as well. The last late answer comes as long after this answer as
  // the last repetition was sent after the first attempt; on a lossy link they were sent within less than that.
  if (tries > kTries) tries = kTries;
  untilMs_ = nowMs + (tries - 1) * kNextAnswerMs;
}

bool CommandLog::isAnswer(uint16_t command, uint8_t sequence, uint16_t nowMs) {
  if (command == kRequestMessage && asksOpen_ != 0) {
    if (since(askedMs_, nowMs) < kAnswerMs) {
      --asksOpen_;
      return false;
    }
    asksOpen_ = 0;  // they were lost
  }
  if (isUnderWay_ == 0 || command != id_ || command == kNoCommand) return false;
  if (command != kSetMessageInterval) return true;
  if (sequence == sequence_) return false;
  sequence_ = sequence;
  return true;
}

void CommandLog::askedAside(uint16_t nowMs) {
  askedMs_ = nowMs;
  if (asksOpen_ != kMostOpen) ++asksOpen_;
}

bool CommandLog::mayAsk(const Asked& asked, uint16_t nowMs) {
  isUnderWay_ = 0;
  return !awaits(kSetMessageInterval, nowMs) && (isOf(asked) || !isOpen(nowMs));
}

bool CommandLog::isAnswerTo(const Asked& asked, uint8_t sequence) {
  if (!isOf(asked) || sequence == sequence_) return false;
  sequence_ = sequence;
  return true;
}

}  // namespace detail
}  // namespace mavmission
