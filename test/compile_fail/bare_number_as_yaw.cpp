// A heading has a unit.
// expect: Yaw
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    takeoff(20_m, 90_deg),
#else
    takeoff(20_m, 90),
#endif
};
