// What can be written to.
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define DEC 10
#define HEX 16
#define OCT 8
#define BIN 2

namespace arduino {

class __FlashStringHelper;
class Print;

// What knows how to print itself.
class Printable {
 public:
  virtual size_t printTo(Print& to) const = 0;

 protected:
  ~Printable() = default;
};

class Print {
 public:
  virtual size_t write(uint8_t byte) = 0;
  virtual size_t write(const uint8_t* bytes, size_t size);
  size_t write(const char* text) { return write(reinterpret_cast<const uint8_t*>(text), strlen(text)); }
  size_t write(const char* text, size_t size) { return write(reinterpret_cast<const uint8_t*>(text), size); }
  // 0 where a stream does not implement it.
  virtual int availableForWrite() { return 0; }
  virtual void flush() {}

  size_t print(const __FlashStringHelper* text) { return write(reinterpret_cast<const char*>(text)); }
  size_t print(const char* text) { return write(text); }
  size_t print(const Printable& what) { return what.printTo(*this); }
  size_t print(char c) { return write(static_cast<uint8_t>(c)); }
  size_t print(unsigned char number, int base = DEC) { return print(static_cast<unsigned long>(number), base); }
  size_t print(int number, int base = DEC) { return print(static_cast<long>(number), base); }
  size_t print(unsigned int number, int base = DEC) { return print(static_cast<unsigned long>(number), base); }
  size_t print(long number, int base = DEC);
  size_t print(unsigned long number, int base = DEC);
  size_t print(double number, int decimals = 2);

  size_t println() { return write("\r\n"); }
  template <typename T>
  size_t println(T value) {
    const size_t size = print(value);
    return size + println();
  }
  template <typename T>
  size_t println(T value, int base) {
    const size_t size = print(value, base);
    return size + println();
  }

 protected:
  ~Print() = default;
};

}  // namespace arduino
