// What the listeners of telemetry have in common: each asks the autopilot for one message, and says how old it is.
#pragma once

#include "base/RetryRules.h"
#include "service/MessageIntervals.h"

namespace mavmission {
// Not used by itself: a sketch declares a PositionListener, AttitudeListener, BatteryListener, GpsListener, RcListener
// or HomeListener, and pays for those that it declares.
//
// It asks for its message at an interval (MAV_CMD_SET_MESSAGE_INTERVAL) until COMMAND_ACK has confirmed that, beside
// the client's transfers and between its commands. It asks again when the message has not come for a while, and when
// the autopilot may have restarted: when its heartbeats had a gap. From one request to the next 2, 4, 8 s and so on
// pass, up to a minute.
class TelemetryListener : public detail::MessageIntervals {
 public:
  // The value of ageMs() before the first message.
  static constexpr uint32_t kNeverHeard = 0xFFFFFFFF;

  // True when the message has come at least once.
  bool isHeard() const { return isHeard_; }
  // True once after each message: it may have brought other values.
  bool isNew();
  // How long ago the last message came [ms], or kNeverHeard.
  uint32_t ageMs() const;
  // True while the autopilot has confirmed the interval. It may still send more rarely, where its line is full; where
  // it has nothing to tell, such as a home that is not set yet, it sends nothing.
  bool isConfirmed() const { return isConfirmed_; }

 protected:
  // Takes the message; false if it is about something else.
  typedef bool (*Decode)(TelemetryListener& listener, const detail::FrameParser& frame);

  // `keys`: of HEARTBEAT and COMMAND_ACK, then of the message, in flash. `intervalMs`: from one message to the next
  // [ms]; 0: the message is not asked for.
  TelemetryListener(MissionClient& client, const MessageKey (&keys)[3], uint16_t intervalMs, Decode decode);

 private:
  static void take(detail::Listener& listener, const detail::FrameParser& frame);
  void takeHeartbeat(uint16_t nowMs);
  uint8_t patience() const;
  void askIfDue(uint16_t nowMs);

  const MessageKey* const key_;
  Decode const decode_;
  uint32_t heardMs_ = 0;
  uint16_t const intervalMs_;
  uint16_t heartbeatMs_ = 0;                          // when the autopilot's last heartbeat came
  uint8_t heartbeatsLeft_ = 0;                        // before the message is requested
  uint8_t pause_ = detail::FollowRules::kFirstPause;  // the next one, from one request to another [heartbeats]
  bool isHeard_ : 1;
  bool isNew_ : 1;
  bool isConfirmed_ : 1;
};

}  // namespace mavmission
