// EepromPlan: a plan in one of two banks.
//
//            store()             commit()              all bytes are as they were written
//   Resting --------> Storing ------------> Committing -----------------------------------> Resting
//    |   ^               |                      |   items' end, Header, Valid (the new plan counts), DropOld
//    |   |               | no room              |
//    |   |               v                      v
//    |   |             Failed <-----------------+ a byte is not as it was written: the old plan is whole
//    |   |                ^
//    |   |                | the same
//    |   +------------ Erasing: EraseOther, EraseActive
//    |    erase()         ^
//    +--------------------+
//
// update() writes one byte of the running step; stepDone() begins the next one.
#include "EepromPlan.h"

#include <string.h>

namespace mavmission {
using namespace detail;
namespace {

constexpr uint8_t kNumbers = 7;  // param1 to z, 4 bytes each, one after the other in a MissionItem
constexpr uint8_t kNumberBytes = 4;
constexpr uint8_t kItemHead = 4;
constexpr uint8_t kSummed = 3;  // bytes of a bank's header that the checksum covers: sequence and count
constexpr uint8_t kNumbersMask = 0x7F;
constexpr uint8_t kAutocontinue = 0x80;
constexpr uint8_t kCurrent = 0x80;

uint8_t lengthOf(uint8_t flags) {
  uint8_t length = kItemHead;
  for (flags &= kNumbersMask; flags != 0; flags >>= 1) length += (flags & 1) * kNumberBytes;
  return length;
}

// The header of an item: which numbers are not 0, and autocontinue; the frame, and current; the command.
uint8_t pack(const MissionItem& item, uint8_t* bytes) {
  const uint8_t* number = reinterpret_cast<const uint8_t*>(&item);
  uint8_t flags = 0;
  uint8_t length = kItemHead;
  for (uint8_t i = 0; i < kNumbers; ++i, number += kNumberBytes) {
    if ((number[0] | number[1] | number[2] | number[3]) == 0) continue;
    flags |= static_cast<uint8_t>(1 << i);
    memcpy(bytes + length, number, kNumberBytes);
    length += kNumberBytes;
  }
  bytes[0] = flags | (item.autocontinue != 0 ? kAutocontinue : 0);
  bytes[1] = static_cast<uint8_t>(item.frame) | (item.current != 0 ? kCurrent : 0);
  bytes[2] = static_cast<uint8_t>(item.command);
  bytes[3] = static_cast<uint8_t>(item.command >> 8);
  return length;
}

}  // namespace

EepromPlan::EepromPlan(const Eeprom& eeprom, uint16_t first, uint16_t size)
    : eeprom_(eeprom),
      first_(first),
      bankSize_((size != 0 ? size : eeprom.size - first) / 2),
      count_(0),
      taken_(0),
      length_(0),
      active_(kNone + 1),
      state_(State::Resting),
      step_(Step::None),
      isBegun_(false),
      isDamaged_(false) {}

void EepromPlan::begin() {
  isBegun_ = true;
  state_ = State::Resting;
  step_ = Step::None;
  length_ = 0;
  const bool isWhole0 = isWhole(0);
  const bool isWhole1 = isWhole(1);
  uint8_t found = isWhole0 ? 0 : isWhole1 ? 1 : kNone + 1;
  if (isWhole0 && isWhole1) {
    const uint8_t later = readByte(addressOf(1) + 1) - readByte(addressOf(0) + 1);
    if (later < 0x80) found = 1;
  }
  activate(found);
  isDamaged_ = found >= kNone && (readByte(addressOf(0)) == kValid || readByte(addressOf(1)) == kValid);
  if (!isWhole0 || !isWhole1) return;
  // The power failed before the old plan was made invalid. Should the new one ever be damaged, the old one must not
  // come back.
  state_ = State::Committing;
  writeMark(target(), kInvalid, Step::DropOld);
}

void EepromPlan::activate(uint8_t bank) {
  active_ = bank;
  count_ = bank >= kNone ? 0 : readWord(addressOf(bank) + 2);
  cachedIndex_ = 0;
  cachedAddress_ = addressOf(bank) + kHeader;
}

// The checksum computed from a bank's items; the complement of the stored one if the items do not fit into the bank.
uint16_t EepromPlan::checksumOf(uint8_t bank) const {
  const uint16_t start = addressOf(bank);
  uint16_t address = start + kHeader;
  uint16_t crc = kChecksumStart;
  uint8_t bytes[kLongestItem];
  for (uint16_t left = readWord(start + 2); left != 0; --left) {
    const uint16_t used = address - start;
    const uint8_t length = used + kItemHead <= bankSize_ ? lengthOf(readByte(address)) : kLongestItem;
    if (used + length > bankSize_) return ~readWord(start + kChecksumAt);
    for (uint8_t i = 0; i < length; ++i) bytes[i] = readByte(address++);
    crc = checksum(crc, bytes, length);
  }
  for (uint8_t i = 0; i < kSummed; ++i) bytes[i] = readByte(start + 1 + i);
  return checksum(crc, bytes, kSummed);
}

bool EepromPlan::isWhole(uint8_t bank) const {
  const uint16_t start = addressOf(bank);
  return readByte(start) == kValid && readWord(start + kChecksumAt) == checksumOf(bank);
}

ItemSource EepromPlan::source() {
  // Without a plan: one item that is refused, since uploading an empty plan would clear the plan aboard.
  return ItemSource{active_ == 0 ? readFrom<0> : readFrom<1>, this, hasPlan() ? count_ : 1u};
}

bool EepromPlan::readItem(uint16_t index, MissionItem& item) {
  if (index >= count_) return false;
  if (index < cachedIndex_) {
    cachedIndex_ = 0;
    cachedAddress_ = addressOf(active_) + kHeader;
  }
  for (; cachedIndex_ < index; ++cachedIndex_) {
    cachedAddress_ += lengthOf(readByte(cachedAddress_));
  }
  uint16_t address = cachedAddress_;
  const uint8_t flags = readByte(address++);
  const uint8_t frame = readByte(address++);
  item.command = readWord(address);
  address += 2;
  uint8_t* number = reinterpret_cast<uint8_t*>(&item);
  for (uint8_t i = 0; i < kNumbers * kNumberBytes; ++i) {
    number[i] = (flags >> (i / kNumberBytes) & 1) != 0 ? readByte(address++) : 0;
  }
  item.frame = static_cast<CoordinateFrame>(frame & ~kCurrent);
  item.current = (frame & kCurrent) != 0;
  item.autocontinue = (flags & kAutocontinue) != 0;
  return true;
}

bool EepromPlan::store() {
  if (isBusy() || !isBegun_) return false;
  state_ = State::Storing;
  taken_ = 0;
  end_ = addressOf(target()) + kHeader;
  checksum_ = kChecksumStart;
  writeMark(target(), kInvalid, Step::Open);
  return true;
}

bool EepromPlan::put(const MissionItem& item) {
  if (!isReady()) return false;
  const uint8_t length = pack(item, buffer_);
  if (end_ - addressOf(target()) + length > bankSize_) {
    state_ = State::Failed;
    return false;
  }
  checksum_ = checksum(checksum_, buffer_, length);
  write(end_, length, Step::Item);
  end_ += length;
  ++taken_;
  return true;
}

bool EepromPlan::commit() {
  if (state_ != State::Storing || taken_ == 0) return false;
  state_ = State::Committing;
  return true;
}

bool EepromPlan::writeItem(void* plan, uint16_t index, const MissionItem& item) {
  if (index == kHomeIndex) return true;
  return static_cast<EepromPlan*>(plan)->put(item);
}

bool EepromPlan::isReadyForItem(void* plan) {
  const EepromPlan& to = *static_cast<EepromPlan*>(plan);
  return to.isReady() || to.state_ != State::Storing;  // writeItem() reports a failure
}

ItemSink EepromPlan::sink() {
  store();
  return ItemSink{writeItem, this, kHomeIndex - 1, isReadyForItem};
}

bool EepromPlan::erase() {
  if (isBusy() || !isBegun_) return false;
  state_ = State::Erasing;
  isDamaged_ = false;
  // First the bank that is not in use: an old plan in it must not come back.
  writeMark(target(), kInvalid, Step::EraseOther);
  return true;
}

void EepromPlan::write(uint16_t address, uint8_t length, Step step) {
  address_ = address;
  length_ = length;
  done_ = 0;
  step_ = step;
}

void EepromPlan::writeMark(uint8_t bank, uint8_t mark, Step step) {
  buffer_[0] = mark;
  write(addressOf(bank), 1, step);
}

EepromPlan::State EepromPlan::update() {
  if (state_ == State::Resting || state_ == State::Failed) return state_;
  if (eeprom_.isReady != nullptr && !eeprom_.isReady()) return state_;
  for (; done_ < length_; ++done_) {
    if (readByte(address_ + done_) == buffer_[done_]) continue;
    eeprom_.write(address_ + done_, buffer_[done_]);
    ++done_;
    return state_;
  }
  // Read back, since a cell may be worn out. The byte that makes the plan valid is written last, when all others are
  // good.
  bool isAsWritten = true;
  for (uint8_t i = 0; i < length_; ++i) isAsWritten = isAsWritten && readByte(address_ + i) == buffer_[i];
  length_ = 0;
  if (isAsWritten || isInvalidAllTheSame()) {
    stepDone();
  } else if (length_ == 0) {
    state_ = State::Failed;
  }
  return state_;
}

// A mark that cannot be written any more: where it was to make a bank invalid, the bank may be so all the same. If it
// is still whole, a byte of its checksum is made wrong instead, which is the next thing to write.
bool EepromPlan::isInvalidAllTheSame() {
  const bool isMark = step_ == Step::Open || step_ >= Step::DropOld;
  if (!isMark) return false;
  const uint8_t bank = address_ >= addressOf(1) ? 1 : 0;
  const uint16_t mark = addressOf(bank);
  // What is to be valid soon needs a mark that can be.
  if (readByte(mark) != kValid) return step_ != Step::Open;
  if (!isWhole(bank)) return true;
  // The new plan is valid, and will count also beside this one.
  if (address_ != mark) return step_ == Step::DropOld;
  buffer_[0] = ~readByte(mark + kChecksumAt);
  write(mark + kChecksumAt, 1, step_);
  return false;
}

// The bytes of a step are written: begins the next step.
void EepromPlan::stepDone() {
  const uint8_t bank = target();
  switch (step_) {
    case Step::None:
    case Step::Open:
    case Step::Item:
      if (state_ != State::Committing) return;
      buffer_[0] = hasPlan() ? readByte(addressOf(active_) + 1) + 1 : 0;
      buffer_[1] = static_cast<uint8_t>(taken_);
      buffer_[2] = static_cast<uint8_t>(taken_ >> 8);
      checksum_ = checksum(checksum_, buffer_, kSummed);
      buffer_[3] = static_cast<uint8_t>(checksum_);
      buffer_[4] = static_cast<uint8_t>(checksum_ >> 8);
      return write(addressOf(bank) + 1, 5, Step::Header);
    case Step::Header: return writeMark(bank, kValid, Step::Valid);
    case Step::Valid: {
      const uint8_t old = active_;
      activate(bank);
      isDamaged_ = false;
      if (old < kNone) return writeMark(old, kInvalid, Step::DropOld);
      return settle();
    }
    case Step::EraseOther:
      if (hasPlan()) return writeMark(active_, kInvalid, Step::EraseActive);
      // Bank 1 may hold a damaged plan.
      return writeMark(1, kInvalid, Step::EraseActive);
    case Step::EraseActive: activate(active_ | kNone); return settle();
    case Step::DropOld: return settle();
  }
}

}  // namespace mavmission
