#include <MavMissionUdp.h>
#include <doctest/doctest.h>

#include <memory>

#include "Frames.h"
#include "LoopUdp.h"

using namespace mavmission;

namespace {

const IPAddress kOne(10, 0, 0, 2), kTwo(10, 0, 0, 3);
constexpr uint16_t kPort = 14555;

// A line whose peer is kOne, named.
struct Desk {
  std::unique_ptr<LoopUdp> udp{new LoopUdp};
  UdpLink line{*udp};
  Desk() {
    setMillis(5000);
    line.setPeer(kOne, kPort);
  }
  void bring(const IPAddress& address, const Bytes& bytes) { udp->bring(address, kPort, bytes.data(), bytes.size()); }
  Bytes readAll() {
    Bytes read;
    for (int byte; (byte = line.read()) >= 0;) read.push_back(static_cast<uint8_t>(byte));
    return read;
  }
  size_t send(const Bytes& bytes) { return line.write(bytes.data(), bytes.size()); }
};

}  // namespace

TEST_CASE("datagrams of the peer are read as one line, and those of others are not there") {
  Desk desk;
  desk.bring(kOne, request(1));
  desk.bring(kTwo, request(2));
  desk.bring(kOne, request(3) + request(4));
  CHECK(desk.line.available() == static_cast<int>(request(1).size()));
  CHECK(desk.line.peek() == 0xFD);
  CHECK(desk.readAll() == request(1) + request(3) + request(4));
  CHECK(desk.line.available() == 0);
  CHECK(desk.line.peek() == -1);
  CHECK(desk.line.strangers() == 1);
}

TEST_CASE("an empty datagram looks like none, and what is after it comes with the next call") {
  Desk desk;
  desk.bring(kOne, Bytes());
  desk.bring(kOne, request(1));
  CHECK(desk.line.read() == -1);
  CHECK(desk.readAll() == request(1));
}

TEST_CASE("one call leaves out four datagrams of others at most") {
  Desk desk;
  for (int i = 0; i < 10; ++i) desk.bring(kTwo, request(1));
  desk.bring(kOne, request(3));
  CHECK(desk.line.read() == -1);
  CHECK(desk.udp->waiting() == 7);
  CHECK(desk.line.available() == 0);
  CHECK(desk.udp->waiting() == 3);
  CHECK(desk.line.available() == static_cast<int>(request(3).size()));
  CHECK(desk.line.strangers() == 10);
}

TEST_CASE("a peer that is forgotten in the middle of its datagram is heard no further, and the next one is") {
  Desk desk;
  desk.bring(kOne, request(1) + request(2));
  CHECK(desk.line.read() == 0xFD);
  desk.line.setPeer(kTwo, kPort);
  desk.bring(kTwo, request(3));
  CHECK(desk.readAll() == request(3));
}

TEST_CASE("what is written goes to the peer while a datagram is being read, and to nobody without a peer") {
  Desk desk;
  desk.bring(kOne, request(1) + request(2));
  CHECK(desk.line.read() == 0xFD);
  desk.bring(kTwo, request(9));
  CHECK(desk.send(heartbeat()) == heartbeat().size());
  REQUIRE(desk.udp->sentCount == 1);
  CHECK(desk.udp->sent[0].address == kOne);
  CHECK(desk.udp->sent[0].port == kPort);
  CHECK(Bytes(desk.udp->sent[0].bytes, desk.udp->sent[0].bytes + desk.udp->sent[0].size) == heartbeat());
  CHECK(desk.readAll().size() == request(1).size() + request(2).size() - 1);
  desk.line.forgetPeer();
  CHECK(desk.line.availableForWrite() == MAVMISSION_UDP_BYTES);
  CHECK(desk.send(heartbeat()) == heartbeat().size());
  CHECK(desk.udp->sentCount == 1);
  CHECK(desk.line.unsent() == 1);
}

TEST_CASE("a datagram that cannot be sent is lost, and the line goes on") {
  Desk desk;
  desk.udp->refuses = true;
  CHECK(desk.send(request(1)) == request(1).size());
  desk.udp->refuses = false;
  CHECK(desk.send(request(2)) == request(2).size());
  CHECK(desk.udp->sentCount == 1);
  CHECK(desk.line.unsent() == 1);
  CHECK(desk.line.packetsSent() == 1);
}

namespace {

// A transparent bridge, which cuts a serial line into datagrams of `chunk` bytes.
struct Bridge {
  IPAddress address;
  size_t chunk;
  Bytes waiting;  // at first: what has come before it heard of us
  uint16_t port = kPort;
  size_t until = 0;  // datagrams, until there is a peer

