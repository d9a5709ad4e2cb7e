// It could be seconds or milliseconds.
// expect: Seconds
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    delay(1_s),
#else
    delay(1000),
#endif
};
