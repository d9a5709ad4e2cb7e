// A constant plan is hardly in RAM. (Of an AVR alone: elsewhere flash is read like RAM.)
// expect: a plan with PROGMEM is in flash: inFlash(plan); a constant one without it: inRam(plan, count)
#include <MavMission.h>
using namespace mavmission;

constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};

ItemSource source() {
#ifdef MENDED
  return inFlash(survey);
#else
  return inRam(survey);
#endif
}
