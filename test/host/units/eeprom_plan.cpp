#include "mavmission/storage/EepromPlan.h"

#include <doctest/doctest.h>
#include <string.h>

#include <vector>

using namespace mavmission;
using namespace mavmission::detail;

namespace {

// What a byte holds whose writing the power cut short.
enum class Torn { Old, Erased, New, Other, Zero };
const Torn kTorn[] = {Torn::Old, Torn::Erased, Torn::New, Torn::Other, Torn::Zero};

// An EEPROM that loses its power at a write. C functions cannot have a context: there is one of it.
struct Chip {
  std::vector<uint8_t> bytes;
  std::vector<uint32_t> wear;
  uint32_t writes;
  uint32_t cutAt;  // the write at which the power goes; 0: never
  Torn torn;
  bool isOff;
  bool isReady;
  uint32_t reads;    // since the last update()
  uint16_t stuckAt;  // an address whose byte does not change any more
  uint16_t stuckToo;
} chip;

uint8_t readByte(uint16_t address) {
  REQUIRE(address < chip.bytes.size());
  ++chip.reads;
  return chip.bytes[address];
}

void writeByte(uint16_t address, uint8_t value) {
  REQUIRE(address < chip.bytes.size());
  REQUIRE(chip.isReady);
  if (chip.isOff) return;
  REQUIRE(chip.bytes[address] != value);  // it would only wear it out
  ++chip.wear[address];
  if (++chip.writes != chip.cutAt) {
    if (address != chip.stuckAt && address != chip.stuckToo) chip.bytes[address] = value;
    return;
  }
  chip.isOff = true;
  if (address == chip.stuckAt || address == chip.stuckToo) return;
  switch (chip.torn) {
    case Torn::Old: break;
    case Torn::Erased: chip.bytes[address] = 0xFF; break;
    case Torn::New: chip.bytes[address] = value; break;
    case Torn::Other: chip.bytes[address] ^= 0x5A; break;
    case Torn::Zero: chip.bytes[address] = 0; break;
  }
}

bool isReady() { return chip.isReady; }

Eeprom eeprom(uint16_t size) {
  chip = Chip();
  chip.bytes.assign(size, 0xFF);
  chip.wear.assign(size, 0);
  chip.isReady = true;
  chip.stuckAt = chip.stuckToo = 0xFFFF;
  return Eeprom{readByte, writeByte, isReady, size};
}

typedef std::vector<MissionItem> Items;

// Items that differ from plan to plan, of every length.
Items plan(uint16_t count, int32_t seed) {
  Items items;
  for (uint16_t i = 0; i < count; ++i) {
    const Degrees place = Degrees::fromE7(seed * 1000 + i + 1);
    const Metres height(static_cast<float>(seed + i));
    if (i % 3 == 0) items.push_back(waypoint(place, -place, height, Seconds(1), Metres(2), 90_deg));
    if (i % 3 == 1) items.push_back(changeSpeed(MetresPerSecond(static_cast<float>(seed))));
    if (i % 3 == 2) items.push_back(waypoint(place, place, aboveSeaLevel(Metres(1)), Seconds(-0.f)));
  }
  items.back().current = 1;
  items.back().autocontinue = 0;
  return items;
}

bool isEqual(const MissionItem& a, const MissionItem& b) {
  return memcmp(&a, &b, kPlaceBytes) == 0 && a.command == b.command && a.frame == b.frame && a.current == b.current &&
         a.autocontinue == b.autocontinue;
}

bool holds(EepromPlan& kept, const Items& items) {
  if (kept.hasPlan() == items.empty() || kept.count() != items.size()) return false;
  const ItemSource source = kept.source();
  // Backwards and forwards: any item may be asked for.
  for (size_t i = items.size(); i-- != 0;) {
    MissionItem item;
    if (!source.read(source.context, static_cast<uint16_t>(i), item) || !isEqual(item, items[i])) return false;
  }
  for (size_t i = 0; i < items.size(); ++i) {
    MissionItem item;
    if (!source.read(source.context, static_cast<uint16_t>(i), item) || !isEqual(item, items[i])) return false;
  }
  return true;
}

// One byte at the most, and few reads unless a whole plan is read back.
EepromPlan::State update(EepromPlan& kept) {
  const uint32_t before = chip.writes;
  chip.reads = 0;
  const EepromPlan::State state = kept.update();
  CHECK(chip.writes - before <= 1);
  return state;
}

void settle(EepromPlan& kept) {
  for (int i = 0; i < 10000 && kept.isBusy(); ++i) update(kept);
  REQUIRE_FALSE(kept.isBusy());
}

bool keep(EepromPlan& kept, const Items& items) {
  REQUIRE(kept.store());
  for (const MissionItem& item : items) {
    for (int i = 0; i < 100 && !kept.isReady(); ++i) update(kept);
    if (!kept.put(item)) return false;
  }
  REQUIRE(kept.commit());
  settle(kept);
  return kept.state() == EepromPlan::State::Resting;
}

EepromPlan afterReset(const Eeprom& memory) {
  chip.isOff = false;
  chip.cutAt = 0;
  EepromPlan kept(memory);
  kept.begin();
  return kept;
}

constexpr uint16_t kSize = 400;

// What `act` leaves when the power goes at each of its writes, in each way, must be `before` or `after`, and stay so.
// `stuckAt`: from behind the older plan on.
template <typename Act>
void cutEverywhere(const Items& older, const Items& before, const Items& after, Act act, uint16_t stuckAt = 0xFFFF) {
  for (Torn torn : kTorn) {
    uint32_t writes = 1;
    for (uint32_t cut = 1; cut <= writes; ++cut) {
      const Eeprom memory = eeprom(kSize);
      EepromPlan kept(memory);
      kept.begin();
      if (!older.empty()) REQUIRE(keep(kept, older));
      chip.stuckAt = stuckAt;
      if (!before.empty()) REQUIRE(keep(kept, before));
      chip.writes = 0;
      chip.cutAt = cut;
      chip.torn = torn;
      act(kept);
      if (!chip.isOff) {
        CHECK(cut == chip.writes + 1);  // the first cut that came too late
        CHECK(holds(kept, after));
        break;
      }
      writes = cut + 1;
      EepromPlan again = afterReset(memory);
      const bool isOld = holds(again, before);
      CHECK((isOld || holds(again, after)));
      CHECK_FALSE(again.isDamaged());
      settle(again);
      CHECK((isOld ? holds(again, before) : holds(again, after)));
      EepromPlan once = afterReset(memory);
      CHECK((isOld ? holds(once, before) : holds(once, after)));
      // And it works on.
      CHECK(keep(once, after.empty() ? before : after));
    }
    CHECK(writes > 1);
  }
}

}  // namespace

