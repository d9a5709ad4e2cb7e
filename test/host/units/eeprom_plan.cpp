#include "mavmission/storage/EepromPlan.h"

#include <doctest/doctest.h>
#include <string.h>

#include <string>
#include <vector>

#include "Script.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

constexpr uint16_t kSize = 400;
constexpr uint8_t kHeader = 6;

// What a byte holds whose writing the power cut short, of the old value and the new one.
typedef uint8_t (*Torn)(uint8_t, uint8_t);
const Torn kTorn[] = {[](uint8_t old, uint8_t) { return old; }, [](uint8_t, uint8_t value) { return value; },
                      [](uint8_t, uint8_t) { return uint8_t{0xFF}; }, [](uint8_t, uint8_t) { return uint8_t{0}; },
                      [](uint8_t old, uint8_t) { return static_cast<uint8_t>(old ^ 0x5A); }};

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

  void cut(uint32_t at, Torn how) {
    writes = 0;
    cutAt = at;
    torn = how;
  }
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
  chip.isOff = ++chip.writes == chip.cutAt;
  if (address == chip.stuckAt || address == chip.stuckToo) return;
  chip.bytes[address] = chip.isOff ? chip.torn(chip.bytes[address], value) : value;
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

// Items that differ from plan to plan, of every length. The plan of a script is the one of its number.
Items plan(uint16_t count) {
  Items items;
  for (uint16_t i = 0; i < count; ++i) {
    const Degrees place = Degrees::fromE7(count * 1000 + i + 1);
    const Metres height(static_cast<float>(count + i));
    if (i % 3 == 0) items.push_back(waypoint(place, -place, height, Seconds(1), Metres(2), 90_deg));
    if (i % 3 == 1) items.push_back(changeSpeed(MetresPerSecond(static_cast<float>(count))));
    if (i % 3 == 2) items.push_back(waypoint(place, place, aboveSeaLevel(Metres(1)), Seconds(-0.f)));
  }
  items.back().current = 1;
  items.back().autocontinue = 0;
  return items;
}

// A plan of items that take 4 bytes each.
Items shortPlan(uint16_t count) { return Items(count, anyCommand(20)); }

bool isEqual(const MissionItem& a, const MissionItem& b) {
  return memcmp(&a, &b, kPlaceBytes) == 0 && a.command == b.command && a.frame == b.frame && a.current == b.current &&
         a.autocontinue == b.autocontinue;
}

bool holds(EepromPlan& kept, const Items& items) {
  if (!kept.hasPlan() || kept.count() != items.size()) return false;
  const ItemSource source = kept.source();
  // Backwards and forwards: any item may be asked for.
  for (size_t n = 2 * items.size(); n-- != 0;) {
    const size_t i = n >= items.size() ? n - items.size() : items.size() - 1 - n;
    MissionItem item;
    if (!source.read(source.context, static_cast<uint16_t>(i), item) || !isEqual(item, items[i])) return false;
  }
  return true;
}

// The plan that is there, by its number, or "none".
std::string tells(EepromPlan& kept) {
  std::string text = "none";
  if (kept.hasPlan()) {
    text = holds(kept, plan(kept.count())) ? std::to_string(kept.count()) : "something else";
  } else {
    const ItemSource source = kept.source();
    MissionItem item;
    CHECK(kept.count() == 0);
    CHECK(source.count == 1);  // an empty plan would clear what is aboard
    CHECK_FALSE(source.read(source.context, 0, item));
  }
  if (kept.isDamaged()) text += " damaged";
  if (kept.state() == EepromPlan::State::Failed) text += " failed";
  return text;
}

// One byte at the most.
EepromPlan::State update(EepromPlan& kept) {
  const uint32_t before = chip.writes;
  const EepromPlan::State state = kept.update();
  CHECK(chip.writes - before <= 1);
  return state;
}

