// Does something at stops of a plan: at the first a servo drops a sample, at the second a sensor is read.
// REMOVE THE PROPELLERS WHILE YOU TRY IT.
//
// The autopilot stands at each stop for up to 20 s, and then flies on by itself: so it comes home even if the Arduino
// fails. When the work is done, goOn() saves the rest of the time.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr LatLon kStart = {-35.3632621_deg, 149.1652374_deg};
constexpr uint8_t kServoPin = 9, kSensorPin = A0;
constexpr uint32_t kWorkMs = 3000;

constexpr MissionItem plan[] PROGMEM = {
    takeoff(kStart, 10_m),
    stopAt(-35.3630000_deg, 149.1652374_deg, 10_m, 20_s),  // item 1: the servo
    stopAt(-35.3630000_deg, 149.1655000_deg, 10_m, 20_s),  // item 2: the sensor
    land(kStart),
};

MissionClient autopilot(TELEM);
PositionListener position(autopilot, 500);
Flight flight(autopilot, position);  // with stops
bool isWorkDone;

void work() {
  isWorkDone = false;
  if (flight.stop() != 2 || !CONSOLE) return;
  CONSOLE.print(F("sensor: "));
  CONSOLE.println(analogRead(kSensorPin));
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  pinMode(kServoPin, OUTPUT);
  flight.fly(inFlash(plan));
}

void loop() {
  if (flight.update()) {
    if (CONSOLE) flight.printTo(CONSOLE);
    if (flight.state() == FlightState::AtStop) work();
  }
  const bool isWorking = flight.state() == FlightState::AtStop && flight.inStateMs() < kWorkMs;
  digitalWrite(kServoPin, isWorking && flight.stop() == 1 ? HIGH : LOW);  // or Servo::write()
  if (flight.state() == FlightState::AtStop && !isWorking && !isWorkDone) isWorkDone = flight.goOn();
}
