// The upload of a plan as a state machine: what the autopilot says and the time go in, what to send comes out. It knows
// no stream and no bytes. MAVLink guide, Mission Protocol, "Upload a Mission to the Vehicle".
//
//               request 0               item n - 1 sent            ACCEPTED
//   Counting  -------------> Sending  ---------------> Confirming ----------> Accepted
//    | COUNT again each       | an item per request     | the last item again each
//    | 1500 ms, 5 in all      | heard, none unasked     | 1500 ms, 5 times
//    v                        v                         v
//   NoAnswer                 TimedOut                  Unconfirmed
//            8.5 s without a new item asked for
//   a refusal in any state: its own status
#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../Status.h"
#include "../autopilot/Personality.h"
#include "../base/Clock.h"
#include "../base/Pace.h"

namespace mavmission {
namespace detail {

class UploadTransfer {
 public:
  static constexpr uint8_t kTries = 5;          // COUNTs, and repeated last items (guide: 5 tries)
  static constexpr uint16_t kAnswerMs = 1500;   // wait for an answer to either (guide: 1500 ms)
  static constexpr uint16_t kPassiveMs = 8500;  // ArduPilot asks again each second and gives up after 8.0 s
  // The most for all COUNTs on a line that loses: ArduPilot gives up 8 s after the first that it has heard.
  static constexpr uint16_t kCountingMs = 7500;
  static constexpr uint16_t kConfirmingMs = 12000;  // the most for the final answer, repeats of the last item included
  static constexpr uint8_t kSameRequestMs = 50;     // a repeat within that is a queue being emptied, not a new question

  enum class State : uint8_t { Counting, Sending, Confirming };
  enum class Send : uint8_t { Nothing, Count, Item, Cancel };

  // What an earlier transfer may have left. kAnswers: it may still be answered, also if it is from before a reset: what
  // only that can have caused is not taken for an answer to this one. kBusy: PX4 may not have heard that it is over.
  static constexpr uint8_t kAnswers = 1, kBusy = 2;

  // Begins with `count` items on the wire, for an autopilot of this kind.
  void begin(uint16_t count, Firmware firmware, uint8_t leftovers, uint16_t nowMs);

  // Right after begin(): only wire items `first` to `behind` - 1, for a part of a plan.
  void limitTo(uint16_t first, uint16_t behind) {
    first_ = first;
    asked_ = first;
    behind_ = behind;
  }

  // What has been heard, and time. Each returns Status::Transferring to go on, or how the transfer has ended.
  Status onRequest(uint16_t item, uint16_t nowMs, Pace& pace);
  Status onAck(uint8_t result, uint16_t nowMs, Pace& pace);
  MAVMISSION_APART Status onTime(uint16_t nowMs, Pace& pace);

  // What is to be sent next, and the item if it is one. After it has been handed to the link: sent().
  Send toSend() const { return send_; }
  uint16_t itemToSend() const { return item_; }
  MAVMISSION_APART void sent(uint16_t nowMs);

  State state() const { return state_; }
  bool hasBegun() const { return state_ != State::Counting; }
  // An answer was heard that may have been to an earlier transfer.
  bool isSuspected() const { return suspicion_ != Status::Transferring; }
  // True if an acceptance may be of an earlier, longer transfer that broke off where this one ends: PX4 then accepts
  // our last item as if it were that one's, repeated, with the sum of what it had until then.
  bool isAcceptanceDoubtful() const { return has(firmware_, kGoesOnWithOlder) && mayBeAnswered() && isUnasked_; }
  // The item behind those that the autopilot has asked for, in their order; it holds all of these but the last.
  uint16_t itemsAskedFor() const { return asked_; }
  // True while it will be asked for the item behind those: it may be made ready.
  bool expectsRequest() const { return state_ != State::Confirming && asked_ < behind_; }
  // The item that went out last: the one that a refusal is about.
  uint16_t lastItem() const { return item_; }

 private:
  bool mayBeAnswered() const { return (leftovers_ & kAnswers) != 0; }
  void endOlder();
  void sendAgain();
  Status onAcceptance();

  uint16_t progressMs_;
  uint16_t sentMs_;
  uint16_t first_;
  uint16_t behind_;
  uint16_t asked_;
  uint16_t item_;
  State state_;
  Send send_;
  uint8_t tries_;     // COUNTs sent; then items since the one before asked_ was asked for
  Status suspicion_;  // an answer that may be to an earlier transfer: the reason if no other comes
  Firmware firmware_;
  uint8_t leftovers_;
  bool recounted_;  // COUNT was sent more than once
  bool freed_;      // an open transfer of ours was cancelled first
  bool repeated_;   // an item was sent more than once
  bool isUnasked_;  // the item before asked_ was sent again without being asked for
  bool isOnly_;     // nothing but the item before asked_ was sent since that was asked for
};

}  // namespace detail
}  // namespace mavmission
