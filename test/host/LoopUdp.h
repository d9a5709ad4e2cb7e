// A UDP socket whose datagrams the test brings and takes, without allocating. It keeps to what the makers' classes do,
// the awkward things included: an ESP32's gives no datagram before the last one has been read to its end, and forgets
// the address of one that is being made as soon as the next one comes.
#pragma once

#include <Udp.h>

class LoopUdp final : public UDP {
 public:
  static constexpr size_t kMost = 64, kLongest = 1460;

  struct Datagram {
    IPAddress address;  // where it comes from, or goes to
    uint16_t port;
    size_t size;
    uint8_t bytes[kLongest];
  };

  Datagram sent[kMost];  // until sentCount is set back
  size_t sentCount = 0;
  size_t readBytes = 0;  // by whoever reads
  bool refuses = false;  // endPacket() sends nothing, as without memory, or without an answer to ARP

  // False if there is no room for it: it is lost.
  bool bring(const IPAddress& address, uint16_t port, const uint8_t* bytes, size_t size) {
    if (count_ == kMost || size > kLongest) return false;
    Datagram& place = queue_[(first_ + count_++) % kMost];
    place.address = address;
    place.port = port;
    place.size = size;
    if (size != 0) memcpy(place.bytes, bytes, size);
    return true;
  }
  size_t waiting() const { return count_; }

  uint8_t begin(uint16_t) override { return 1; }
  void stop() override {}

  int beginPacket(IPAddress address, uint16_t port) override {
    remoteAddress_ = address;
    remotePort_ = port;
    making_.size = 0;
    return 1;
  }
  int beginPacket(const char*, uint16_t) override { return 0; }
  size_t write(uint8_t byte) override { return write(&byte, 1); }
  size_t write(const uint8_t* bytes, size_t size) override {
    if (making_.size + size > kLongest) return 0;
    memcpy(making_.bytes + making_.size, bytes, size);
    making_.size += size;
    return size;
  }
  int endPacket() override {
    if (refuses || sentCount == kMost) return 0;
    making_.address = remoteAddress_;
    making_.port = remotePort_;
    sent[sentCount++] = making_;
    return 1;
  }

  int parsePacket() override {
    if (available() > 0 || count_ == 0) return 0;
    now_ = queue_[first_];
    first_ = (first_ + 1) % kMost;
    --count_;
    at_ = 0;
    remoteAddress_ = now_.address;
    remotePort_ = now_.port;
    return static_cast<int>(now_.size);
  }
  int available() override { return static_cast<int>(now_.size - at_); }
  int read() override {
    if (at_ == now_.size) return -1;
    ++readBytes;
    return now_.bytes[at_++];
  }
  int read(unsigned char* bytes, size_t size) override {
    int count = 0;
    for (; size != 0 && at_ != now_.size; --size, ++count) *bytes++ = static_cast<uint8_t>(read());
    return count;
  }
  int read(char* bytes, size_t size) override { return read(reinterpret_cast<unsigned char*>(bytes), size); }
  int peek() override { return at_ == now_.size ? -1 : now_.bytes[at_]; }
  void flush() override {}
  IPAddress remoteIP() override { return remoteAddress_; }
  uint16_t remotePort() override { return remotePort_; }

 private:
  Datagram queue_[kMost];
  size_t first_ = 0, count_ = 0;
  Datagram now_ = Datagram();
  size_t at_ = 0;
  Datagram making_ = Datagram();
  IPAddress remoteAddress_;
  uint16_t remotePort_ = 0;
};
