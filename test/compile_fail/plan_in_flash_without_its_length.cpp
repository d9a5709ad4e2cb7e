// A pointer does not know how many items there are.
// expect: inFlash
#include <MavMission.h>
using namespace mavmission;

extern Stream& line;
MissionClient autopilot(line);
constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
const MissionItem* const where = survey;

void start() {
#ifdef MENDED
  autopilot.upload(inFlash(survey));
#else
  autopilot.upload(inFlash(where));
#endif
  static_cast<void>(where);
}
