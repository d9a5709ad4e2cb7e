// Uploads a plan and says in words on the serial monitor (115200 baud) how it goes: progress, result, what is aboard,
// and the counters that make a wiring fault visible. Tries again after a failure that another try may mend. Nothing is
// sent while the aircraft is armed.
#include <MavMission.h>
using namespace mavmission;

#ifdef HAVE_HWSERIAL1
#define TELEM Serial1
#define CONSOLE Serial
#else
// An Uno and a Nano have one port, for the autopilot; the console is a USB-serial adapter on pin 11.
#include <SoftwareSerial.h>
SoftwareSerial console(10, 11);
#define TELEM Serial
#define CONSOLE console
#endif

constexpr MissionItem plan[] PROGMEM = {
    takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
    delay(5_s),    waypoint(-35.3614500_deg, 149.1652374_deg, 25.5_m),
    jump(1, 2),    returnToLaunch(),
};

constexpr uint32_t kPauseMs = 5000;  // before another try
constexpr uint8_t kMaxTries = 5;

MissionClient autopilot(TELEM);
uint32_t failedAtMs;
uint8_t tries;
bool tryAgain;

void onProgress(void*, uint16_t done, uint16_t total) {
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

// Whether the same upload may go well next time: not when the plan itself is at fault, or the aircraft flies.
bool mayGoWellNextTime(Status status) {
  return status == Status::Unconfirmed || status == Status::NoAnswer || status == Status::TimedOut ||
         status == Status::TookTooLong || status == Status::Error || status == Status::Denied ||
         status == Status::CancelledByAutopilot || status == Status::OtherPlanAboard;
}

void report(Status status) {
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
  CONSOLE.print(F("upload, try "));
  CONSOLE.println(tries);
  autopilot.upload(inFlash(plan));
}

void setup() {
  CONSOLE.begin(115200);
  TELEM.begin(57600);
  autopilot.onProgress(onProgress);
  autopilot.retryWhenBusy(60);
  start();
}

void loop() {
  const Status status = autopilot.update();
  if (isEnd(status)) {
    report(status);
    failedAtMs = millis();
    tryAgain = mayGoWellNextTime(status) && tries < kMaxTries;
  }
  if (tryAgain && millis() - failedAtMs >= kPauseMs) start();
}
