// Reading a plan back as a state machine. MAVLink guide, Mission Protocol, "Download a Mission from the Vehicle".
//
//            COUNT n                 item n - 1
//   Listing ---------> Fetching ------------------> Closing --> done, when our own ACK has left
//    | REQUEST_LIST      | REQUEST_INT
//    | every 1500 ms,    | every 250 ms, up to
//    | up to 5 attempts  | 8 attempts for each item
//    v                   v
//   NoAnswer            TimedOut
//
// An autopilot that answers each request by itself is asked for several items, one after the other, before the first
// has come. They are taken in their order. When one is lost, what comes after it is not used: from it on all are asked
// for again, when no answer can be under way any more.
//
// PX4 ends a reading at a request that it does not expect, as a copy of an earlier one is that the line brings. The
// reading then begins anew, and each request waits until a copy of the one before has arrived.
#pragma once

#include <stdint.h>

#include "../base/Pace.h"
#include "../base/RetryRules.h"
#include "../base/Status.h"

namespace mavmission {
namespace detail {

class DownloadTransfer : public DownloadRules {
 public:
  enum class State : uint8_t { Listing, Fetching, Closing };
  enum class Send : uint8_t { Nothing, List, Request, Accepted };  // after Nothing, in the order of State

  MAVMISSION_APART void begin(uint16_t nowMs, uint8_t anew = 0);
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
  // Where several may be asked for at once: stayAhead() says after onItem() how many others had been asked for before.
  uint8_t othersAsked() const { return pending_ == 0 ? 0 : static_cast<uint8_t>(pending_ - 1); }
  void stayAhead(uint8_t others, uint16_t nowMs);
  // No item is needed: the reading is closed.
  void close() {
    state_ = State::Closing;
    pending_ = 0;
  }
  // Requests the item that has just come again at once, because it could not be used yet.
  void askAgain();
  // The autopilot has ended the reading: it begins anew. False if it has ended it too often.
  bool beginAnew(uint16_t nowMs);
  Status onAck(uint8_t result) const;
  // `answersAny`: the autopilot answers each request by itself. `mayBeAhead`: several items may have been asked for at
  // once.
  Status onTime(uint16_t nowMs, const Pace& pace, bool answersAny = true, bool mayBeAhead = true);

  // True while a copy of the last message may still arrive, and would end the reading.
  bool mustWait(uint16_t nowMs) const;
  // The output: the message to send next and, for a request, the number of the item. Call sent() when the message has
  // been handed to the link; sent() is true if that was the last message of the download. `asksAhead`: several items
  // may be asked for at once now.
  Send toSend(bool asksAhead = false) const {
    if (pending_ != 0 && !(asksAhead && pending_ < kUnderWay && pending_ < left_)) return Send::Nothing;
    return static_cast<Send>(static_cast<uint8_t>(state_) + 1);
  }
  uint16_t itemToAsk() const { return next_ + pending_; }
  uint16_t itemsTaken() const { return next_; }
  bool sent(uint16_t nowMs, bool asksAhead = true);

  State state() const { return state_; }
  // True if the download is in this state and its request has been sent. An answer that comes before the request has
  // been sent belongs to something earlier.
  bool expectsAnswer(State state) const { return state_ == state && (tries_ | pending_) != 0; }
  uint8_t tries() const { return tries_; }

 private:
  uint16_t sentMs_;
  uint16_t startedMs_;  // when the request that is open now was sent first; not for one of several that are open
  uint16_t left_;       // items that have not come
  uint16_t next_;       // the first of them
  State state_;
  uint8_t pending_;  // messages of this state under way: of requests for items, from next_ on; 0: one is to be sent
  uint8_t tries_;    // attempts at the request that is open now; 0 also while it is one of several
  uint8_t anew_;     // how often the reading has begun anew
};

}  // namespace detail
}  // namespace mavmission
