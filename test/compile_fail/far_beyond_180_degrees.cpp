// Even a number that no integer holds.
// expect: write a coordinate from -180 to 180 degrees, a heading up to 360
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(9_deg, 1_deg, 20_m),
#else
    waypoint(99999999999999999999999999_deg, 1_deg, 20_m),
#endif
};
