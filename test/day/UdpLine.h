// The client's line: UdpLink over a socket. Datagrams both ways, each "host:port:bytes" in hexadecimal, of the hosts
// 10.0.0.1 to 10.0.0.255; "-" behind the last one.
#pragma once

#include <Arduino.h>

#include "LoopUdp.h"
#include "MavMissionUdp.h"
#include "Words.h"

constexpr size_t kLine = 65536;

class Line {
 public:
  LoopUdp udp;
  mavmission::UdpLink stream{udp};

  void sayPeer() {
    printf("host=%d port=%d strangers=%d packets=%d unsent=%d\n", stream.peerAddress()[3], stream.peerPort(),
           stream.strangers(), stream.packetsSent(), stream.unsent());
  }

  bool bring(Words& words) {
    for (;;) {
      const std::string word = words.word();
      if (word == "-" || word.empty()) return true;
      const size_t first = word.find(':'), second = word.find(':', first + 1);
      const Bytes bytes = bytesOf(word.substr(second + 1));
      const uint8_t host = static_cast<uint8_t>(strtoul(word.c_str(), nullptr, 10));
      const uint16_t port = static_cast<uint16_t>(strtoul(word.c_str() + first + 1, nullptr, 10));
      if (!udp.bring(IPAddress(10, 0, 0, host), port, bytes.data(), bytes.size())) return false;
    }
  }
  bool hasLeft() const { return udp.sentCount != 0; }
  void sayWhatLeft() {
    for (size_t i = 0; i < udp.sentCount; ++i) {
      const LoopUdp::Datagram& datagram = udp.sent[i];
      printf("%d:%d:", datagram.address[3], datagram.port);
      say(datagram.bytes, datagram.size);
      putchar(' ');
    }
    putchar('-');
    udp.sentCount = 0;
  }
};
