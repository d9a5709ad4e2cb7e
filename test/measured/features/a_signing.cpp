// The upload on a signed link.
// -DMAVMISSION_SIGNING=1
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
const uint8_t secret[32] PROGMEM = {0x8f, 0x1c};
MissionClient autopilot(Serial1);
EepromTimestamps timestamps(0);

void setup() {
  Serial1.begin(57600);
  autopilot.signWith(keyInFlash(secret), 7, timestamps);
  autopilot.upload(inFlash(survey));
}
void loop() { autopilot.update(); }
