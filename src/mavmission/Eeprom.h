// Bytes that are kept without power: the board's own EEPROM, or a substitute of the sketch's.
#pragma once

#include <stdint.h>

namespace mavmission {

// Functions that read and write its bytes.
struct Eeprom {
  // The byte at an address.
  uint8_t (*read)(uint16_t address);
  // Begins to write a byte and returns; isReady() becomes true when that is done. It may also write the byte at once.
  void (*write)(uint16_t address, uint8_t value);
  // True when write() may be called without waiting. Null: always.
  bool (*isReady)();
  uint16_t size;  // [bytes]
};

#ifdef __AVR__
// The EEPROM of an AVR: 4,096 bytes on a Mega, 1,024 on an Uno, a Nano, a Leonardo. A byte takes 3.4 ms to write, and
// can be written 100,000 times. (Data sheet, ATmega2560, "EEPROM Data Memory".)
Eeprom ownEeprom();
#endif

}  // namespace mavmission
