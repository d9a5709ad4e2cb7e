// UdpLink: a line to the autopilot over UDP. Include it after the header of the UDP class. Not part of MavMission.h:
// few sketches have one, and not every core has UDP.
#pragma once

#include <Arduino.h>
#include <Udp.h>
#include <stdint.h>

#include "mavmission/PacketLink.h"
#include "mavmission/base/Clock.h"
#include "mavmission/base/RetryRules.h"
#include "mavmission/link/AutopilotHeartbeat.h"

// The longest frame that can be sent, 63 to 280 [bytes]. A sketch that is short of RAM, and sends neither plans as
// files nor messages of its own, defines it as 63 before it includes this: what a client sends, signed or not.
#ifndef MAVMISSION_UDP_BYTES
#define MAVMISSION_UDP_BYTES 280
#endif

#if MAVMISSION_UDP_BYTES < 63
#error "MAVMISSION_UDP_BYTES must be 63 to 280: the longest frame of a client has 63 bytes"
#endif

namespace mavmission {

// A line to the autopilot over UDP, for MissionClient as any serial port. Over any class of Arduino's UDP: WiFiUDP of
// an ESP32 or an ESP8266, EthernetUDP.
//
//   WiFiUDP udp;
//   UdpLink line(udp);             // udp.begin(14550) in setup(), behind the network's own begin
//   MissionClient autopilot(line);
//
// One peer. It is found: the sender whose datagram is the first that brings a heartbeat of an autopilot, with a right
// checksum; or it is named, by setPeer(). From then on all other senders' datagrams are left out.
// - A second sender that brings an autopilot's heartbeat within 1.2 s of the first is a second aircraft: no peer is
//   taken, severalHeard() is true, and the sketch has to name one.
// - A peer that was found, and has been silent for 5 s, may have restarted with another port: the next heartbeat of an
//   autopilot from its address brings the new one. Another address is never taken in its place: the client might go on
//   with another aircraft. A sketch that wants that calls forgetPeer(). A peer that was named stays as it was named.
//
// What is written leaves in whole frames, as PacketLink says: a frame for each datagram, at once. While there is no
// peer it is lost, as on a line at whose other end nobody is. A datagram that is lost is a loss on the line, and
// nothing else.
//
// Nothing waits here. UDP classes may: an Ethernet shield's endPacket() waits for an answer to its ARP where the peer
// has gone, 1.6 s unless Ethernet.setRetransmissionTimeout() and setRetransmissionCount() say less. This class takes no
// heap; WiFiUDP takes 1,460 bytes of it for sending, and as many for a datagram that has come, until that is read.
//
// RAM: MAVMISSION_UDP_BYTES, and some 50 bytes [bytes]. The UDP object belongs to the sketch, must outlive this, and
// must not be used by anything else. Source: MAVLink guide, Packet Serialization; ports in docs/radio.md.
class UdpLink : public PacketLink {
 public:
  // `udp` need not have begun yet.
  explicit UdpLink(UDP& udp) : PacketLink(buffer_, sizeof(buffer_)), udp_(udp) {}

  // Names the peer: what is sent goes there, what comes from there is heard, and nothing else.
  void setPeer(const IPAddress& address, uint16_t port) {
    forgetPeer();
    address_ = address;
    port_ = port;
    isNamed_ = true;
  }

  // Forgets the peer, named or found: the next one is looked for. The bytes of its last datagram are not read further.
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

  // Datagrams of others that were left out. It wraps to 0 behind 65535.
  uint16_t strangers() const { return strangers_; }

  // The bytes of the peer's datagrams, one behind the other, as a serial port gives them.
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

  // Whether the datagram that has come is the peer's; the first one makes its sender the peer.
  bool isFromPeer(uint16_t nowMs) {
    const uint16_t port = udp_.remotePort();
    if (severalHeard_ || port == 0) return false;
    if (!hasPeer()) {
      if (!detail::readAutopilotHeartbeat(udp_)) return false;
      address_ = udp_.remoteIP();
      port_ = port;
      foundMs_ = nowMs;
      return true;
    }
    const bool isItsAddress = udp_.remoteIP() == address_;
    if (isItsAddress && port == port_) return true;
    if (isNamed_) return false;
    if (!isSettled_) {
      if (!detail::readAutopilotHeartbeat(udp_)) return false;
      severalHeard_ = true;
      port_ = 0;
      return false;
    }
    if (!isItsAddress || !isSilent_ || !detail::readAutopilotHeartbeat(udp_)) return false;
    port_ = port;
    return true;
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
