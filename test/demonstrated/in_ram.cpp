// A plan in RAM that the sketch changes before it uploads it.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

MissionItem route[] = {
    takeoff(20_m),
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
};

MissionClient autopilot(Serial1);

void setup() {
  Serial1.begin(57600);
  route[1].x += 12345;
  autopilot.upload(inRam(route));
}

void loop() { autopilot.update(); }
