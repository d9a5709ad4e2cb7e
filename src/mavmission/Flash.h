// Constant data that stays in flash: the same words on AVR, where flash is a memory of its own, and elsewhere.
#pragma once

#include <stdint.h>
#include <string.h>

#ifdef ARDUINO
#include <Arduino.h>  // flash as the board's core has it, and which namespace its classes are in
#endif

#ifndef PROGMEM
#define PROGMEM
#define pgm_read_byte(address) (*reinterpret_cast<const uint8_t*>(address))
#define pgm_read_word(address) (*reinterpret_cast<const uint16_t*>(address))
#define memcpy_P memcpy
#define strncmp_P strncmp
#endif

#ifdef ARDUINO
namespace mavmission {
typedef const __FlashStringHelper* FlashText;  // what Serial.print() takes as text in flash
}
#else
namespace mavmission {
typedef const char* FlashText;
}
#endif

namespace mavmission {

// A copy of one value that lies in flash. The small ones are read straight into registers.
template <typename T>
inline T fromFlash(const T* address) {
  T value;
  memcpy_P(&value, address, sizeof(T));
  return value;
}
inline uint8_t fromFlash(const uint8_t* address) { return pgm_read_byte(address); }
inline uint16_t fromFlash(const uint16_t* address) { return pgm_read_word(address); }

}  // namespace mavmission
