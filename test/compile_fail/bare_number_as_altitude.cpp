// An altitude has a unit.
// expect: Altitude
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
#else
    waypoint(-35.3632621_deg, 149.1652374_deg, 20),
#endif
};
