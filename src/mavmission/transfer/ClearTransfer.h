// Taking a plan away as a pure state machine (MAVLink guide, Mission Protocol, "Clear Missions"): MISSION_CLEAR_ALL,
// repeated until MISSION_ACK answers it, for one type of plan or for all three, one by one.
#pragma once

#include <stdint.h>

#include "../PlanType.h"
#include "../Status.h"
#include "../base/Pace.h"
#include "../base/RetryRules.h"

namespace mavmission {
namespace detail {

class ClearTransfer : public ClearRules {
 public:
  // Due: to be sent as soon as the link can. Sent: an answer is waited for.
  enum class State : uint8_t { Due, Sent };

  // PlanType::All: mission, fence and rally, one by one, since ArduPilot does not know the type for all.
  void begin(PlanType type);

  // An answer: Transferring to go on with the next type, Cleared, or why it was refused. `type()` is what it is about.
  Status onAccepted();
  Status onTime(uint16_t nowMs, const Pace& pace);
  void sent(uint16_t nowMs);

  State state() const { return state_; }
  // The type that is being cleared now.
  PlanType type() const { return type_; }
  // False before MISSION_CLEAR_ALL of this type has left: nothing can answer it.
  bool hasBeenSent() const { return tries_ != 0; }
  uint8_t tries() const { return tries_; }

 private:
  void next(PlanType type);

  uint16_t sentMs_;
  uint8_t tries_;  // for this type
  State state_;
  PlanType type_;
  PlanType last_;  // after which it ends
};

}  // namespace detail
}  // namespace mavmission