void settle(EepromPlan& kept) {
  for (int i = 0; i < 10000 && kept.isBusy(); ++i) update(kept);
  REQUIRE((chip.isOff || !kept.isBusy()));
}

void waitUntilReady(EepromPlan& kept) {
  for (int i = 0; i < 100 && !kept.isReady(); ++i) update(kept);
}

// A plan in an EEPROM that is new, or in a part of it.
struct Keeper {
  Eeprom memory;
  EepromPlan kept;
  uint16_t first, part;

  explicit Keeper(uint16_t size = kSize, uint16_t first = 0, uint16_t part = 0)
      : memory(eeprom(size)), kept(memory, first, part), first(first), part(part) {
    kept.begin();
  }
  bool keep(const Items& items) {
    if (!kept.store()) return false;
    for (const MissionItem& item : items) {
      waitUntilReady(kept);
      if (!kept.put(item)) return false;
    }
    if (!kept.commit()) return false;
    settle(kept);
    return kept.state() == EepromPlan::State::Resting;
  }
  void reset() {
    chip.isOff = false;
    chip.cutAt = 0;
    kept = EepromPlan(memory, first, part);
    kept.begin();
  }
  // Which plan is there after each event: stores N; erases; resets: the board begins anew, "busy" if it has to write
  // then; settles: until it is no longer. "stuck N": byte N does not change any more.
  std::string plays(const std::string& script) {
    Transcript said;
    for (const Event& event : eventsOf(script)) {
      const uint16_t number = static_cast<uint16_t>(event.number);
      if (event.is("stuck")) {
        chip.stuckAt = number;
        continue;
      }
      if (event.is("stores")) {
        const bool isKept = keep(plan(number));
        CHECK((isKept || chip.isOff || kept.state() == EepromPlan::State::Failed));
      }
      if (event.is("erases")) CHECK(kept.erase());
      if (event.is("resets")) {
        reset();
      } else {
        event.is("settles");  // as after every event but a reset
        settle(kept);
      }
      said.note(tells(kept) + (kept.isBusy() ? " busy" : ""));
    }
    return said.text();
  }
};

// What the last event leaves when the power goes at each of its writes, in each way, must be the plan from before or
// the one from after it, and stay so.
void cutEverywhere(const std::string& before, const std::string& last) {
  CAPTURE(before);
  Keeper uncut;
  uncut.plays(before + ", " + last);
  const std::string after = tells(uncut.kept);
  for (Torn torn : kTorn) {
    for (uint32_t cut = 1;; ++cut) {
      Keeper keeper;
      keeper.plays(before);
      const std::string old = tells(keeper.kept);
      chip.cut(cut, torn);
      keeper.plays(last);
      if (!chip.isOff) {
        CHECK(cut > 1);
        CHECK(cut == chip.writes + 1);  // the first cut that came too late
        CHECK(tells(keeper.kept) == after);
        break;
      }
      keeper.reset();
      const std::string found = tells(keeper.kept);
      CHECK((found == old || found == after));
      settle(keeper.kept);
      CHECK(tells(keeper.kept) == found);
      keeper.reset();
      CHECK(tells(keeper.kept) == found);
      CHECK(keeper.plays("stores 1") == "1");  // and it works on
    }
  }
}

}  // namespace

TEST_CASE("what was never written holds no plan, and gives none") {
  for (uint8_t fill : {0x00, 0xFF, 0x4D}) {
    Keeper keeper;
    chip.bytes.assign(kSize, fill);
    CHECK(keeper.plays("resets") == (fill == 0x4D ? "none damaged" : "none"));
    CHECK(chip.writes == 0);
  }
}

TEST_CASE("nothing is stored before it is known which bank holds the plan") {
  EepromPlan kept(eeprom(kSize));
  CHECK(tells(kept) == "none");
  CHECK(kept.stored() == 0);
  CHECK_FALSE(kept.store());
  CHECK_FALSE(kept.erase());
  const ItemSink sink = kept.sink();
  CHECK(sink.isReady(sink.context));
  CHECK_FALSE(sink.write(sink.context, 0, returnToLaunch()));
  for (int i = 0; i < 10; ++i) kept.update();
  CHECK(chip.writes == 0);
}

