// A plan kept in EEPROM. It survives a power failure at any moment: either the old plan or the new one is there
// afterwards, whole. It does not block: a byte takes 3.4 ms to write, and each update() writes at most one.
//
//   EepromPlan plan;
//   ...
//   plan.begin();                              // in setup(): is there one?
//   autopilot.upload(plan.source());           // put it aboard
//   autopilot.download(plan.sink());           // keep what is aboard; then, at Status::Downloaded:
//   plan.commit();
//   ...
//   plan.update();                             // in loop()
//
// The memory is divided into two banks, one of which holds the plan. A new plan is written to the other bank, read back
// item by item, and made valid by a single byte; only then is the old plan made invalid, by a single byte.
//
//   byte 0     0x4D: the bank is valid. Written last.
//   byte 1     sequence: if the power failed between those two bytes, both banks are valid, and the later one counts
//   byte 2     items, the lower byte first
//   byte 4     checksum (Checksum.h) of the items' bytes, then of bytes 1 to 3
//   byte 6     the items: 4 bytes, and 4 more for each of param1 to z that is not 0
//
// A byte is written only if its value changes. If byte 0 is worn out and stays 0x4D, the checksum is made wrong.
//
// On a board whose EEPROM library keeps the bytes in flash (an ESP32, a Pico), the change is written by one call of the
// library's commit(), which may block. A power failure during that call may lose both plans.
#pragma once

#include <stdint.h>

#include "../base/Checksum.h"
#include "../plan/ItemSink.h"
#include "../plan/ItemSource.h"
#include "Eeprom.h"

namespace mavmission {

// A plan in EEPROM.
class EepromPlan {
 public:
  // Resting: nothing to do. Storing: waits for items; put() takes one whenever isReady(). Committing, Erasing: it is
  // writing. Failed: there is no room, or the EEPROM does not keep what is written; the old plan is still whole.
  enum class State : uint8_t { Resting, Storing, Committing, Erasing, Failed };

#ifdef __AVR__
  // All of the board's own EEPROM.
  EepromPlan() : EepromPlan(ownEeprom()) {}
#else
  // Does not compile: the sketch has to say where bytes are kept without power.
  template <int known = 0>
  EepromPlan() {
    static_assert(known != 0,
                  "this board has no EEPROM of its own: name what keeps the bytes. Write #include <EEPROM.h> and "
                  "EepromPlan plan(MAVMISSION_EEPROM(EEPROM, 1024));");
  }
#endif
  // `size` bytes of an EEPROM from `first` on (0: all that there are), at least 2 * (6 + 32). Nothing else may write
  // there.
  explicit EepromPlan(const Eeprom& eeprom, uint16_t first = 0, uint16_t size = 0);

  // Looks for a plan; must be called once, before everything else: without it there is no plan, and none can be stored.
  // Reads the whole plan, which takes some milliseconds (docs/measurements.md).
  void begin();

  // True if a plan is there, and whole.
  bool hasPlan() const { return active_ < kNone; }
  // True if begin() found a plan with a wrong checksum, which counts as none.
  bool isDamaged() const { return isDamaged_; }
  uint16_t count() const { return count_; }  // items of the plan

  // The plan that is there now. If there is none, an upload of the source is refused (Status::SourceRefused). When
  // another plan has been stored, or this one erased, the source gives no item any more, and a transfer of it ends with
  // SourceRefused: call source() again. (It gives items again when a second plan is stored: do not keep it for that
  // long.)
  ItemSource source();

  // --- Storing another plan

  // Begins to store a plan; a plan that was begun and not committed is dropped. False if a plan is being committed or
  // erased, or begin() has not been called.
  bool store();
  // True when put() takes an item.
  bool isReady() const { return state_ == State::Storing && length_ == 0; }
  // Stores the next item. False, with State::Failed, if there is no room; also false while isReady() is false.
  bool put(const MissionItem& item);
  uint16_t stored() const { return taken_; }  // items since store()
  // Makes the stored items the plan; the state is State::Resting when that is done. False if no item was stored: to
  // delete the plan call erase().
  bool commit();
  // A sink for a download, which takes each item when it can; calls store().
  ItemSink sink();

  // Deletes the plan. False if a plan is being committed.
  bool erase();

  // To be called from loop(): writes at most one byte, and never waits for it.
  State update();
  State state() const { return state_; }
  bool isBusy() const { return state_ == State::Committing || state_ == State::Erasing; }

  // The room for the items of a plan [bytes]; an item takes 4 to 32, a waypoint 16, or 20 with an unset yaw.
  uint16_t room() const { return bankSize_ - kHeader; }

 private:
  enum class Step : uint8_t { None, Open, Item, Header, Valid, DropOld, EraseOther, EraseActive };

  static constexpr uint8_t kNone = 2;  // no plan; plus the bank that held the last one
  static constexpr uint8_t kValid = 0x4D;
  static constexpr uint8_t kInvalid = 0;
  static constexpr uint8_t kHeader = 6;  // [bytes]
  static constexpr uint8_t kChecksumAt = 4;
  static constexpr uint8_t kLongestItem = 32;

  template <uint8_t bank>
  static bool readFrom(void* plan, uint16_t index, MissionItem& item) {
    EepromPlan& from = *static_cast<EepromPlan*>(plan);
    return from.active_ == bank && from.readItem(index, item);
  }
  MAVMISSION_APART bool readItem(uint16_t index, MissionItem& item);
  static bool writeItem(void* plan, uint16_t index, const MissionItem& item);
  static bool isReadyForItem(void* plan);

  MAVMISSION_APART uint16_t addressOf(uint8_t bank) const { return first_ + (bank != 0 ? bankSize_ : 0); }
  // A new plan never goes where the last one was: so a source of that one does not give its items.
  uint8_t target() const { return (active_ & 1) ^ 1; }
  uint8_t readByte(uint16_t address) const { return eeprom_.read(address); }
  uint16_t readWord(uint16_t address) const {
    return static_cast<uint16_t>(readByte(address) | readByte(address + 1) << 8);
  }
  bool isWhole(uint8_t bank) const;
  uint16_t checksumOf(uint8_t bank) const;
  void activate(uint8_t bank);
  MAVMISSION_APART void write(uint16_t address, uint8_t length, Step step);
  MAVMISSION_APART void writeMark(uint8_t bank, uint8_t mark, Step step);
  bool isInvalidAllTheSame();
  void stepDone();
  // Called when a change is complete: it is stored permanently, where that takes a call.
  void settle() {
    state_ = State::Resting;
#ifndef __AVR__
    if (eeprom_.commit != nullptr && !eeprom_.commit()) state_ = State::Failed;
#endif
  }

  Eeprom eeprom_;
  uint16_t first_;
  uint16_t bankSize_;
  uint16_t count_;        // of the active bank's plan
  uint16_t cachedIndex_;  // an item of the plan, and its address
  uint16_t cachedAddress_;
  uint16_t taken_;     // items of the plan being stored
  uint16_t end_;       // the address after the last one
  uint16_t checksum_;  // of them
  uint16_t address_;   // of the bytes being written
  uint8_t length_;     // how many bytes; 0: none
  uint8_t done_;       // how many of them are written
  uint8_t active_;     // bank 0, 1, or kNone and more
  State state_;
  Step step_;
  bool isBegun_;
  bool isDamaged_;
  uint8_t buffer_[kLongestItem];
};

}  // namespace mavmission
