// Uploads a plan and prints on the serial monitor (115200 baud) the progress, the result, which plan is aboard, and the
// counters that show a wiring fault. If the failure may be temporary, it retries. While the aircraft is armed, the
// upload is refused.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr MissionItem plan[] PROGMEM = {
    takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
    delay(5_s),    waypoint(-35.3614500_deg, 149.1652374_deg, 25.5_m),
    jump(1, 2),    returnToLaunch(),
};

constexpr uint32_t kPauseMs = 5000;  // before a retry
constexpr uint8_t kMaxTries = 5;

MissionClient autopilot(TELEM);
uint32_t failedAtMs;
uint8_t tries;
bool tryAgain;

void onProgress(void*, uint16_t done, uint16_t total) {
  if (!CONSOLE) return;
  CONSOLE.print(done);
  CONSOLE.print('/');
  CONSOLE.println(total);
}

void printCounters() {
  const LinkCounters counters = autopilot.counters();
  CONSOLE.print(F("bytes "));
  CONSOLE.print(counters.bytes);
  CONSOLE.print(F(", frames "));
  CONSOLE.print(counters.frames + counters.unknownMessages);
  CONSOLE.print(F(", bad checksums "));
  CONSOLE.print(counters.badChecksums);
  CONSOLE.print(F(", frames lost "));
  CONSOLE.print(counters.framesLost);
  CONSOLE.print(F(", bytes that are no frame "));
  CONSOLE.println(counters.bytesSkipped);
}

void report(Status status) {
  if (!CONSOLE) return;
  CONSOLE.println(toString(status));
  CONSOLE.print(F("aboard: "));
  CONSOLE.println(toString(autopilot.aboard()));
  if (autopilot.failedItem() != MissionClient::kNoItem) {
    CONSOLE.print(F("item "));
    CONSOLE.println(autopilot.failedItem());
  }
  printCounters();
}

void start() {
  ++tries;
  tryAgain = false;
  autopilot.upload(inFlash(plan));
  if (!CONSOLE) return;
  CONSOLE.print(F("upload, try "));
  CONSOLE.println(tries);
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  autopilot.onProgress(onProgress);
  autopilot.retryWhenBusy(60);
  start();
}

void loop() {
  const Status status = autopilot.update();
  if (isEnd(status)) {
    report(status);
    failedAtMs = millis();
    tryAgain = isWorthRetry(status) && tries < kMaxTries;
  }
  if (tryAgain && millis() - failedAtMs >= kPauseMs) start();
}
