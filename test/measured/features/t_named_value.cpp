// The upload with a NamedValue, sent again and again.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);
NamedValue weight("weight");

void setup() {
  Serial1.begin(57600);
  autopilot.upload(inFlash(survey));
}
void loop() {
  autopilot.update();
  if (!autopilot.isSent()) return;
  weight.set(3.25f);
  autopilot.sendMessage(weight);
}
