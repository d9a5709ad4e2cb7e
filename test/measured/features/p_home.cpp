// The upload with a HomeListener, which needs a longer buffer.
// -DMAVMISSION_MAX_PAYLOAD=60
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);
HomeListener home(autopilot, 5000);
volatile int32_t seen;

void setup() {
  Serial1.begin(57600);
  autopilot.upload(inFlash(survey));
}
void loop() {
  autopilot.update();
  if (home.isNew()) seen = home.aboveSeaLevelMm();
}
