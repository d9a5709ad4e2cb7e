// A button that starts the mission. At power-on the plan is uploaded; if the button is then held for two seconds, the
// aircraft arms and flies the plan. The sketch prints how the upload and the start ended, and the autopilot's messages.
// TAKE OFF THE PROPELLERS WHILE YOU TRY IT.
//
// A button that is stuck, or pressed at power-on, starts nothing: it has to be released first. After a reset in flight
// nothing is uploaded or started: both are refused while the aircraft is armed.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr uint8_t kButton = 2;  // the button joins this pin to GND
constexpr uint32_t kHoldMs = 2000;

constexpr MissionItem plan[] PROGMEM = {
    takeoff(-35.3632621_deg, 149.1652374_deg, 10_m),
    waypoint(-35.3630000_deg, 149.1652374_deg, 10_m),
    land(-35.3632621_deg, 149.1652374_deg),
};

MissionClient autopilot(TELEM);
MissionFollower mission(autopilot);
bool wasReleased;
uint32_t releasedAtMs;

// True once, when the button has been held long enough.
bool isHeld() {
  if (digitalRead(kButton) == HIGH) {
    wasReleased = true;
    releasedAtMs = millis();
    return false;
  }
  if (!wasReleased || millis() - releasedAtMs < kHoldMs) return false;
  wasReleased = false;
  return true;
}

void onText(void*, uint8_t, const char* text) {
  CONSOLE.print(F("autopilot: "));
  CONSOLE.println(text);
}

void setup() {
  pinMode(kButton, INPUT_PULLUP);
  CONSOLE.begin(115200);
  beginTelem(57600);
  mission.onText(onText);
  autopilot.upload(inFlash(plan));
}

void loop() {
  const Status status = autopilot.update();
  if (isEnd(status)) CONSOLE.println(toString(status));
  if (!isHeld()) return;
  CONSOLE.println(F("start"));
  if (autopilot.start() == Status::Busy) CONSOLE.println(toString(Status::Busy));
}
