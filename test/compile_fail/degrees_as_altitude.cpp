// An angle is no altitude.
// expect: Altitude
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    takeoff(20_m),
#else
    takeoff(20_deg),
#endif
};
