// A length is no angle.
// expect: Degrees
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(35_deg, 149_deg, 20_m),
#else
    waypoint(35_m, 149_deg, 20_m),
#endif
};
