// The upload with a verification behind it.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);

void setup() {
  Serial1.begin(57600);
  autopilot.upload(inFlash(survey));
}
void loop() {
  if (autopilot.update() == Status::Accepted) autopilot.verify(inFlash(survey));
}
