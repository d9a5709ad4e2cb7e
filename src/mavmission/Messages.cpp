#include "Messages.h"

#include "Flash.h"

namespace mavmission {

const MessageKey kKeys[] PROGMEM = {
#define MAVMISSION_KEY(NAME, type, target) \
  {MAVLINK_MSG_ID_##NAME, MAVLINK_MSG_ID_##NAME##_CRC, MAVLINK_MSG_ID_##NAME##_MIN_LEN, MAVLINK_MSG_ID_##NAME##_LEN, target},
    MAVMISSION_RECEIVED_MESSAGES(MAVMISSION_KEY) MAVMISSION_SENT_MESSAGES(MAVMISSION_KEY)
#undef MAVMISSION_KEY
};

const MessageKey* wantedKey(uint16_t messageId) {
  for (uint8_t i = 0; i < static_cast<uint8_t>(KeyIndex::kReceived); ++i) {
    if (fromFlash(&kKeys[i].id) == messageId) return &kKeys[i];
  }
  return nullptr;
}

}  // namespace mavmission
