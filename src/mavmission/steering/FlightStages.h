// A flight from its plan to its end, and who has ended it, as a pure state machine: its inputs are what the last
// heartbeat shows, the ends of operations and the time, its output is the operation to begin next. It knows neither the
// client nor the line. docs/design/flying.md has the diagram.
#pragma once

#include <stdint.h>

#include "../base/Config.h"
#include "../base/RetryRules.h"
#include "../base/Status.h"
#include "FlightState.h"

namespace mavmission {
namespace detail {

// What may be begun next.
enum class FlightOrder : uint8_t { None, Upload, Start, TakeOff, GoTo, Home, Land, Disarm };

// True for those of a plan; the others are given by the sketch.
constexpr bool isOfPlan(FlightOrder order) {
  return order == FlightOrder::Upload || order == FlightOrder::Start || order == FlightOrder::Disarm;
}

// In whose hands the aircraft is, by its mode. Unclear: it returns, and this may be the plan's own end.
enum class FlightHands : uint8_t { Own, Unclear, Pilot, Failsafe };

// The aircraft, as its last heartbeat and its mission show it.
struct FlightSight {
  FlightHands hands;
  uint16_t mode;     // in the numbers of modeNumber()
  bool isHeard;      // its heartbeats come
  bool isLossy;      // some may be lost
  bool isArmed;      // by the last one
  bool isOver;       // it is at the plan's last item, or comes down as it was told to
  bool mayRest;      // disarmed, it may have changed to this mode by itself
  bool staysArmed;   // it has flown its plan to the end, and does not disarm by itself
  bool isOtherPlan;  // somebody has replaced the plan
};

// All zero at the start.
class FlightStages : public FlightRules {
 public:
  FlightState state() const { return state_; }
  EndedBy endedBy() const { return endedBy_; }
  // Why it is not ready, why it has ended, or why the last order in flight was refused.
  Status why() const { return why_; }
  FlightOrder running() const { return running_; }
  bool isUnderWay() const { return state_ >= FlightState::Preparing && state_ <= FlightState::AtStop; }
  bool isInFlight() const { return state_ == FlightState::Flying || state_ == FlightState::AtStop; }
  // On the ground, and not given up: a person who touches it ends it.
  bool isWaiting() const { return state_ == FlightState::Preparing || state_ == FlightState::NotReady; }
  uint32_t inStateMs(uint32_t nowMs) const { return nowMs - sinceMs_; }
  void setLimit(uint16_t seconds) { limitS_ = seconds; }
  // True once after each change of the state or of why().
  bool takeNews();
  void noteNews() { isNew_ = true; }
  // The time of the calls that follow.
  void setNow(uint32_t nowMs) { nowMs_ = nowMs; }

  // --- What the sketch wants. Status::Transferring: it is done in time. Any other status: why not.

  // A flight that begins with this order.
  Status begin(FlightOrder first);
  // An ended flight is forgotten: the next one may begin.
  void forget();
  // An order in flight. On the ground an order to come down gives the flight up.
  Status order(FlightOrder what);
  // A flight of this order alone, of an aircraft that is in the air already.
  Status take(FlightOrder what);
  // Gives the flight up, on the ground. In the air the autopilot flies on.
  void giveUp(FlightOrder ifItFlies);

  // --- What happens

  // `isBeat`: a heartbeat has come since the last call.
  void look(const FlightSight& sight, bool isBeat);
  // The running operation has ended. `hasArmed`: it has armed the aircraft, and disarmed it again.
  void onEnd(Status status, const FlightSight& sight, bool hasArmed);
  // It is where it was sent; or it has left its stop.
  void arrive() { change(FlightState::AtStop); }
  void leave() { change(FlightState::Flying); }
  // The plan that was to be uploaded cannot be flown: nothing is begun.
  void refuse(Status why) {
    running_ = FlightOrder::None;
    end(EndedBy::Refusal, why);
  }

  // --- What to do

  // The operation to begin now, if none runs. Then begun() tells that it was begun.
  FlightOrder due(bool isHeard) const;
  void begun(uint16_t mode);
  // True once if the running operation has to be broken off, since the flight has ended. (An upload goes on to its end,
  // for which nobody waits any more.)
  bool takeBreak();

 private:
  MAVMISSION_APART void change(FlightState state);
  MAVMISSION_APART void end(EndedBy who, Status why);
  void endBy(const FlightSight& sight, Status why);
  void fly();
  bool setsModes() const { return running_ == FlightOrder::Start || running_ == FlightOrder::TakeOff; }
  void lookAtGround(const FlightSight& sight);
  void lookInFlight(const FlightSight& sight);
  void onRefused(FlightOrder what, Status status, const FlightSight& sight, bool hasArmed);

  FlightState state_;
  EndedBy endedBy_;
  Status why_;
  FlightOrder order_;    // to be begun
  FlightOrder running_;  // has begun
  FlightOrder after_;    // to be begun in the air, where the flight was given up on the ground
  uint8_t tries_;        // of the order
  uint8_t beats_;        // heartbeats since it has become unclear who flies, or since the plan's end
  bool isNew_ : 1;
  bool hasHeard_ : 1;      // since it began
  bool seenDisarmed_ : 1;  // since it began
  bool wasSilent_ : 1;     // in flight
  bool isSilent_ : 1;      // so it is still
  bool knowsRest_ : 1;     // restModes_ are known
  bool isGivenUp_ : 1;
  uint16_t restModes_[2];  // on the ground it is in one of these, unless somebody sets another one
  uint16_t heardMs_;       // when a heartbeat came last
  uint16_t limitS_;        // 0: the usual one
  uint32_t nowMs_;
  uint32_t beganMs_;  // when the flight began
  uint32_t sinceMs_;  // when the state began
  uint32_t triedMs_;  // when the order was refused last
};

}  // namespace detail
}  // namespace mavmission
