// The pilot's remote control, as the receiver gets it (RC_CHANNELS).
#pragma once

#include "TelemetryListener.h"

namespace mavmission {

// Used like a PositionListener.
class RcListener : public TelemetryListener {
 public:
  // Must live as long as the client. `intervalMs`: from one message to the next; 0: the message is not requested.
  explicit RcListener(MissionClient& client, uint16_t intervalMs = 1000);

  // The number of channels of the receiver; 0 if there is no receiver.
  uint8_t count() const { return count_; }
  // The pulse length of channel 1 to 18 [us], usually from 1000 to 2000; 0: not known, or there is no such channel.
  uint16_t channelUs(uint8_t number) const;
  // The strength of the signal, 0 to 254, in the receiver's own scale.
  bool hasRssi() const { return rssi_ != 255; }
  uint8_t rssi() const { return rssi_; }  // 255: not known

 private:
  static constexpr uint8_t kChannels = 18;
  static bool decode(TelemetryListener& listener, const detail::FrameParser& frame);

  uint16_t channelsUs_[kChannels];
  uint8_t count_ = 0;
  uint8_t rssi_ = 255;
};

}  // namespace mavmission
