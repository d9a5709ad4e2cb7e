// A whole number could be degrees or steps of 1e-7 degree.
// expect: write an angle with its unit: -35.3632621_deg, or Degrees::fromE7(e7) for a computed one
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(Degrees::fromE7(-353632621), Degrees::fromE7(1491652374), 20_m),
#else
    waypoint(-353632621, 1491652374, 20_m),
#endif
};
