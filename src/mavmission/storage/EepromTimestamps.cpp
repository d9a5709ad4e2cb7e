#include "EepromTimestamps.h"

#ifdef __AVR__
#include <avr/eeprom.h>
#include <util/crc16.h>
#else
#include "../base/Checksum.h"
#endif

namespace mavmission {
namespace {

#ifdef __AVR__
uint8_t* inEeprom(uint16_t address) { return reinterpret_cast<uint8_t*>(address); }
#endif

#ifndef __AVR__
uint16_t _crc_ccitt_update(uint16_t crc, uint8_t byte) { return detail::checksum(crc, &byte, 1); }
#endif

}  // namespace

#ifdef __AVR__
EepromTimestamps::EepromTimestamps(uint16_t address, uint8_t slots)
    : TimestampStore{loadFrom, saveTo, this},
#else
EepromTimestamps::EepromTimestamps(const Eeprom& eeprom, uint16_t address, uint8_t slots)
    : TimestampStore{loadFrom, saveTo, this},
      eeprom_(eeprom),
#endif
      address_(address),
      slots_(slots),
      next_(0),
      left_(0),
      isWriting_(false),
      slot_() {
}

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

// The greatest time of all valid slots. A slot that was being written when the power failed is not valid.
uint32_t EepromTimestamps::loadFrom(void* context) {
  EepromTimestamps& store = *static_cast<EepromTimestamps*>(context);
  uint32_t greatest = 0;
  store.next_ = 0;
  for (uint8_t i = 0; i < store.slots_; ++i) {
    uint8_t read[kSlot];
#ifdef __AVR__
    eeprom_read_block(read, inEeprom(store.address_ + bytes(i)), kSlot);
#else
    for (uint8_t byte = 0; byte < kSlot; ++byte)
      read[byte] = store.eeprom_.read(static_cast<uint16_t>(store.address_ + bytes(i) + byte));
#endif
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

// Writing a byte takes 3.4 ms: each call begins one, when the one before is done.
bool EepromTimestamps::saveTo(void* context, uint32_t time) {
  EepromTimestamps& store = *static_cast<EepromTimestamps*>(context);
#ifdef __AVR__
  if (!eeprom_is_ready()) return false;
#else
  if (store.eeprom_.isReady != nullptr && !store.eeprom_.isReady()) return false;
#endif
  if (!store.isWriting_) {
    store.fillSlot(time);
    store.left_ = kSlot;
    store.isWriting_ = true;
  }
  if (store.left_ != 0) {
    const uint8_t at = static_cast<uint8_t>(kSlot - store.left_);
    --store.left_;
#ifdef __AVR__
    eeprom_update_byte(inEeprom(store.address_ + bytes(store.next_) + at), store.slot_[at]);
#else
    const uint16_t address = static_cast<uint16_t>(store.address_ + bytes(store.next_) + at);
    if (store.eeprom_.read(address) != store.slot_[at]) store.eeprom_.write(address, store.slot_[at]);
#endif
    return false;
  }
#ifndef __AVR__
  if (store.eeprom_.commit != nullptr && !store.eeprom_.commit()) return false;
#endif
  store.isWriting_ = false;
  if (++store.next_ == store.slots_) store.next_ = 0;
  return true;
}

}  // namespace mavmission
