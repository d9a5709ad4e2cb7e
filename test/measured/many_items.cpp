// An upload of ITEMS waypoints that a function computes.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem first PROGMEM = waypoint(-35.3632621_deg, 149.1652374_deg, 20_m);

bool read(void*, uint16_t index, MissionItem& item) {
  memcpy_P(&item, &first, sizeof item);
  item.x += 1000L * index;
  return true;
}

MissionClient autopilot(Serial1);

void setup() {
  Serial1.begin(57600);
  autopilot.setOperationTimeout(30000);
  autopilot.upload(fromFunction(read, ITEMS));
}

void loop() { autopilot.update(); }
