// UdpLink: a line to the autopilot over UDP. Include it after the header of the UDP class. Not part of MavMission.h:
// few sketches have one, and not every core has UDP.
#pragma once

#include <Arduino.h>
#include <Udp.h>
#include <stdint.h>

#include "mavmission/base/Clock.h"
#include "mavmission/base/RetryRules.h"
#include "mavmission/link/AutopilotHeartbeat.h"
#include "mavmission/link/PacketLink.h"

// The longest frame that can be sent, 63 to 280 [bytes]. A sketch that is short of RAM, and sends neither plans as
// files nor messages of its own, defines it as 63 before it includes this: what a client sends, signed or not.
#ifndef MAVMISSION_UDP_BYTES
#define MAVMISSION_UDP_BYTES 280
#endif

#if MAVMISSION_UDP_BYTES < 63
#error "MAVMISSION_UDP_BYTES must be 63 to 280: the longest frame of a client has 63 bytes"
#endif

namespace mavmission {

// A line to the autopilot over UDP, which MissionClient uses like a serial port. It works with any class that
// implements Arduino's UDP: WiFiUDP of an ESP32 or an ESP8266, EthernetUDP.
//
//   WiFiUDP udp; UdpLink line(udp);             // udp.begin(14550) in setup(), after the network has begun
//   MissionClient autopilot(line);
//
// There is one peer. Either it is found: it is the sender of the first heartbeat of an autopilot with a right checksum.
// Or the sketch names it by setPeer(). From then on datagrams of all other senders are ignored.
// - A transparent bridge cuts the serial line into datagrams anywhere. It is found with the datagram in which its first
//   heartbeat ends, unless a piece of that was lost: then with the next one. This takes longer than 10 s only if the
//   bridge itself collects for so long: it may wait for 256 bytes, of which a heartbeat a second fills 21. Pieces of
//   two senders are kept at a time; with more that cut their heartbeats just then, one may be found a heartbeat later.
// - A second sender of an autopilot's heartbeat within 1.2 s of the first counts as a second aircraft: then there is no
//   peer, severalHeard() is true, and the sketch has to name one.
// - A peer that was found, and has been silent for 5 s, may have restarted with another port: with the next heartbeat
//   of an autopilot from its address, the new port is used. Another address never replaces it, since the client might
//   then continue with another aircraft; a sketch that wants this calls forgetPeer(). A peer that was named does not
//   change.
//
// Each frame is sent at once, in its own datagram (see PacketLink). While there is no peer, frames are lost, as on a
// wire with nothing at its end. A lost datagram is like a lost frame on a wire.
//
// This class does not wait, but a UDP class may: if the peer has gone, an Ethernet shield's endPacket() waits for an
// ARP answer, 1.6 s unless Ethernet.setRetransmissionTimeout() and setRetransmissionCount() say less. This class uses
// no heap; WiFiUDP uses 1,460 bytes of heap for sending, and as many for a received datagram until it is read.
//
// RAM: MAVMISSION_UDP_BYTES, and some 110 [bytes]. The UDP object belongs to the sketch, must outlive this, and
// must not be used by anything else. Source: MAVLink guide, Packet Serialization; ports in docs/radio.md.
class UdpLink : public PacketLink {
 public:
  // `udp` need not have begun yet.
  explicit UdpLink(UDP& udp) : PacketLink(buffer_, sizeof(buffer_)), udp_(udp) {}

  // Names the peer: datagrams are sent only there, and accepted only from there.
  void setPeer(const IPAddress& address, uint16_t port) {
    forgetPeer();
    address_ = address;
    port_ = port;
    isNamed_ = true;
  }

  // Forgets the peer, named or found: the next one that is found becomes the peer. The rest of its last datagram is
  // dropped.
  void forgetPeer() {
    if (isPeers_) leaveOut();
    port_ = 0;
    isNamed_ = isSettled_ = isSilent_ = severalHeard_ = false;
  }

  // Whether there is a peer; its address, and its port, 1 to 65535, or 0 without one.
  bool hasPeer() const { return port_ != 0; }
  const IPAddress& peerAddress() const { return address_; }
  uint16_t peerPort() const { return port_; }

  // True if two senders have brought heartbeats of autopilots: there is no peer until setPeer() or forgetPeer().
  bool severalHeard() const { return severalHeard_; }

  // The number of ignored datagrams of others. After 65535 it is 0 again.
  uint16_t strangers() const { return strangers_; }

