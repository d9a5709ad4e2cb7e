// What UploadOverEthernet uses of the library "Ethernet", with Serial1 in place of the shield: what comes there is
// gathered to whole frames, each of them a datagram from one peer, and a datagram to that peer goes out there.
#pragma once

#include <Arduino.h>
#include <Udp.h>

class EthernetClass {
 public:
  void begin(uint8_t*, const IPAddress&) { Serial1.begin(57600); }
  void setRetransmissionTimeout(uint16_t) {}
  void setRetransmissionCount(uint8_t) {}
};

static EthernetClass Ethernet;

class EthernetUDP : public UDP {
 public:
  uint8_t begin(uint16_t) override { return 1; }
  void stop() override {}
  int beginPacket(IPAddress address, uint16_t port) override {
    isToPeer_ = address == peer() && port == kPort;
    return 1;
  }
  int beginPacket(const char*, uint16_t) override { return 0; }
  size_t write(uint8_t byte) override { return isToPeer_ ? Serial1.write(byte) : 1; }
  size_t write(const uint8_t* bytes, size_t size) override { return isToPeer_ ? Serial1.write(bytes, size) : size; }
  int endPacket() override { return 1; }

  int parsePacket() override {
    if (read_ != size_) return 0;
    if (size_ != 0) gathered_ = size_ = read_ = 0;
    for (int byte; size_ == 0 && (byte = Serial1.read()) >= 0;) {
      if (gathered_ == 0 && byte != 0xFD) continue;
      datagram_[gathered_++] = static_cast<uint8_t>(byte);
      if (gathered_ > 2 && gathered_ == 12u + datagram_[1]) size_ = gathered_;
    }
    return static_cast<int>(size_);
  }
  int available() override { return static_cast<int>(size_ - read_); }
  int read() override { return read_ == size_ ? -1 : datagram_[read_++]; }
  int read(unsigned char* bytes, size_t size) override {
    int count = 0;
    for (; size != 0 && read_ != size_; --size, ++count) *bytes++ = datagram_[read_++];
    return count;
  }
  int read(char* bytes, size_t size) override { return read(reinterpret_cast<unsigned char*>(bytes), size); }
  int peek() override { return read_ == size_ ? -1 : datagram_[read_]; }
  void flush() override {}
  IPAddress remoteIP() override { return peer(); }
  uint16_t remotePort() override { return kPort; }

 private:
  static const uint16_t kPort = 14555;
  static IPAddress peer() { return IPAddress(192, 168, 144, 10); }

  bool isToPeer_ = false;
  uint16_t gathered_ = 0, size_ = 0, read_ = 0;
  uint8_t datagram_[280];
};
