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
//
// An order that others may have overtaken is guarded: each attempt leaves right after a heartbeat, in the same
// update(), so that the operation has seen whose the aircraft is (ModeOrder). Heartbeats come once a second; so one is
// asked for, beside the command, and again until it comes (MAV_CMD_REQUEST_MESSAGE; both autopilots answer it at once,
// and PX4 does not take SET_MESSAGE_INTERVAL for its heartbeat).
#pragma once

#include <stdint.h>

#include "../base/Clock.h"
#include "../base/Config.h"
#include "../base/RetryRules.h"
#include "../base/Status.h"

namespace mavmission {
namespace detail {

class CommandTransfer : public CommandRules {
 public:
  enum class State : uint8_t { Due, Sent, InProgress, Listening, Pausing, Doubting, Restoring };

  // Begins the next command of an operation, after the answer to the one before. `repeats`: the command may be sent
  // again when its answer does not come.
  MAVMISSION_APART void next(bool repeats);
  void listen(uint16_t waitMs, uint16_t nowMs) { wait(State::Listening, waitMs, nowMs); }
  void pause(uint16_t waitMs, uint16_t nowMs) { wait(State::Pausing, waitMs, nowMs); }
  void setRepeats(bool repeats) { repeats_ = repeats ? 1 : 0; }
  bool repeats() const { return repeats_ != 0; }
  // An order may undo, or have undone, somebody's mode: it does not leave again, and heartbeats are asked for until one
  // shows what has come of it.
  void doubt() {
    askLater();
    state_ = static_cast<uint8_t>(State::Doubting);
  }
  // Begins the command that sets a mode again which an order has undone. It leaves after each heartbeat that does not
  // show that mode yet, and on a lossy link as often as it can while that heartbeat is fresh: most frames of this
  // length are lost there.
  MAVMISSION_APART void restore() {
    next(true);
    guard();
    state_ = static_cast<uint8_t>(State::Restoring);
  }
  // True while somebody's mode may be undone: heartbeats are asked for twice as often.
  bool isUrgent() const { return state() >= State::Doubting; }
  bool isRestoring() const { return state() == State::Restoring; }

  // Status::Transferring while the command goes on, or else the status with which it has ended. `asksOpen`: requests
  // for a heartbeat that have not been answered.
  MAVMISSION_APART Status onTime(uint8_t asksOpen, uint16_t nowMs);
  void onProgress(uint16_t nowMs) {
    if (!isRestoring()) wait(State::InProgress, kProgressMs, nowMs);
  }
  // The command has been accepted. If it is to be confirmed by what the autopilot sends once a second, it is not sent
  // again before that time, on a lossy link too. `isQuestion`: what confirms it is an answer, which may be lost as
  // often as any; an order that is accepted again and again, and that nothing confirms, is given up.
  void onAccepted(bool isQuestion) {
    if (waitMs_ >= kAnswerMs) return;
    waitMs_ = isQuestion ? kAnswerMs : kAcceptedMs;
    if (isQuestion && tries_ > 2) tries_ = 2;
  }
  // The command is over, and no other follows at once.
  void rest() { tries_ = 0; }

  // True when the command must be sent, if the CommandLog has nothing against that.
  bool isDue() const { return state() == State::Due || isRestoring(); }
  // `answerMs`: how long to wait for an answer before it is sent again; less on a lossy link, and then more often.
  MAVMISSION_APART void sent(uint16_t nowMs, uint16_t answerMs = kAnswerMs);
  // How long its answer is waited for [ms].
  uint16_t waitMs() const { return waitMs_; }

  // --- Heartbeats

  // To be called whenever update() comes by, before anything is made of what it has read. `isOld`: what it reads may
  // have waited since before loop() stood still (Link::isOld()): no order leaves after such a heartbeat. `isBlind`: so
  // long that nothing is under way any more after that. True where the rest of an order may still have to leave, which
  // nobody means any more.
  MAVMISSION_APART bool look(bool isOld, bool isBlind, uint16_t nowMs);
  // True while what is read may have waited while loop() stood still.
  bool isOld() const { return isOld_ != 0; }

  // Each attempt of the command that has begun leaves right after a heartbeat. (The client's gate says for which
  // commands: autopilot/Guarded.h)
  void guard() { isGuarded_ = 1; }
  // No order leaves after the last heartbeat.
  void forgetHeartbeat() { isFresh_ = 0; }
  // Asks for a heartbeat, at once, until one comes.
  void ask() {
    if (isAsking_ == 0) isFresh_ = 1;
    isAsking_ = 1;
  }
  // The same a little later: after a heartbeat that leaves a doubt.
  void askLater() {
    isAsking_ = 1;
    isFresh_ = 0;
  }
  // True when the request must be sent, `againMs` after the one before.
  MAVMISSION_APART bool isAskDue(uint16_t nowMs, uint16_t againMs) const {
    return isAsking_ != 0 && isOld_ == 0 && (isFresh_ != 0 || since(lookedMs_, nowMs) >= againMs);
  }
  void asked(uint16_t nowMs);
  // The autopilot's heartbeat has come. To be called before the operation takes it.
  MAVMISSION_APART void onHeartbeat(uint16_t nowMs);
  // True if the command that is due lacks the heartbeat after which it may leave.
  bool lacksHeartbeat(uint16_t nowMs) const {
    return isGuarded_ != 0 && (isOld_ != 0 || isAsking_ != 0 || isFresh_ == 0 || since(lookedMs_, nowMs) >= kFreshMs);
  }
  // True while a guarded command that has left may not have arrived yet, or had not when what is read now was sent.
  bool mayBeUnderWay(uint16_t nowMs) const {
    if (hasOrdered_ == 0) return false;
    return isOld_ != 0 || static_cast<uint8_t>(nowMs / kOrderTickMs - ordered_) < kUnderWayMs / kOrderTickMs;
  }

  State state() const { return static_cast<State>(state_); }
  // How often the command has been sent.
  uint8_t tries() const { return tries_; }

 private:
  // The wait after an acceptance on a lossy link, by which it is known.
  static constexpr uint16_t kAcceptedMs = kAnswerMs - 1;
  static constexpr uint8_t kOrderTickMs = 16;  // a byte of them is 4 s; look() comes sooner

  MAVMISSION_APART void wait(State state, uint16_t waitMs, uint16_t nowMs);

  uint16_t sentMs_;
  uint16_t waitMs_;
  uint16_t lookedMs_;  // when the last heartbeat came, or when one was asked for since; isOld_: since when
  uint8_t ordered_;    // when a guarded command has left last [kOrderTickMs]
  uint8_t tries_ : 7;
  uint8_t isOld_ : 1;
  uint8_t state_ : 3;  // State
  uint8_t repeats_ : 1;
  uint8_t isGuarded_ : 1;
  uint8_t isAsking_ : 1;
  uint8_t isFresh_ : 1;     // no command has left after the last heartbeat yet; while asking: nor a request
  uint8_t hasOrdered_ : 1;  // ordered_ is known
};

}  // namespace detail
}  // namespace mavmission
