// The upload with a verification by file behind it, PlanFiles.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);
PlanFiles files(autopilot);

void setup() {
  Serial1.begin(57600);
  autopilot.upload(inFlash(survey));
}
void loop() {
  if (autopilot.update() == Status::Accepted) files.verify(inFlash(survey));
}
