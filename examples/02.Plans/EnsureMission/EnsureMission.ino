// Safe to run at each power-on: uploads the plan only if it is not aboard already, and prints which of the two
// happened. If the board is reset in flight, the sketch changes nothing. While it waits, it prints every 5 s what is
// missing; the example LinkDoctor finds out more.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr MissionItem plan[] PROGMEM = {
    takeoff(20_m),
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
    waypoint(-35.3614500_deg, 149.1652374_deg, 25.5_m),
    returnToLaunch(),
};

constexpr uint32_t kPauseMs = 5000;  // before a retry, and between two messages about what is missing

MissionClient autopilot(TELEM);
uint32_t failedAtMs, saidAtMs;
uint32_t bytesBefore;
bool tryAgain;

void report(Status status) {
  CONSOLE.println(toString(status));
  CONSOLE.print(F("aboard: "));
  CONSOLE.println(toString(autopilot.aboard()));
}

void sayWhatIsMissing() {
  const uint32_t bytes = autopilot.counters().bytes;
  if (bytes == bytesBefore) {
    CONSOLE.println(F("no bytes come: look at the wire from its TX to our RX, and at GND"));
  } else if (!autopilot.hasAutopilot()) {
    CONSOLE.println(F("bytes, but no autopilot: look at the baud rate, and at the port's protocol"));
  } else {
    CONSOLE.println(F("waiting: if this stays, look at the wire from our TX to its RX"));
  }
  bytesBefore = bytes;
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  autopilot.ensure(inFlash(plan));
}

void loop() {
  const Status status = autopilot.update();
  if (autopilot.isBusy() && millis() - saidAtMs >= kPauseMs) {
    saidAtMs = millis();
    sayWhatIsMissing();
  }
  if (isEnd(status)) {
    report(status);
    failedAtMs = saidAtMs = millis();
    tryAgain = isWorthRetry(status);
  }
  if (tryAgain && millis() - failedAtMs >= kPauseMs) {
    tryAgain = false;
    autopilot.ensure(inFlash(plan));
  }
}
