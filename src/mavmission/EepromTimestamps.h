// A TimestampStore in the EEPROM of an AVR. For another board a sketch provides its own.
//
//   EepromTimestamps timestamps(0);  // in the first EepromTimestamps::bytes(8) = 48 bytes
//   autopilot.signWith(key, 1, timestamps);
//
// Wear: each save writes one of the slots, in turn, and there is one save about every 39 s of the autopilot's time (see
// Signing::kReserve), and one at the start. A cell lasts for 100,000 writes: with 8 slots that is a year of running day
// and night.
#pragma once

#include <stdint.h>

#include "TimestampStore.h"

#ifdef __AVR__

namespace mavmission {

class EepromTimestamps : public TimestampStore {
 public:
  static constexpr uint8_t kSlot = 6;  // a time, and its checksum [bytes]

  // The size of this number of slots [bytes].
  static constexpr uint16_t bytes(uint8_t slots) { return static_cast<uint16_t>(slots) * kSlot; }

  EepromTimestamps(const EepromTimestamps&) = delete;
  EepromTimestamps& operator=(const EepromTimestamps&) = delete;

  // `address`: the first of bytes(slots) bytes of EEPROM, which nothing else may write. `slots`: at least 2, since a
  // reset while a slot is being written leaves that one invalid. The store must live as long as the client that signs
  // with it.
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
