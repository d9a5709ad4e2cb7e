// Takes off, follows a beacon for a minute, holds its position, and returns. Here the beacon is computed: it moves
// around a square of 30 m. A sketch with a real beacon calls renew() each time the beacon has reported its place, and
// only then: when no report has come for a second, the aircraft holds its position. TAKE OFF THE PROPELLERS WHILE YOU
// TRY IT.
//
// The sketch does not take control from a pilot, and after a reset in flight it sends nothing.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr LatLon kField = {-35.3632621_deg, 149.1652374_deg};  // near the takeoff place
constexpr Metres kHeight = 10_m;                               // above home
constexpr uint32_t kFollowMs = 60000;

MissionClient autopilot(TELEM);
Steering steering(autopilot);
MovingTarget target(steering);

enum class Stage : uint8_t { TakingOff, Climbing, Starting, Following, Returning, Landing, Done };
Stage stage = Stage::TakingOff;
uint8_t tries;  // of the running operation
bool tryAgain;
uint32_t sinceMs;  // when the following began, or when an operation failed

// Where the beacon is: it moves 2 m each second, north, east, south and west.
LatLon beacon() {
  const uint32_t walkedCm = millis() / 5 % 12000;
  const int32_t along = walkedCm % 3000;
  switch (walkedCm / 3000) {
    case 0: return moved(kField, along, 0);
    case 1: return moved(kField, 3000, along);
    case 2: return moved(kField, 3000 - along, 3000);
    default: return moved(kField, 0, 3000 - along);
  }
}

void order() {
  tryAgain = false;
  ++tries;
  if (stage == Stage::TakingOff) {
    steering.takeOff(kHeight);
  } else if (stage == Stage::Starting) {
    target.start(beacon(), kHeight);
  } else {
    steering.returnHome();
  }
}

void begin(Stage next) {
  stage = next;
  tries = 0;
  order();
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  begin(Stage::TakingOff);
}

void onEnded(Status status) {
  if (stage == Stage::Following) return;  // this was the hold: onHeld() handles its end
  CONSOLE.println(toString(status));
  if (status == Status::Done) {
    sinceMs = millis();
    if (stage == Stage::TakingOff) stage = Stage::Climbing;
    if (stage == Stage::Starting) stage = Stage::Following;
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

// No more targets are sent.
void onHeld(Status status) {
  CONSOLE.println(toString(status));
  stage = Stage::Done;
  if (status == Status::Done || status == Status::NotRenewed) begin(Stage::Returning);
}

void loop() {
  const Status followed = target.update();  // before the client's
  const Status status = autopilot.update();
  if (isEnd(status)) onEnded(status);
  if (isEnd(followed) && stage == Stage::Following) return onHeld(followed);

  static uint32_t askedMs;
  if (millis() - askedMs >= 100) {
    askedMs = millis();
    target.renew(beacon(), kHeight);
  }
  if (stage == Stage::Following && millis() - sinceMs >= kFollowMs) target.stop();
  if (autopilot.isBusy()) return;
  if (tryAgain && millis() - sinceMs >= 5000) return order();
  if (tryAgain) return;
  if (stage == Stage::Climbing && steering.hasArrived()) begin(Stage::Starting);
  if (stage == Stage::Landing && autopilot.hasAutopilot() && !autopilot.isArmed()) {
    CONSOLE.println(F("home"));
    stage = Stage::Done;
  }
}
