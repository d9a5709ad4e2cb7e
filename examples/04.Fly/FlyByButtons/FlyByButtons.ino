// Flies by hand, with four buttons. One, held for a second, takes off to 5 m, and later lands. While another is held,
// the aircraft flies forward, or turns; without a button it holds its position. The velocity is renewed ten times a
// second: if the sketch no longer did that, the aircraft would be stopped. REMOVE THE PROPELLERS WHILE YOU TRY IT.
//
// The sketch does not take control from a pilot. After a reset in flight, and after a cable that was out for long, only
// the button that lands moves the aircraft: have a transmitter at hand.
#include <MavMission.h>
#include <MavMissionButton.h>   // HoldButton
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

// Each button joins its pin to GND.
constexpr uint8_t kFlyOrLand = 2, kForward = 3, kLeft = 4, kRight = 5;
constexpr Metres kHeight = 5_m;  // above home

MissionClient autopilot(TELEM);
SteeredFlight flight(autopilot);
VelocityTarget velocity(flight.steering());
HoldButton button(kFlyOrLand);

bool isDown(uint8_t pin) { return digitalRead(pin) == LOW; }

BodyVelocity wanted() {
  const float turn = isDown(kLeft) ? -20 : isDown(kRight) ? 20 : 0;
  return BodyVelocity(isDown(kForward) ? 2_mps : 0_mps).turning(DegreesPerSecond(turn));
}

void setup() {
  for (uint8_t pin = kForward; pin <= kRight; ++pin) pinMode(pin, INPUT_PULLUP);
  CONSOLE.begin(115200);
  beginTelem(57600);
}

void loop() {
  velocity.update();  // before the flight's
  if (flight.update() && CONSOLE) flight.printTo(CONSOLE);
  static uint32_t renewedMs;
  if (millis() - renewedMs >= 100) {
    renewedMs = millis();
    const bool isFlown = velocity.renew(wanted()) == Status::Transferring;
    // In the air it begins to fly so, and again after a cut cable.
    if (!isFlown && flight.state() == FlightState::AtStop) velocity.start(wanted());
  }
  // The button lands what flies. A person asks for the aircraft by it, in the air, too.
  if (!button.isPressed() || flight.land() == Status::Transferring) return;
  flight.begin();
  if (flight.land() != Status::Transferring) flight.takeOff(kHeight);
}