TEST_CASE("what was never written holds no plan, and gives none") {
  for (uint8_t fill : {0x00, 0xFF, 0x4D}) {
    const Eeprom memory = eeprom(kSize);
    chip.bytes.assign(kSize, fill);
    EepromPlan kept(memory);
    kept.begin();
    CHECK_FALSE(kept.hasPlan());
    CHECK(kept.count() == 0);
    CHECK(kept.isDamaged() == (fill == 0x4D));
    const ItemSource source = kept.source();
    CHECK(source.count == 1);  // an empty plan would clear what is aboard
    MissionItem item;
    CHECK_FALSE(source.read(source.context, 0, item));
    CHECK(chip.writes == 0);
  }
}

TEST_CASE("nothing is stored before it is known which bank holds the plan") {
  const Eeprom memory = eeprom(kSize);
  EepromPlan kept(memory);
  CHECK_FALSE(kept.store());
  CHECK_FALSE(kept.erase());
  const ItemSink sink = kept.sink();
  CHECK(sink.isReady(sink.context));
  CHECK_FALSE(sink.write(sink.context, 0, returnToLaunch()));
  for (int i = 0; i < 10; ++i) kept.update();
  CHECK(chip.writes == 0);
}

TEST_CASE("a plan that was kept is there after a reset, to the bit") {
  const Eeprom memory = eeprom(kSize);
  EepromPlan kept(memory);
  kept.begin();
  for (uint16_t count = 1; count <= 8; ++count) {
    const Items items = plan(count, count);
    REQUIRE(keep(kept, items));
    CHECK(holds(kept, items));
    EepromPlan again = afterReset(memory);
    CHECK(holds(again, items));
    CHECK_FALSE(again.isBusy());
  }
}

