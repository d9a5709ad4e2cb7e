// A status is no number: 0 would mean success to many.
// expect: Status
#include <MavMission.h>
using namespace mavmission;

extern Stream& line;
MissionClient autopilot(line);
constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
const MissionItem* const where = survey;

void start() {
#ifdef MENDED
  const Status status = autopilot.status();
  static_cast<void>(status);
#else
  const int status = autopilot.status();
  static_cast<void>(status);
#endif
  static_cast<void>(where);
}