TEST_CASE("a plan that was kept is there after a reset, to the bit") {
  Keeper keeper;
  CHECK(keeper.plays("stores 1, resets, stores 2, resets, stores 3, resets, stores 4, resets") ==
        "1 (2 times), 2 (2 times), 3 (2 times), 4 (2 times)");
  CHECK(keeper.plays("stores 5, resets, stores 6, resets, stores 7, resets, stores 8, resets") ==
        "5 (2 times), 6 (2 times), 7 (2 times), 8 (2 times)");
}

TEST_CASE("the power may go at any byte: the old plan or the new one is there, whole") {
  cutEverywhere("", "stores 5");
  cutEverywhere("stores 3", "stores 5");
  cutEverywhere("stores 7, stores 3", "stores 5");
  cutEverywhere("stores 3, stores 6", "stores 5");
  cutEverywhere("stores 5, stores 3", "stores 5");
  // Beside a bank whose mark is worn out.
  cutEverywhere("stores 4, stuck 0, stores 3", "stores 2");
}

TEST_CASE("the power may go while a plan is erased: it is there or not, and no older one comes back") {
  cutEverywhere("stores 4, stores 3", "erases");
  cutEverywhere("stores 3", "erases");
}

TEST_CASE("the power may go again while what the last cut left is put right") {
  for (Torn first : kTorn) {
    for (Torn second : kTorn) {
      Keeper keeper;
      keeper.plays("stores 3");
      chip.writes = 0;
      keeper.plays("stores 2");
      const uint32_t last = chip.writes;  // by which the old plan was made invalid
      keeper.plays("stores 3");
      chip.cut(last, first);
      keeper.plays("stores 2");
      keeper.reset();
      CHECK(tells(keeper.kept) == "2");
      chip.cut(1, second);
      settle(keeper.kept);
      keeper.reset();
      CHECK(tells(keeper.kept) == "2");
      settle(keeper.kept);
      CHECK(tells(keeper.kept) == "2");
    }
  }
}

TEST_CASE("a plan whose bytes are spoilt is none, and no older one takes its place") {
  Keeper keeper;
  keeper.plays("stores 3, stores 4");
  const std::vector<uint8_t> good = chip.bytes;
  uint16_t spoilt = 0;
  for (uint16_t address = 0; address < kSize; ++address) {
    for (uint8_t flip : {0x01, 0x80, 0xFF}) {
      chip.bytes = good;
      chip.bytes[address] ^= flip;
      keeper.reset();
      if (keeper.kept.hasPlan()) {
        CHECK(holds(keeper.kept, plan(4)));  // a byte that is not the plan's
      } else {
        ++spoilt;
      }
    }
  }
  CHECK(spoilt >= 3 * (kHeader + 4 * 16));
}

TEST_CASE("a plan with more items than there is room for is refused, and the old one stays") {
  Keeper keeper;
  keeper.plays("stores 2");
  CHECK(keeper.kept.room() == kSize / 2 - kHeader);
  const MissionItem of16Bytes = waypoint(1_deg, 2_deg, 3_m, Seconds(0), Metres(0), 0_deg);
  const Items fits(keeper.kept.room() / 16u, of16Bytes), tooLong(keeper.kept.room() / 16u + 1, of16Bytes);
  CHECK_FALSE(keeper.keep(tooLong));
  CHECK(tells(keeper.kept) == "2 failed");
  CHECK_FALSE(keeper.kept.commit());
  chip.writes = 0;
  for (int i = 0; i < 100; ++i) CHECK(update(keeper.kept) == EepromPlan::State::Failed);
  CHECK(chip.writes == 0);  // what has failed stays so
  CHECK(keeper.keep(fits));
  keeper.reset();
  CHECK(holds(keeper.kept, fits));
}

