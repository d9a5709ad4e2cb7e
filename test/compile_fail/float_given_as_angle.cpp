// No conversion leads from a float to an angle.
// expect: Degrees
#include <MavMission.h>
using namespace mavmission;

extern Stream& line;
MissionClient autopilot(line);
constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
const MissionItem* const where = survey;

void start() {
#ifdef MENDED
  const Degrees angle = 35.3632621_deg; autopilot.setTargetIds(1); static_cast<void>(angle);
#else
  const Degrees angle = 35.3632621; autopilot.setTargetIds(1); static_cast<void>(angle);
#endif
  static_cast<void>(where);
}
