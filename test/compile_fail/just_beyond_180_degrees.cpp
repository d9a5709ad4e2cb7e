// The limit is exact.
// expect: a coordinate is at most 180 degrees: for west or south write a minus sign before it
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(-35.3632621_deg, 180.0000000_deg, 20_m),
#else
    waypoint(-35.3632621_deg, 180.0000001_deg, 20_m),
#endif
};
