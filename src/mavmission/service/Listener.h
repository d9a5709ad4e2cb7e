// An object that receives frames beside the running operation. A sketch declares the ones that it needs
// (MissionFollower, MessageListener, TelemetryPause, LinkDoctor); the others are not in its program.
#pragma once

#include <stdint.h>

#include "../link/FrameParser.h"

namespace mavmission {

class MissionClient;

namespace detail {

class Port;

class Listener : private MoreKeys {
 public:
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

 protected:
  // Takes a frame of one of the messages, from any sender. Called from update(); may start operations.
  typedef void (*Take)(Listener& listener, const FrameParser& frame);

  // `keys`: of the messages to be received, in flash. The listener must live as long as the client.
  Listener(MissionClient& client, const MessageKey* keys, uint8_t count, Take take);

  // The same, on the client of another listener.
  Listener(const Listener& beside, const MessageKey* keys, uint8_t count, Take take);

  // True if the frame is from the client's autopilot.
  bool isFromAutopilot(const FrameParser& frame) const;

  Port& client_;

 private:
  static const MessageKey* keyAmong(const MoreKeys* list, uint16_t messageId);
  static void tellAll(const MoreKeys* list, const FrameParser& frame);

  Take take_;
};

}  // namespace detail
}  // namespace mavmission
