// ArduPilot counts up to 32,767 in a jump: 40,000 would be -25,536.
// expect: jumpRepeatsMustBeFromMinus1To32767
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),
#ifdef MENDED
    jump(0, 32767),
#else
    jump(0, 40000),
#endif
};
