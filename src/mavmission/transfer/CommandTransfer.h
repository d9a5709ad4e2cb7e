// The sending of commands, one after the other, as a state machine: its inputs are the answers and the time, its output
// is when to send. It knows neither the stream nor its bytes nor the meaning of a command. MAVLink guide, Command
// Protocol.
//
//          sent            an answer
//   Due  -------->  Sent  ----------->  the next command, or the end
//    ^               |  \ IN_PROGRESS
//    |               |   -----------> InProgress: 5 s more each time
//    | every 1500 ms |
//    +---------------+ up to 5 attempts, then NoAnswer; Unconfirmed for a command that is sent only once
//
//   Listening: nothing is sent while we wait for a message that the autopilot sends by itself; Unconfirmed at timeout
//   Pausing: a pause before the next attempt
#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../Status.h"
#include "../base/Clock.h"
#include "../base/RetryRules.h"

namespace mavmission {
namespace detail {

class CommandTransfer : public CommandRules {
 public:
  // In the place of a command's id (MAV_CMD): of a message that no COMMAND_ACK answers.
  static constexpr uint16_t kNoCommand = 0;

  enum class State : uint8_t { Due, Sent, InProgress, Listening, Pausing };

  // Begins the next command of an operation, after the answer to the one before. `repeats`: the command may be sent
  // again when its answer does not come.
  void next(bool repeats, uint16_t nowMs);
  // Begins the first command of an operation. `last` is the transfer of the operation before, which was a command, too:
  // late answers to that command may still come.
  void beginBehind(const CommandTransfer& last) {
    sentMs_ = last.sentMs_;
    waitMs_ = last.waitMs_;
    id_ = last.id_;
  }
  void listen(uint16_t waitMs, uint16_t nowMs) { wait(State::Listening, waitMs, nowMs); }
  void pause(uint16_t waitMs, uint16_t nowMs) { wait(State::Pausing, waitMs, nowMs); }
  void setRepeats(bool repeats) { repeats_ = repeats ? 1 : 0; }
  bool repeats() const { return repeats_ != 0; }

  // Status::Transferring while the command goes on, or else the status with which it has ended.
  MAVMISSION_APART Status onTime(uint16_t nowMs);
  // True for an answer to the command that is under way.
  bool isAnswer(uint16_t command) const { return command == id_ && id_ != kNoCommand && tries_ != 0; }
  void onProgress(uint16_t nowMs) { wait(State::InProgress, kProgressMs, nowMs); }
  // The command has been accepted. If it is to be confirmed by what the autopilot sends once a second, it is not sent
  // again before that time, on a line that loses too.
  void onAccepted() {
    if (waitMs_ >= kAnswerMs) return;
    waitMs_ = kAnswerMs;
    if (tries_ > 2) tries_ = 2;
  }
  // The command has been answered, and no other follows at once. From now on we allow for late answers to its other
  // attempts.
  void rest(uint16_t nowMs);

  // True when the command with this id must be sent now. If the command before had the same id and was sent more than
  // once, this one waits until the late answers should have come: COMMAND_ACK does not say which attempt it answers.
  bool isDue(uint16_t id, uint16_t nowMs) const {
    return state() == State::Due && (tries_ != 0 || id != id_ || since(sentMs_, nowMs) >= waitMs_);
  }
  // `answerMs`: how long to wait for an answer before it is sent again; less on a line that loses, and then more often.
  void sent(uint16_t id, uint16_t nowMs, uint16_t answerMs = kAnswerMs);

  // A listener on the same link has sent a command with this id. Our next command with the same id waits until the
  // listener's command has been answered, or until the timeout for that answer.
  void sentByListener(uint16_t id, uint16_t nowMs) {
    id_ = id;
    tries_ = 0;
    wait(State::Due, kAnswerMs, nowMs);
  }
  // The listener's command with this id, sent at `sentMs`, has been answered.
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
