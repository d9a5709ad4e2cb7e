// An LED that tells whether the aircraft is fit to fly. Lit: fit. One blink a second: not yet, or not known. Four
// blinks a second: unfit. Dark: no autopilot is heard. What has changed is printed, with the reason, and so are the
// autopilot's texts, such as why it does not arm.
//
// It is made of what the autopilot says of its sensors, its estimator and its vibration. It is no permission to fly.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr uint8_t kLed = 4;  // from this pin through 330 ohms to the LED, and from there to GND

MissionClient autopilot(TELEM);
Vehicle<autopilot> vehicle;  // what it is asked for, it requests every second

bool isLit() {
  if (!vehicle.isHeard()) return false;
  switch (vehicle.fitness()) {
    case Fitness::Fit: return true;
    case Fitness::Unfit: return millis() % 250 < 125;
    default: return millis() % 1000 < 100;
  }
}

void onText(void*, uint8_t, const char* text) {
  if (!CONSOLE) return;
  CONSOLE.print(F("autopilot: "));
  CONSOLE.println(text);
}

void setup() {
  CONSOLE.begin(115200);
  pinMode(kLed, OUTPUT);
  beginTelem(57600);
  vehicle.texts().onText(onText);
}

void loop() {
  autopilot.update();
  digitalWrite(kLed, isLit() ? HIGH : LOW);

  static FitReason last = FitReason::NotHeard;
  const FitReason now = vehicle.whyNotFit();
  if (now == last) return;
  last = now;
  if (!CONSOLE) return;
  CONSOLE.print(toString(fitnessOf(now)));
  CONSOLE.print(F(": "));
  CONSOLE.println(toString(now));
}
