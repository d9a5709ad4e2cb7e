// Flies a plan each time that a button is held for two seconds. REMOVE THE PROPELLERS WHILE YOU TRY IT.
//
// A second press, a bounce or a stuck button does nothing. After a pilot, a failsafe or a reset has ended the flight,
// nothing is armed until the button is held again.
#include <MavMission.h>
#include <MavMissionButton.h>   // HoldButton
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr LatLon kStart = {-35.3632621_deg, 149.1652374_deg};

constexpr MissionItem plan[] PROGMEM = {
    takeoff(kStart, 10_m),
    waypoint(-35.3630000_deg, 149.1652374_deg, 10_m),
    land(kStart),
};

MissionClient autopilot(TELEM);
Flight flight(autopilot);
HoldButton button(2, 2000);  // joins pin 2 to GND

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
}

void loop() {
  if (flight.update() && CONSOLE) flight.printTo(CONSOLE);
  if (!button.isPressed()) return;
  flight.begin();  // a person asks for the aircraft
  flight.fly(inFlash(plan));
}
