#include "Listener.h"

#include "MissionClient.h"

namespace mavmission {

Listener::Listener(MissionClient& client, const MessageKey* keys, uint8_t count, Take take)
    : MoreKeys{keys, count, nullptr}, client_(client), take_(take) {
  client.link_.add(*this);
}

bool Listener::isFromAutopilot(const FrameParser& frame) const {
  return client_.link_.finder().isFrom(frame.systemId(), frame.componentId());
}

}  // namespace mavmission
