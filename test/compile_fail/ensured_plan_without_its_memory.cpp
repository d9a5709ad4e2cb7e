// An array in flash and one in RAM have one type: the sketch says which it is.
// expect: write ensure(inFlash(plan)) for a plan with PROGMEM, ensure(inRam(plan)) for one without
#include <MavMission.h>
using namespace mavmission;

extern Stream& line;
MissionClient autopilot(line);
constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
const MissionItem* const where = survey;

void start() {
#ifdef MENDED
  autopilot.ensure(inFlash(survey));
#else
  autopilot.ensure(survey);
#endif
  static_cast<void>(where);
}
