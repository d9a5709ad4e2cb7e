// Uploads a plan, reads it back, arms, flies it, and prints each item reached.
// TAKE OFF THE PROPELLERS WHILE YOU TRY IT.
//
// While the aircraft is armed, nothing is uploaded or started: so nothing happens after a reset in flight.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr MissionItem plan[] PROGMEM = {
    takeoff(-35.3632621_deg, 149.1652374_deg, 10_m),
    waypoint(-35.3630000_deg, 149.1652374_deg, 10_m),
    waypoint(-35.3630000_deg, 149.1655000_deg, 10_m),
    land(-35.3632621_deg, 149.1652374_deg),
};

MissionClient autopilot(TELEM);
MissionFollower mission(autopilot);

enum class Stage : uint8_t { Uploading, Starting, Flying, Done };
Stage stage = Stage::Uploading;
uint32_t refusedAtMs;
uint8_t startTries;
bool startAgain;
bool saysComplete;     // the text that a rover sends at the end of its mission has come
uint32_t notOverAtMs;  // when the mission was last known to be under way

void onReached(void*, uint16_t item) {
  CONSOLE.print(F("reached "));
  CONSOLE.println(item);
}

void onText(void*, uint8_t, const char* text) {
  CONSOLE.print(F("autopilot: "));
  CONSOLE.println(text);
  if (strcmp_P(text, PSTR("Mission Complete")) == 0) saysComplete = true;
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  mission.onReached(onReached);
  mission.onText(onText);
  autopilot.upload(inFlash(plan), Readback::Always);
}

void start() {
  startAgain = false;
  saysComplete = false;
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
      if (autopilot.startArming() == StartArming::Disarmed) {
        CONSOLE.println(F("the mission could not begin: disarmed again"));
      }
      // For half a minute after power-on an autopilot refuses to arm, and says why in words. If the aircraft stays
      // armed, it flies, or somebody else is in control: leave it to the pilot.
      startAgain = startTries < 10 && autopilot.startArming() != StartArming::Armed;
      refusedAtMs = millis();
      if (startAgain) return;
      break;
    case Stage::Flying:  // PX4 may find an accepted plan infeasible later
    case Stage::Done: break;
  }
  stage = Stage::Done;
}

void loop() {
  const Status status = autopilot.update();
  if (isEnd(status)) onEnded(status);
  if (startAgain && millis() - refusedAtMs >= 5000) start();
  if (stage != Stage::Flying) return;
  // Copter and PX4 disarm when they have landed at the end of the mission. A rover stays armed, and in AUTO.
  const bool isOver = saysComplete || mission.state() == MissionState::Complete;
  if (!isOver) notOverAtMs = millis();
  if (!autopilot.hasAutopilot()) return;  // no heartbeat has come for a while
  if (!autopilot.isArmed()) {
    CONSOLE.println(F("landed"));
    stage = Stage::Done;
  } else if (millis() - notOverAtMs >= 5000) {
    CONSOLE.println(F("arrived: disarm"));
    stage = Stage::Done;
    autopilot.disarm();
  }
}
