// A length is no angle.
// expect: an angle has its unit, so that it is exact: -35.3632621_deg, or Degrees::fromE7() where it is computed
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(35_deg, 149_deg, 20_m),
#else
    waypoint(35_m, 149_deg, 20_m),
#endif
};
