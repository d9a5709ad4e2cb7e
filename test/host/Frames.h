// Frames made byte by byte, and what a parser finds in bytes.
#pragma once

#include <string.h>

#include <string>
#include <type_traits>
#include <vector>

#include "mavmission/link/FrameParser.h"

typedef std::vector<uint8_t> Bytes;

// The payload that a message of MAVLink's headers is.
template <typename Message>
Bytes bytesOf(const Message& message) {
  static_assert(std::is_pod<Message>::value, "a message, whose bytes are the payload");
  const uint8_t* first = reinterpret_cast<const uint8_t*>(&message);
  return Bytes(first, first + sizeof(message));
}

// The message that a payload is; what MAVLink 2 left out of it is 0.
template <typename Message>
Message messageIn(const Bytes& payload) {
  static_assert(std::is_pod<Message>::value, "a message, whose bytes are the payload");
  Message message = Message();
  memcpy(&message, payload.data(), payload.size() < sizeof(message) ? payload.size() : sizeof(message));
  return message;
}

// CRC_EXTRA of a message of MAVLink's headers; 0 where they do not have it.
uint8_t crcExtraOf(uint32_t messageId);

// What a frame is made of. The defaults are those of an autopilot's MAVLink 2 frame.
struct FrameParts {
  uint32_t messageId;
  Bytes payload;
  uint8_t crcExtra;
  uint8_t version = 2;
  uint8_t sequence = 0;
  uint8_t systemId = 1;
  uint8_t componentId = 1;
  uint8_t incompatibility = 0;
  uint8_t compatibility = 0;

  FrameParts(uint32_t id, const Bytes& bytes, uint8_t extra) : messageId(id), payload(bytes), crcExtra(extra) {}
  template <typename Message>
  FrameParts(uint32_t id, const Message& message, uint8_t extra) : FrameParts(id, bytesOf(message), extra) {}
  FrameParts(uint32_t id, const Bytes& bytes) : FrameParts(id, bytes, crcExtraOf(id)) {}
  template <typename Message>
  FrameParts(uint32_t id, const Message& message) : FrameParts(id, bytesOf(message)) {}
};

// Its bytes, with as many bytes of signature as the flag asks for; the payload goes out as it is.
Bytes packed(const FrameParts& parts);

// The frames that the tests use most.
FrameParts heartbeatParts(uint8_t autopilot = 12, uint8_t baseMode = 0, uint32_t mode = 0, uint8_t type = 2,
                          uint8_t state = 3);
FrameParts requestParts(uint16_t item, uint8_t targetSystem = 1, uint8_t targetComponent = 191, uint8_t type = 0);
FrameParts ackParts(uint8_t result, uint8_t targetSystem = 1, uint8_t targetComponent = 191, uint8_t type = 0,
                    uint32_t opaqueId = 0);
Bytes heartbeat(uint8_t sequence = 0);
Bytes request(uint16_t item, uint8_t sequence = 0);
Bytes ack(uint8_t result, uint8_t sequence = 0);
// A frame of a message that nobody wants, 30 (ATTITUDE), with a payload of `length` times `fill`.
Bytes telemetry(uint8_t length = 28, uint8_t fill = 0x11, uint8_t version = 2);

Bytes operator+(const Bytes& left, const Bytes& right);

// A frame that lies in bytes.
struct FrameIn {
  size_t size = 0;                               // 0: none begins there, or not all of it is there
  FrameParts parts = FrameParts(0, Bytes(), 0);  // the payload filled up with zeros, to 255 bytes
  bool isRight = false;                          // the message is known, and the checksum right
  Bytes bytes;                                   // all of it; of a FrameCutter alone
  size_t end = 0;                                // where it ends in what the FrameCutter took; behind all of it at most
};
FrameIn frameAt(const Bytes& bytes, size_t at = 0);

// Cuts what a client writes into frames, one behind the other. Zeros may fill the space between them.
class FrameCutter {
 public:
  // Those that these bytes complete.
  std::vector<FrameIn> take(const Bytes& bytes);

 private:
  Bytes unread_;
};

// A frame as the parser gave it.
struct Found {
  mavmission::detail::FrameParser::Result result;
  uint16_t messageId;
  uint8_t version, sequence, systemId, componentId;
  Bytes payload;
};

// A parser that begins as in a MissionClient: all zero.
class ParserUnderTest {
 public:
  ParserUnderTest();

  // Takes bytes, and those that wait after each; the frames that were found.
  std::vector<Found> take(const Bytes& bytes);
  // Silence on the line.
  std::vector<Found> silence();

  const mavmission::detail::FrameParser& parser() const { return parser_; }

 private:
  void note(mavmission::detail::FrameParser::Result result, std::vector<Found>& found);
  mavmission::detail::FrameParser parser_;
};

// The wanted ones.
std::vector<Found> wanted(const std::vector<Found>& found);
// "request 3, ack 0" and the like for the wanted ones, "other" for any other.
std::string textOf(const std::vector<Found>& found);
// The wanted frames that a fresh parser finds, and after them in silence.
std::string wantedIn(const Bytes& bytes);
