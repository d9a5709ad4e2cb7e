// Not even an explicit one.
// expect: write an angle with its unit: -35.3632621_deg, or Degrees::fromE7(e7) for a computed one
#include <MavMission.h>
using namespace mavmission;

extern Stream& line;
MissionClient autopilot(line);
constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
const MissionItem* const where = survey;

void start() {
#ifdef MENDED
  const Degrees angle = Degrees::fromE7(353632621);
  static_cast<void>(angle);
#else
  const Degrees angle(35.3632621);
  static_cast<void>(angle);
#endif
  static_cast<void>(where);
}
