// Reading a plan back as a state machine. MAVLink guide, Mission Protocol, "Download a Mission from the Vehicle".
//
//            COUNT n                 item n - 1
//   Listing ---------> Fetching ------------------> Closing --> done, when our own ACK has left
//    | REQUEST_LIST      | REQUEST_INT again each
//    | again each        | 250 ms, 5 in all for an item
//    | 1500 ms, 5 in all v
//    v                  TimedOut
//   NoAnswer
#pragma once

#include <stdint.h>

#include "../Status.h"
#include "../base/Pace.h"

namespace mavmission {
namespace detail {

class DownloadTransfer {
 public:
  static constexpr uint8_t kTries = 5;         // guide: 5 tries
  static constexpr uint8_t kLossyTries = 250;  // on a line that loses
  static constexpr uint16_t kListMs = 1500;    // guide: 1500 ms
  static constexpr uint16_t kItemMs = 250;     // guide: 250 ms for plan items

  enum class State : uint8_t { Listing, Fetching, Closing };
  enum class Send : uint8_t { Nothing, List, Request, Accepted };

  void begin(uint16_t nowMs);

  // What has been heard, and time. Each returns Status::Transferring to go on, or how it has ended.
  // True if it is the answer to our question.
  bool onCount(uint16_t count);
  // True if it is the item that was asked for; the next one is then asked for.
  bool onItem(uint16_t item, uint16_t nowMs, Pace& pace);
  // The item that has just come, and was not taken, is asked for again at once.
  void askAgain();
  Status onAck(uint8_t result) const;
  Status onTime(uint16_t nowMs, const Pace& pace);

  // What is to be sent next, and the item if it is a request. After it has been handed to the link: sent(), which is
  // true when that was all.
  Send toSend() const { return send_; }
  uint16_t itemToAsk() const { return next_; }
  bool sent(uint16_t nowMs);

  State state() const { return state_; }
  // True if an answer in this state can be one to us: what comes before the question has left is an answer to something
  // earlier.
  bool expectsAnswer(State state) const { return state_ == state && tries_ != 0; }
  uint8_t tries() const { return tries_; }

 private:
  uint16_t sentMs_;
  uint16_t count_;
  uint16_t next_;
  State state_;
  Send send_;
  uint8_t tries_;  // of what is asked for now
};

}  // namespace detail
}  // namespace mavmission
