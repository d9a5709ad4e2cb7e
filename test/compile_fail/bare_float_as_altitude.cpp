// An altitude has a unit.
// expect: Altitude
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    takeoff(20.5_m),
#else
    takeoff(20.5f),
#endif
};
