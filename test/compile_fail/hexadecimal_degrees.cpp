// Hexadecimal digits are not degrees.
// expect: plain decimal digits
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(16_deg, 1_deg, 20_m),
#else
    waypoint(0x10_deg, 1_deg, 20_m),
#endif
};
