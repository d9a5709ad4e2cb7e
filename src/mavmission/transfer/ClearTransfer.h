// Taking a plan away as a pure state machine (MAVLink guide, Mission Protocol, "Clear Missions"): MISSION_CLEAR_ALL,
// repeated until MISSION_ACK answers it, for one type of plan or for all three, one by one.
//
//             ACCEPTED                        no items
//   Clearing ----------> Asking, if in doubt ----------> the next type, or Cleared
//      ^                   | items are aboard
//      +-------------------+
//
// Where something else may have caused the ACCEPTED it proves nothing: MISSION_REQUEST_LIST then asks how many items
// are aboard.
#pragma once

#include <stdint.h>

#include "../base/Pace.h"
#include "../base/RetryRules.h"
#include "../base/Status.h"
#include "../item/PlanType.h"

namespace mavmission {
namespace detail {

class ClearTransfer : public ClearRules {
 public:
  // Due: to be sent as soon as the link can. Sent: an answer is waited for.
  enum class State : uint8_t { Due, Sent };

  // PlanType::All: mission, fence and rally, one by one, since ArduPilot does not know the type for all.
  // `isDoubtful`: an ACCEPTED may be the answer to something before.
  void begin(PlanType type, bool isDoubtful);

  // The answers: true if no plan of this type is aboard. onCount(): the autopilot says how many items it has.
  bool onAccepted();
  bool onCount(bool isEmpty);
  // After that: false if it was the last type.
  bool next();
  Status onTime(uint16_t nowMs, const Pace& pace);
  void sent(uint16_t nowMs);

  State state() const { return state_; }
  // MISSION_REQUEST_LIST is sent, and not MISSION_CLEAR_ALL.
  bool isAsking() const { return isAsking_; }
  // The type that is being cleared now.
  PlanType type() const { return type_; }
  // False before the message of this step has left: nothing can answer it.
  bool hasBeenSent() const { return tries_ != 0; }
  uint8_t tries() const { return tries_; }
  // What was known to be aboard before the first MISSION_CLEAR_ALL of this type.
  Aboard aboardBefore() const { return aboardBefore_; }
  void setAboardBefore(Aboard what) { aboardBefore_ = what; }

 private:
  void begin(PlanType type);

  uint16_t sentMs_;
  uint8_t tries_;   // at this step
  uint8_t clears_;  // how often MISSION_CLEAR_ALL of this type had left when the number of items was asked for
  State state_;
  PlanType type_;
  PlanType last_;  // after which it ends
  Aboard aboardBefore_;
  bool isDoubtful_;
  bool isAsking_;
};

}  // namespace detail
}  // namespace mavmission
