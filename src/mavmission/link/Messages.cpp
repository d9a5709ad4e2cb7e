#include "Messages.h"

#include "../base/Flash.h"

namespace mavmission {
namespace detail {

const MessageKey kKeys[] PROGMEM = {
#define MAVMISSION_KEY(NAME, type, target) MAVMISSION_MESSAGE_KEY(NAME, target),
    MAVMISSION_RECEIVED_MESSAGES(MAVMISSION_KEY) MAVMISSION_SENT_MESSAGES(MAVMISSION_KEY)
#undef MAVMISSION_KEY
};

// A switch becomes a tree of comparisons, which is quicker than a walk through the table.
const MessageKey* wantedKey(uint16_t messageId) {
  KeyIndex index;
  switch (messageId) {
#define MAVMISSION_CASE(NAME, type, target) \
  case MAVLINK_MSG_ID_##NAME: index = KeyIndex::NAME; break;
    MAVMISSION_RECEIVED_MESSAGES(MAVMISSION_CASE)
#undef MAVMISSION_CASE
    default: return nullptr;
  }
  return &kKeys[static_cast<uint8_t>(index)];
}

}  // namespace detail
}  // namespace mavmission
