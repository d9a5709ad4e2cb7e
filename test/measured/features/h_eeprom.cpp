// The upload of a plan that an EepromPlan keeps.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

MissionClient autopilot(Serial1);
EepromPlan plan;

void setup() {
  Serial1.begin(57600);
  plan.begin();
  autopilot.upload(plan.source());
}
void loop() { autopilot.update(); }
