// Messages that the sketch itself wants, such as RC channels: to be decoded with any MAVLink library, or by hand.
#pragma once

#include "Listener.h"

namespace mavmission {

// A received message, valid during the call.
struct ReceivedMessage {
  uint16_t id;             // of the message
  uint8_t systemId;        // of the sender
  uint8_t componentId;     // of the sender
  uint8_t version;         // of MAVLink: 1 or 2
  uint8_t length;          // bytes of payload as received: MAVLink 2 omits trailing zeros
  const uint8_t* payload;  // as it lies on the wire

  // Copies the payload to a message struct of `size` bytes; omitted bytes become 0.
  void copyTo(void* message, uint8_t size) const;
};

// Called from update() with each message that has one of the keys. The function may begin an operation if none runs,
// and may call cancel().
typedef void (*MessageFunction)(void* context, const ReceivedMessage& message);

// Receives messages from any sender, and passes each to a function. An array of keys in flash says which messages. They
// may be of any dialect: the id (below 65,536), the CRC_EXTRA and the MAVLink 1 length are in the message's definition.
//
//   const MessageKey keys[] PROGMEM = {messageKey(24, 24, 30)};  // GPS_RAW_INT
//   MessageListener gps(autopilot, keys, onGps);
//
// Messages with a payload of more than MAVMISSION_MAX_PAYLOAD bytes are ignored.
class MessageListener : public detail::Listener {
 public:
  // The keys must be in flash. The listener must live as long as the client: declare it next to the client, not in a
  // function.
  template <uint8_t N>
  MessageListener(MissionClient& client, const MessageKey (&keys)[N], MessageFunction function, void* context = nullptr)
      : Listener(client, keys, N, take), function_(function), context_(context) {}

 private:
  static void take(detail::Listener& listener, const detail::FrameParser& frame);

  MessageFunction function_;
  void* context_;
};

// The key of a message to be received: its id, its CRC_EXTRA, and the length of its payload in MAVLink 1 [bytes].
constexpr MessageKey messageKey(uint16_t id, uint8_t crcExtra, uint8_t lengthV1) {
  return MessageKey{id, crcExtra, lengthV1, lengthV1, MessageKey::kNoTarget};
}

}  // namespace mavmission
