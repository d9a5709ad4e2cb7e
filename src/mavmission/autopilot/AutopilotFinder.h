// Finds out which autopilot is on the line, from the heartbeats alone.
#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../base/Clock.h"
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
  bool onHeartbeat(uint8_t systemId, uint8_t componentId, uint8_t autopilot, uint8_t vehicleType, uint16_t nowMs);
  Heartbeat& toFill() { return heartbeat_; }
  // Takes a heartbeat that is complete already, and stores it if it comes from the autopilot that we talk to.
  void onHeartbeat(const Heartbeat& heartbeat, uint16_t nowMs) {
    if (onHeartbeat(heartbeat.systemId, heartbeat.componentId, heartbeat.autopilot, heartbeat.vehicleType, nowMs)) {
      heartbeat_ = heartbeat;
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
  bool isCertain() const { return isFound() && (named_ || settled_); }
  // True if two or more autopilots are heard and none has been named.
  bool severalHeard() const { return severalHeard_; }

  // True if these are the ids of the autopilot that we talk to.
  bool isFrom(uint8_t systemId, uint8_t componentId) const {
    return heard_ && systemId == heartbeat_.systemId && componentId == heartbeat_.componentId;
  }

  // The autopilot's last heartbeat; all zeros before the first.
  const Heartbeat& heartbeat() const { return heartbeat_; }
  Firmware firmware() const;
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
  static constexpr uint8_t kQuadPlane = 20;  // MAV_TYPE_VTOL_TAILSITTER_QUADROTOR, of all VTOL types

  Heartbeat heartbeat_;
  uint16_t heardMs_;
  uint16_t firstMs_;
  uint16_t otherMs_;
  bool heard_ : 1;  // bit fields save RAM at the cost of a little flash
  bool settled_ : 1;
  bool severalHeard_ : 1;
  bool named_ : 1;
  bool isVehicleKnown_ : 1;
  bool isPlane_ : 1;  // which says another type in its heartbeat
};

}  // namespace detail
}  // namespace mavmission
