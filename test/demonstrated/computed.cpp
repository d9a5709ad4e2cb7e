// A plan that a function computes: no variable holds it.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

bool row(void*, uint16_t index, MissionItem& item) {
  item = waypoint(-35.3632621_deg, 149.1652374_deg, 20_m);
  item.x += 1000L * index;
  return true;
}

MissionClient autopilot(Serial1);

void setup() {
  Serial1.begin(57600);
  autopilot.upload(fromFunction(row, 12));
}

void loop() { autopilot.update(); }
