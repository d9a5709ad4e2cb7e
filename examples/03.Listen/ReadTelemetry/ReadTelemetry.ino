// Prints the aircraft's position, battery and GPS every second. There are AttitudeListener, RcListener and
// HomeListener, too; only the listeners that a sketch declares take flash and RAM.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

MissionClient autopilot(TELEM);
PositionListener position(autopilot, 1000);  // requested every 1000 ms
BatteryListener battery(autopilot, 5000);
GpsListener gps(autopilot, 5000);

void printPosition() {
  CONSOLE.print(position.place().latitude.e7());
  CONSOLE.print(' ');
  CONSOLE.print(position.place().longitude.e7());
  CONSOLE.print(F(" (1e-7 deg), "));
  if (position.hasHeights()) {
    CONSOLE.print(position.aboveHomeMm() / 1000);
    CONSOLE.print(F(" m above home, "));
  }
  CONSOLE.print(position.speedCmS());
  CONSOLE.println(F(" cm/s"));
}

void printBattery() {
  if (battery.hasVoltage()) {
    CONSOLE.print(battery.voltageMv());
    CONSOLE.print(F(" mV, "));
  }
  if (battery.hasRemaining()) {
    CONSOLE.print(battery.remainingPercent());
    CONSOLE.println(F(" % left"));
  } else {
    CONSOLE.println(F("how much is left is not measured"));
  }
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
}

void loop() {
  autopilot.update();
  if (position.isNew() && position.hasPlace() && CONSOLE) printPosition();
  if (battery.isNew() && CONSOLE) printBattery();
  if (gps.isNew() && CONSOLE) {
    CONSOLE.print(gps.hasFix() ? F("fix") : F("no fix yet"));
    if (gps.hasSatellites()) {
      CONSOLE.print(F(", satellites: "));
      CONSOLE.print(gps.satellites());
    }
    CONSOLE.println();
  }
}
