// Safe to run at each power-on: puts the plan aboard only if it is not there already, and prints which of the two it
// was. If the board is reset in flight, it only looks, and changes nothing.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr MissionItem plan[] PROGMEM = {
    takeoff(20_m),
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
    waypoint(-35.3614500_deg, 149.1652374_deg, 25.5_m),
    returnToLaunch(),
};

constexpr uint32_t kPauseMs = 5000;  // before a retry

MissionClient autopilot(TELEM);
uint32_t failedAtMs;
bool tryAgain;

void report(Status status) {
  CONSOLE.println(toString(status));
  CONSOLE.print(F("aboard: "));
  CONSOLE.println(toString(autopilot.aboard()));
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  autopilot.ensure(inFlash(plan));
}

void loop() {
  const Status status = autopilot.update();
  if (isEnd(status)) {
    report(status);
    failedAtMs = millis();
    tryAgain = isWorthRetry(status);
  }
  if (tryAgain && millis() - failedAtMs >= kPauseMs) {
    tryAgain = false;
    autopilot.ensure(inFlash(plan));
  }
}
