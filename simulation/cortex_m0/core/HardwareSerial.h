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

// A port whose bytes cross the emulated UART once in a millisecond, as many as its baud rate lets pass.
class UART : public arduino::HardwareSerial {
 public:
  void begin(unsigned long baud) override { begin(baud, SERIAL_8N1); }
  void begin(unsigned long baud, uint16_t) override { baud_ = baud; }
  void end() override { baud_ = 0; }
  int available() override { return static_cast<int>(received_.count()); }
  int peek() override { return received_.count() == 0 ? -1 : received_.first(); }
  int read() override { return received_.count() == 0 ? -1 : received_.take(); }
  int availableForWrite() override;
  void flush() override;
  size_t write(uint8_t byte) override;
  using Print::write;
  operator bool() override { return true; }

  // For the clock's interrupt: what leaves in this millisecond, 255 bytes at most, and what has come.
  uint8_t leaving(uint8_t* bytes);
  void arrive(uint8_t byte);

 private:
  struct Ring {
    enum : uint16_t { Size = 64 };
    volatile uint16_t in, out;
    uint8_t bytes[Size + 1];
    uint16_t count() const { return static_cast<uint16_t>(in >= out ? in - out : in + Size + 1 - out); }
    uint8_t first() const { return bytes[out]; }
    uint8_t take() {
      const uint8_t byte = bytes[out];
      out = out == Size ? 0 : static_cast<uint16_t>(out + 1);
      return byte;
    }
    bool put(uint8_t byte) {
      if (count() == Size) return false;
      bytes[in] = byte;
      in = in == Size ? 0 : static_cast<uint16_t>(in + 1);
      return true;
    }
  };

  uint32_t baud_;
  uint32_t credit_;  // what the line has let pass and nobody has used [thousandths of a byte]
  Ring received_;
  Ring toSend_;
};
