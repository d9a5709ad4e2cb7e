// A command is sent later, from update(): a temporary would be gone by then.
// expect: deleted
// expect of clang++: deleted member function
#include <MavMission.h>
using namespace mavmission;

extern Stream& line;
MissionClient autopilot(line);
constexpr FlightCommand openGripper = flightCommand(211, 1, 0);

void start() {
#ifdef MENDED
  autopilot.send(openGripper);
#else
  autopilot.send(flightCommand(211, 1, 0));
#endif
}
