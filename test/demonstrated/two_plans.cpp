// Two plans, of which one is uploaded: whoever looks at the firmware cannot tell which.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem north[] PROGMEM = {waypoint(-35.36_deg, 149.16_deg, 20_m)};
constexpr MissionItem south[] PROGMEM = {waypoint(-35.37_deg, 149.16_deg, 20_m)};

MissionClient autopilot(Serial1);

void setup() {
  Serial1.begin(57600);
  autopilot.upload(analogRead(0) > 2000 ? inFlash(south) : inFlash(north));
}

void loop() { autopilot.update(); }