TEST_CASE("the power may go at any byte: the old plan or the new one is there, whole") {
  const Items new5 = plan(5, 70);
  const auto storeNew = [&](EepromPlan& kept) {
    kept.store();
    for (const MissionItem& item : new5) {
      for (int i = 0; i < 100 && !kept.isReady(); ++i) kept.update();
      if (!kept.put(item)) return;
    }
    kept.commit();
    for (int i = 0; i < 10000 && kept.isBusy(); ++i) kept.update();
  };
  cutEverywhere(Items(), Items(), new5, storeNew);
  cutEverywhere(Items(), plan(3, 20), new5, storeNew);
  cutEverywhere(plan(7, 40), plan(3, 20), new5, storeNew);
  cutEverywhere(plan(3, 20), plan(6, 40), new5, storeNew);
  cutEverywhere(new5, plan(3, 20), new5, storeNew);
}

TEST_CASE("the power may go while a plan is erased: it is there or not, and no older one comes back") {
  const auto erase = [](EepromPlan& kept) {
    kept.erase();
    for (int i = 0; i < 100 && kept.isBusy(); ++i) kept.update();
  };
  cutEverywhere(plan(4, 10), plan(3, 20), Items(), erase);
  cutEverywhere(Items(), plan(3, 20), Items(), erase);
}

TEST_CASE("the power may go again while what the last cut left is put right") {
  for (Torn first : kTorn) {
    for (Torn second : kTorn) {
      const Items before = plan(3, 20);
      const Items after = plan(2, 30);
      const Eeprom memory = eeprom(kSize);
      EepromPlan kept(memory);
      kept.begin();
      REQUIRE(keep(kept, before));
      chip.writes = 0;
      REQUIRE(keep(kept, after));
      const uint32_t last = chip.writes;  // by which the old plan was made invalid
      REQUIRE(keep(kept, before));
      chip.writes = 0;
      chip.cutAt = last;
      chip.torn = first;
      EepromPlan cut(kept);
      cut.store();
      for (const MissionItem& item : after) {
        for (int i = 0; i < 100 && !cut.isReady(); ++i) cut.update();
        cut.put(item);
      }
      cut.commit();
      for (int i = 0; i < 10000 && cut.isBusy(); ++i) cut.update();
      EepromPlan again = afterReset(memory);
      CHECK(holds(again, after));
      chip.writes = 0;
      chip.cutAt = 1;
      chip.torn = second;
      for (int i = 0; i < 100 && again.isBusy(); ++i) again.update();
      EepromPlan then = afterReset(memory);
      CHECK(holds(then, after));
      settle(then);
      CHECK(holds(then, after));
    }
  }
}

TEST_CASE("a plan whose bytes are spoilt is none, and no older one takes its place") {
  const Items items = plan(4, 5);
  const Eeprom memory = eeprom(kSize);
  EepromPlan kept(memory);
  kept.begin();
  REQUIRE(keep(kept, plan(3, 20)));
  REQUIRE(keep(kept, items));
  const std::vector<uint8_t> good = chip.bytes;
  uint16_t spoilt = 0;
  for (uint16_t address = 0; address < kSize; ++address) {
    for (uint8_t flip : {0x01, 0x80, 0xFF}) {
      chip.bytes = good;
      chip.bytes[address] ^= flip;
      EepromPlan again = afterReset(memory);
      if (again.hasPlan()) {
        CHECK(holds(again, items));  // a byte that is not the plan's
      } else {
        ++spoilt;
      }
    }
  }
  CHECK(spoilt >= 3 * (6 + 4 * 16));
}

TEST_CASE("a plan with more items than there is room for is refused, and the old one stays") {
  const Eeprom memory = eeprom(kSize);
  EepromPlan kept(memory);
  kept.begin();
  const Items old = plan(2, 9);
  REQUIRE(keep(kept, old));
  CHECK(kept.room() == kSize / 2 - 6);
  Items tooLong;
  const MissionItem of16Bytes = waypoint(1_deg, 2_deg, 3_m, Seconds(0), Metres(0), 0_deg);
  for (uint16_t bytes = 0; bytes <= kept.room(); bytes += 16) tooLong.push_back(of16Bytes);
  CHECK_FALSE(keep(kept, tooLong));
  CHECK(kept.state() == EepromPlan::State::Failed);
  CHECK_FALSE(kept.commit());
  CHECK(holds(kept, old));
  tooLong.pop_back();
  REQUIRE(keep(kept, tooLong));
  CHECK(holds(kept, tooLong));
  EepromPlan again = afterReset(memory);
  CHECK(holds(again, tooLong));
}

