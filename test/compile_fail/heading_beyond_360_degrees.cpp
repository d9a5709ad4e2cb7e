// A heading is one turn at most.
// expect: an angle is at most 180 degrees, and a heading 360
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    takeoff(20_m, 360_deg),
#else
    takeoff(20_m, 360.0000001_deg),
#endif
};
