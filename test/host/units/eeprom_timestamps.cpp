#include "mavmission/storage/EepromTimestamps.h"

#include <doctest/doctest.h>

#include <initializer_list>
#include <vector>

#include "mavmission/base/Checksum.h"

using namespace mavmission;

namespace {

constexpr uint16_t kFirst = 10;
constexpr uint8_t kSlots = 4;
constexpr uint16_t kSlot = 6;  // bytes

// C functions cannot have a context: there is one memory.
struct Chip {
  std::vector<uint8_t> bytes;
  uint32_t writes;
  bool isReady;
  bool commits;
} chip;

uint8_t readByte(uint16_t address) {
  REQUIRE(address < chip.bytes.size());
  return chip.bytes[address];
}

void writeByte(uint16_t address, uint8_t value) {
  REQUIRE(address >= kFirst);
  REQUIRE(address < kFirst + kSlots * kSlot);
  REQUIRE(chip.isReady);
  REQUIRE(chip.bytes[address] != value);  // it would only wear it out
  ++chip.writes;
  chip.bytes[address] = value;
}

bool isReady() { return chip.isReady; }
bool commitAll() { return chip.commits; }

Eeprom memory(bool hasCommit = false) {
  return Eeprom{readByte, writeByte, isReady, 100, hasCommit ? commitAll : static_cast<bool (*)()>(nullptr)};
}

void fresh(uint8_t fill = 0xFF) {
  chip = Chip();
  chip.bytes.assign(100, fill);
  chip.isReady = true;
  chip.commits = true;
}

uint32_t loaded() {
  EepromTimestamps store(memory(), kFirst, kSlots);
  return store.load(store.context);
}

// A memory that was never written, and its store, which has looked into it.
struct Fresh : EepromTimestamps {
  explicit Fresh(bool hasCommit = false) : EepromTimestamps((fresh(), memory(hasCommit)), kFirst, kSlots) {
    CHECK(load(context) == 0);
  }
};

void save(EepromTimestamps& store, uint32_t time) {
  int calls = 0;
  while (!store.save(store.context, time)) REQUIRE(++calls < 20);
  CHECK(calls == kSlot);  // a byte in each
}

// A time and its checksum, as they lie in a slot.
std::vector<uint8_t> slotOf(uint32_t time) {
  std::vector<uint8_t> bytes;
  for (int i = 0; i < 4; ++i, time >>= 8) bytes.push_back(static_cast<uint8_t>(time));
  const uint16_t crc = detail::checksum(detail::kChecksumStart, bytes.data(), 4);
  bytes.push_back(static_cast<uint8_t>(crc));
  bytes.push_back(static_cast<uint8_t>(crc >> 8));
  return bytes;
}

std::vector<uint8_t> slotAt(uint8_t index) {
  const uint8_t* const from = &chip.bytes[kFirst + index * kSlot];
  return std::vector<uint8_t>(from, from + kSlot);
}

}  // namespace

TEST_CASE("a memory that was never written has no time") {
  for (uint8_t fill : {0x00, 0xFF, 0x5A}) {
    fresh(fill);
    CHECK(loaded() == 0);
    CHECK(chip.writes == 0);
  }
}

TEST_CASE("a time lies in its slot with its lowest byte first, and its checksum after it") {
  Fresh store;
  save(store, 0x12345678);
  CHECK(slotAt(0) == slotOf(0x12345678));
  CHECK(chip.bytes[kFirst + kSlot] == 0xFF);
  CHECK(loaded() == 0x12345678);
  CHECK(EepromTimestamps::bytes(8) == 48);
}

TEST_CASE("each time is written into the next slot, and after the last one into the first") {
  for (bool isLoadedAnew : {false, true}) {
    Fresh once;
    for (uint32_t i = 0; i < 11; ++i) {
      EepromTimestamps again(memory(), kFirst, kSlots);
      if (isLoadedAnew) CHECK(again.load(again.context) == (i == 0 ? 0 : 1000 + i - 1));
      save(isLoadedAnew ? again : once, 1000 + i);
      for (uint8_t slot = 0; slot < kSlots; ++slot) {
        // The last time that was written there.
        if (i >= slot) CHECK(slotAt(slot) == slotOf(1000 + i - (i - slot) % kSlots));
      }
      CHECK(loaded() == 1000 + i);
    }
  }
}

TEST_CASE("what lies after the last slot is nobody's time, and a memory that was wiped begins with the first one") {
  Fresh store;
  save(store, 5);
  const std::vector<uint8_t> later = slotOf(7);
  for (uint16_t i = 0; i < kSlot; ++i) chip.bytes[kFirst + kSlots * kSlot + i] = later[i];
  CHECK(loaded() == 5);
  save(store, 6);
  chip.bytes.assign(100, 0xFF);
  CHECK(store.load(store.context) == 0);
  save(store, 8);
  CHECK(slotAt(0) == slotOf(8));
}

TEST_CASE("a store is loaded again after a time that was broken off") {
  Fresh store;
  CHECK_FALSE(store.save(store.context, 0x01010101));
  CHECK(store.load(store.context) == 0);
  save(store, 0x02020202);
  CHECK(slotAt(0) == slotOf(0x02020202));
}

TEST_CASE("a time whose bytes are spoilt is none: the one before it counts, and its slot is the next one written") {
  Fresh store;
  save(store, 0x11223344);
  save(store, 0x21324354);
  const std::vector<uint8_t> good = chip.bytes;
  for (uint16_t byte = 0; byte < kSlot; ++byte) {
    for (uint8_t flip : {0x01, 0x80, 0xFF}) {
      chip.bytes = good;
      chip.bytes[kFirst + kSlot + byte] ^= flip;
      CHECK(loaded() == 0x11223344);
      EepromTimestamps again(memory(), kFirst, kSlots);
      again.load(again.context);
      save(again, 0x31415926);
      CHECK(slotAt(0) == slotOf(0x11223344));
      CHECK(slotAt(1) == slotOf(0x31415926));
    }
  }
}

TEST_CASE("of equal times the slot of the last one counts") {
  Fresh store;
  save(store, 7);
  save(store, 7);
  EepromTimestamps again(memory(), kFirst, kSlots);
  CHECK(again.load(again.context) == 7);
  save(again, 8);
  CHECK(slotAt(2) == slotOf(8));
}

TEST_CASE("nothing is written while the last byte is being written") {
  Fresh store;
  chip.isReady = false;
  for (int i = 0; i < 20; ++i) CHECK_FALSE(store.save(store.context, 5));
  CHECK(chip.writes == 0);
  chip.isReady = true;
  save(store, 5);
  CHECK(loaded() == 5);
}

TEST_CASE("a time is saved when the memory has been committed, and tried again when that has failed") {
  Fresh store(true);
  chip.commits = false;
  for (int i = 0; i < 20; ++i) CHECK_FALSE(store.save(store.context, 5));
  chip.commits = true;
  CHECK(store.save(store.context, 5));
  CHECK(slotAt(0) == slotOf(5));
  save(store, 6);
  CHECK(slotAt(1) == slotOf(6));
}