TEST_CASE("a Mega's EEPROM keeps 127 waypoints of a file, an Uno's 31") {
  const MissionItem ofAFile = waypoint(-35.3632621_deg, 149.1652374_deg, 20_m, Seconds(0), Metres(0), 0_deg);
  struct Board {
    uint16_t bytes, items;
  };
  for (const Board& board : {Board{4096, 127}, Board{1024, 31}}) {
    EepromPlan kept(eeprom(board.bytes));
    kept.begin();
    CHECK_FALSE(keep(kept, Items(board.items + 1u, ofAFile)));
    CHECK(keep(kept, Items(board.items, ofAFile)));
  }
}

TEST_CASE("a byte that does not keep what it is given is found before the plan is exchanged") {
  const Items old = plan(3, 20);
  const Items items = plan(5, 70);
  uint16_t found = 0;
  for (uint16_t address = kSize / 2; address < kSize / 2 + 100; ++address) {
    const Eeprom memory = eeprom(kSize);
    EepromPlan kept(memory);
    kept.begin();
    REQUIRE(keep(kept, old));
    chip.stuckAt = address;
    // A stuck byte is written again and again, but not without end.
    kept.store();
    bool isTaken = true;
    for (const MissionItem& item : items) {
      for (int i = 0; i < 100 && !kept.isReady(); ++i) kept.update();
      isTaken = isTaken && kept.put(item);
    }
    CHECK(kept.commit() == isTaken);
    settle(kept);
    const bool isKept = kept.state() == EepromPlan::State::Resting;
    CHECK((isKept || kept.state() == EepromPlan::State::Failed));
    if (!isKept) ++found;
    CHECK((isKept ? holds(kept, items) : holds(kept, old)));
    EepromPlan again = afterReset(memory);
    CHECK((isKept ? holds(again, items) : holds(again, old)));
  }
  CHECK(found > 90);
}

TEST_CASE("a plan is stored beside a bank whose mark is worn out, as often as one likes, and can be erased") {
  for (const uint16_t mark : {0, kSize / 2}) {
    CAPTURE(mark);
    const Eeprom memory = eeprom(kSize);
    EepromPlan kept(memory);
    kept.begin();
    if (mark != 0) REQUIRE(keep(kept, plan(1, 9)));
    REQUIRE(keep(kept, plan(3, 20)));
    chip.stuckAt = mark;
    for (int32_t i = 1; i <= 4; ++i) {
      CHECK(keep(kept, plan(2, i)));
      CHECK(holds(kept, plan(2, i)));
      EepromPlan again = afterReset(memory);
      CHECK_FALSE(again.isBusy());
      CHECK(holds(again, plan(2, i)));
    }
    CHECK(kept.erase());
    settle(kept);
    CHECK(kept.state() == EepromPlan::State::Resting);
    CHECK_FALSE(kept.hasPlan());
    CHECK_FALSE(afterReset(memory).hasPlan());
  }
  const auto store = [](EepromPlan& kept) { keep(kept, plan(2, 7)); };
  cutEverywhere(plan(2, 5), plan(3, 6), plan(2, 7), store, 0);
}

TEST_CASE("a new plan counts though the old one can be made invalid by no byte, and the next is not stored") {
  const Eeprom memory = eeprom(kSize);
  EepromPlan kept(memory);
  kept.begin();
  REQUIRE(keep(kept, plan(3, 20)));
  chip.stuckAt = 0;
  chip.stuckToo = 4;
  CHECK(keep(kept, plan(2, 1)));
  for (int i = 0; i < 2; ++i) {
    EepromPlan again = afterReset(memory);
    settle(again);
    CHECK(holds(again, plan(2, 1)));
    CHECK(again.store());
    for (int j = 0; j < 100; ++j) update(again);
    CHECK(again.state() == EepromPlan::State::Failed);
    CHECK(holds(again, plan(2, 1)));
  }
}

