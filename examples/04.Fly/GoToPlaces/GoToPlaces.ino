// Flies without a plan: takes off, goes to three places, works at each, and returns. A sensor that is read at one place
// decides where the next place is. REMOVE THE PROPELLERS WHILE YOU TRY IT.
//
// If the Arduino fails, the aircraft waits where it is until its battery is low: set up that failsafe. A pilot who
// takes over keeps the aircraft.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr Metres kHeight = 10_m;  // above home
constexpr uint8_t kPlaces = 3;
constexpr uint32_t kWorkMs = 3000;  // the time that the work at a place needs
constexpr uint8_t kSensor = A0;

MissionClient autopilot(TELEM);
SteeredFlight flight(autopilot);
LatLon place = {-35.3632621_deg, 149.1652374_deg};  // near the takeoff place
uint8_t number;                                     // of the place, from 1; 0: above the takeoff place

// 30 m to the north, or to the east if the sensor's value is high.
void goOn() {
  if (number == kPlaces) {
    flight.goHome();
    return;
  }
  place = analogRead(kSensor) > 511 ? moved(place, 0, 3000) : moved(place, 3000, 0);
  ++number;
  flight.goTo(place, kHeight);
  if (!CONSOLE) return;
  CONSOLE.print(F("to "));
  CONSOLE.println(number);
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  flight.takeOff(kHeight);
}

void loop() {
  if (flight.update() && CONSOLE) flight.printTo(CONSOLE);
  if (flight.state() != FlightState::AtStop) return;
  if (number == 0 || flight.inStateMs() >= kWorkMs) goOn();
}
