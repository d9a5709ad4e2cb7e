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

TEST_CASE("an empty datagram looks like none, and what is behind it comes with the next call") {
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
