// Serial1 as a Stream that can be made to have less room for what is written, and that notices when a writer
// would have been made to wait.
#pragma once

#include <Arduino.h>

class Line : public Stream {
 public:
  static const uint8_t kRing = 63;  // bytes that HardwareSerial's ring takes

  explicit Line(HardwareSerial& serial) : serial_(serial) {}

  // The ring of a smaller port [bytes]; 0: it takes nothing for the moment.
  void setRoom(uint8_t room) { ring_ = room; }
  // Bytes that were written when there was no room: a port would have waited.
  uint16_t blocked() const { return blocked_; }

  int available() override { return serial_.available(); }
  int read() override { return serial_.read(); }
  int peek() override { return serial_.peek(); }
  void flush() override { serial_.flush(); }
  int availableForWrite() override { return room(); }
  size_t write(uint8_t byte) override {
    if (room() == 0) ++blocked_;
    return serial_.write(byte);
  }
  using Print::write;

 private:
  uint8_t room() {
    const uint8_t waiting = kRing - serial_.availableForWrite();
    return waiting < ring_ ? ring_ - waiting : 0;
  }

  HardwareSerial& serial_;
  uint16_t blocked_ = 0;
  uint8_t ring_ = kRing;
};
