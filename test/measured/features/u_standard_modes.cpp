// The upload with StandardModes: one set, one read.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);
StandardModes modes(autopilot);
volatile uint8_t seen;

void setup() {
  Serial1.begin(57600);
  autopilot.upload(inFlash(survey));
}
void loop() {
  const Status status = autopilot.update();
  if (status == Status::Accepted) modes.set(StandardMode::Mission);
  if (status == Status::Done) modes.read(1);
  seen = static_cast<uint8_t>(modes.current());
}
