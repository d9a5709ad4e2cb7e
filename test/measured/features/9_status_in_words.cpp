// The upload with its status printed in words.
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
  const Status status = autopilot.update();
  if (isEnd(status)) Serial1.println(toString(status));
}
