// Uploads a plan from flash by the autopilot's answer alone, uploadWithoutReadback().
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);

void setup() {
  Serial1.begin(57600);
  autopilot.uploadWithoutReadback(inFlash(survey));
}
void loop() { autopilot.update(); }
