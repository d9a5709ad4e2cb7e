// Flies without a plan: takes off, goes to three places, works at each, and returns. A sensor that is read at one place
// decides where the next place is. TAKE OFF THE PROPELLERS WHILE YOU TRY IT.
//
// The sketch does not take control from a pilot, and after a reset in flight it sends nothing.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr LatLon kField = {-35.3632621_deg, 149.1652374_deg};  // near the takeoff place
constexpr Metres kHeight = 10_m;                               // above home
constexpr uint8_t kPlaces = 3;
constexpr uint32_t kWorkMs = 3000;  // the time that the work at a place needs
constexpr uint8_t kLamp = 13;       // lit while it works
constexpr uint8_t kSensor = A0;

MissionClient autopilot(TELEM);
Steering steering(autopilot);

enum class Stage : uint8_t { TakingOff, Climbing, Flying, Working, Returning, Landing, Done };
Stage stage = Stage::TakingOff;
LatLon place = kField;
uint8_t number;  // of the place, from 1
uint8_t tries;   // of the running operation
bool tryAgain;
uint32_t sinceMs;  // when the work began, or when an operation failed

void order() {
  tryAgain = false;
  ++tries;
  if (stage == Stage::TakingOff) {
    steering.takeOff(kHeight);
  } else if (stage == Stage::Flying) {
    steering.goTo(place, kHeight);
  } else {
    steering.returnHome();
  }
}

void begin(Stage next) {
  stage = next;
  tries = 0;
  order();
}

// 30 m to the north, or to the east if the sensor's value is high.
void goOn() {
  if (number == kPlaces) return begin(Stage::Returning);
  place = analogRead(kSensor) > 511 ? moved(place, 0, 3000) : moved(place, 3000, 0);
  ++number;
  CONSOLE.print(F("to "));
  CONSOLE.println(number);
  begin(Stage::Flying);
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  pinMode(kLamp, OUTPUT);
  begin(Stage::TakingOff);
}

void onEnded(Status status) {
  CONSOLE.println(toString(status));
  if (status == Status::Done) {
    if (stage == Stage::TakingOff) stage = Stage::Climbing;
    if (stage == Stage::Returning) stage = Stage::Landing;
    return;
  }
  // For half a minute after power-on an autopilot refuses to arm, so takeOff() is tried again. Later operations are
  // tried again only if the answer was lost. If a pilot or a failsafe is in control, the sketch leaves the aircraft to
  // them.
  tryAgain = tries < 10 && (isWorthRetry(status) || status == Status::NoHome);
  sinceMs = millis();
  if (!tryAgain) stage = Stage::Done;
}

void loop() {
  const Status status = autopilot.update();
  if (isEnd(status)) onEnded(status);
  if (autopilot.isBusy()) return;
  if (tryAgain && millis() - sinceMs >= 5000) return order();
  if (tryAgain) return;
  const bool isWaiting = stage == Stage::Climbing || stage == Stage::Flying || stage == Stage::Working;
  if (isWaiting && autopilot.hasAutopilot() && !steering.maySteer()) {
    CONSOLE.println(F("taken over"));
    stage = Stage::Done;
  }
  switch (stage) {
    case Stage::Climbing:
      if (steering.hasArrived()) goOn();
      break;
    case Stage::Flying:
      if (!steering.hasArrived()) break;
      CONSOLE.println(F("working"));
      digitalWrite(kLamp, HIGH);
      sinceMs = millis();
      stage = Stage::Working;
      break;
    case Stage::Working:
      if (millis() - sinceMs < kWorkMs) break;
      digitalWrite(kLamp, LOW);
      goOn();
      break;
    case Stage::Landing:
      if (!autopilot.hasAutopilot() || autopilot.isArmed()) break;
      CONSOLE.println(F("home"));
      stage = Stage::Done;
      break;
    default: break;
  }
}