TEST_CASE("a bank is filled to its last byte: a Mega's EEPROM keeps 127 waypoints of a file, an Uno's 31") {
  const MissionItem ofAFile = waypoint(-35.3632621_deg, 149.1652374_deg, 20_m, Seconds(0), Metres(0), 0_deg);
  const struct {
    uint16_t bytes;
    Items items;
  } kBoards[] = {{4096, Items(127, ofAFile)}, {1024, Items(31, ofAFile)}, {2 * (kHeader + 40), shortPlan(10)}};
  for (const auto& board : kBoards) {
    Keeper keeper(board.bytes);
    Items more = board.items;
    more.push_back(more[0]);
    CHECK_FALSE(keeper.keep(more));
    CHECK(keeper.keep(board.items));
    CHECK(holds(keeper.kept, board.items));
    keeper.reset();
    CHECK(holds(keeper.kept, board.items));
  }
}

TEST_CASE("a byte that does not keep what it is given is found before the plan is exchanged") {
  uint16_t found = 0;
  for (uint16_t address = kSize / 2; address < kSize / 2 + 100; ++address) {
    Keeper keeper;
    keeper.plays("stores 3");
    chip.stuckAt = address;
    // A stuck byte is written again and again, but not without end.
    const bool isFound = keeper.plays("stores 5, resets") == "3 failed, 3";
    if (isFound) ++found;
    CHECK((isFound || tells(keeper.kept) == "5"));
  }
  CHECK(found > 90);
}

TEST_CASE("a plan is stored beside a bank whose mark is worn out, as often as one likes, and can be erased") {
  for (const char* before : {"stores 3, stuck 0", "stores 1, stores 3, stuck 200"}) {
    Keeper keeper;
    keeper.plays(before);
    CHECK(keeper.plays("stores 4, resets, stores 2, resets, stores 5, resets, stores 1, resets") ==
          "4 (2 times), 2 (2 times), 5 (2 times), 1 (2 times)");
    CHECK(keeper.plays("erases, resets") == "none, none damaged");
  }
}

TEST_CASE("a new plan counts though the old one can be made invalid by no byte, and the next is not stored") {
  Keeper keeper;
  keeper.plays("stores 3, stuck 0");
  chip.stuckToo = 4;
  CHECK(keeper.plays("stores 2, resets, settles, stores 1") == "2, 2 busy, 2, 2 failed");
  CHECK(keeper.plays("resets, settles, stores 1") == "2 busy, 2, 2 failed");
}

TEST_CASE("nothing is written while the last byte is being written, and a plan is stored by a byte each time") {
  Keeper keeper;
  keeper.plays("stores 3");
  REQUIRE(keeper.kept.store());
  chip.isReady = false;
  chip.reads = 0;
  for (int i = 0; i < 50; ++i) keeper.kept.update();
  CHECK(chip.reads == 0);
  chip.isReady = true;
  const MissionItem item = plan(1)[0];
  CHECK_FALSE(keeper.kept.put(item));  // the bank is still to be made invalid
  update(keeper.kept);
  update(keeper.kept);
  CHECK(keeper.kept.put(item));
  CHECK_FALSE(keeper.kept.put(item));
  CHECK(keeper.kept.stored() == 1);
}

TEST_CASE("the same plan again wears out three bytes, and no byte is written twice for a plan") {
  Keeper keeper;
  keeper.plays("stores 5, stores 5");
  chip.wear.assign(kSize, 0);
  keeper.plays("stores 5");
  uint32_t total = 0;
  for (uint32_t one : chip.wear) {
    CHECK(one <= 1);
    total += one;
  }
  CHECK(total <= 6);  // both marks, the sequence, the checksum
}

