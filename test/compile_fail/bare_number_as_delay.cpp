// It could be seconds or milliseconds. (On a board it is the core's own delay(), which is no item.)
// expect: Seconds
// expect of avr-g++: void value
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {
#ifdef MENDED
    delay(1_s),
#else
    delay(1000),
#endif
};