  Bridge(const IPAddress& at, size_t bytes, const Bytes& before) : address(at), chunk(bytes), waiting(before) {}
  void bring(Desk& desk, const Bytes& bytes) {
    for (waiting = waiting + bytes; waiting.size() >= chunk; waiting.erase(waiting.begin(), waiting.begin() + chunk)) {
      if (!desk.line.hasPeer()) ++until;
      desk.udp->bring(address, port, waiting.data(), chunk);
      desk.readAll();
    }
  }
};

Bytes heartbeatOf(uint8_t version, uint8_t autopilot, uint8_t sequence) {
  FrameParts parts = heartbeatParts(autopilot);
  parts.version = version;
  parts.sequence = sequence;
  return packed(parts);
}

// Twenty seconds of an autopilot behind a bridge, with other frames; there may be a ground station behind another one.
void live(Desk& desk, Bridge& bridge, uint8_t version, uint8_t others, bool hasStranger) {
  Bridge stranger(kTwo, bridge.chunk, bridge.waiting + Bytes{1, 2, 3});
  for (uint8_t s = 0; s < 20; ++s, setMillis(millis() + 1000)) {
    bridge.bring(desk, heartbeatOf(version, 12, s));
    if (hasStranger) stranger.bring(desk, heartbeatOf(version, 8, s));
    for (uint8_t i = 0; i < others; ++i) bridge.bring(desk, request(i));
  }
}

}  // namespace

TEST_CASE("a bridge that cuts frames anywhere is found by the datagram in which its first heartbeat ends") {
  const Bytes before = telemetry(60, 0xFD);
  for (const size_t chunk : {1, 2, 7, 16, 21, 32, 64, 128, 200})
    for (const uint8_t version : {1, 2})
      for (const uint8_t others : {0, 20})
        for (const bool hasStranger : {false, true})
          for (size_t begun = 0; begun < before.size(); begun += 5) {
            CAPTURE(chunk);
            CAPTURE(version);
            CAPTURE(others);
            CAPTURE(hasStranger);
            CAPTURE(begun);
            Desk desk;
            desk.line.forgetPeer();
            Bridge bridge(kOne, chunk, Bytes(before.begin() + begun, before.end()));
            const size_t end = bridge.waiting.size() + heartbeatOf(version, 12, 0).size();
            live(desk, bridge, version, others, hasStranger);
            CHECK(bridge.until == (end + chunk - 1) / chunk);
            CHECK(desk.line.peerAddress() == kOne);
          }
}

TEST_CASE("a bridge that cuts frames and comes back with another port is found again after 5 s of silence") {
  for (const size_t chunk : {1, 7, 16, 64}) {
    Desk desk;
    desk.line.forgetPeer();
    Bridge bridge(kOne, chunk, Bytes());
    live(desk, bridge, 2, 3, true);
    REQUIRE(desk.line.peerPort() == kPort);
    setMillis(millis() + 4000);
    desk.readAll();
    bridge.port = 40000;
    live(desk, bridge, 2, 3, true);
    CHECK(desk.line.peerPort() == 40000);
  }
}

TEST_CASE("of two that begin within 1.2 s none is the peer until one is named, which does not change") {
  Desk desk;
  desk.line.forgetPeer();
  for (const IPAddress& address : {kOne, kTwo, kOne}) {
    desk.bring(address, heartbeatOf(2, 12, 0));
    desk.readAll();
    CHECK(desk.line.hasPeer() == (address == kOne && !desk.line.severalHeard()));
    setMillis(millis() + 900);
  }
  CHECK(desk.line.severalHeard());
  desk.send(heartbeat());
  CHECK(desk.udp->sentCount == 0);
  desk.line.setPeer(kTwo, kPort);
  desk.bring(kOne, request(1));
  desk.bring(kTwo, request(2));
  CHECK(desk.readAll() == request(2));
  setMillis(millis() + 6000);
  const Bytes beat = heartbeatOf(2, 12, 1);
  desk.udp->bring(kTwo, 40000, beat.data(), beat.size());
  CHECK(desk.readAll().empty());
  CHECK(desk.line.peerPort() == kPort);
}

TEST_CASE("another host never takes the place of a peer that is silent, until that is forgotten") {
  Desk desk;
  desk.line.forgetPeer();
  const Bytes beat = heartbeatOf(2, 12, 0);
  desk.bring(kOne, beat);
  desk.readAll();
  for (uint8_t s = 0; s < 30; ++s) {
    setMillis(millis() + 2000);
    desk.udp->bring(kTwo, 40000, beat.data(), beat.size());
    desk.readAll();
    CHECK(desk.line.peerAddress() == kOne);
    CHECK(desk.line.peerPort() == kPort);
  }
  desk.line.forgetPeer();
  desk.udp->bring(kTwo, 40000, beat.data(), beat.size());
  desk.readAll();
  CHECK(desk.line.peerAddress() == kTwo);
  CHECK(desk.line.peerPort() == 40000);
}
