// Puts a flight plan aboard a Pixhawk.
#include <MavMission.h>
using namespace mavmission;

#ifdef HAVE_HWSERIAL1
#define TELEM Serial1  // a Mega, a Leonardo: Serial stays free for the computer
#else
#define TELEM Serial  // an Uno, a Nano: the only port
#endif

constexpr MissionItem survey[] PROGMEM = {
    takeoff(20_m),  // above home
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
    waypoint(-35.3614500_deg, 149.1652374_deg, 20_m),
    returnToLaunch(),
};

MissionClient autopilot(TELEM);

void setup() {
  TELEM.begin(57600);
  autopilot.upload(inFlash(survey));
}

void loop() {
  if (autopilot.update() == Status::Accepted) {
    // The plan is aboard.
  }
}
