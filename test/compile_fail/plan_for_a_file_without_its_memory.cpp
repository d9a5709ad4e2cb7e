// An array in flash and one in RAM have one type: the sketch says which it is.
// expect: write upload(inFlash(plan)) for a plan with PROGMEM, upload(inRam(plan)) for one without
#include <MavMission.h>
using namespace mavmission;

extern Stream& line;
MissionClient autopilot(line);
PlanFiles files(autopilot);
constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
const MissionItem* const where = survey;

void start() {
#ifdef MENDED
  files.upload(inFlash(survey));
#else
  files.upload(survey);
#endif
  static_cast<void>(where);
}
