// An IPv4 address, as far as ArduinoCore-API's is used.
#pragma once

#include <stdint.h>

#include "Print.h"

namespace arduino {

class IPAddress : public Printable {
 public:
  IPAddress() : IPAddress(0, 0, 0, 0) {}
  IPAddress(uint8_t first, uint8_t second, uint8_t third, uint8_t fourth) : bytes_{first, second, third, fourth} {}
  uint8_t operator[](int index) const { return bytes_[index]; }
  bool operator==(const IPAddress& other) const { return memcmp(bytes_, other.bytes_, sizeof(bytes_)) == 0; }
  size_t printTo(Print& to) const override {
    size_t size = 0;
    for (int i = 0; i < 4; ++i) size += (i != 0 ? to.print('.') : 0) + to.print(bytes_[i]);
    return size;
  }

 private:
  uint8_t bytes_[4];
};

}  // namespace arduino

using arduino::IPAddress;
