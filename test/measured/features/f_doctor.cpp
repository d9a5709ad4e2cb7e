// The upload with a LinkDoctor.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);
LinkDoctor doctor(autopilot);
volatile uint8_t verdict;

void setup() {
  Serial1.begin(57600);
  autopilot.upload(inFlash(survey));
}
void loop() {
  verdict = static_cast<uint8_t>(doctor.update());
  autopilot.update();
}
