// What the library uses of the Arduino core, on the computer: bytes go to and come from whatever implements Stream, and
// time is what the test says it is.
#pragma once

#ifdef ARDUINO
#error "ARDUINO is defined: the library would take this computer for a board and look for its flash"
#endif

#include <stddef.h>
#include <stdint.h>
#include <string.h>

// Text in flash, where there is none.
#define F(text) (text)
#define PSTR(text) (text)

class Print {
 public:
  virtual size_t write(uint8_t byte) = 0;
  virtual size_t write(const uint8_t* bytes, size_t size) {
    size_t written = 0;
    while (written < size && write(bytes[written]) == 1) ++written;
    return written;
  }
  // As in the core: 0 where a stream does not implement it.
  virtual int availableForWrite() { return 0; }
  size_t print(const char* text) { return write(reinterpret_cast<const uint8_t*>(text), strlen(text)); }
  size_t print(unsigned number) {
    return (number > 9 ? print(number / 10) : 0) + write(static_cast<uint8_t>('0' + number % 10));
  }
  size_t println() { return print("\r\n"); }
  size_t println(const char* text) { return print(text) + println(); }

 protected:
  ~Print() = default;
};

class Stream : public Print {
 public:
  virtual int available() = 0;
  virtual int read() = 0;
  virtual int peek() = 0;

 protected:
  ~Stream() = default;
};

// A port of the board's own.
class HardwareSerial : public Stream {
 protected:
  ~HardwareSerial() = default;
};

// Milliseconds since the start, wrapping after 2^32; the test sets it.
uint32_t millis();
void setMillis(uint32_t nowMs);
