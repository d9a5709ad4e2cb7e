// Pieces of work that take long by themselves, each when it is due.
#include <Arduino.h>
#include <MavMission.h>
#include <mavmission/signing/Sha256.h>
using namespace mavmission;
using namespace mavmission::detail;

EepromPlan plan;
WaypointsText text;
Sha256 sum;

char characters[160];  // the lines of a text, up to a 0
volatile uint8_t workDue;
volatile bool isGood;

extern "C" {
__attribute__((noinline)) WaypointsText::Step measured_take(char c) { return text.take(c); }
__attribute__((noinline)) void measured_begin() { plan.begin(); }
__attribute__((noinline)) void measured_block() { sum.work(Sha256::kRounds); }
}

bool takeText() {
  text.begin();
  for (const char* next = characters; *next != '\0'; ++next) {
    if (measured_take(*next) == WaypointsText::Step::Bad) return false;
  }
  return true;
}

// As many waypoints as there is room for, then what a sketch does that finds them there.
bool keepPlan() {
  MissionItem item = waypoint(-35.3632621_deg, 149.1652374_deg, 20_m);
  item.param4 = 0;  // a yaw of 0, as in a file: an unset one takes four bytes more
  plan.begin();
  plan.store();
  for (uint8_t count = 0; count != ITEMS; plan.update()) {
    if (plan.isReady() && plan.put(item)) ++count;
  }
  while (!plan.isReady()) plan.update();
  plan.commit();
  while (plan.isBusy()) plan.update();
  measured_begin();
  return plan.count() == ITEMS;
}

bool hash() {
  const uint8_t block[Sha256::kBlock] = {};
  sum.begin();
  sum.add(block, sizeof(block));
  measured_block();
  return sum.isReady();
}

void setup() {}

void loop() {
  switch (workDue) {
    case 1: isGood = takeText(); break;
    case 2: isGood = keepPlan(); break;
    case 3: isGood = hash(); break;
    default: return;
  }
  workDue = 0;
}
