// A listener that sets the intervals of messages (MAV_CMD_SET_MESSAGE_INTERVAL) beside the client's operations.
#pragma once

#include "../transfer/CommandLog.h"
#include "Listener.h"

namespace mavmission {
namespace detail {

// COMMAND_ACK names the command, and not the message whose interval was set. So of all listeners of a client only one
// has such a command under way at a time, and none while the client has a command of its own: its CommandLog knows.
class MessageIntervals : public Listener {
 protected:
  MessageIntervals(MissionClient& client, const MessageKey* keys, uint8_t count, Take take)
      : Listener(client, keys, count, take) {}

  // True if no outstanding answer could be mistaken for the answer to a command that leaves now.
  bool mayAsk(uint16_t nowMs) const;

  // Requests a message at this interval [us]; -1 is never, 0 the autopilot's default. Only when mayAsk() and the link
  // can send. `tries`: the number of earlier attempts.
  void ask(float messageId, float intervalUs, uint8_t tries, uint16_t nowMs);

  // From now on answers may come, to the last command or to its repeats.
  void await(uint16_t nowMs);

  // True for a COMMAND_ACK that answers a command of ask(); once for each frame.
  bool isAnswer(const FrameParser& frame) const;

  // True while an answer may come, or late ones.
  bool isWaiting() const;
  // The only answer to the last command has been heard.
  void settle();
  // To be called with each heartbeat: nobody answers any more after some time, and times have 16 bits.
  void giveUpWaiting(uint16_t nowMs);

  CommandLog::Asked asked_ = CommandLog::Asked();
};

}  // namespace detail
}  // namespace mavmission
