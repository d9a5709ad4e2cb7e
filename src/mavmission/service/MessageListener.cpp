#include "MessageListener.h"

#include <string.h>

namespace mavmission {
using namespace detail;

void ReceivedMessage::copyTo(void* message, uint8_t size) const {
  const uint8_t there = length < size ? length : size;
  memcpy(message, payload, there);
  memset(static_cast<uint8_t*>(message) + there, 0, size - there);
}

void MessageListener::take(Listener& listener, const FrameParser& frame) {
  MessageListener& self = static_cast<MessageListener&>(listener);
  if (self.function_ == nullptr) return;
  self.function_(self.context_, ReceivedMessage{frame.messageId(), frame.systemId(), frame.componentId(),
                                                frame.version(), frame.length(), frame.payload()});
}

}  // namespace mavmission
