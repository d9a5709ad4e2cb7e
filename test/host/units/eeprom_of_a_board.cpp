// What a sketch gives in the place of an AVR's EEPROM: the object of a board's library, with commit() or without.
#include <doctest/doctest.h>
#include <string.h>

#include <initializer_list>

#include "mavmission/storage/EepromPlan.h"
#include "mavmission/storage/EepromTimestamps.h"

using namespace mavmission;

// As on an ESP32 and a Pico: what is written stays when it has been committed.
struct InRamUntilCommit {
  uint8_t now[256], kept[256];
  int commits;
  bool fails;
  uint8_t read(int address) { return now[address]; }
  void write(int address, uint8_t value) { now[address] = value; }
  bool commit() {
    ++commits;
    if (fails) return false;
    memcpy(kept, now, sizeof(kept));
    return true;
  }
  void losePower() { memcpy(now, kept, sizeof(now)); }
};

// As on an Uno R4 and a Teensy: it stays at once.
struct AtOnce {
  uint8_t bytes[256];
  uint8_t read(int address) { return bytes[address]; }
  void write(int address, uint8_t value) { bytes[address] = value; }
};

InRamUntilCommit committed;
AtOnce direct;

namespace {

const MissionItem kItems[] = {takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m), returnToLaunch()};

void finish(EepromPlan& plan) {
  for (int i = 0; i < 1000 && plan.isBusy(); ++i) plan.update();
}

void storeAll(EepromPlan& plan) {
  REQUIRE(plan.store());
  for (const MissionItem& item : kItems) {
    for (int i = 0; i < 100 && !plan.isReady(); ++i) plan.update();
    REQUIRE(plan.put(item));
  }
  for (int i = 0; i < 100 && !plan.isReady(); ++i) plan.update();
  REQUIRE(plan.commit());
  finish(plan);
}

bool holdsAll(EepromPlan& plan) {
  plan.begin();
  if (plan.count() != 3) return false;
  const ItemSource source = plan.source();
  for (uint16_t i = 0; i < 3; ++i) {
    MissionItem item;
    if (!source.read(source.context, i, item) || item.command != kItems[i].command || item.y != kItems[i].y)
      return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a plan is committed once when it is whole, and stays when the power goes") {
  committed = InRamUntilCommit();
  EepromPlan plan(MAVMISSION_EEPROM(committed, 256));
  plan.begin();
  storeAll(plan);
  CHECK(plan.state() == EepromPlan::State::Resting);
  for (int i = 0; i < 10; ++i) plan.update();
  CHECK(committed.commits == 1);
  committed.losePower();
  EepromPlan after(MAVMISSION_EEPROM(committed, 256));
  CHECK(holdsAll(after));
  // And once more when it is exchanged, and when it is erased.
  storeAll(after);
  CHECK(committed.commits == 2);
  REQUIRE(after.erase());
  finish(after);
  CHECK(committed.commits == 3);
  committed.losePower();
  EepromPlan last(MAVMISSION_EEPROM(committed, 256));
  last.begin();
  CHECK(!last.hasPlan());
}

TEST_CASE("a plan whose commit failed is told as failed") {
  committed = InRamUntilCommit();
  committed.fails = true;
  EepromPlan plan(MAVMISSION_EEPROM(committed, 256));
  plan.begin();
  storeAll(plan);
  CHECK(plan.state() == EepromPlan::State::Failed);
}

TEST_CASE("a board whose library has no commit() keeps a plan too") {
  direct = AtOnce();
  EepromPlan plan(MAVMISSION_EEPROM(direct, 256));
  plan.begin();
  storeAll(plan);
  EepromPlan after(MAVMISSION_EEPROM(direct, 256));
  CHECK(holdsAll(after));
}

TEST_CASE("the time of signatures is the greatest that was saved, also when the power went in the middle") {
  committed = InRamUntilCommit();
  for (uint32_t time : {5u, 900u, 70000u, 70001u, 16777217u, 20000000u, 30000000u, 30000001u, 30000002u, 40000000u}) {
    EepromTimestamps store(MAVMISSION_EEPROM(committed, 256), 16);
    const uint32_t before = store.load(store.context);
    CHECK(before < time);
    CHECK(!store.save(store.context, time));  // a byte of it
    committed.losePower();
    EepromTimestamps again(MAVMISSION_EEPROM(committed, 256), 16);
    CHECK(again.load(again.context) == before);
    int calls = 0;
    while (!again.save(again.context, time)) REQUIRE(++calls < 20);
    committed.losePower();
    EepromTimestamps last(MAVMISSION_EEPROM(committed, 256), 16);
    CHECK(last.load(last.context) == time);
  }
}
