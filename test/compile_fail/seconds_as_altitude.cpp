// A time is no altitude.
// expect: write an altitude with its unit: 20_m, or Metres(height) for a computed one
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    takeoff(20_m),
#else
    takeoff(20_s),
#endif
};
