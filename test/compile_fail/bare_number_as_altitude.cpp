// An altitude has a unit.
// expect: an altitude has a unit: 20_m, or Metres(height) where it is computed
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
#else
    waypoint(-35.3632621_deg, 149.1652374_deg, 20),
#endif
};
