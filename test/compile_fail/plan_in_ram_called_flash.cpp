// A plan that is filled in as the sketch runs lies in RAM.
// expect: this plan is in RAM: write inRam(plan), or declare it as constexpr MissionItem plan[] PROGMEM
#include <MavMission.h>
using namespace mavmission;

MissionItem survey[2] = {takeoff(20_m), returnToLaunch()};

ItemSource source() {
#ifdef MENDED
  return inRam(survey);
#else
  return inFlash(survey);
#endif
}
