// 24 items for the firmwares that are measured.
#pragma once

#include <MavMission.h>

namespace mavmission {

// Each kind of item that costs differently on either autopilot: with a place, looking for one, a jump, none of these.
#define EIGHT                                                                                \
  takeoff(20_m), waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),                           \
      waypoint(-35.3614500_deg, 149.1652374_deg, 25_m, 3_s), jump(1, 2), changeSpeed(5_mps), \
      loiterTime(-35.3614500_deg, 149.1652374_deg, 20_m, 9_s), delay(5_s), land()
constexpr MissionItem plan[] PROGMEM = {EIGHT, EIGHT, EIGHT};

}  // namespace mavmission
