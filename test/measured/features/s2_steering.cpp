// A client with a Steering: takeOff(), goTo(), hasArrived(), returnHome().
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

MissionClient autopilot(Serial1);
Steering steering(autopilot);

void setup() {
  Serial1.begin(57600);
  steering.takeOff(20_m);
}
void loop() {
  if (autopilot.update() == Status::Done) steering.goTo(LatLon{-35.3630000_deg, 149.1652374_deg}, 20_m);
  if (steering.hasArrived()) steering.returnHome();
}
