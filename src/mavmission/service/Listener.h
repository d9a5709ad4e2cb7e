// Something that hears frames beside the running operation. A sketch declares what it needs (MissionFollower, Words,
// MessageListener); what it does not declare is not in its program.
#pragma once

#include <stdint.h>

#include "../link/FrameParser.h"

namespace mavmission {

class MissionClient;

namespace detail {

class Client;

class Listener : private MoreKeys {
 public:
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

 protected:
  // Takes a frame of one of the messages, of any sender. Called from update(); may start operations.
  typedef void (*Take)(Listener& listener, const FrameParser& frame);

  // `keys`: of the messages to be heard, in flash. The listener must stay as long as the client.
  Listener(MissionClient& client, const MessageKey* keys, uint8_t count, Take take);

  // True if the frame is the autopilot's that the client talks to.
  bool isFromAutopilot(const FrameParser& frame) const;

  // The next listener behind `one`, or the first if that is null, whose frames are taken by the same function: all of
  // the client's that are of one kind, this one among them. Null behind the last.
  const Listener* nextAlike(const Listener* one) const;

  Client& client_;

 private:
  friend class Link;
  static const MessageKey* keyAmong(const MoreKeys* list, uint16_t messageId);
  static void tellAll(const MoreKeys* list, const FrameParser& frame);

  Take take_;
};

}  // namespace detail
}  // namespace mavmission
