// A message on the line between an autopilot and the sketch, and the frame that carries it.
#pragma once

#include <stdint.h>
#include <string.h>

#include <vector>

#include "Frames.h"
#include "mavmission/base/MavlinkHeaders.h"

struct Message {
  uint32_t id;
  Bytes payload;  // with its trailing zeros
};

template <typename T>
Message messageOf(uint32_t id, const T& payload) {
  const uint8_t* begin = reinterpret_cast<const uint8_t*>(&payload);
  return Message{id, Bytes(begin, begin + sizeof(payload))};
}

template <typename T>
T read(const Message& message) {
  T payload = T();
  memcpy(&payload, message.payload.data(), message.payload.size() < sizeof(T) ? message.payload.size() : sizeof(T));
  return payload;
}

// Returns the frame in which this sender sends the message.
Bytes frameOf(const Message& message, uint8_t sequence, uint8_t systemId = 1, uint8_t componentId = 1);

// Returns the system to which a message is addressed; 0: to none.
uint8_t targetOf(const Message& message);

// Finds the frames in what the client writes. It begins each at the start of a frame: nothing is lost before the line.
class Unpacker {
 public:
  struct Found {
    Message message;
    bool isRight;  // whether its checksum is right
    size_t length;
    size_t end;  // how many bytes of this call there are up to its last one
  };
  std::vector<Found> take(const Bytes& bytes);

 private:
  Bytes unread_;
};
