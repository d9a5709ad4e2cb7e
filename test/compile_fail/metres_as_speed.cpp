// A length is no speed.
// expect: MetresPerSecond
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    changeSpeed(5_mps),
#else
    changeSpeed(5_m),
#endif
};
