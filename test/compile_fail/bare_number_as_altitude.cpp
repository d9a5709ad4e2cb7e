// An altitude has a unit.
// expect: write an altitude with its unit: 20_m, or Metres(height) for a computed one
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
#else
    waypoint(-35.3632621_deg, 149.1652374_deg, 20),
#endif
};
