// A listener that sets the intervals of messages (MAV_CMD_SET_MESSAGE_INTERVAL) beside what its client does.
#pragma once

#include "Listener.h"

namespace mavmission {
namespace detail {

// COMMAND_ACK names the command, and not the message whose interval it is about. So of all listeners of a client one
// has such a command under way at a time, and none beside a command of the client's own.
class MessageIntervals : public Listener {
 protected:
  MessageIntervals(MissionClient& client, const MessageKey* keys, uint8_t count, Take take)
      : Listener(client, keys, count, hear), hear_(take) {}

  // True if no answer that is still to come could be taken for the answer to a command that leaves now.
  bool mayAsk(uint16_t nowMs) const;

  // Asks for a message at this interval [us]; -1 is never, 0 the autopilot's default. Only when mayAsk() and the link
  // can send. `tries`: how often that has been asked before.
  void ask(float messageId, float intervalUs, uint8_t tries, uint16_t nowMs);

  // True for a COMMAND_ACK that answers such a command.
  bool isAnswer(const FrameParser& frame) const;

  // The only answer to the last command has been heard.
  void settle();

  uint16_t askedMs_ = 0;    // when the last command left, or was answered while others may still be
  bool isWaiting_ = false;  // for an answer, or for late ones

 private:
  static void hear(Listener& listener, const FrameParser& frame);

  Take hear_;
};

}  // namespace detail
}  // namespace mavmission
