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
  if (!CONSOLE) return;
  CONSOLE.println(toString(status));
  if (status == Status::NoAnswer) CONSOLE.println(F("if this stays, look at the wire from our TX to its RX"));
  CONSOLE.print(F("aboard: "));
  CONSOLE.println(toString(autopilot.aboard()));
}

void sayWhatIsMissing() {
  const LinkCounters counters = autopilot.counters();
  const bool isSilent = counters.bytes == bytesBefore;
  bytesBefore = counters.bytes;
  if (!CONSOLE) return;
  if (isSilent) {
    CONSOLE.println(F("no bytes come: look at the wire from its TX to our RX, and at GND"));
  } else if (counters.frames == 0) {
    CONSOLE.println(F("bytes, but no autopilot: look at the baud rate, and at the port's protocol"));
  } else {
    CONSOLE.print(toString(autopilot.status()));
    CONSOLE.print(F(", items done: "));
    CONSOLE.println(autopilot.itemsDone());
  }
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
