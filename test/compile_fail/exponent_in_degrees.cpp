// An exponent is not read digit by digit.
// expect: plain decimal digits
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    waypoint(10_deg, 1_deg, 20_m),
#else
    waypoint(1e3_deg, 1_deg, 20_m),
#endif
};
