// Uploads a fence and rally points, one after the other. Both need MAVLink 2 on the port (ArduPilot's SERIALn_PROTOCOL
// 2).
#include <MavMission.h>
#include <MavMissionMonitor.h>  // TELEM and CONSOLE: this board's ports
using namespace mavmission;

constexpr MissionItem fence[] PROGMEM = {
    // A field that the aircraft must not leave: four corners, and each says how many corners there are.
    fenceInside(-35.3640_deg, 149.1640_deg, 4),
    fenceInside(-35.3640_deg, 149.1670_deg, 4),
    fenceInside(-35.3610_deg, 149.1670_deg, 4),
    fenceInside(-35.3610_deg, 149.1640_deg, 4),
    // A mast in the field, to which the aircraft must keep a distance.
    fenceOutsideCircle(-35.3625_deg, 149.1655_deg, 15_m),
};

constexpr MissionItem rallyPoints[] PROGMEM = {
    rallyPoint(-35.3632_deg, 149.1652_deg, 20_m),
    rallyPoint(-35.3615_deg, 149.1645_deg, 25_m),
};

MissionClient autopilot(TELEM);
bool isFenceUp = false;

void report(Status status) {
  if (!CONSOLE) return;
  CONSOLE.print(isFenceUp ? F("rally: ") : F("fence: "));
  CONSOLE.println(status == Status::Accepted ? F("aboard, as it was meant") : toString(status));
}

void setup() {
  CONSOLE.begin(115200);
  beginTelem(57600);
  autopilot.upload(inFlash(fence), PlanType::Fence, Readback::Always);
}

void loop() {
  const Status status = autopilot.update();
  if (!isEnd(status)) return;
  report(status);
  if (!isFenceUp && status == Status::Accepted) {
    isFenceUp = true;
    autopilot.upload(inFlash(rallyPoints), PlanType::Rally, Readback::Always);
  }
}
