// Frames of any message for the sketch itself: GPS, attitude, RC channels... to be decoded with any MAVLink library, or
// by hand.
#pragma once

#include "service/Listener.h"

namespace mavmission {

// A received message, valid during the call.
struct ReceivedMessage {
  uint16_t id;             // of the message
  uint8_t systemId;        // of the sender
  uint8_t componentId;     // of the sender
  uint8_t version;         // of MAVLink: 1 or 2
  uint8_t length;          // bytes of payload as they came: MAVLink 2 leaves trailing zeros out
  const uint8_t* payload;  // as it lies on the wire

  // Copies the payload to a message struct of `size` bytes; what was left out becomes 0.
  void copyTo(void* message, uint8_t size) const;
};

// Called from update() with each message that was asked for; may start operations.
typedef void (*MessageFunction)(void* context, const ReceivedMessage& message);

// Hears the messages of an array of keys in flash, from any sender, and hands each to a function. The keys are any
// dialect's: an id below 65,536, the CRC_EXTRA and the MAVLink 1 length are in its definition.
//
//   const MessageKey keys[] PROGMEM = {messageKey(24, 24, 30)};  // GPS_RAW_INT
//   MessageListener gps(autopilot, keys, onGps);
//
// Messages with a payload of more than MAVMISSION_MAX_PAYLOAD bytes are stepped over.
class MessageListener : public detail::Listener {
 public:
  // The keys must lie in flash and stay as long as the listener; so must the client.
  template <uint8_t N>
  MessageListener(MissionClient& client, const MessageKey (&keys)[N], MessageFunction function, void* context = nullptr)
      : Listener(client, keys, N, take), function_(function), context_(context) {}

 private:
  static void take(detail::Listener& listener, const detail::FrameParser& frame);

  MessageFunction function_;
  void* context_;
};

// A key of a message that is received: its id, CRC_EXTRA, and the length of its payload in MAVLink 1 [bytes].
constexpr MessageKey messageKey(uint16_t id, uint8_t crcExtra, uint8_t lengthV1) {
  return MessageKey{id, crcExtra, lengthV1, lengthV1, MessageKey::kNoTarget};
}

}  // namespace mavmission
