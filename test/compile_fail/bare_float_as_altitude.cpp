// An altitude has a unit.
// expect: write an altitude with its unit: 20_m, or Metres(height) for a computed one
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    takeoff(20.5_m),
#else
    takeoff(20.5f),
#endif
};
