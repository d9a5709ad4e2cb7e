// Which autopilot is on the line, told by the heartbeats, and by nothing else.
#pragma once

#include <stdint.h>

#include "../Config.h"
#include "Personality.h"

namespace mavmission {
namespace detail {

// What a HEARTBEAT says, in the order of its payload, and whose it is.
struct Heartbeat {
  uint32_t customMode;  // the autopilot's own number of the mode it is in
  uint8_t vehicleType;  // MAV_TYPE
  uint8_t autopilot;    // MAV_AUTOPILOT
  uint8_t baseMode;     // MAV_MODE_FLAG
  uint8_t state;        // MAV_STATE
  uint8_t version;      // of the frame: 1 or 2. (In the payload it is a constant, 3.)
  uint8_t systemId;
  uint8_t componentId;
};

class AutopilotFinder {
 public:
  static constexpr uint16_t kLostMs = 5000;    // without a heartbeat (guide: lost after 4 to 5 missed ones)
  static constexpr uint16_t kSettleMs = 1200;  // a second autopilot on the line is heard within a heartbeat's period

  // Names the autopilot to talk to; any other is then nobody. Undone by systemId 0.
  void setTargetIds(uint8_t systemId, uint8_t componentId);

  // A heartbeat has come. True if it is that of the autopilot that we talk to: it is then to be filled in.
  bool onHeartbeat(uint8_t systemId, uint8_t componentId, uint8_t autopilot, uint8_t vehicleType, uint16_t nowMs);
  Heartbeat& toFill() { return heartbeat_; }
  // The same for one that is at hand.
  void onHeartbeat(const Heartbeat& heartbeat, uint16_t nowMs) {
    if (onHeartbeat(heartbeat.systemId, heartbeat.componentId, heartbeat.autopilot, heartbeat.vehicleType, nowMs)) {
      heartbeat_ = heartbeat;
    }
  }
  // It has said something else.
  void onFrame(uint16_t nowMs) { heardMs_ = nowMs; }
  MAVMISSION_APART void onTime(uint16_t nowMs);

  // An autopilot is there.
  bool isHeard() const { return heard_; }
  // An autopilot is there, and it is clear which one.
  bool isFound() const { return heard_ && !severalHeard_; }
  // As isFound(), and a second one would have been heard by now.
  bool isCertain() const { return isFound() && (named_ || settled_); }
  // Two or more are there, and none has been named.
  bool severalHeard() const { return severalHeard_; }

  // True for a frame of the autopilot that we talk to.
  bool isFrom(uint8_t systemId, uint8_t componentId) const {
    return heard_ && systemId == heartbeat_.systemId && componentId == heartbeat_.componentId;
  }

  // The autopilot's last heartbeat; all zeros before the first.
  const Heartbeat& heartbeat() const { return heartbeat_; }
  Firmware firmware() const;
  bool isArmed() const;

 private:
  Heartbeat heartbeat_;
  uint16_t heardMs_;
  uint16_t firstMs_;
  uint16_t otherMs_;
  bool heard_ : 1;  // bits, for RAM: they cost a little flash
  bool settled_ : 1;
  bool severalHeard_ : 1;
  bool named_ : 1;
};

}  // namespace detail
}  // namespace mavmission
