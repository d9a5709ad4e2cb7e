// The upload with a Payload.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
PayloadAnswer carryOut(void*, const PayloadCommand& command) {
  return command.id == 211 ? PayloadAnswer::Accepted : PayloadAnswer::Unsupported;
}
MissionClient autopilot(Serial1);
Payload payload(autopilot, carryOut);

void setup() {
  Serial1.begin(57600);
  autopilot.upload(inFlash(survey));
}
void loop() {
  autopilot.update();
  payload.update();
}
