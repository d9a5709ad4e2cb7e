// A float holds a coordinate to metres only.
// expect: write an angle with its unit: -35.3632621_deg, or Degrees::fromE7(e7) for a computed one
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
#else
    waypoint(-35.3632621f, 149.1652374f, 20_m),
#endif
};
