// A TimestampStore in EEPROM: an AVR's own, or what a sketch has in its place (Eeprom.h).
//
//   EepromTimestamps timestamps(0);  // in the first EepromTimestamps::bytes(8) = 48 bytes of an AVR's
//   EepromTimestamps timestamps(MAVMISSION_EEPROM(EEPROM, 512), 0);  // on another board
//   autopilot.signWith(key, 1, timestamps);
//
// Wear: the first time is saved when the client begins to sign, and another one in about 39 s of the autopilot's time.
// Each save writes the next slot. A cell of EEPROM can be written 100,000 times, so 8 slots last for a year of running
// day and night. Flash that is written by commit() lasts for less: a board that runs for long needs another store.
#pragma once

#include <stdint.h>

#include "../signing/TimestampStore.h"
#include "Eeprom.h"

namespace mavmission {

// A TimestampStore in EEPROM.
class EepromTimestamps : public TimestampStore {
 public:
  static constexpr uint8_t kSlot = 6;  // a time, and its checksum [bytes]

  // The size of this number of slots [bytes].
  static constexpr uint16_t bytes(uint8_t slots) { return static_cast<uint16_t>(slots) * kSlot; }

  EepromTimestamps(const EepromTimestamps&) = delete;
  EepromTimestamps& operator=(const EepromTimestamps&) = delete;

  // `address`: of the first of bytes(slots) bytes of EEPROM, which nobody else may write. `slots`: at least 2; with 1,
  // a reset while it is being written would leave no valid time. This object must live as long as the client that signs
  // with it.
#ifdef __AVR__
  explicit EepromTimestamps(uint16_t address, uint8_t slots = 8);
#else
  explicit EepromTimestamps(const Eeprom& eeprom, uint16_t address, uint8_t slots = 8);
  // Does not compile: this board needs an Eeprom.
  template <typename Address>
  explicit EepromTimestamps(Address, uint8_t = 8) : TimestampStore(), eeprom_(nullptr, nullptr, nullptr, 0) {
    static_assert(sizeof(Address) == 0,
                  "this board has no EEPROM of its own: name what keeps the bytes. Write #include <EEPROM.h> and "
                  "EepromTimestamps timestamps(MAVMISSION_EEPROM(EEPROM, 512), 0);");
  }
#endif

 private:
  static uint32_t loadFrom(void* context);
  static bool saveTo(void* context, uint32_t time);
  void fillSlot(uint32_t time);

#ifndef __AVR__
  Eeprom eeprom_;
#endif
  uint16_t address_;
  uint8_t slots_;
  uint8_t next_;  // the slot that is written next
  uint8_t left_;  // bytes of slot_ that are not written yet
  bool isWriting_;
  uint8_t slot_[kSlot];
};

}  // namespace mavmission