  // The bytes of the peer's datagrams, one after the other, as from a serial port.
  int available() override { return next() ? udp_.available() : 0; }
  int read() override { return next() ? udp_.read() : -1; }
  int peek() override { return next() ? udp_.peek() : -1; }

 private:
  // Datagrams of others that are left out in one call, at most: they take time too.
  static constexpr uint8_t kAtOnce = 4;

  // True if a byte of the peer's can be read: of the datagram that is being read, or else of the next one.
  bool next() {
    if (isPeers_ && udp_.available() > 0) return true;
    isPeers_ = false;
    const uint16_t nowMs = static_cast<uint16_t>(millis());
    if (hasPeer()) {
      const uint16_t quietMs = detail::since(heardMs_, nowMs);
      if (quietMs >= detail::FinderRules::kLostMs) isSilent_ = true;
      if (detail::since(foundMs_, nowMs) >= detail::FinderRules::kSettleMs) isSettled_ = true;
    }
    for (uint8_t left = kAtOnce; left != 0; --left) {
      if (udp_.parsePacket() <= 0) return false;
      isPeers_ = isFromPeer(nowMs);
      if (isPeers_) {
        heardMs_ = nowMs;
        isSilent_ = false;
        if (udp_.available() > 0) return true;
      } else {
        ++strangers_;
      }
      leaveOut();
    }
    return false;
  }

  // Whether the datagram that has come is the peer's; its first heartbeat makes its sender the peer.
  bool isFromPeer(uint16_t nowMs) {
    const uint16_t port = udp_.remotePort();
    if (severalHeard_ || port == 0) return false;
    if (!hasPeer()) {
      if (!bringsHeartbeat()) return false;
      address_ = udp_.remoteIP();
      port_ = port;
      foundMs_ = nowMs;
      return true;
    }
    const bool isItsAddress = udp_.remoteIP() == address_;
    if (isItsAddress && port == port_) return true;
    if (isNamed_) return false;
    if (!isSettled_) {
      if (!bringsHeartbeat()) return false;
      severalHeard_ = true;
      port_ = 0;
      return false;
    }
    if (!isItsAddress || !isSilent_ || !bringsHeartbeat()) return false;
    port_ = port;
    return true;
  }

  // A sender whose datagrams are searched for a heartbeat.
  struct Sender {
    IPAddress address;
    uint16_t port;
    detail::HeartbeatSearch search;
    bool is(const Sender& other) const { return port == other.port && address == other.address; }
  };

  // Whether a heartbeat of an autopilot ends in the datagram that has come. If this ends within what may be one, the
  // search in this sender's next datagram goes on from there, if no two others do the same in between.
  bool bringsHeartbeat() {
    Sender sender{udp_.remoteIP(), udp_.remotePort(), detail::HeartbeatSearch()};
    const bool wasLast = last_.is(sender);
    if (wasLast || before_.is(sender)) sender.search = (wasLast ? last_ : before_).search;
    const bool isFound = sender.search.readsAutopilot(udp_);
    if (!wasLast && !sender.search.isBegun()) return isFound;
    if (!wasLast && last_.search.isBegun()) before_ = last_;
    last_ = sender;
    return isFound;
  }

  // Some cores give the next datagram only when this one has been read to its end.
  void leaveOut() {
    isPeers_ = false;
    uint8_t rest[16];
    while (udp_.read(rest, sizeof(rest)) > 0) {
    }
  }

  bool sendPacket(const uint8_t* bytes, uint16_t size) override {
    if (!hasPeer() || udp_.beginPacket(address_, port_) == 0) return false;
    const bool isWhole = udp_.write(bytes, size) == size;
    return udp_.endPacket() != 0 && isWhole;
  }

  static_assert(MAVMISSION_UDP_BYTES <= kLongestFrame,
                "MAVMISSION_UDP_BYTES: MAVLink has no longer frame than 280 bytes");

  UDP& udp_;
  IPAddress address_;
  uint16_t port_ = 0;
  // The last two senders that cut what may be a heartbeat: one may be somebody else.
  Sender last_ = Sender(), before_ = Sender();
  uint16_t foundMs_ = 0;
  uint16_t heardMs_ = 0;
  uint16_t strangers_ = 0;
  bool isNamed_ = false;
  bool isSettled_ = false;  // a second aircraft would have been heard
  bool isSilent_ = false;
  bool severalHeard_ = false;
  bool isPeers_ = false;  // the datagram that is being read
  uint8_t buffer_[MAVMISSION_UDP_BYTES];
};

}  // namespace mavmission
