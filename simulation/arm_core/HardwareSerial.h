// The board's ports: what every one of them has, and this board's own kind.
#pragma once

#include <stdint.h>

#include "Stream.h"

#define SERIAL_8N1 0x413

namespace arduino {

class HardwareSerial : public Stream {
 public:
  virtual void begin(unsigned long baud) = 0;
  virtual void begin(unsigned long baud, uint16_t config) = 0;
  virtual void end() = 0;
  using Print::write;
  virtual operator bool() = 0;

 protected:
  ~HardwareSerial() = default;
};

}  // namespace arduino

class UART : public arduino::HardwareSerial {
 public:
  void begin(unsigned long baud) override;
  void begin(unsigned long baud, uint16_t config) override;
  void end() override;
  int available() override;
  int peek() override;
  int read() override;
  int availableForWrite() override;
  void flush() override;
  size_t write(uint8_t byte) override;
  using Print::write;
  operator bool() override;
};
