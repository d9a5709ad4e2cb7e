// A length is no angle.
// expect: write an angle with its unit: -35.3632621_deg, or Degrees::fromE7(e7) for a computed one
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(35_deg, 149_deg, 20_m),
#else
    waypoint(35_m, 149_deg, 20_m),
#endif
};
