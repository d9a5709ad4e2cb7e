// Reading a plan back as a state machine. MAVLink guide, Mission Protocol, "Download a Mission from the Vehicle".
//
//            COUNT n                 item n - 1
//   Listing ---------> Fetching ------------------> Closing --> done, when our own ACK has left
//    | REQUEST_LIST      | REQUEST_INT
//    | every 1500 ms,    | every 250 ms, up to
//    | up to 5 attempts  | 5 attempts for each item
//    v                   v
//   NoAnswer            TimedOut
#pragma once

#include <stdint.h>

#include "../Status.h"
#include "../base/Pace.h"
#include "../base/RetryRules.h"

namespace mavmission {
namespace detail {

class DownloadTransfer : public DownloadRules {
 public:
  enum class State : uint8_t { Listing, Fetching, Closing };
  enum class Send : uint8_t { Nothing, List, Request, Accepted };

  MAVMISSION_APART void begin(uint16_t nowMs);
  // After begin(): the items before this one are there already.
  void skipTo(uint16_t item) { next_ = item; }

  // The inputs: the messages that have been received, and the time. Those that return a Status return
  // Status::Transferring while the download goes on, or else the status with which it has ended.
  // onCount() is true if the COUNT is the answer to our REQUEST_LIST.
  bool onCount(uint16_t count, uint16_t nowMs, Pace& pace);
  // expectsItem() is true if this is the item that was requested; the one before, which comes again, shows `pace` how
  // long the line takes. onItem() says that the item has been used, and requests the next one.
  bool expectsItem(uint16_t item, uint16_t nowMs, Pace& pace) const;
  void onItem(uint16_t nowMs, Pace& pace);
  // Requests the item that has just come again at once, because it could not be used yet.
  void askAgain();
  Status onAck(uint8_t result) const;
  Status onTime(uint16_t nowMs, const Pace& pace);

  // The output: the message to send next and, for a request, the number of the item. Call sent() when the message has
  // been handed to the link; sent() is true if that was the last message of the download.
  Send toSend() const { return send_; }
  uint16_t itemToAsk() const { return next_; }
  bool sent(uint16_t nowMs);

  State state() const { return state_; }
  // True if the download is in this state and its request has been sent. An answer that comes before the request has
  // been sent belongs to something earlier.
  bool expectsAnswer(State state) const { return state_ == state && tries_ != 0; }
  uint8_t tries() const { return tries_; }

 private:
  uint16_t sentMs_;
  uint16_t startedMs_;  // when the request that is open now was sent first
  uint16_t count_;
  uint16_t next_;
  State state_;
  Send send_;
  uint8_t tries_;  // attempts at the request that is open now
};

}  // namespace detail
}  // namespace mavmission
