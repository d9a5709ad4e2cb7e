// Does something at each waypoint of a mission: at the first a servo drops a sample, at the second a sensor is read.
// The mission is paused during the work, then goes on. TAKE OFF THE PROPELLERS WHILE YOU TRY IT.
//
// If the aircraft is armed when the sketch starts, nothing is sent: so after a reset in flight the autopilot flies its
// mission to the end without the Arduino. A pilot who takes control keeps it.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr MissionItem plan[] PROGMEM = {
    takeoff(-35.3632621_deg, 149.1652374_deg, 10_m),
    waypoint(-35.3630000_deg, 149.1652374_deg, 10_m),  // item 1: the servo
    waypoint(-35.3630000_deg, 149.1655000_deg, 10_m),  // item 2: the sensor
    land(-35.3632621_deg, 149.1652374_deg),
};
constexpr uint16_t kServoItem = 1, kSensorItem = 2;
constexpr uint8_t kServoPin = 9, kSensorPin = A0;
constexpr uint32_t kWorkMs = 3000;

MissionClient autopilot(TELEM);
MissionFollower mission(autopilot);
Steering steering(autopilot);

enum class Stage : uint8_t { Uploading, Starting, Flying, Holding, Working, GoingOn, Done };
Stage stage = Stage::Uploading;
constexpr uint16_t kNone = MissionClient::kNoItem;
uint16_t workItem = kNone;  // the waypoint at which there is work to do
uint32_t sinceMs;           // when the work began, or when the answer to a command was lost
bool isDue;                 // the operation of this stage has to be begun
uint8_t tries;

void enter(Stage next) {
  stage = next;
  isDue = true;
  tries = 0;
  sinceMs = millis();
}

void onReached(void*, uint16_t item) {
  CONSOLE.print(F("reached "));
  CONSOLE.println(item);
  if (stage != Stage::Flying || (item != kServoItem && item != kSensorItem)) return;
  workItem = item;
  enter(Stage::Holding);
}

void setServo(bool isOpen) { digitalWrite(kServoPin, isOpen ? HIGH : LOW); }  // or Servo::write()

void beginWork() {
  if (workItem == kServoItem) {
    CONSOLE.println(F("servo open"));
    setServo(true);
  } else {
    CONSOLE.print(F("sensor: "));
    CONSOLE.println(analogRead(kSensorPin));
  }
  enter(Stage::Working);
}

void endWork() {
  if (workItem == kServoItem) setServo(false);
  workItem = kNone;
  CONSOLE.println(F("going on"));
  enter(Stage::GoingOn);
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  pinMode(kServoPin, OUTPUT);
  mission.onReached(onReached);
  enter(Stage::Uploading);
}

// Begins the operation of this stage.
void giveOrder() {
  isDue = false;
  ++tries;
  switch (stage) {
    case Stage::Uploading: autopilot.upload(inFlash(plan)); break;
    case Stage::Starting: autopilot.start(); break;
    case Stage::Holding: steering.pause(); break;
    case Stage::GoingOn: steering.resume(); break;
    default: break;
  }
}

void onEnded(Status status) {
  if (stage == Stage::Uploading && status == Status::Accepted) return enter(Stage::Starting);
  if (status == Status::Done) {
    if (stage == Stage::Starting || stage == Stage::GoingOn) enter(Stage::Flying);
    if (stage == Stage::Holding) beginWork();
    return;
  }
  CONSOLE.println(toString(status));
  // An operation is tried again if the answer was lost; so is arming, which an autopilot refuses for half a minute
  // after power-on. If somebody else is in control, nothing is tried again.
  isDue = tries < 10 && isWorthRetry(status);
  sinceMs = millis();
  if (!isDue) stage = Stage::Done;
}

void loop() {
  const Status status = autopilot.update();
  if (isEnd(status)) onEnded(status);
  if (autopilot.isBusy()) return;
  const uint32_t elapsedMs = millis() - sinceMs;
  if (isDue && (tries == 0 || elapsedMs >= 5000)) return giveOrder();
  if (stage == Stage::Working && elapsedMs >= kWorkMs) return endWork();
  if (stage == Stage::Flying && mission.currentItem() != kNone && autopilot.hasAutopilot() && !autopilot.isArmed()) {
    CONSOLE.println(F("landed"));
    stage = Stage::Done;
  }
}
