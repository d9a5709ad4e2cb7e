// A constant plan is hardly in RAM. (Of an AVR alone: elsewhere flash is read like RAM.)
// expect: write inFlash(plan) for a plan with PROGMEM, inRam(plan, count) for a constant plan without
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
