// A telemetry listener whose message has one id on ArduPilot, and another one on other autopilots.
#pragma once

#include "TelemetryListener.h"

namespace mavmission {
namespace detail {

class EitherListener : public TelemetryListener {
 protected:
  // `keys`: of HEARTBEAT and COMMAND_ACK, of ArduPilot's message, and of that of others, in flash.
  EitherListener(MissionClient& client, const MessageKey (&keys)[4], uint16_t intervalMs, Decode decode)
      : TelemetryListener(client, keys, intervalMs, decode, takeEither), keys_(&keys[2]) {}

 private:
  static void takeEither(Listener& listener, const FrameParser& frame);

  const MessageKey* const keys_;  // of ArduPilot's message, and of that of others
};

}  // namespace detail
}  // namespace mavmission
