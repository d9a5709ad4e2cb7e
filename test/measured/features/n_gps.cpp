// The upload with a GpsListener.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);
GpsListener gps(autopilot, 500);
volatile int32_t seen;

void setup() {
  Serial1.begin(57600);
  autopilot.upload(inFlash(survey));
}
void loop() {
  autopilot.update();
  if (gps.isNew()) seen = gps.satellites();
}
