// An altitude has a unit.
// expect: an altitude has a unit: 20_m, or Metres(height) where it is computed
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    takeoff(20.5_m),
#else
    takeoff(20.5f),
#endif
};
