// An angle is no altitude.
// expect: an altitude has a unit: 20_m, or Metres(height) where it is computed
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    takeoff(20_m),
#else
    takeoff(20_deg),
#endif
};
