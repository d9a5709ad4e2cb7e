// Even a number that no integer holds.
// expect: an angle is at most 180 degrees
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(9_deg, 1_deg, 20_m),
#else
    waypoint(99999999999999999999999999_deg, 1_deg, 20_m),
#endif
};
