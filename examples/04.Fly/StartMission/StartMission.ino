// Flies a plan, and says what happens: puts it aboard, waits until the autopilot is ready, arms, flies, lands.
// REMOVE THE PROPELLERS WHILE YOU TRY IT.
//
// A pilot who takes over, a failsafe, or a reset in flight ends the sketch's part: it arms and moves nothing any more.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr LatLon kStart = {-35.3632621_deg, 149.1652374_deg};

constexpr MissionItem plan[] PROGMEM = {
    takeoff(kStart, 10_m),
    waypoint(-35.3630000_deg, 149.1652374_deg, 10_m),
    waypoint(-35.3630000_deg, 149.1655000_deg, 10_m),
    land(kStart),
};

MissionClient autopilot(TELEM);
Flight flight(autopilot);

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  flight.fly(inFlash(plan));
}

void loop() {
  if (flight.update() && CONSOLE) flight.printTo(CONSOLE);
}
