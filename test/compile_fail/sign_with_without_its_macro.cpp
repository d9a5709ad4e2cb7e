// Signing is compiled in where MAVMISSION_SIGNING says so.
// expect: compile the library with -DMAVMISSION_SIGNING=1
#ifdef MENDED
#define MAVMISSION_SIGNING 1
#else
// As the library comes.
#endif
#include <MavMission.h>
using namespace mavmission;

extern Stream& line;
const uint8_t secret[32] PROGMEM = {1, 2, 3};
TimestampStore store;

void start(MissionClient& autopilot) { autopilot.signWith(keyInFlash(secret), 7, store); }
