// Who has asked the autopilot for what by a command, how often, and which answers may still come: every COMMAND_ACK is
// given to its owner here, and nobody else keeps a record of them. A pure part: it knows neither the stream nor frames.
//
// COMMAND_ACK names the command (MAV_CMD) alone: neither its parameters, such as the message of a SET_MESSAGE_INTERVAL,
// nor which of several attempts it answers. So a command leaves only when no answer to an earlier one with the same id
// may be mistaken for its own, whoever has sent that:
//
//   who                          which command          what is remembered
//   the client's operation       its own, one a time    the id, and until when answers may come
//   who asks for a heartbeat     REQUEST_MESSAGE        how many are not answered, and when the last left
//   one of the listeners         SET_MESSAGE_INTERVAL   which listener, and when its command left
//
//                    sent()                 ended(): the answer                 1.6 s for each repeat
//   an operation:  -----------> under way ------------------------> late answers ----------------------> nothing
//                                   | cancelled, and begin(): for 1.5 s from the last one on ^
//                                   +--------------------------------------------------------+
#pragma once

#include <stdint.h>

#include "../base/Clock.h"
#include "../base/Config.h"
#include "../base/RetryRules.h"

namespace mavmission {
namespace detail {

// All zero at the start.
class CommandLog : public CommandRules {
 public:
  // In the place of a command's id (MAV_CMD): of a message that no COMMAND_ACK answers.
  static constexpr uint16_t kNoCommand = 0;
  static constexpr uint16_t kSetMessageInterval = 511, kRequestMessage = 512;

  // What a listener has asked; it lies with the listener, and lives as long as the log.
  struct Asked {
    uint16_t atMs;  // when its last command left, or got one of several answers
  };

  // --- The client's operation

  // What was there before an operation. Command: the operation before has sent commands, and what it has sent may still
  // be answered. Other: an operation without commands has been between. Nothing: for so long that no answer comes. The
  // times of this log have 16 bits, so those of a command before an Other may have wrapped: it is waited for anew.
  enum class Before : uint8_t { Command, Other, Nothing };
  // An operation begins. The one before may have been cancelled in the middle of a command.
  void begin(Before before, uint16_t nowMs);
  // No late answer to its command is waited for.
  void forget() {
    isUnderWay_ = 0;
    id_ = kNoCommand;
  }
  // True if the operation's command with this id may leave: the first time, or again.
  bool maySend(uint16_t id, uint16_t nowMs);
  // It has left, and is answered within `answerMs`.
  void sent(uint16_t id, uint16_t answerMs, uint16_t nowMs);
  // It goes on: the answer comes later.
  void onProgress(uint16_t nowMs) { untilMs_ = nowMs + kProgressMs; }
  // It has been answered, or given up, after so many attempts; each of the others may be answered as well.
  void ended(uint8_t tries, uint16_t nowMs);
  // No answer has come in all the time that was allowed.
  void gaveUp() {
    if (isUnderWay_ != 0) forget();
  }
  // True for a COMMAND_ACK that answers the operation's command. `sequence`: the number of its frame.
  bool isAnswer(uint16_t command, uint8_t sequence, uint16_t nowMs);

  // --- Requests for a heartbeat, and others whose answer nobody waits for

  void askedAside(uint16_t nowMs);
  uint8_t asksOpen() const { return asksOpen_; }
  // The heartbeat has come.
  void onHeartbeat() {
    if (asksOpen_ > kLateAsks) asksOpen_ = kLateAsks;
  }

  // --- A listener's SET_MESSAGE_INTERVAL

  // True if it may leave: no answer to somebody else's may still come. Not while an operation has a command under way.
  bool mayAsk(const Asked& asked, uint16_t nowMs);
  // It has left, or got one of several answers: from now on there may be another one.
  void await(Asked& asked, uint16_t nowMs) {
    asked.atMs = nowMs;
    asked_ = &asked;
  }
  // True while it is this listener whose answer may still come.
  bool isOf(const Asked& asked) const { return asked_ == &asked; }
  // True for a SET_MESSAGE_INTERVAL's answer that is this listener's. A frame that the line repeats is none.
  bool isAnswerTo(const Asked& asked, uint8_t sequence);
  // The only answer has come.
  void settle() { asked_ = nullptr; }
  // To be called at least twice a minute: nobody answers any more after some time.
  void giveUpOld(const Asked& asked, uint16_t nowMs) {
    if (isOf(asked) && !isOpen(nowMs)) settle();
  }

 private:
  static constexpr uint8_t kMostOpen = 127;  // of asksOpen_

  // True while a listener's command may be answered.
  bool isOpen(uint16_t nowMs) const {
    return asked_ != nullptr && since(asked_->atMs, nowMs) < IntervalRules::kAnswerMs;
  }
  MAVMISSION_APART bool awaits(uint16_t id, uint16_t nowMs);

  const Asked* asked_;  // of the listener that has asked last; null: it has its answer
  uint16_t id_;         // of the operation's command that is under way, or may get late answers
  uint16_t untilMs_;    // these come by then
  uint16_t askedMs_;    // when the last of asksOpen_ left
  uint8_t asksOpen_ : 7;
  uint8_t isUnderWay_ : 1;
  uint8_t sequence_;  // of the frame with the last answer to a SET_MESSAGE_INTERVAL
};

}  // namespace detail
}  // namespace mavmission
