// A heading is one turn at most.
// expect: write a coordinate from -180 to 180 degrees, a heading up to 360
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    takeoff(20_m, 360_deg),
#else
    takeoff(20_m, 360.0000001_deg),
#endif
};
