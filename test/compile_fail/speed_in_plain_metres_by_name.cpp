// A number becomes a length only by name.
// expect: Metres
#include <MavMission.h>
using namespace mavmission;

extern Stream& line;
MissionClient autopilot(line);
constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
const MissionItem* const where = survey;

void start() {
#ifdef MENDED
  const Metres height(20);
  static_cast<void>(height);
#else
  const Metres height = 20;
  static_cast<void>(height);
#endif
  static_cast<void>(where);
}
