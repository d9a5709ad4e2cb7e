#include "RcListener.h"

#include "TelemetryKeys.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TELEMETRY_KEYS(RC_CHANNELS);

}  // namespace

RcListener::RcListener(MissionClient& client, uint16_t intervalMs)
    : TelemetryListener(client, kListened, intervalMs, decode) {}

bool RcListener::decode(TelemetryListener& listener, const FrameParser& frame) {
  RcListener& self = static_cast<RcListener&>(listener);
  mavlink_rc_channels_t message;
  frame.copyPayload(&message, sizeof(message));
  static_assert(offsetof(mavlink_rc_channels_t, chan18_raw) ==
                    offsetof(mavlink_rc_channels_t, chan1_raw) + sizeof(uint16_t) * (kChannels - 1),
                "the channels must lie one after the other");
  memcpy(self.channelsUs_, reinterpret_cast<const uint8_t*>(&message) + offsetof(mavlink_rc_channels_t, chan1_raw),
         sizeof(self.channelsUs_));
  self.count_ = message.chancount < kChannels ? message.chancount : kChannels;
  self.rssi_ = message.rssi;
  return true;
}

uint16_t RcListener::channelUs(uint8_t number) const {
  if (number == 0 || number > count_) return 0;
  const uint16_t us = channelsUs_[number - 1];
  return us == 0xFFFF ? 0 : us;
}

}  // namespace mavmission
