// No angle is more than 180 degrees.
// expect: write a coordinate from -180 to 180 degrees: west and south have a minus sign
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(-35.3632621_deg, 179_deg, 20_m),
#else
    waypoint(-35.3632621_deg, 181_deg, 20_m),
#endif
};
