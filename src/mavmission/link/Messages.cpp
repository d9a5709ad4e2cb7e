#include "Messages.h"

#include "../base/Flash.h"

namespace mavmission {
namespace detail {

namespace {

constexpr MessageKey kFreePlace = {0xFFFF, 0, 0, 0, MessageKey::kNoTarget};

// The key at this place. (C++11 has no array whose elements can be named in the initialiser.)
constexpr MessageKey keyAt(uint8_t place) {
#define MAVMISSION_KEY(NAME, type, target) \
  place == static_cast<uint8_t>(KeyIndex::NAME) ? MessageKey MAVMISSION_MESSAGE_KEY(NAME, target):
  return MAVMISSION_RECEIVED_MESSAGES(MAVMISSION_KEY) MAVMISSION_SENT_MESSAGES(MAVMISSION_KEY) kFreePlace;
#undef MAVMISSION_KEY
}

// A key that is at its own place is found by wantedKey().
#define MAVMISSION_RECEIVED(NAME, type, target)                                        \
  static_assert(keyAt(MAVLINK_MSG_ID_##NAME % kKeyPlaces).id == MAVLINK_MSG_ID_##NAME, \
                #NAME " must be the only received message with its place");
#define MAVMISSION_SENT(NAME, type, target)                                                   \
  static_assert(static_cast<uint8_t>(KeyIndex::NAME) != MAVLINK_MSG_ID_##NAME % kKeyPlaces && \
                    keyAt(static_cast<uint8_t>(KeyIndex::NAME)).id == MAVLINK_MSG_ID_##NAME,  \
                #NAME " must have a place alone, and not its own");
MAVMISSION_RECEIVED_MESSAGES(MAVMISSION_RECEIVED)
MAVMISSION_SENT_MESSAGES(MAVMISSION_SENT)
#undef MAVMISSION_RECEIVED
#undef MAVMISSION_SENT

}  // namespace

const MessageKey kKeys[kKeyPlaces] PROGMEM = {
    keyAt(0), keyAt(1), keyAt(2),  keyAt(3),  keyAt(4),  keyAt(5),  keyAt(6),  keyAt(7),
    keyAt(8), keyAt(9), keyAt(10), keyAt(11), keyAt(12), keyAt(13), keyAt(14), keyAt(15),
};

const MessageKey* wantedKey(uint16_t messageId) {
  const MessageKey* const key = &kKeys[messageId % kKeyPlaces];
  return fromFlash(&key->id) == messageId ? key : nullptr;
}

}  // namespace detail
}  // namespace mavmission
