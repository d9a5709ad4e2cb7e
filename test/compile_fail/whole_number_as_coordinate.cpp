// A whole number could be degrees or steps of 1e-7 degree.
// expect: Degrees
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(Degrees::fromE7(-353632621), Degrees::fromE7(1491652374), 20_m),
#else
    waypoint(-353632621, 1491652374, 20_m),
#endif
};
