// Uploads a plan, reads it back, and prints which plan is aboard; if it differs, also where.
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr MissionItem plan[] PROGMEM = {
    takeoff(20_m),
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m, 3_s),
    changeSpeed(4_mps),
    waypoint(-35.3614500_deg, 149.1652374_deg, 25.5_m),
    land(-35.3632621_deg, 149.1652374_deg),
};

MissionClient autopilot(TELEM);

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  autopilot.upload(inFlash(plan), Readback::Always);
}

void loop() {
  const Status status = autopilot.update();
  if (!isEnd(status) || !CONSOLE) return;
  CONSOLE.println(toString(status));
  CONSOLE.print(F("aboard: "));
  CONSOLE.println(toString(autopilot.aboard()));
  if (status == Status::Differs) {
    CONSOLE.print(F("item "));
    CONSOLE.print(autopilot.failedItem());
    CONSOLE.print(F(": "));
    CONSOLE.println(toString(autopilot.differingField()));
  }
}
