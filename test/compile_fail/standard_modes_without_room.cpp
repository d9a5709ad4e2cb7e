// AVAILABLE_MODES is longer than what this library keeps of a message.
// expect: compile the library with -DMAVMISSION_MAX_PAYLOAD=46
#ifdef MENDED
// As the library comes.
#else
#define MAVMISSION_MAX_PAYLOAD 45
#endif
#include <MavMission.h>
using namespace mavmission;

extern MissionClient autopilot;

StandardModes modes(autopilot);
