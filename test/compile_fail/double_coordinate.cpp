// A number with a point is no coordinate: on AVR it would be one to metres only.
// expect: write an angle with its unit: -35.3632621_deg, or Degrees::fromE7(e7) for a computed one
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
#else
    waypoint(-35.3632621, 149.1652374, 20_m),
#endif
};
