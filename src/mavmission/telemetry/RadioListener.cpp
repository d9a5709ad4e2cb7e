#include "RadioListener.h"

#include <Arduino.h>

#include "../base/Flash.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;
namespace {

const MessageKey kListened[] PROGMEM = {MAVMISSION_LISTENER_KEY(RADIO_STATUS)};

}  // namespace

RadioListener::RadioListener(MissionClient& client) : Listener(client, kListened, 1, take) {}

void RadioListener::take(Listener& listener, const FrameParser& frame) {
  RadioListener& self = static_cast<RadioListener&>(listener);
  static_assert(offsetof(Values, corrected) == offsetof(mavlink_radio_status_t, fixed) &&
                    offsetof(Values, remoteRssi) == offsetof(mavlink_radio_status_t, remrssi) &&
                    offsetof(Values, freeBuffer) == offsetof(mavlink_radio_status_t, txbuf) &&
                    offsetof(Values, remoteNoise) == offsetof(mavlink_radio_status_t, remnoise),
                "the values lie as in the message");
  frame.copyPayload(&self.values_, MAVLINK_MSG_ID_RADIO_STATUS_LEN);
  self.heardMs_ = millis();
  self.isHeard_ = self.isNew_ = true;
}

bool RadioListener::isNew() {
  const bool wasNew = isNew_;
  isNew_ = false;
  return wasNew;
}

uint32_t RadioListener::ageMs() const { return isHeard_ ? millis() - heardMs_ : kNeverHeard; }

}  // namespace mavmission