TEST_CASE("nothing is written while the last byte is being written, and a plan is stored by a byte each time") {
  const Eeprom memory = eeprom(kSize);
  EepromPlan kept(memory);
  kept.begin();
  REQUIRE(keep(kept, plan(3, 20)));
  REQUIRE(kept.store());
  chip.isReady = false;
  chip.reads = 0;
  for (int i = 0; i < 50; ++i) kept.update();
  CHECK(chip.reads == 0);
  chip.isReady = true;
  CHECK_FALSE(kept.put(plan(1, 1)[0]));  // the bank is still to be made invalid
  update(kept);
  update(kept);
  CHECK(kept.put(plan(1, 1)[0]));
  CHECK_FALSE(kept.put(plan(1, 1)[0]));
  CHECK(kept.stored() == 1);
}

TEST_CASE("the same plan again wears out three bytes, and no byte is written twice for a plan") {
  const Eeprom memory = eeprom(kSize);
  EepromPlan kept(memory);
  kept.begin();
  const Items items = plan(5, 7);
  REQUIRE(keep(kept, items));
  REQUIRE(keep(kept, items));
  chip.wear.assign(kSize, 0);
  REQUIRE(keep(kept, items));
  uint32_t total = 0;
  uint32_t most = 0;
  for (uint32_t one : chip.wear) {
    total += one;
    if (one > most) most = one;
  }
  CHECK(most == 1);
  CHECK(total <= 6);  // both marks, the sequence, the checksum
}

TEST_CASE("another plan is begun, erased or committed only when it may be") {
  const Eeprom memory = eeprom(kSize);
  EepromPlan kept(memory);
  kept.begin();
  CHECK_FALSE(kept.commit());
  REQUIRE(kept.store());
  CHECK_FALSE(kept.commit());  // an empty plan is no plan
  const Items items = plan(2, 3);
  REQUIRE(keep(kept, items));
  REQUIRE(kept.store());
  for (int i = 0; i < 10; ++i) kept.update();
  REQUIRE(kept.put(plan(1, 1)[0]));
  REQUIRE(kept.store());  // begins anew
  CHECK(kept.stored() == 0);
  for (int i = 0; i < 100; ++i) kept.update();
  REQUIRE(kept.put(items[0]));
  REQUIRE(kept.commit());
  CHECK_FALSE(kept.store());
  CHECK_FALSE(kept.erase());
  CHECK_FALSE(kept.put(items[0]));
  settle(kept);
  CHECK(holds(kept, Items(items.begin(), items.begin() + 1)));
}

TEST_CASE("a sink takes a download's items as it can, and leaves out home") {
  const Eeprom memory = eeprom(kSize);
  EepromPlan kept(memory);
  kept.begin();
  const Items items = plan(4, 8);
  const ItemSink sink = kept.sink();
  CHECK(sink.write(sink.context, kHomeIndex, items[0]));
  for (uint16_t i = 0; i < items.size(); ++i) {
    uint16_t waited = 0;
    while (!sink.isReady(sink.context)) {
      update(kept);
      REQUIRE(++waited < 100);
    }
    CHECK(sink.write(sink.context, i, items[i]));
  }
  CHECK_FALSE(kept.hasPlan());
  REQUIRE(kept.commit());
  settle(kept);
  CHECK(holds(kept, items));
}

TEST_CASE("a source gives the plan that was there when it was taken, or nothing") {
  for (const char* changes : {"s", "es"}) {
    EepromPlan kept(eeprom(kSize));
    kept.begin();
    REQUIRE(keep(kept, plan(2, 1)));
    const ItemSource old = kept.source();
    for (const char* change = changes; *change != '\0'; ++change) {
      if (*change == 's') REQUIRE(keep(kept, plan(3, 2)));
      if (*change == 'e') kept.erase();
      settle(kept);
      MissionItem item;
      CHECK_FALSE(old.read(old.context, 0, item));
      if (*change == 's') CHECK(holds(kept, plan(3, 2)));
    }
  }
}

TEST_CASE("the sequence of plans goes round") {
  const Eeprom memory = eeprom(kSize);
  EepromPlan kept(memory);
  kept.begin();
  for (int32_t round = 0; round < 600; ++round) {
    const Items items = plan(1, round);
    REQUIRE(keep(kept, items));
    EepromPlan again = afterReset(memory);
    REQUIRE(holds(again, items));
  }
}

