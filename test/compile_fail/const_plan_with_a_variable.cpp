// A plan in flash must be known to the compiler: constexpr says so, and an item that is no constant is an error.
// expect: constant
#include <MavMission.h>
using namespace mavmission;

int measured();

#ifdef MENDED
const int height = 20;
#else
const int height = measured();
#endif

constexpr MissionItem survey[] PROGMEM = {takeoff(Metres(height)), returnToLaunch()};
