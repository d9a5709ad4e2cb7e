#include "../EepromTimestamps.h"

#ifdef __AVR__

#include <avr/eeprom.h>
#include <util/crc16.h>

namespace mavmission {
namespace {

uint8_t* inEeprom(uint16_t address) { return reinterpret_cast<uint8_t*>(address); }

}  // namespace

EepromTimestamps::EepromTimestamps(uint16_t address, uint8_t slots)
    : TimestampStore{loadFrom, saveTo, this},
      address_(address),
      slots_(slots),
      next_(0),
      left_(0),
      isWriting_(false),
      slot_() {}

void EepromTimestamps::fillSlot(uint32_t time) {
  uint16_t crc = 0xFFFF;
  for (uint8_t i = 0; i < kSlot - 2; ++i) {
    slot_[i] = static_cast<uint8_t>(time);
    time >>= 8;
    crc = _crc_ccitt_update(crc, slot_[i]);
  }
  slot_[kSlot - 2] = static_cast<uint8_t>(crc);
  slot_[kSlot - 1] = static_cast<uint8_t>(crc >> 8);
}

// The greatest time of all slots that are whole. One that was being written when the power went is not.
uint32_t EepromTimestamps::loadFrom(void* context) {
  EepromTimestamps& store = *static_cast<EepromTimestamps*>(context);
  uint32_t greatest = 0;
  store.next_ = 0;
  for (uint8_t i = 0; i < store.slots_; ++i) {
    uint8_t read[kSlot];
    eeprom_read_block(read, inEeprom(store.address_ + bytes(i)), kSlot);
    uint32_t time = 0;
    for (uint8_t byte = kSlot - 2; byte != 0; --byte) time = time << 8 | read[byte - 1];
    store.fillSlot(time);
    uint8_t difference = 0;
    for (uint8_t byte = 0; byte < kSlot; ++byte) difference |= read[byte] ^ store.slot_[byte];
    if (difference != 0 || time < greatest) continue;
    greatest = time;
    store.next_ = static_cast<uint8_t>(i + 1);
  }
  if (store.next_ == store.slots_) store.next_ = 0;
  store.isWriting_ = false;
  return greatest;
}

// A byte takes the EEPROM 3.4 ms: one is begun in a call, when the one before is done.
bool EepromTimestamps::saveTo(void* context, uint32_t time) {
  EepromTimestamps& store = *static_cast<EepromTimestamps*>(context);
  if (!eeprom_is_ready()) return false;
  if (!store.isWriting_) {
    store.fillSlot(time);
    store.left_ = kSlot;
    store.isWriting_ = true;
  }
  if (store.left_ != 0) {
    const uint8_t at = static_cast<uint8_t>(kSlot - store.left_);
    --store.left_;
    eeprom_update_byte(inEeprom(store.address_ + bytes(store.next_) + at), store.slot_[at]);
    return false;
  }
  store.isWriting_ = false;
  if (++store.next_ == store.slots_) store.next_ = 0;
  return true;
}

}  // namespace mavmission

#endif
