// The upload with a MissionFollower.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);
MissionFollower follower(autopilot);
volatile uint16_t seen;

void setup() {
  Serial1.begin(57600);
  autopilot.upload(inFlash(survey));
}
void loop() {
  autopilot.update();
  seen = follower.currentItem();
}
