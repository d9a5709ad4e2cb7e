// Uploads a plan to ArduPilot as a file: the old plan stays aboard until the whole new one has arrived, so an upload
// that breaks off leaves no mixture of the two. On PX4, and if ArduPilot's FTP is switched off, the plan is uploaded
// item by item. Then it prints which plan is aboard. A Nano and a Leonardo are too small.
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
PlanFiles files(autopilot);

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  files.upload(inFlash(plan));
}

void loop() {
  const Status status = autopilot.update();
  if (!isEnd(status) || !CONSOLE) return;
  CONSOLE.println(toString(status));
  CONSOLE.println(files.isByFile() ? F("by file") : F("item by item"));
  CONSOLE.print(F("aboard: "));
  CONSOLE.println(toString(autopilot.aboard()));
}
