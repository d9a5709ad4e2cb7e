// The same with offerAll(): every command.
#include <Arduino.h>
#include <MavMissionConsole.h>
using namespace mavmission;

MissionClient autopilot(Serial1);
EepromPlan plan;
PlanConsole console(Serial, autopilot, plan);

void setup() {
  Serial1.begin(57600);
  Serial.begin(115200);
  plan.begin();
  console.offerAll();
}
void loop() {
  plan.update();
  console.update();
  autopilot.update();
}
