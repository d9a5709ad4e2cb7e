// The state of the telemetry radio on the line (RADIO_STATUS): signal strength, noise, errors, free buffer.
#pragma once

#include "../service/Listener.h"

namespace mavmission {

// Receives RADIO_STATUS. The radio sends it by itself, a SiK radio once a second with its own system id, as do many
// WiFi and ESP-NOW bridges: so nothing is requested, and any sender counts. An autopilot does not forward the message
// of its own radio. On a signed link the message is received, too, although it has no signature.
class RadioListener : public detail::Listener {
 public:
  // Must live as long as the client: declare it next to the client, not in a function.
  explicit RadioListener(MissionClient& client);

  // The value of ageMs() before the first message.
  static constexpr uint32_t kNeverHeard = 0xFFFFFFFF;
  // This value of a strength or a noise means that it is not known.
  static constexpr uint8_t kUnknown = 255;

  // True when the message has come at least once.
  bool isHeard() const { return isHeard_; }
  // True once after each message.
  bool isNew();
  // The time since the last message [ms], or kNeverHeard.
  uint32_t ageMs() const;

  // Signal strength and noise at the radio that sends the message, and at the other one. The scale is the radio's; on a
  // SiK radio it is some 0.5 dB for each.
  uint8_t rssi() const { return values_.rssi; }
  uint8_t remoteRssi() const { return values_.remoteRssi; }
  uint8_t noise() const { return values_.noise; }
  uint8_t remoteNoise() const { return values_.remoteNoise; }
  // The free part of the radio's transmit buffer [%]; near 0 more is sent than the radio carries.
  uint8_t freeBufferPercent() const { return values_.freeBuffer; }
  // Packets with errors since the radio's start, and those that it could correct. After 65535 they are 0 again.
  uint16_t receiveErrors() const { return values_.receiveErrors; }
  uint16_t corrected() const { return values_.corrected; }

 private:
  static void take(detail::Listener& listener, const detail::FrameParser& frame);

  // As in the message.
  struct Values {
    uint16_t receiveErrors, corrected;
    uint8_t rssi, remoteRssi, freeBuffer, noise, remoteNoise;
  };
  Values values_ = {0, 0, kUnknown, kUnknown, 0, kUnknown, kUnknown};
  bool isHeard_ = false, isNew_ = false;
  uint32_t heardMs_ = 0;
};

}  // namespace mavmission
