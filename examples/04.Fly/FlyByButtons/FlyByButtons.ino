// Flies by hand, with four buttons. One takes off to 5 m, and later lands. While another is held, the aircraft flies
// forward, or turns; without a button it holds its position. The velocity is renewed ten times a second: if the sketch
// no longer did that, the aircraft would be stopped. TAKE OFF THE PROPELLERS WHILE YOU TRY IT.
//
// The sketch does not take control from a pilot, and after a reset in flight it sends nothing. A button that is stuck,
// or pressed at power-on, does nothing until it has been released.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

// Each button joins its pin to GND.
constexpr uint8_t kFlyOrLand = 2;
constexpr uint8_t kForward = 3;
constexpr uint8_t kLeft = 4;
constexpr uint8_t kRight = 5;

constexpr Metres kHeight = 5_m;  // above home
constexpr uint32_t kBounceMs = 50;

MissionClient autopilot(TELEM);
Steering steering(autopilot);
VelocityTarget velocity(steering);

enum class Stage : uint8_t { OnGround, TakingOff, Climbing, Starting, Flying, Landing };
Stage stage = Stage::OnGround;

bool isDown(uint8_t pin) { return digitalRead(pin) == LOW; }

BodyVelocity wanted() {
  const float turn = isDown(kLeft) ? -20 : isDown(kRight) ? 20 : 0;
  return BodyVelocity(isDown(kForward) ? 2_mps : 0_mps).turning(DegreesPerSecond(turn));
}

// True once for each time that the button is pressed.
bool isPressed() {
  static bool wasDown = true;
  static uint32_t changedMs;
  if (isDown(kFlyOrLand) == wasDown || millis() - changedMs < kBounceMs) return false;
  changedMs = millis();
  wasDown = !wasDown;
  return wasDown;
}

void goDown() {
  steering.landNow();
  stage = Stage::Landing;
}

void onPressed() {
  if (autopilot.isBusy()) return;
  if (stage == Stage::OnGround) {
    steering.takeOff(kHeight);
    stage = Stage::TakingOff;
  } else if (stage == Stage::Flying) {
    velocity.stop();  // then onStopped() lands
  } else {
    goDown();
  }
}

void onEnded(Status status) {
  if (stage == Stage::Flying) return;  // this was the hold: onStopped() handles its end
  CONSOLE.println(toString(status));
  if (status != Status::Done) {
    stage = Stage::OnGround;  // or a pilot has it: then the next takeOff() is refused, too
  } else if (stage == Stage::TakingOff) {
    stage = Stage::Climbing;
  } else if (stage == Stage::Starting) {
    stage = Stage::Flying;
  }
}

// No more velocities are sent.
void onStopped(Status status) {
  CONSOLE.println(toString(status));
  stage = Stage::OnGround;
  if (status == Status::Done || status == Status::NotRenewed) goDown();
}

void setup() {
  for (uint8_t pin = kFlyOrLand; pin <= kRight; ++pin) pinMode(pin, INPUT_PULLUP);
  CONSOLE.begin(115200);
  beginTelem(57600);
}

void loop() {
  const Status flown = velocity.update();  // before the client's
  const Status status = autopilot.update();
  if (isEnd(status)) onEnded(status);
  if (isEnd(flown) && stage == Stage::Flying) onStopped(flown);
  if (isPressed()) onPressed();

  static uint32_t renewedMs;
  if (millis() - renewedMs >= 100) {
    renewedMs = millis();
    velocity.renew(wanted());
  }
  if (autopilot.isBusy()) return;
  if (stage == Stage::Climbing && steering.hasArrived()) {
    velocity.start(wanted());
    stage = Stage::Starting;
  }
  if (stage == Stage::Landing && autopilot.hasAutopilot() && !autopilot.isArmed()) {
    CONSOLE.println(F("landed"));
    stage = Stage::OnGround;
  }
}
