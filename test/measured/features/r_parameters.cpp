// The upload with Parameters: one read, one set.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);
Parameters parameters(autopilot);
volatile int32_t seen;

void setup() {
  Serial1.begin(57600);
  autopilot.upload(inFlash(survey));
}
void loop() {
  const Status status = autopilot.update();
  if (status == Status::Accepted) parameters.read(F("FENCE_ENABLE"));
  if (status == Status::Done && parameters.whole() == 0) parameters.setWhole(F("FENCE_ENABLE"), 1);
  seen = parameters.whole();
}
