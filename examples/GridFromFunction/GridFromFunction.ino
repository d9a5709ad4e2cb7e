// A lawn mower's grid of 302 items that is computed during the upload: only the item being sent is in RAM. Lanes run
// west to east and back, each further north than the one before.
#include <MavMission.h>
#include <MavMissionTelem.h>  // TELEM: this board's port to the autopilot
using namespace mavmission;

// The south-west corner of the field, and the grid's size.
constexpr Degrees kSouth = -35.3632621_deg;
constexpr Degrees kWest = 149.1652374_deg;
constexpr Degrees kLaneLength = 0.0011000_deg;   // 100 m at this latitude
constexpr Degrees kLaneSpacing = 0.0000180_deg;  // 2 m
constexpr uint16_t kLanes = 150;
constexpr Metres kHeight = 15_m;

constexpr uint16_t kItems = 1 + 2 * kLanes + 1;  // takeoff, two ends of each lane, the way home

// Item `index` of the plan. The same index must always give the same item, however often it is requested.
bool gridItem(void*, uint16_t index, MissionItem& item) {
  if (index == 0) {
    item = takeoff(kHeight);
  } else if (index == kItems - 1) {
    item = returnToLaunch();
  } else {
    const uint16_t lane = (index - 1) / 2;
    const bool isSecondEnd = (index - 1) % 2 != 0;
    const bool isEast = isSecondEnd != (lane % 2 != 0);  // every other lane is flown back
    item = waypoint(kSouth + kLaneSpacing * lane, isEast ? kWest + kLaneLength : kWest, kHeight);
  }
  return true;
}

MissionClient autopilot(TELEM);

void setup() {
  beginTelem(57600);
  autopilot.upload(fromFunction(gridItem, kItems));
}

void loop() { autopilot.update(); }
