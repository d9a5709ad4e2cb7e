// Link::send() for the messages of Messages.h. Not in Link.h, which a sketch includes and which must name no MAVLink
// type.
#pragma once

#include "Link.h"
#include "Messages.h"

namespace mavmission {
namespace detail {

template <typename T>
void Link::send(T& message) {
  sendAs<T>(&message);
}

template <typename T>
void Link::prepareAs(void* payload) {
  static_assert(sizeof(T) <= Outbox::kMaxPayload, "raise Outbox::kMaxPayload to the length of this message");
  pack(static_cast<uint8_t*>(payload), &kKeys[static_cast<uint8_t>(MessageOf<T>::kKey)]);
}

template <typename T>
void Link::sendAs(void* payload) {
  static_assert(sizeof(T) <= Outbox::kMaxPayload, "raise Outbox::kMaxPayload to the length of this message");
  sendMessage(static_cast<uint8_t*>(payload), &kKeys[static_cast<uint8_t>(MessageOf<T>::kKey)]);
}

}  // namespace detail
}  // namespace mavmission