TEST_CASE("another plan is begun, erased or committed only when it may be") {
  Keeper keeper;
  EepromPlan& kept = keeper.kept;
  CHECK_FALSE(kept.commit());
  REQUIRE(kept.store());
  CHECK_FALSE(kept.commit());  // an empty plan is no plan
  keeper.plays("stores 2");
  REQUIRE(kept.store());
  waitUntilReady(kept);
  REQUIRE(kept.put(plan(2)[1]));
  REQUIRE(kept.store());  // begins anew
  CHECK(kept.stored() == 0);
  waitUntilReady(kept);
  REQUIRE(kept.put(plan(1)[0]));
  REQUIRE(kept.commit());
  CHECK_FALSE(kept.store());
  CHECK_FALSE(kept.erase());
  CHECK_FALSE(kept.put(plan(1)[0]));
  settle(kept);
  CHECK(tells(kept) == "1");
}

TEST_CASE("begin() drops a plan that is being stored") {
  Keeper keeper;
  keeper.plays("stores 2");
  CHECK(keeper.kept.sink().limit == 65534);
  waitUntilReady(keeper.kept);
  REQUIRE(keeper.kept.put(plan(1)[0]));
  keeper.kept.begin();
  CHECK((keeper.kept.state() == EepromPlan::State::Resting));
  CHECK(tells(keeper.kept) == "2");
}

TEST_CASE("a sink takes a download's items as it can, and leaves out home") {
  Keeper keeper;
  const Items items = plan(4);
  const ItemSink sink = keeper.kept.sink();
  CHECK(sink.write(sink.context, kHomeIndex, items[0]));
  for (uint16_t i = 0; i < items.size(); ++i) {
    for (int waited = 0; waited < 100 && !sink.isReady(sink.context); ++waited) update(keeper.kept);
    CHECK(sink.write(sink.context, i, items[i]));
  }
  CHECK_FALSE(keeper.kept.hasPlan());
  REQUIRE(keeper.kept.commit());
  settle(keeper.kept);
  CHECK(tells(keeper.kept) == "4");
}

TEST_CASE("a source gives the plan that was there when it was taken, or nothing") {
  for (bool erases : {false, true}) {
    Keeper keeper;
    keeper.plays("stores 2");
    const ItemSource old = keeper.kept.source();
    MissionItem item;
    if (erases) CHECK(keeper.plays("erases") == "none");
    CHECK(old.read(old.context, 0, item) == !erases);
    CHECK(keeper.plays("stores 3") == "3");
    CHECK_FALSE(old.read(old.context, 0, item));
  }
}

TEST_CASE("the sequence of plans goes round") {
  Keeper keeper;
  for (int round = 0; round < 300; ++round) {
    REQUIRE(keeper.plays("stores 1, resets, stores 2, resets") == "1 (2 times), 2 (2 times)");
  }
}

TEST_CASE("a plan keeps to its part of the EEPROM") {
  Keeper keeper(kSize, 100, 200);
  CHECK(keeper.kept.room() == 94);
  CHECK(keeper.plays("stores 3, stores 2, stores 3, stores 1") == "3, 2, 3, 1");
  for (uint16_t address = 0; address < kSize; ++address) {
    if (address < 100 || address >= 300) CHECK(chip.wear[address] == 0);
  }
}

TEST_CASE("a bank holds what the header says, byte by byte") {
  Keeper keeper(kSize, 100, 200);
  MissionItem item = anyCommand(0x1234, 1);
  item.current = 1;
  REQUIRE(keeper.keep(Items(1, item)));
  const uint8_t bytes[] = {0, 1, 0, 0x81, 0x82, 0x34, 0x12, 0, 0, 0x80, 0x3F};
  uint16_t crc = checksum(kChecksumStart, bytes + 3, 8);
  crc = checksum(crc, bytes, 3);
  const uint8_t low = static_cast<uint8_t>(crc), high = static_cast<uint8_t>(crc >> 8);
  const std::vector<uint8_t> first = {0x4D, 0, 1, 0, low, high, 0x81, 0x82, 0x34, 0x12, 0, 0, 0x80, 0x3F};
  CHECK(std::vector<uint8_t>(&chip.bytes[100], &chip.bytes[100] + first.size()) == first);
  // The next one lies in the other half, and has the next number; the first one is invalid.
  keeper.plays("stores 2");
  CHECK(chip.bytes[100] == 0);
  const std::vector<uint8_t> second = {0x4D, 1, 2, 0};
  CHECK(std::vector<uint8_t>(&chip.bytes[200], &chip.bytes[204]) == second);
  keeper.plays("stores 3");
  CHECK(chip.bytes[101] == 2);
  CHECK(chip.bytes[200] == 0);
}

