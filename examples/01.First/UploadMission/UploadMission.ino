// Puts a flight plan aboard a Pixhawk.
#include <MavMission.h>
#include <MavMissionLed.h>    // showOnLed(): on the board's own LED
#include <MavMissionTelem.h>  // TELEM: this board's port to the autopilot
using namespace mavmission;

// In Australia: write your own places.
constexpr MissionItem survey[] PROGMEM = {
    takeoff(20_m),  // above home
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
    waypoint(-35.3614500_deg, 149.1652374_deg, 20_m),
    returnToLaunch(),
};

MissionClient autopilot(TELEM);

void setup() {
  beginTelem(57600);
  autopilot.upload(inFlash(survey));
}

void loop() {
  autopilot.update();
  showOnLed(autopilot.status());  // slow: the plan is aboard; fast: it failed
}
