#include "Eeprom.h"

#ifdef __AVR__
#include <avr/eeprom.h>

namespace mavmission {
namespace {

uint8_t* at(uint16_t address) { return reinterpret_cast<uint8_t*>(address); }
uint8_t read(uint16_t address) { return eeprom_read_byte(at(address)); }
void write(uint16_t address, uint8_t value) { eeprom_write_byte(at(address), value); }
bool isReady() { return eeprom_is_ready(); }

}  // namespace

Eeprom ownEeprom() { return Eeprom{read, write, isReady, E2END + 1}; }

}  // namespace mavmission
#endif
