// A heading to the west of north is at most 180 degrees.
// expect: no match for 'operator-'
// expect of clang++: invalid argument type
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    takeoff(20_m, -90_deg),
#else
    takeoff(20_m, -270_deg),
#endif
};
