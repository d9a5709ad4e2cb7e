// The upload of a plan as a state machine: its inputs are the autopilot's messages and the time, its output is what to
// send. It knows neither the stream nor its bytes. MAVLink guide, Mission Protocol, "Upload a Mission to the Vehicle".
//
//               request 0               item n - 1 sent            ACCEPTED
//   Counting  -------------> Sending  ---------------> Confirming ----------> Accepted
//    | COUNT                  | one item for            | the last item repeated
//    | every 1500 ms,         | every request           | every 1500 ms,
//    | up to 5 attempts       |                         | up to 5 repetitions
//    v                        v                         v
//   NoAnswer                 TimedOut                  Unconfirmed
//                after 8.5 s without a request for a new item
//   A refusal in any state ends the upload with the status of that refusal.
#pragma once

#include <stdint.h>

#include "../autopilot/Personality.h"
#include "../base/Clock.h"
#include "../base/Config.h"
#include "../base/Pace.h"
#include "../base/RetryRules.h"
#include "../base/Status.h"
#include "UploadVerdict.h"

namespace mavmission {
namespace detail {

class UploadTransfer : public UploadRules {
 public:
  typedef UploadState State;
  enum class Send : uint8_t { Nothing, Count, Cancel, Item, NextItem };

  // Begins the upload of `count` items on the wire to an autopilot with this firmware. `leftovers`: kFromOpen,
  // kFromBusy, kFromBefore.
  void begin(uint16_t count, Firmware firmware, uint8_t leftovers);

  // Limits the upload to wire items `first` to `end` - 1, for a part of a plan. To be called right after begin().
  void limitTo(uint16_t first, uint16_t end) {
    first_ = first;
    requestedEnd_ = first;
    sentEnd_ = first;
    item_ = first - 1;
    end_ = end;
  }

  // The inputs: the messages that have been received, and the time. Each returns Status::Transferring while the upload
  // goes on, or else the status with which it has ended. What they learn about the line is kept in `pace`.
  Status onRequest(uint16_t item, uint16_t nowMs, Pace& pace);
  Status onAck(uint8_t result, uint16_t nowMs, Pace& pace);
  Status onTime(uint16_t nowMs, Pace& pace);

  // The output: what to send next and, for an item, its number. Call sent() when it has been handed to the link.
  Send toSend() const { return send_; }
  uint16_t itemToSend() const { return send_ == Send::NextItem ? nextItem() : item_; }
  void sent(uint16_t nowMs);

  // An item was requested by MISSION_REQUEST_INT.
  void noteInt() { isAskedByInt_ = true; }
  bool isAskedByInt() const { return isAskedByInt_; }

  State state() const { return state_; }
  // Attempts at COUNT; later, how often items were sent since the newest request.
  uint8_t tries() const { return tries_; }
  bool hasBegun() const { return state_ != State::Counting; }
  // True if an answer has come that may belong to an earlier transfer: a refusal then does not tell what is aboard.
  bool isSuspected() const { return suspicion_ != Status::Transferring; }
  // An earlier transfer was ended before this one.
  bool hasFreed() const { return has(kFreed); }
  // The autopilot has named the checksum of our plan.
  void noteProven() { isProven_ = true; }
  bool isProven() const { return isProven_; }
  // The number of the item after the one that the autopilot has requested last. The autopilot holds all items before
  // that one.
  uint16_t itemsAskedFor() const { return requestedEnd_; }
  // The item after the one that the autopilot waits for. While expectsRequest(), it may be packed in advance.
  uint16_t nextItem() const { return item_ + 1; }
  bool expectsRequest() const { return state_ != State::Confirming && nextItem() < end_; }
  // The current item: a refusal is about this item, unless it may be about the next one.
  uint16_t lastItem() const { return item_; }
  bool isLastItemRefused() const { return tries_ <= kCopies || !detail::has(firmware_, kIgnoresOtherItems); }

 private:
  struct Now;
  void note(uint8_t evidence) { evidence_ |= evidence; }
  bool has(uint8_t evidence) const { return (evidence_ & evidence) != 0; }
  void endOther();
  void freeFirst();
  MAVMISSION_APART void moveTo(uint16_t item, uint16_t nowMs);

  uint16_t progressMs_;
  uint16_t sentMs_;
  uint16_t startedMs_;  // when COUNT, or the current item, was sent first
  uint16_t first_;
  uint16_t end_;
  uint16_t requestedEnd_;  // the item after the one that was requested last
  uint16_t sentEnd_;       // the item after the last one that was sent
  uint16_t item_;  // the item that the autopilot waits for, as far as is known; first_ - 1 before the first request
  State state_;
  Send send_;
  uint8_t tries_;     // attempts at COUNT; later, how often items were sent since the current one is current
  Status suspicion_;  // an answer that may belong to an earlier transfer: the result if no other answer comes
  Firmware firmware_;
  uint8_t evidence_;  // UploadEvidence up to kBeyond
  bool isAgain_ : 1;  // the current item was sent before it became current the last time
  bool isAskedByInt_ : 1;
  bool isProven_ : 1;
};

}  // namespace detail
}  // namespace mavmission
