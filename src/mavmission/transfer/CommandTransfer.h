// One command after the other as a state machine: answers and the time go in, when to send comes out. It knows no
// stream, no bytes, and not what a command means. MAVLink guide, Command Protocol.
//
//          sent            an answer
//   Due  -------->  Sent  ----------->  the next command, or the end
//    ^               |  \ IN_PROGRESS
//    |               |   -----------> InProgress: 5 s more each time
//    | every 1500 ms |
//    +---------------+ up to 5 attempts, then NoAnswer; Unconfirmed for what is sent only once
//
//   Listening: nothing is sent, something that the autopilot sends by itself is waited for; then Unconfirmed
//   Pausing: a wait before the next attempt
#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../Status.h"
#include "../base/Clock.h"

namespace mavmission {
namespace detail {

class CommandTransfer {
 public:
  static constexpr uint8_t kTries = 5;           // guide: 5 tries
  static constexpr uint8_t kLossyTries = 40;     // on a line that loses: 80 ms apart or more
  static constexpr uint16_t kAnswerMs = 1500;    // wait for an answer (guide: 1500 ms)
  static constexpr uint16_t kProgressMs = 5000;  // after IN_PROGRESS, and for a command that is sent only once
  static constexpr uint8_t kLateAnswersS = 20;   // how long late answers may come, at the most [s]
  static constexpr uint16_t kNextAnswerMs = kAnswerMs + 100;  // from an answer to that to the next sending

  // In the place of a command's id (MAV_CMD): of a message that no COMMAND_ACK answers.
  static constexpr uint16_t kNoCommand = 0;

  enum class State : uint8_t { Due, Sent, InProgress, Listening, Pausing };

  // Begins with a command behind another one, whose answer has just been taken. `repeats`: may it be sent again?
  void next(bool repeats, uint16_t nowMs);
  // Begins the first command of an operation: `last` is what the last operation left, if that was a command, whose late
  // answers may still come.
  void beginBehind(const CommandTransfer& last) {
    sentMs_ = last.sentMs_;
    waitMs_ = last.waitMs_;
    id_ = last.id_;
  }
  void listen(uint16_t waitMs, uint16_t nowMs) { wait(State::Listening, waitMs, nowMs); }
  void pause(uint16_t waitMs, uint16_t nowMs) { wait(State::Pausing, waitMs, nowMs); }
  void setRepeats(bool repeats) { repeats_ = repeats ? 1 : 0; }

  // Status::Transferring to go on, or how the command has ended.
  MAVMISSION_APART Status onTime(uint16_t nowMs);
  // True for an answer to the command that is under way.
  bool isAnswer(uint16_t command) const { return command == id_ && id_ != kNoCommand && tries_ != 0; }
  void onProgress(uint16_t nowMs) { wait(State::InProgress, kProgressMs, nowMs); }
  // It has been answered, and nothing follows it: the late answers to its other sendings come within a while.
  void rest(uint16_t nowMs);

  // True when the command with this id is to be sent now. Behind one with the same id that was sent more than once it
  // waits until the other answers should have come: COMMAND_ACK does not say which sending it answers.
  bool isDue(uint16_t id, uint16_t nowMs) const {
    return state() == State::Due && (tries_ != 0 || id != id_ || since(sentMs_, nowMs) >= waitMs_);
  }
  // `answerMs`: how long to wait for an answer before it is sent again; less on a line that loses, and then more often.
  void sent(uint16_t id, uint16_t nowMs, uint16_t answerMs = kAnswerMs);

  // A listener has sent a command with this id beside us; our next one with the same id waits until the answer to it
  // has come, or should have.
  void sentByListener(uint16_t id, uint16_t nowMs) {
    id_ = id;
    tries_ = 0;
    wait(State::Due, kAnswerMs, nowMs);
  }
  // That command, which left at `sentMs`, has been answered.
  void answeredToListener(uint16_t id, uint16_t sentMs) {
    if (id_ == id && sentMs_ == sentMs) waitMs_ = 0;
  }

  State state() const { return static_cast<State>(state_); }
  // How often the command has been sent.
  uint8_t tries() const { return tries_; }

 private:
  MAVMISSION_APART void wait(State state, uint16_t waitMs, uint16_t nowMs);

  uint16_t sentMs_;
  uint16_t waitMs_;
  uint16_t id_;
  uint8_t tries_;
  uint8_t state_ : 7;  // State
  uint8_t repeats_ : 1;
};

}  // namespace detail
}  // namespace mavmission
