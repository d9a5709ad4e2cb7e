// Bytes that stay when the power goes: the board's own EEPROM, or what a sketch has in its place.
#pragma once

#include <stdint.h>

namespace mavmission {

// How its bytes are read and written.
struct Eeprom {
  // The byte at an address.
  uint8_t (*read)(uint16_t address);
  // Begins to write a byte and returns; isReady() says when that is done. It may also write it at once.
  void (*write)(uint16_t address, uint8_t value);
  // True when write() may be called without waiting. Null: always.
  bool (*isReady)();
  uint16_t size;  // [bytes]
};

#ifdef __AVR__
// The EEPROM of an AVR: 4,096 bytes on a Mega, 1,024 on an Uno, a Nano, a Leonardo. A byte takes 3.4 ms to write and
// lasts for 100,000 times. (Data sheet, ATmega2560, "EEPROM Data Memory".)
Eeprom ownEeprom();
#endif

}  // namespace mavmission
