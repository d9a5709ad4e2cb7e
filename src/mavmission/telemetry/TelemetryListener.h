// The common part of the telemetry listeners: each requests one message from the autopilot, and says how old it is.
#pragma once

#include "../base/RetryRules.h"
#include "../service/MessageIntervals.h"

namespace mavmission {
// Not used by itself: a sketch declares a PositionListener, AttitudeListener, BatteryListener, GpsListener, RcListener
// or HomeListener, and only those take flash and RAM.
//
// It requests its message at an interval (MAV_CMD_SET_MESSAGE_INTERVAL), during the client's transfers and between its
// commands, and repeats the request until COMMAND_ACK has confirmed it. It requests the message again when it has not
// come for a while, and when there was a gap in the heartbeats, since the autopilot may have restarted. From one
// request to the next 2, 4, 8 s and so on pass, at most a minute.
class TelemetryListener : public detail::MessageIntervals {
 public:
  // The value of ageMs() before the first message.
  static constexpr uint32_t kNeverHeard = 0xFFFFFFFF;

  // True when the message has come at least once.
  bool isHeard() const { return isHeard_; }
  // True once after each message, whose values may differ from the last ones.
  bool isNew();
  // The time since the last message [ms], or kNeverHeard.
  uint32_t ageMs() const;
  // True while the autopilot has confirmed the interval. It may still send the message more rarely, if its link is
  // full, or not at all, if it has no value yet, such as a home that is not set.
  bool isConfirmed() const { return isConfirmed_; }
  // The interval that is requested [ms].
  uint16_t intervalMs() const { return intervalMs_; }

 protected:
  // Takes the message; false if it is about something else.
  typedef bool (*Decode)(TelemetryListener& listener, const detail::FrameParser& frame);

  // `keys`: of HEARTBEAT and COMMAND_ACK, then of the message, in flash. `intervalMs`: from one message to the next
  // [ms]; 0: the message is not requested.
  TelemetryListener(MissionClient& client, const MessageKey (&keys)[3], uint16_t intervalMs, Decode decode);
  // The same for a message that has another id on some autopilots: the keys of both lie after the first two, and
  // `takeEither` chooses one of them by request() before it calls take().
  TelemetryListener(MissionClient& client, const MessageKey (&keys)[4], uint16_t intervalMs, Decode decode,
                    Take takeEither);

  // Takes a frame of any of its messages.
  static void take(detail::Listener& listener, const detail::FrameParser& frame);
  // From now on this message is requested.
  void request(const MessageKey* key) { key_ = key; }

 private:
  void takeHeartbeat(uint16_t nowMs);
  uint8_t patience() const;
  void askIfDue(uint16_t nowMs);

  const MessageKey* key_;
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
