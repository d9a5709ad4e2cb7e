// The same with a progress callback.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);
volatile uint16_t seen;

void progress(void*, uint16_t done, uint16_t) { seen = done; }

void setup() {
  Serial1.begin(57600);
  autopilot.onProgress(progress);
  autopilot.upload(inFlash(survey));
}
void loop() { autopilot.update(); }
