// What is beyond 180 degrees is a heading, and no coordinate.
// expect: write a coordinate from -180 to 180 degrees: west and south have a minus sign
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m, 0_s, 0_m, 210.8_deg),
#else
    waypoint(-35.3632621_deg, 210.8_deg, 20_m),
#endif
};
