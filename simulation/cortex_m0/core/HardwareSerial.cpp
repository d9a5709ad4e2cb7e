#include "HardwareSerial.h"

#include "Arduino.h"

extern "C" {
// Read by the test, from outside: bytes for Serial1 that write() had to wait with, and bytes for which it had no room.
uint32_t waitedBytes;
uint32_t lostBytes;
}

UART Serial;
UART Serial1;

int UART::availableForWrite() { return Ring::Size - toSend_.count(); }

void UART::flush() {
  while (toSend_.count() != 0) yield();
}

size_t UART::write(uint8_t byte) {
  if (baud_ == 0) return 0;
  if (toSend_.count() == Ring::Size && this == &Serial1) ++waitedBytes;
  while (!toSend_.put(byte)) yield();
  return 1;
}

uint8_t UART::leaving(uint8_t* bytes) {
  credit_ += baud_ / 10;
  uint8_t count = 0;
  while (credit_ >= 1000 && toSend_.count() != 0 && count < 255) {
    bytes[count++] = toSend_.take();
    credit_ -= 1000;
  }
  if (toSend_.count() == 0 && credit_ > 1000) credit_ = 1000;
  return count;
}

void UART::arrive(uint8_t byte) {
  if (baud_ != 0 && !received_.put(byte) && this == &Serial1) ++lostBytes;
}
