// To the compiler 010 is 8; to the reader it is 10.
// expect: plain decimal digits
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(10_deg, 1_deg, 20_m),
#else
    waypoint(010_deg, 1_deg, 20_m),
#endif
};
