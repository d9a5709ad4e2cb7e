#include "TelemetryListener.h"

#include <Arduino.h>

#include "../base/Clock.h"
#include "../base/Flash.h"
#include "../client/Port.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;

TelemetryListener::TelemetryListener(MissionClient& client, const MessageKey (&keys)[3], uint16_t intervalMs,
                                     Decode decode)
    : MessageIntervals(client, keys, 3, take),
      key_(&keys[2]),
      decode_(decode),
      intervalMs_(intervalMs),
      isHeard_(false),
      isNew_(false),
      isConfirmed_(false) {}

TelemetryListener::TelemetryListener(MissionClient& client, const MessageKey (&keys)[4], uint16_t intervalMs,
                                     Decode decode, Take takeEither)
    : MessageIntervals(client, keys, 4, takeEither),
      key_(&keys[2]),
      decode_(decode),
      intervalMs_(intervalMs),
      isHeard_(false),
      isNew_(false),
      isConfirmed_(false) {}

bool TelemetryListener::isNew() {
  const bool wasNew = isNew_;
  isNew_ = false;
  return wasNew;
}

uint32_t TelemetryListener::ageMs() const { return isHeard_ ? millis() - heardMs_ : kNeverHeard; }

void TelemetryListener::take(Listener& listener, const FrameParser& frame) {
  TelemetryListener& self = static_cast<TelemetryListener&>(listener);
  if (!self.isFromAutopilot(frame)) return;
  const uint32_t nowMs = millis();
  switch (frame.messageId()) {
    case MAVLINK_MSG_ID_HEARTBEAT: return self.takeHeartbeat(static_cast<uint16_t>(nowMs));
    case MAVLINK_MSG_ID_COMMAND_ACK: {
      if (!self.isAnswer(frame)) return self.askIfDue(static_cast<uint16_t>(nowMs));  // another listener has its answer
      self.settle();
      self.isConfirmed_ = frame.payloadByte(offsetof(mavlink_command_ack_t, result)) == MAV_RESULT_ACCEPTED;
      if (self.isConfirmed_ && self.heartbeatsLeft_ < self.patience()) self.heartbeatsLeft_ = self.patience();
      return;
    }
    default:
      if (!self.decode_(self, frame)) return;
      self.heardMs_ = nowMs;
      self.isHeard_ = true;
      self.isNew_ = true;
      if (!self.isConfirmed_) return;
      self.heartbeatsLeft_ = self.patience();
      self.pause_ = FollowRules::kFirstPause;
  }
}

// How many heartbeats may come without the message before it is asked for again.
uint8_t TelemetryListener::patience() const {
  return static_cast<uint8_t>(2 * (intervalMs_ / 1000) + FollowRules::kSilence);
}

void TelemetryListener::takeHeartbeat(uint16_t nowMs) {
  giveUpWaiting(nowMs);
  // An autopilot that has restarted has forgotten the interval, but may send the message at another one.
  if (since(heartbeatMs_, nowMs) >= IntervalRules::kRestartMs) {
    isConfirmed_ = false;
    heartbeatsLeft_ = 0;
    pause_ = FollowRules::kFirstPause;
  }
  heartbeatMs_ = nowMs;
  if (heartbeatsLeft_ != 0) --heartbeatsLeft_;
  askIfDue(nowMs);
}

void TelemetryListener::askIfDue(uint16_t nowMs) {
  if (intervalMs_ == 0 || heartbeatsLeft_ != 0 || isWaiting() || !mayAsk(nowMs) || !client_.link().canSend()) return;
  ask(fromFlash(&key_->id), static_cast<float>(uint32_t{1000} * intervalMs_), 0, nowMs);
  heartbeatsLeft_ = pause_;
  if (pause_ < FollowRules::kLongestPause) pause_ *= 2;
}

}  // namespace mavmission