TEST_CASE("numbers, commands and flags come back, whichever of their bytes are 0") {
  Keeper keeper;
  Items items;
  for (uint8_t byte = 0; byte < 4; ++byte) {
    MissionItem item = anyCommand(static_cast<uint16_t>(0x0101 << byte));
    item.x = 1 << 8 * byte;
    item.autocontinue = byte % 2;
    item.current = byte / 2;
    items.push_back(item);
  }
  REQUIRE(keeper.keep(items));
  CHECK(holds(keeper.kept, items));
}

TEST_CASE("of two valid banks the later one counts, the other one is made invalid, and the numbers go round") {
  for (uint8_t sequence : {0, 1, 127, 128, 254, 255}) {
    CAPTURE(sequence);
    Keeper keeper;
    keeper.plays(times(sequence, "stores 1") + "stores 3");
    const uint16_t old = sequence % 2 == 0 ? 0 : kSize / 2;
    CHECK(chip.bytes[old + 1] == sequence);
    keeper.plays("stores 2");
    chip.bytes[old] = 0x4D;  // as if the power had failed before that
    CHECK(keeper.plays("resets") == "2 busy");
    CHECK_FALSE(keeper.kept.store());
    CHECK(keeper.plays("settles") == "2");
    CHECK(chip.bytes[old] == 0);
    // Should the newer one be damaged, the older one does not come back.
    chip.bytes[kSize / 2 - old + 8] ^= 1;
    CHECK(keeper.plays("resets") == "none damaged");
  }
}

TEST_CASE("more than 255 items are kept") {
  Keeper keeper(4096);
  REQUIRE(keeper.keep(shortPlan(400)));
  keeper.reset();
  CHECK(holds(keeper.kept, shortPlan(400)));
}

TEST_CASE("a number of items that does not fit into the bank is a damaged plan, whatever the other bytes are") {
  Keeper keeper;
  chip.bytes.assign(kSize, 0);
  const uint8_t header[] = {0x4D, 0, 0xF0, 0xFF, 0x00, 0xFF, 0x00};
  memcpy(chip.bytes.data(), header, sizeof(header));
  CHECK(keeper.plays("resets") == "none damaged");
}

TEST_CASE("a damaged plan is told in whichever bank it lies, until it is erased or another one is stored") {
  for (uint16_t bank : {0, 1}) {
    for (bool isErased : {true, false}) {
      Keeper keeper;
      CHECK(keeper.plays(bank == 0 ? "stores 2" : "stores 1, stores 2") == (bank == 0 ? "2" : "1, 2"));
      chip.bytes[bank * kSize / 2 + 8] ^= 1;
      CHECK(keeper.plays("resets") == "none damaged");
      CHECK(keeper.plays(isErased ? "erases, resets" : "stores 5, resets") ==
            (isErased ? "none (2 times)" : "5 (2 times)"));
    }
  }
}

TEST_CASE("an erased plan is gone after a reset, in whichever bank it was") {
  for (const char* before : {"stores 1", "stores 1, stores 2", "stores 1, stores 2, stores 3"}) {
    Keeper keeper;
    keeper.plays(before);
    CHECK(keeper.plays("erases, resets") == "none (2 times)");
  }
}
