// A plan kept in EEPROM. It survives the power going at any moment: what is there then is the old plan or the new one,
// whole. It does not block: a byte takes 3.4 ms to write, and each update() writes one at the most.
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
// The room is two banks, of which one holds the plan. A new one is written to the other bank, read back item by item,
// and made valid by a single byte; only then is the old one made invalid, by a single byte.
//
//   byte 0     0x4D: the bank is valid. Written last.
//   byte 1     sequence: of two valid banks (the power went between those two bytes) the later one holds the plan
//   byte 2     items, the lower byte first
//   byte 4     checksum (Checksum.h) of the items' bytes, then of bytes 1 to 3
//   byte 6     the items: 4 bytes, and 4 more for each of param1 to z that is not 0
//
// A byte is written only if it is another than what is there.
#pragma once

#include <stdint.h>

#include "Eeprom.h"
#include "ItemSink.h"
#include "ItemSource.h"
#include "base/Checksum.h"

namespace mavmission {

// A plan in EEPROM.
class EepromPlan {
 public:
  // Resting: nothing to do. Storing: items are taken, one when isReady(). Committing, Erasing: being written. Failed:
  // no room, or the EEPROM does not keep what it is given; the old plan is whole.
  enum class State : uint8_t { Resting, Storing, Committing, Erasing, Failed };

#ifdef __AVR__
  // All of the board's own EEPROM.
  EepromPlan() : EepromPlan(ownEeprom()) {}
#endif
  // `size` bytes of an EEPROM from `first` on (0: as many as there are); 2 * (6 + 32) at the least. Nobody else may
  // write there.
  explicit EepromPlan(const Eeprom& eeprom, uint16_t first = 0, uint16_t size = 0);

  // Looks what is there; needed once, before the rest: without it there is no plan, and none is stored. Reads all of a
  // plan, which takes some milliseconds (DESIGN.md, "Plans from text, and in EEPROM").
  void begin();

  // A plan is there, and whole.
  bool hasPlan() const { return active_ != kNone; }
  // A plan was there whose checksum is wrong: it is none.
  bool isDamaged() const { return isDamaged_; }
  uint16_t count() const { return count_; }  // items of the plan

  // The plan; one that is refused (Status::SourceRefused) if there is none. Not while another is being stored: it would
  // be exchanged in mid-transfer.
  ItemSource source();

  // --- Another plan

  // Begins one; what was begun before is forgotten. False: a plan is being committed or erased, or begin() is still to
  // come.
  bool store();
  // True when put() takes an item.
  bool isReady() const { return state_ == State::Storing && length_ == 0; }
  // The next item. False, and Failed, if there is no room; false too if it is not isReady().
  bool put(const MissionItem& item);
  uint16_t stored() const { return taken_; }  // items since store()
  // All items are there: makes them the plan. False without an item: what erases is erase(). State::Resting when done.
  bool commit();
  // Takes what a download brings, each item when it can; begins with store().
  ItemSink sink();

  // Takes the plan away. False: one is being committed.
  bool erase();

  // To be called from loop(): writes one byte at the most, and never waits for it.
  State update();
  State state() const { return state_; }
  bool isBusy() const { return state_ == State::Committing || state_ == State::Erasing; }

  // The room for the items of a plan [bytes]; one takes 4 to 32, a waypoint 16, or 20
  // with an unset yaw.
  uint16_t room() const { return bankSize_ - kHeader; }

 private:
  enum class Step : uint8_t { None, Open, Item, Header, Valid, DropOld, EraseOther, EraseActive };

  static constexpr uint8_t kNone = 2;  // no bank
  static constexpr uint8_t kValid = 0x4D;
  static constexpr uint8_t kInvalid = 0;
  static constexpr uint8_t kHeader = 6;  // [bytes]
  static constexpr uint8_t kLongestItem = 32;

  static bool readItem(void* plan, uint16_t index, MissionItem& item);
  static bool writeItem(void* plan, uint16_t index, const MissionItem& item);
  static bool isReadyForItem(void* plan);

  uint16_t addressOf(uint8_t bank) const { return first_ + (bank != 0 ? bankSize_ : 0); }
  uint8_t target() const { return active_ == 0 ? 1 : 0; }
  uint8_t readByte(uint16_t address) const { return eeprom_.read(address); }
  uint16_t readWord(uint16_t address) const {
    return static_cast<uint16_t>(readByte(address) | readByte(address + 1) << 8);
  }
  bool isWhole(uint8_t bank) const;
  uint16_t checksumOf(uint8_t bank) const;
  void activate(uint8_t bank);
  void write(uint16_t address, uint8_t length, Step step);
  void writeMark(uint8_t bank, uint8_t mark, Step step);
  void stepDone();

  Eeprom eeprom_;
  uint16_t first_;
  uint16_t bankSize_;
  uint16_t count_;        // of the active bank's plan
  uint16_t cachedIndex_;  // an item of it, and where that is
  uint16_t cachedAddress_;
  uint16_t taken_;     // items of the plan that is being stored
  uint16_t end_;       // behind the last of them
  uint16_t checksum_;  // of them
  uint16_t address_;   // of what is being written
  uint8_t length_;     // of it; 0: nothing
  uint8_t done_;       // bytes of it that are there
  uint8_t active_;     // bank 0, 1, or kNone
  State state_;
  Step step_;
  bool isBegun_;
  bool isDamaged_;
  uint8_t buffer_[kLongestItem];
};

}  // namespace mavmission
