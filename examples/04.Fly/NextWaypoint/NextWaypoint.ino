// A soil probe: the aircraft lands in one field after another. After each landing the probe takes its sample, then the
// aircraft flies to the next field. REMOVE THE PROPELLERS WHILE YOU TRY IT.
//
// Each leg is a plan, which the autopilot flies to its landing even if the Arduino fails. If a pilot takes over, or
// somebody touches the aircraft between two legs, the sketch does not take off any more.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr LatLon places[] = {
    {-35.3632621_deg, 149.1652374_deg},  // the start
    {-35.3631000_deg, 149.1652374_deg},
    {-35.3631000_deg, 149.1654000_deg},
};
constexpr uint8_t kFields = sizeof(places) / sizeof(places[0]) - 1;
constexpr Metres kHeight = 10_m;
constexpr uint32_t kSampleMs = 5000;  // the time that the probe needs

MissionClient autopilot(TELEM);
Flight flight(autopilot);
uint8_t field = 1;

bool legItem(void*, uint16_t index, MissionItem& item) {
  item = index == 0   ? takeoff(places[field - 1], kHeight)
         : index == 1 ? waypoint(places[field], kHeight)
                      : land(places[field]);
  return true;
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  flight.fly(fromFunction(legItem, 3));
}

void loop() {
  if (flight.update() && CONSOLE) flight.printTo(CONSOLE);
  // Landed: the probe works.
  if (flight.state() != FlightState::Landed || flight.inStateMs() < kSampleMs || field == kFields) return;
  ++field;
  flight.fly(fromFunction(legItem, 3));
}
