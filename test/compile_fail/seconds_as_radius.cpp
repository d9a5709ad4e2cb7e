// The fifth argument of a waypoint is a length.
// expect: Metres
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(35_deg, 149_deg, 20_m, 5_s, 5_m),
#else
    waypoint(35_deg, 149_deg, 20_m, 5_s, 5_s),
#endif
};
