// A speed has a unit.
// expect: MetresPerSecond
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    changeSpeed(5_mps),
#else
    changeSpeed(5),
#endif
};
