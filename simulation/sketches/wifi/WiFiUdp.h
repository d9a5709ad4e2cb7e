// A socket to compile against, which hears nothing.
#pragma once

#include <Arduino.h>
#include <Udp.h>

class WiFiUDP : public UDP {
 public:
  uint8_t begin(uint16_t) override { return 1; }
  void stop() override {}
  int beginPacket(IPAddress, uint16_t) override { return 0; }
  int beginPacket(const char*, uint16_t) override { return 0; }
  int endPacket() override { return 0; }
  size_t write(uint8_t) override { return 0; }
  size_t write(const uint8_t*, size_t) override { return 0; }
  int parsePacket() override { return 0; }
  int available() override { return 0; }
  int read() override { return -1; }
  int read(unsigned char*, size_t) override { return 0; }
  int read(char*, size_t) override { return 0; }
  int peek() override { return -1; }
  void flush() override {}
  IPAddress remoteIP() override { return IPAddress(); }
  uint16_t remotePort() override { return 0; }
};
