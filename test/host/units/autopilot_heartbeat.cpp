#include "mavmission/link/AutopilotHeartbeat.h"

#include <doctest/doctest.h>

#include "Frames.h"
#include "MemoryStream.h"

using namespace mavmission::detail;

namespace {

struct Read {
  bool isFound;
  size_t rest;  // bytes of the datagram that have not been read
};

Read readFrom(const Bytes& bytes) {
  MemoryStream datagram;
  datagram.bring(bytes);
  const bool isFound = HeartbeatSearch().readsAutopilot(datagram);
  return Read{isFound, datagram.toRead.size()};
}

Bytes ofVersion1(FrameParts parts) {
  parts.version = 1;
  return packed(parts);
}

Bytes signedFrame(FrameParts parts) {
  parts.incompatibility = 1;
  return packed(parts);
}

}  // namespace

TEST_CASE("an autopilot's heartbeat is found after whatever frames, and what is after it is left") {
  const Bytes before[] = {
      Bytes(),
      telemetry(),
      telemetry(28, 0x11, 1),
      telemetry(9),  // as long as a heartbeat
      signedFrame(requestParts(3)),
      request(1) + ofVersion1(requestParts(2)),
      Bytes{'n', 'o', ' ', 'f', 'r', 'a', 'm', 'e'},
      Bytes{0xFD, 9, 0, 0},  // the beginning of a heartbeat whose rest was lost
      Bytes{0xFE, 9, 7, 1, 1, 0, 0xFD},
  };
  for (const Bytes& frames : before) {
    FrameParts inMode = heartbeatParts();
    inMode.payload[0] = inMode.payload[3] = 7;  // of its custom mode
    for (const Bytes& found : {heartbeat(), packed(inMode), ofVersion1(inMode)}) {
      const Read read = readFrom(frames + found + request(4));
      CHECK(read.isFound);
      CHECK(read.rest == request(4).size());
    }
  }
  CHECK(readFrom(signedFrame(heartbeatParts())).isFound);
}

TEST_CASE("what is no autopilot's heartbeat is read to the end of the datagram") {
  Bytes damaged = heartbeat(), other = heartbeat();
  damaged.back() ^= 1;
  other[other.size() - 2] ^= 1;
  // Like a heartbeat, but for one byte of the message's number.
  for (const uint32_t id : {1u, 1u << 8, 1u << 16}) {
    FrameParts parts = heartbeatParts();
    parts.messageId = id;
    CHECK(!readFrom(packed(parts)).isFound);
    if (id == 1) CHECK(!readFrom(ofVersion1(parts)).isFound);
  }
  FrameParts gimbal = heartbeatParts(3);
  gimbal.payload[4] = 26;  // MAV_TYPE_GIMBAL, with its autopilot's name
  const Bytes notes[] = {
      Bytes(),
      damaged,
      packed(gimbal),
      other,
      signedFrame(heartbeatParts(8)),
      packed(heartbeatParts(8)),  // a ground station's
      ofVersion1(heartbeatParts(8)),
      telemetry() + request(1),
  };
  for (const Bytes& bytes : notes) {
    const Read read = readFrom(bytes);
    CHECK(!read.isFound);
    CHECK(read.rest == 0);
  }
}

TEST_CASE("a heartbeat after one that does not count is found") {
  for (const Bytes& first : {packed(heartbeatParts(8)), signedFrame(heartbeatParts(8)), ofVersion1(heartbeatParts(8))})
    CHECK(readFrom(first + heartbeat()).isFound);
}

TEST_CASE("a heartbeat that is cut in two datagrams at any byte is found by its last byte") {
  for (const Bytes& whole : {heartbeat(), ofVersion1(heartbeatParts())}) {
    for (const Bytes& before : {Bytes(), telemetry(), signedFrame(requestParts(3)), Bytes{0xFD, 0xFE, 9}}) {
      const Bytes bytes = before + whole;
      for (size_t length = 0; length < bytes.size(); ++length) {
        HeartbeatSearch search;
        MemoryStream datagram;
        datagram.bring(Bytes(bytes.begin(), bytes.begin() + length));
        CHECK(!search.readsAutopilot(datagram));
        CHECK(datagram.toRead.empty());
        CHECK((search.isBegun() || length <= before.size()));
        datagram.bring(Bytes(bytes.begin() + length, bytes.end()) + request(4));
        CHECK(search.readsAutopilot(datagram));
        CHECK(!search.isBegun());
        CHECK(datagram.toRead.size() == request(4).size());
      }
    }
  }
}
