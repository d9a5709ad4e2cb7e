// Two clients, each with an autopilot and a port of its own.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient first(Serial1);
MissionClient second(Serial2);

void setup() {
  Serial1.begin(57600);
  Serial2.begin(57600);
  first.upload(inFlash(survey));
  second.upload(inFlash(survey));
}
void loop() {
  first.update();
  second.update();
}
