// Reading a plan as a file, as a state machine. MAVLink guide, File Transfer Protocol; ArduPilot's files of plans.
//
//            it is open             how many items          every item is there
//   Opening ------------> Heading ------------------> Reading -------------------> Closing --> done
//    | OpenFileRO           | ReadFile                 | BurstReadFile, then        | TerminateSession, once: what
//    |                      |                          | ReadFile for what is       | becomes of it does not matter
//    here v                      v                          v missing
//   NoAnswer: no FTP       TimedOut                   TimedOut
#pragma once

#include <stdint.h>

#include "../base/Pace.h"
#include "../base/RetryRules.h"
#include "../base/Status.h"

namespace mavmission {
namespace detail {

class FileReadTransfer : public FileRules {
 public:
  enum class State : uint8_t { Opening, Heading, Reading, Closing };
  enum class Send : uint8_t { Nothing, Open, Header, Burst, Item, Close };

  // `takesAnyOrder`: items after a lost one are taken all the same, and that one is read afterwards.
  void begin(bool takesAnyOrder);

  // The inputs. Each answer that is none to the request that was sent last is ignored.
  void onOpened(uint16_t nowMs, Pace& pace);
  // The file's header; true if that was asked for.
  bool onCount(uint16_t count, uint16_t nowMs, Pace& pace);
  // True if this item, which has come, is wanted now; onItem() then says that it has been used, otherwise onUnused().
  bool wants(uint16_t item) const;
  void onItem(uint16_t item, uint16_t nowMs, Pace& pace);
  void onUnused(uint16_t nowMs);
  // The autopilot has sent all that it had to send of a burst.
  void onBurstEnd();
  // Closes the file; the reading then ends with this status.
  void close(Status result);
  // Transferring while the reading goes on, else the status with which it has ended.
  Status onClosed() const { return state_ == State::Closing && tries_ != 0 ? result_ : Status::Transferring; }
  Status onTime(uint16_t nowMs, const Pace& pace);
  // True when the line loses so much that the mission protocol is the quicker way from here on.
  bool isTooSlow() const { return state_ == State::Reading && !isBurstWorthIt_ && count_ - taken_ > kFewItems; }

  // The output: what to send next, and for Burst and Item from which item on. Call sent() when it has been handed over.
  Send toSend() const { return send_; }
  uint16_t itemToAsk() const { return holeCount_ != 0 ? holes_[0].from : end_; }
  void sent(uint16_t nowMs);

  State state() const { return state_; }
  uint8_t tries() const { return tries_; }
  uint16_t itemsTaken() const { return taken_; }
  uint16_t count() const { return count_; }

 private:
  // Items that were left out of a burst.
  struct Hole {
    uint16_t from, end;
  };
  static constexpr uint8_t kHoles = 4;

  void learn(uint16_t nowMs, Pace& pace) const;
  void ask(Send what);
  void judgeBurst();
  void askNext();
  void fill(uint8_t hole, uint16_t item);

  Hole holes_[kHoles];
  uint16_t sentMs_;     // when the last request was sent, or the last piece came
  uint16_t startedMs_;  // when the request that is open now was sent first
  uint16_t count_;
  uint16_t end_;  // the first item after all that have been taken
  uint16_t taken_;
  uint8_t holeCount_;
  uint8_t mostHoles_;
  uint16_t burstFirst_;
  uint16_t burstGot_;  // pieces of the last burst, those that were not wanted included
  uint8_t tries_;      // attempts at the request that is open now; 0: it has not been sent
  bool isBurstWorthIt_;
  State state_;
  Send send_;
  Send request_;
  Status result_;
};

}  // namespace detail
}  // namespace mavmission
