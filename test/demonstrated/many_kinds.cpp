// A plan of what each autopilot must get differently, and a word to the console.
#include <Arduino.h>
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem tour[] PROGMEM = {
    takeoff(15_m),
    changeSpeed(5_mps),
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
    waypoint(-35.3614500_deg, 149.1652374_deg, 25.5_m, 3_s),
    jump(2, 2),
    delay(4_s),
    land(),
};

MissionClient autopilot(Serial1);

void setup() {
  Serial.begin(115200);
  Serial1.begin(57600);
  autopilot.upload(inFlash(tour));
}

void loop() {
  const Status status = autopilot.update();
  if (isEnd(status)) Serial.println(toString(status));
}
