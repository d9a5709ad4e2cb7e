// HOME_POSITION is longer than what the library keeps by default.
// expect: compile the library with -DMAVMISSION_MAX_PAYLOAD=60
#ifdef MENDED
#define MAVMISSION_MAX_PAYLOAD 60
#else
// As the library comes.
#endif
#include <MavMission.h>
using namespace mavmission;

extern MissionClient autopilot;

HomeListener home(autopilot);