TEST_CASE("a plan keeps to its part of the EEPROM") {
  const Eeprom memory = eeprom(kSize);
  EepromPlan kept(memory, 100, 200);
  kept.begin();
  CHECK(kept.room() == 94);
  for (int32_t round = 0; round < 4; ++round) REQUIRE(keep(kept, plan(3, round)));
  for (uint16_t address = 0; address < kSize; ++address) {
    if (address < 100 || address >= 300) CHECK(chip.wear[address] == 0);
  }
}

// A plan of items that take 4 bytes each.
Items shortPlan(uint16_t count, uint16_t command = 20) { return Items(count, anyCommand(command)); }

TEST_CASE("a bank holds what the header says, byte by byte") {
  const Eeprom memory = eeprom(kSize);
  EepromPlan kept(memory, 100, 200);
  kept.begin();
  MissionItem item = anyCommand(0x1234, 1);
  item.current = 1;
  REQUIRE(keep(kept, Items(1, item)));
  const uint8_t bytes[] = {0, 1, 0, 0x81, 0x82, 0x34, 0x12, 0, 0, 0x80, 0x3F};
  uint16_t crc = checksum(kChecksumStart, bytes + 3, 8);
  crc = checksum(crc, bytes, 3);
  const std::vector<uint8_t> first = {
      0x4D, 0, 1,    0,   static_cast<uint8_t>(crc), static_cast<uint8_t>(crc >> 8), 0x81, 0x82, 0x34, 0x12,
      0,    0, 0x80, 0x3F};
  CHECK(std::vector<uint8_t>(&chip.bytes[100], &chip.bytes[100] + first.size()) == first);
  // The next one lies in the other half, and has the next number; the first one is invalid.
  REQUIRE(keep(kept, shortPlan(2)));
  CHECK(chip.bytes[100] == 0);
  CHECK(chip.bytes[200] == 0x4D);
  CHECK(chip.bytes[201] == 1);
  CHECK(chip.bytes[202] == 2);
  CHECK(chip.bytes[203] == 0);
  REQUIRE(keep(kept, shortPlan(3)));
  CHECK(chip.bytes[101] == 2);
  CHECK(chip.bytes[200] == 0);
}

TEST_CASE("numbers, commands and flags come back, whichever of their bytes are 0") {
  const Eeprom memory = eeprom(kSize);
  EepromPlan kept(memory);
  kept.begin();
  Items items;
  for (uint8_t byte = 0; byte < 4; ++byte) {
    MissionItem item = anyCommand(static_cast<uint16_t>(0x0101 << byte));
    item.x = 1 << 8 * byte;
    item.autocontinue = byte % 2;
    item.current = byte / 2;
    items.push_back(item);
  }
  REQUIRE(keep(kept, items));
  CHECK(holds(kept, items));
}

TEST_CASE("of two valid banks the later one counts, the other one is made invalid, and the numbers go round") {
  for (uint8_t sequence : {0, 1, 127, 128, 254, 255}) {
    CAPTURE(sequence);
    const Eeprom memory = eeprom(kSize);
    EepromPlan kept(memory);
    kept.begin();
    const Items older = plan(3, 20), newer = plan(2, 30);
    for (int32_t i = 0; i < sequence; ++i) REQUIRE(keep(kept, plan(1, i)));
    REQUIRE(keep(kept, older));
    const uint16_t old = sequence % 2 == 0 ? 0 : kSize / 2;
    CHECK(chip.bytes[old + 1] == sequence);
    REQUIRE(keep(kept, newer));
    chip.bytes[old] = 0x4D;  // as if the power had failed before that
    EepromPlan again = afterReset(memory);
    CHECK(holds(again, newer));
    CHECK(again.isBusy());
    CHECK_FALSE(again.store());
    settle(again);
    CHECK(chip.bytes[old] == 0);
    // Should the newer one be damaged, the older one does not come back.
    chip.bytes[kSize / 2 - old + 8] ^= 1;
    EepromPlan damaged = afterReset(memory);
    CHECK_FALSE(damaged.hasPlan());
    CHECK(damaged.isDamaged());
  }
}

