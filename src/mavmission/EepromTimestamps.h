// A TimestampStore in the EEPROM of an AVR. For another board, a sketch makes one of its own.
//
//   EepromTimestamps timestamps(0);  // in the first EepromTimestamps::bytes(8) = 48 bytes
//   autopilot.signWith(key, 1, timestamps);
//
// Wear: a save writes one of the slots, in turn, and there is one save in about 39 s of the autopilot's time (see
// Signing::kReserve), and one when it begins. A cell bears 100,000 writes: with 8 slots that is a year of running
// day and night.
#pragma once

#include <stdint.h>

#include "TimestampStore.h"

#ifdef __AVR__

namespace mavmission {

class EepromTimestamps : public TimestampStore {
 public:
  static constexpr uint8_t kSlot = 6;  // a time, and its checksum [bytes]

  // EEPROM that so many slots take [bytes].
  static constexpr uint16_t bytes(uint8_t slots) { return static_cast<uint16_t>(slots) * kSlot; }

  EepromTimestamps(const EepromTimestamps&) = delete;
  EepromTimestamps& operator=(const EepromTimestamps&) = delete;

  // `address`: of the first of bytes(slots) bytes of EEPROM, which nobody else may write. `slots`: at least 2, or a
  // reset while one is being written leaves none. Must stay as long as the client that signs with it.
  explicit EepromTimestamps(uint16_t address, uint8_t slots = 8);

 private:
  static uint32_t loadFrom(void* context);
  static bool saveTo(void* context, uint32_t time);
  void fillSlot(uint32_t time);

  uint16_t address_;
  uint8_t slots_;
  uint8_t next_;  // the slot that is written next
  uint8_t left_;  // bytes of slot_ that are not written yet
  bool isWriting_;
  uint8_t slot_[kSlot];
};

}  // namespace mavmission

#endif
