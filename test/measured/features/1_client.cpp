// A client that finds the autopilot and keeps the link alive.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

MissionClient autopilot(Serial1);

void setup() { Serial1.begin(57600); }
void loop() { autopilot.update(); }