TEST_CASE("a bank is filled to its last byte") {
  const Eeprom memory = eeprom(2 * (6 + 40));
  EepromPlan kept(memory);
  kept.begin();
  CHECK(kept.room() == 40);
  CHECK_FALSE(keep(kept, shortPlan(11)));
  REQUIRE(keep(kept, shortPlan(10)));
  CHECK(holds(kept, shortPlan(10)));
  EepromPlan again = afterReset(memory);
  CHECK(holds(again, shortPlan(10)));
}

TEST_CASE("more than 255 items are kept") {
  const Eeprom memory = eeprom(4096);
  EepromPlan kept(memory);
  kept.begin();
  REQUIRE(keep(kept, shortPlan(400)));
  EepromPlan again = afterReset(memory);
  CHECK(again.count() == 400);
  CHECK(holds(again, shortPlan(400)));
}

TEST_CASE("a number of items that does not fit into the bank is a damaged plan, whatever the other bytes are") {
  const Eeprom memory = eeprom(kSize);
  chip.bytes.assign(kSize, 0);
  const uint8_t header[] = {0x4D, 0, 0xF0, 0xFF, 0x00, 0xFF, 0x00};
  memcpy(chip.bytes.data(), header, sizeof(header));
  EepromPlan kept(memory);
  kept.begin();
  CHECK_FALSE(kept.hasPlan());
  CHECK(kept.isDamaged());
}

TEST_CASE("a damaged plan is told in whichever bank it lies, until it is erased or another one is stored") {
  for (uint16_t bank : {0, 1}) {
    for (bool isErased : {true, false}) {
      const Eeprom memory = eeprom(kSize);
      EepromPlan kept(memory);
      kept.begin();
      CHECK_FALSE(kept.isDamaged());
      for (uint16_t i = 0; i <= bank; ++i) REQUIRE(keep(kept, plan(2, i)));
      chip.bytes[bank * kSize / 2 + 8] ^= 1;
      EepromPlan again = afterReset(memory);
      CHECK_FALSE(again.hasPlan());
      CHECK(again.isDamaged());
      if (isErased) {
        REQUIRE(again.erase());
        settle(again);
        CHECK(again.state() == EepromPlan::State::Resting);
      } else {
        REQUIRE(keep(again, plan(2, 5)));
      }
      CHECK_FALSE(again.isDamaged());
      EepromPlan last = afterReset(memory);
      CHECK_FALSE(last.isDamaged());
      CHECK(last.hasPlan() == !isErased);
    }
  }
}

TEST_CASE("an erased plan is gone after a reset, in whichever bank it was") {
  for (uint16_t plans : {1, 2, 3}) {
    const Eeprom memory = eeprom(kSize);
    EepromPlan kept(memory);
    kept.begin();
    for (uint16_t i = 0; i < plans; ++i) REQUIRE(keep(kept, plan(2, i)));
    REQUIRE(kept.erase());
    settle(kept);
    CHECK_FALSE(kept.hasPlan());
    CHECK(kept.count() == 0);
    EepromPlan again = afterReset(memory);
    CHECK_FALSE(again.hasPlan());
    CHECK_FALSE(again.isDamaged());
  }
}

TEST_CASE("before begin() there is no plan, and begin() drops a plan that is being stored") {
  const Eeprom memory = eeprom(kSize);
  EepromPlan kept(memory);
  CHECK_FALSE(kept.hasPlan());
  CHECK_FALSE(kept.isDamaged());
  CHECK(kept.count() == 0);
  CHECK(kept.stored() == 0);
  kept.begin();
  const Items items = plan(2, 3);
  REQUIRE(keep(kept, items));
  CHECK(kept.sink().limit == 65534);
  for (int i = 0; i < 10; ++i) update(kept);
  REQUIRE(kept.put(items[0]));
  kept.begin();
  CHECK(kept.state() == EepromPlan::State::Resting);
  CHECK(holds(kept, items));
}

TEST_CASE("what has failed stays so, and writes no more") {
  const Eeprom memory = eeprom(2 * (6 + 40));
  EepromPlan kept(memory);
  kept.begin();
  CHECK_FALSE(keep(kept, shortPlan(11)));
  chip.writes = 0;
  for (int i = 0; i < 100; ++i) CHECK(update(kept) == EepromPlan::State::Failed);
  CHECK(chip.writes == 0);
}
