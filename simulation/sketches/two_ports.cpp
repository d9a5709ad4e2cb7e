// Two clients, each with an autopilot of its own on a port of its own: both put a plan aboard and read it back, at
// once.
#include <Arduino.h>
#include <MavMission.h>

using namespace mavmission;

constexpr MissionItem firstPlan[] PROGMEM = {
    takeoff(20_m),
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
    waypoint(-35.3614500_deg, 149.1652374_deg, 20_m),
    returnToLaunch(),
};
constexpr MissionItem secondPlan[] PROGMEM = {
    waypoint(47.3977420_deg, 8.5455970_deg, 30_m),
    waypoint(47.3979420_deg, 8.5455970_deg, 31_m),
    land(47.3979420_deg, 8.5455970_deg),
};

MissionClient first(Serial1);
MissionClient second(Serial2);
MissionFollower firstFollower(first);
MissionFollower secondFollower(second);

static void onEnd(void* name, Status status) {
  Serial.print(static_cast<const char*>(name));
  Serial.print(' ');
  Serial.println(toString(status));
}

static char firstName[] = "first", secondName[] = "second";

void setup() {
  Serial.begin(500000);
  Serial1.begin(57600);
  Serial2.begin(57600);
  first.onEnd(onEnd, firstName);
  second.onEnd(onEnd, secondName);
  first.upload(inFlash(firstPlan), Readback::Always);
  second.upload(inFlash(secondPlan), Readback::Always);
}

void loop() {
  first.update();
  second.update();
}
