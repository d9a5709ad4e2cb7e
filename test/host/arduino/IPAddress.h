// An IPv4 address, as far as the library uses the core's.
#pragma once

#include <stdint.h>

class IPAddress {
 public:
  IPAddress() : IPAddress(0, 0, 0, 0) {}
  IPAddress(uint8_t first, uint8_t second, uint8_t third, uint8_t fourth) : bytes_{first, second, third, fourth} {}
  uint8_t operator[](int index) const { return bytes_[index]; }
  bool operator==(const IPAddress& other) const {
    for (int i = 0; i < 4; ++i) {
      if (bytes_[i] != other.bytes_[i]) return false;
    }
    return true;
  }

 private:
  uint8_t bytes_[4];
};
