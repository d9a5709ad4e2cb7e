// A status is printed as its words. (The monitor stands for Serial, which takes text in flash and numbers.)
// expect: no matching function for call to
// expect of clang++: no matching member function for call to
#include <MavMission.h>
using namespace mavmission;

struct Monitor {
  void println(FlashText) {}
  void println(const void*, int) {}
};
Monitor monitor;

void report(MissionClient& autopilot) {
#ifdef MENDED
  monitor.println(toString(autopilot.status()));
#else
  monitor.println(autopilot.status());
#endif
}
