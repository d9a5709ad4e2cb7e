// Takes off, follows a beacon for a minute, and returns. Here the beacon is computed: it moves around a square of 30 m.
// A sketch with a real beacon calls renew() when the beacon has reported its place, and only then: when no report has
// come for a second, the aircraft holds its position. REMOVE THE PROPELLERS WHILE YOU TRY IT.
//
// A pilot who takes over keeps the aircraft, and after a reset in flight nothing is sent.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr LatLon kField = {-35.3632621_deg, 149.1652374_deg};  // near the takeoff place
constexpr Metres kHeight = 10_m;                               // above home
constexpr uint32_t kFollowMs = 60000;

MissionClient autopilot(TELEM);
SteeredFlight flight(autopilot);
MovingTarget target(flight.steering());

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

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  flight.takeOff(kHeight);
}

void loop() {
  const Status followed = target.update();  // before the flight's
  if (flight.update()) {
    if (CONSOLE) flight.printTo(CONSOLE);
    if (flight.state() == FlightState::AtStop) target.start(beacon(), kHeight);
  }
  static uint32_t reportedMs;
  if (millis() - reportedMs >= 100) {
    reportedMs = millis();
    target.renew(beacon(), kHeight);
  }
  if (target.isFollowed() && flight.inStateMs() >= kFollowMs) target.stop();
  if (!isEnd(followed)) return;
  if (CONSOLE) CONSOLE.println(toString(followed));
  flight.goHome();  // refused while a pilot or a failsafe has it
}
