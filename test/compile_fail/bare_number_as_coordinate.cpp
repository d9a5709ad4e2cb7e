// A number without a unit is no coordinate.
// expect: Degrees
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
#else
    waypoint(-35.3632621, 149.1652374, 20_m),
#endif
};
