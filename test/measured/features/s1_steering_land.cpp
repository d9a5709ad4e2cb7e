// A client with a Steering that calls landNow() and no more.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

MissionClient autopilot(Serial1);
Steering steering(autopilot);

void setup() {
  Serial1.begin(57600);
  steering.landNow();
}
void loop() { autopilot.update(); }
