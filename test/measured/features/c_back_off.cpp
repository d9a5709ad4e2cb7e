// The upload with retryWhenBusy().
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);

void setup() {
  Serial1.begin(57600);
  autopilot.retryWhenBusy(60);
  autopilot.upload(inFlash(survey));
}
void loop() { autopilot.update(); }
