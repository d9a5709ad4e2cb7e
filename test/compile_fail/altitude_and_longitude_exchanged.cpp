// Each argument has its own type.
// expect: Degrees
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(35_deg, 149_deg, 20_m),
#else
    waypoint(35_deg, 20_m, 149_deg),
#endif
};
