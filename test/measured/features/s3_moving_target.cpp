// A client with a Steering and a MovingTarget: start(), renew(), stop().
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

MissionClient autopilot(Serial1);
Steering steering(autopilot);
MovingTarget target(steering);

void setup() {
  Serial1.begin(57600);
  steering.takeOff(20_m);
}
void loop() {
  target.update();
  const LatLon place = {Degrees::fromE7(-353630000 + analogRead(0)), 149.1652374_deg};
  if (autopilot.update() == Status::Done) target.start(place, 20_m);
  if (target.renew(place, 20_m) == Status::NotRenewed) target.stop();
  if (steering.hasArrived()) steering.returnHome();
}
