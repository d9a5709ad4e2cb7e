// The fourth argument of a waypoint is a time.
// expect: Seconds
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(35_deg, 149_deg, 20_m, 5_s),
#else
    waypoint(35_deg, 149_deg, 20_m, 5_m),
#endif
};
