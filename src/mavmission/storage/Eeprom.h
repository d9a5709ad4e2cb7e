// Bytes that are kept without power: the board's own EEPROM, or a substitute that the sketch provides.
#pragma once

#include <stdint.h>

namespace mavmission {

// Functions that read and write the bytes of an EEPROM. On a board that is not an AVR, the sketch includes EEPROM.h and
// gives them in one line:
//
//   EepromPlan plan(MAVMISSION_EEPROM(EEPROM, 1024));  // on an ESP32 and a Pico EEPROM.begin(1024) comes first
//   EepromPlan plan(Eeprom{readByte, writeByte, isReady, 8192});  // two or three functions of its own, for an FRAM
struct Eeprom {
  // The byte at an address.
  uint8_t (*read)(uint16_t address);
  // Begins to write a byte and returns; isReady() becomes true when that is done. It may also write the byte at once.
  void (*write)(uint16_t address, uint8_t value);
  // True when write() may be called without waiting. Null: always.
  bool (*isReady)();
  uint16_t size;  // [bytes]
#ifndef __AVR__
  // Stores permanently what has been written, if the memory needs such a call; returns false if that failed. Null: no
  // such call is needed. It may block: a page of flash takes some 50 ms.
  bool (*commit)();
  constexpr Eeprom(uint8_t (*readByte)(uint16_t), void (*writeByte)(uint16_t, uint8_t), bool (*ready)(), uint16_t bytes,
                   bool (*commitAll)() = nullptr)
      : read(readByte), write(writeByte), isReady(ready), size(bytes), commit(commitAll) {}
#endif
};

#ifndef __AVR__
// The functions of an Eeprom for an object with read(address) and write(address, byte), and commit() where it has one.
template <typename Kind, Kind& object>
struct EepromOf {
  static uint8_t read(uint16_t address) { return static_cast<uint8_t>(object.read(address)); }
  static void write(uint16_t address, uint8_t value) { object.write(address, value); }
  template <typename T>
  static auto commitOf(T& it, int) -> decltype(static_cast<bool>(it.commit())) {
    return it.commit();
  }
  template <typename T>
  static bool commitOf(T&, long) {
    return true;
  }
  static bool commit() { return commitOf(object, 0); }
};

// `bytes` of the board's EEPROM library, by the name of its object.
#define MAVMISSION_EEPROM(object, bytes)                                                                            \
  (mavmission::Eeprom(mavmission::EepromOf<decltype(object), object>::read,                                         \
                      mavmission::EepromOf<decltype(object), object>::write, nullptr, static_cast<uint16_t>(bytes), \
                      mavmission::EepromOf<decltype(object), object>::commit))
#endif

#ifdef __AVR__
// The EEPROM of an AVR: 4,096 bytes on a Mega, 1,024 on an Uno, a Nano, a Leonardo. A byte takes 3.4 ms to write, and
// can be written 100,000 times. (Data sheet, ATmega2560, "EEPROM Data Memory".)
Eeprom ownEeprom();
#endif

}  // namespace mavmission
