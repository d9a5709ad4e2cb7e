#include "Listener.h"

#include "../base/Flash.h"
#include "../client/Port.h"

namespace mavmission {
namespace detail {

Listener::Listener(MissionClient& client, const MessageKey* keys, uint8_t count, Take take)
    : MoreKeys{keys, count, nullptr, keyAmong, tellAll}, client_(Port::of(client)), take_(take) {
  client_.link().add(*this);
}

Listener::Listener(const Listener& beside, const MessageKey* keys, uint8_t count, Take take)
    : MoreKeys{keys, count, nullptr, keyAmong, tellAll}, client_(beside.client_), take_(take) {
  client_.link().add(*this);
}

const MessageKey* Listener::keyAmong(const MoreKeys* list, uint16_t messageId) {
  const MessageKey* key = nullptr;
  for (; list != nullptr; list = list->next) {
    const MessageKey* const found = list->find(messageId);
    if (found == nullptr) continue;
    key = found;
    // A key of the sketch's own does not say where the message has its target. A listener of the library that hears the
    // same message must know for whom it is.
    if (fromFlash(&key->target) != MessageKey::kNoTarget) break;
  }
  return key;
}

void Listener::tellAll(const MoreKeys* list, const FrameParser& frame) {
  for (; list != nullptr; list = list->next) {
    Listener& hearing = *static_cast<Listener*>(const_cast<MoreKeys*>(list));
    if (list->find(frame.messageId()) != nullptr) hearing.take_(hearing, frame);
  }
}

bool Listener::isFromAutopilot(const FrameParser& frame) const {
  return client_.autopilot().isFrom(frame.systemId(), frame.componentId());
}

}  // namespace detail
}  // namespace mavmission
