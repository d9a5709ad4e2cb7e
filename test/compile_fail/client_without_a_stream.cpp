// A client speaks over one stream.
// expect: MissionClient
#include <MavMission.h>
using namespace mavmission;

extern Stream& line;
MissionClient autopilot(line);
constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
const MissionItem* const where = survey;

void start() {
#ifdef MENDED
  MissionClient other(line);
  static_cast<void>(other);
#else
  MissionClient other;
  static_cast<void>(other);
#endif
  static_cast<void>(where);
}
