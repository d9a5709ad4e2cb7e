// The upload with an AttitudeListener.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);
AttitudeListener attitude(autopilot, 500);
volatile int32_t seen;

void setup() {
  Serial1.begin(57600);
  autopilot.upload(inFlash(survey));
}
void loop() {
  autopilot.update();
  if (attitude.isNew()) seen = attitude.roll().e7();
}
