// Finds out which autopilot is on the line, from the heartbeats alone, and whether it still is that one.
//
// The search belongs to the beginning: the first autopilot that is heard becomes ours, unless a second one is heard
// within 1.2 s. From then on it stays the one, also while it is silent. Heartbeats of others change nothing, and a
// sketch that wants another autopilot names it. What is known of ours is one identity: its ids, its firmware, its type
// of vehicle, and that it has not restarted. When that changes, or when it was silent for so long that anything may
// have happened, knowledge() changes, and whoever has learned something of the autopilot forgets it then.
#pragma once

#include <stdint.h>

#include "../base/Clock.h"
#include "../base/Config.h"
#include "../base/RetryRules.h"
#include "Personality.h"

namespace mavmission {
namespace detail {

// The contents of a HEARTBEAT, in the order of its payload, and the sender of its frame.
struct Heartbeat {
  uint32_t customMode;  // the current mode, in the autopilot's own numbers
  uint8_t vehicleType;  // MAV_TYPE
  uint8_t autopilot;    // MAV_AUTOPILOT
  uint8_t baseMode;     // MAV_MODE_FLAG
  uint8_t state;        // MAV_STATE
  uint8_t systemId;
  uint8_t componentId;
};

class AutopilotFinder : public FinderRules {
 public:
  // Names the autopilot to talk to; any other is then nobody. Undone by systemId 0.
  void setTargetIds(uint8_t systemId, uint8_t componentId);

  // Takes a heartbeat. True if it comes from the autopilot that we talk to: the caller then writes it to toFill().
  // MAV_AUTOPILOT_GENERIC is what other devices say as well: it is taken for an autopilot's only where the sketch has
  // named it, or where MAVMISSION_GENERIC_FIRMWARE says which autopilot it is.
  bool onHeartbeat(uint8_t systemId, uint8_t componentId, uint8_t autopilot, uint8_t vehicleType, uint16_t nowMs);
  Heartbeat& toFill() { return heartbeat_; }
  // To be called then, with the state (MAV_STATE) that the heartbeat before has shown.
  void noteState(uint8_t before);
  // Takes a heartbeat that is complete already, and stores it if it comes from the autopilot that we talk to.
  void onHeartbeat(const Heartbeat& heartbeat, uint16_t nowMs) {
    if (onHeartbeat(heartbeat.systemId, heartbeat.componentId, heartbeat.autopilot, heartbeat.vehicleType, nowMs)) {
      const uint8_t before = heartbeat_.state;
      heartbeat_ = heartbeat;
      noteState(before);
    }
  }
  // A message of the autopilot other than its heartbeat: it is not lost, although its heartbeats may be.
  void onFrame(uint16_t nowMs) { heardMs_ = nowMs; }
  MAVMISSION_APART void onTime(uint16_t nowMs);
  // The time since a message of the autopilot was heard, while it is heard [ms].
  uint16_t quietMs(uint16_t nowMs) const { return since(heardMs_, nowMs); }

  // True if an autopilot is heard.
  bool isHeard() const { return heard_; }
  // True if an autopilot is heard and it is clear which one we talk to.
  bool isFound() const { return heard_ && !severalHeard_; }
  // True if isFound(), and a second autopilot would have been heard by now.
  bool isCertain() const { return isFound() && isChosen(); }
  // True if it is clear which one is ours, also while it is silent.
  bool isChosen() const { return settled_ || named_; }
  // True if a second autopilot is heard in the search, and none has been named: nothing is sent then.
  bool severalHeard() const { return severalHeard_; }

  // A number that changes when what the autopilot has shown is to be forgotten: it is another one now, has restarted,
  // or was not heard for so long that anything may have happened.
  uint8_t knowledge() const { return knowledge_; }
  void forget() { knowledge_ = static_cast<uint8_t>((knowledge_ & kIdentity) | ((knowledge_ + 1) & ~kIdentity)); }
  // True if two such numbers are of the same autopilot, which has not restarted.
  static bool isSame(uint8_t one, uint8_t other) { return ((one ^ other) & kIdentity) == 0; }
  // True once when it is another autopilot, or has restarted: then what was begun for it is over, too.
  bool takeChange() {
    const bool isOther = isOther_;
    isOther_ = false;
    return isOther;
  }

  // True while its last heartbeat, which the next one has to confirm, has shown another firmware or vehicle than those
  // before: nothing is sent to it.
  bool isDoubted() const { return isDoubted_; }

  // True if these are the ids of the autopilot that we talk to.
  bool isFrom(uint8_t systemId, uint8_t componentId) const {
    return heard_ && systemId == heartbeat_.systemId && componentId == heartbeat_.componentId;
  }

  // The autopilot's last heartbeat; all zeros before the first.
  const Heartbeat& heartbeat() const { return heartbeat_; }
  MAVMISSION_APART Firmware firmware() const;
  bool isArmed() const;

  // MAV_TYPE: that of its heartbeat, or a QuadPlane's, if a plane was found to say another one.
  uint8_t vehicleType() const { return isPlane_ ? kQuadPlane : heartbeat_.vehicleType; }
  // False while a plane might say that it is what the heartbeat says (Client::asksVehicle()).
  bool isVehicleKnown() const { return isVehicleKnown_; }
  void setVehicle(bool isPlane) {
    isVehicleKnown_ = true;
    isPlane_ = isPlane;
  }

 private:
  MAVMISSION_APART void change();

  static constexpr uint8_t kIdentity = 0xF0;  // the part of knowledge_ that counts autopilots and restarts
  static constexpr uint8_t kQuadPlane = 20;   // MAV_TYPE_VTOL_TAILSITTER_QUADROTOR, of all VTOL types

  Heartbeat heartbeat_;
  uint16_t heardMs_;
  uint16_t searchMs_;  // when our autopilot was heard first, or another one last; when ours was lost
  uint8_t knowledge_;
  bool heard_ : 1;    // bit fields save RAM at the cost of a little flash
  bool settled_ : 1;  // no second autopilot was heard in time: it is ours, also while it is silent
  bool severalHeard_ : 1;
  bool named_ : 1;
  bool isVehicleKnown_ : 1;
  bool isPlane_ : 1;  // which says another type in its heartbeat
  bool isDoubted_ : 1;
  bool isOther_ : 1;  // it has changed, or restarted, and takeChange() has not told yet
};

}  // namespace detail
}  // namespace mavmission
