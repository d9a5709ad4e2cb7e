// Constant data in flash: the same functions on AVR, where flash is a memory of its own, and elsewhere.
#pragma once

#include <stdint.h>
#include <string.h>

#include "FlashText.h"

#ifndef PROGMEM
#define PROGMEM
#define pgm_read_byte(address) (*reinterpret_cast<const uint8_t*>(address))
#define pgm_read_word(address) (*reinterpret_cast<const uint16_t*>(address))
#define memcpy_P memcpy
#define strncmp_P strncmp
#endif

namespace mavmission {
namespace detail {

// A copy of one value that lies in flash. Small values are read straight into registers.
template <typename T>
inline T fromFlash(const T* address) {
  T value;
  memcpy_P(&value, address, sizeof(T));
  return value;
}
inline uint8_t fromFlash(const uint8_t* address) { return pgm_read_byte(address); }
inline uint16_t fromFlash(const uint16_t* address) { return pgm_read_word(address); }

}  // namespace detail
}  // namespace mavmission
