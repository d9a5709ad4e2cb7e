// The eighth decimal would be dropped without a word.
// expect: at most 7 decimals
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
#else
    waypoint(-35.36326215_deg, 149.1652374_deg, 20_m),
#endif
};
