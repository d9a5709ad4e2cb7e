// Uploads a plan, proves it by reading it back, arms, flies it, and says each item that is reached; at the end it reads
// the plan once more. TAKE OFF THE PROPELLERS WHILE YOU TRY IT.
//
// Nothing happens while the aircraft is armed: an Arduino that resets in flight uploads and starts nothing.
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
    takeoff(-35.3632621_deg, 149.1652374_deg, 10_m),
    waypoint(-35.3630000_deg, 149.1652374_deg, 10_m),
    waypoint(-35.3630000_deg, 149.1655000_deg, 10_m),
    land(-35.3632621_deg, 149.1652374_deg),
};

MissionClient autopilot(TELEM);
MissionFollower mission(autopilot);

enum class Stage : uint8_t { Uploading, Starting, Flying, Reading, Done };
Stage stage = Stage::Uploading;
uint32_t refusedAtMs;
uint8_t startTries;
bool startAgain;
bool wasArmed;

void onReached(void*, uint16_t item) {
  CONSOLE.print(F("reached "));
  CONSOLE.println(item);
}

void onText(void*, uint8_t, const char* text) {
  CONSOLE.print(F("autopilot: "));
  CONSOLE.println(text);
}

bool printCommand(void*, uint16_t index, const MissionItem& item) {
  if (index == kHomeIndex) return true;
  CONSOLE.print(index);
  CONSOLE.print(F(": command "));
  CONSOLE.println(item.command);
  return true;
}

void setup() {
  CONSOLE.begin(115200);
  TELEM.begin(57600);
  mission.onReached(onReached);
  mission.onText(onText);
  autopilot.upload(inFlash(plan), Verified);
}

void start() {
  startAgain = false;
  ++startTries;
  autopilot.start();
}

void onEnded(Status status) {
  CONSOLE.println(toString(status));
  switch (stage) {
    case Stage::Uploading:
      if (status != Status::Accepted) break;
      stage = Stage::Starting;
      start();
      return;
    case Stage::Starting:
      if (status == Status::Done) {
        stage = Stage::Flying;
        return;
      }
      // Arming is refused for half a minute after an autopilot starts; it says why in words.
      startAgain = startTries < 10;
      refusedAtMs = millis();
      if (startAgain) return;
      break;
    case Stage::Flying:  // an accepted plan may be found infeasible later
    case Stage::Reading:
    case Stage::Done:
      break;
  }
  stage = Stage::Done;
}

void loop() {
  const Status status = autopilot.update();
  if (isEnd(status)) onEnded(status);
  if (startAgain && millis() - refusedAtMs >= 5000) start();
  if (stage != Stage::Flying) return;
  // An autopilot disarms when it has landed; not every one says of a landing that it was reached.
  if (autopilot.isArmed()) {
    wasArmed = true;
  } else if (wasArmed) {
    CONSOLE.println(F("landed"));
    stage = Stage::Reading;
    autopilot.download(toFunction(printCommand));
  }
}
