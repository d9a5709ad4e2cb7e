// Takes off, follows a beacon for a minute, holds, and comes home. Here the beacon is computed: it walks around a
// square of 30 m. A sketch with a real one calls renew() whenever the beacon has told where it is, and only then: when
// it falls silent for a second, the aircraft holds where it is. TAKE OFF THE PROPELLERS WHILE YOU TRY IT.
//
// The aircraft is never taken out of a pilot's hands, and an Arduino that resets in flight sends nothing.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr LatLon kField = {-35.3632621_deg, 149.1652374_deg};  // near where it stands
constexpr Metres kHeight = 10_m;                               // above home
constexpr uint32_t kFollowMs = 60000;

MissionClient autopilot(TELEM);
Steering steering(autopilot);
MovingTarget target(steering);

enum class Stage : uint8_t { TakingOff, Climbing, Starting, Following, Returning, Landing, Done };
Stage stage = Stage::TakingOff;
uint8_t tries;  // of the order that is being carried out
bool tryAgain;
uint32_t sinceMs;  // when the following began, or when an order failed

// Where the beacon is: it walks 2 m each second, north, east, south and west.
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
  if (stage == Stage::Following) return;  // the hold: onHeld() has how it ended
  CONSOLE.println(toString(status));
  if (status == Status::Done) {
    sinceMs = millis();
    if (stage == Stage::TakingOff) stage = Stage::Climbing;
    if (stage == Stage::Starting) stage = Stage::Following;
    if (stage == Stage::Returning) stage = Stage::Landing;
    return;
  }
  // For half a minute after its start an autopilot refuses to be armed. Later, only what was lost is tried again: if a
  // pilot or a failsafe has the aircraft, it is left there.
  tryAgain = tries < 10 && (isWorthRetry(status) || status == Status::NoHome);
  sinceMs = millis();
  if (!tryAgain) stage = Stage::Done;
}

// The target goes out no more.
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
