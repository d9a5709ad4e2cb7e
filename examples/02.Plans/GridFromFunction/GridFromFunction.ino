// A lawn mower's grid of 302 items that is computed during the upload: only the item being sent is in RAM. Lanes run
// west to east and back, each further north than the one before.
#include <MavMission.h>
#include <MavMissionTelem.h>  // TELEM: this board's port to the autopilot
using namespace mavmission;

// The south-west corner of the field, and the grid's size.
constexpr LatLon kCorner = {-35.3632621_deg, 149.1652374_deg};
constexpr int32_t kLaneLengthCm = 10000;
constexpr int32_t kLaneSpacingCm = 200;
constexpr uint16_t kLanes = 150;
constexpr Metres kHeight = 15_m;

constexpr uint16_t kItems = 1 + 2 * kLanes + 1;  // takeoff, two ends of each lane, return

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
    const LatLon end = moved(kCorner, lane * kLaneSpacingCm, isEast ? kLaneLengthCm : 0);
    item = waypoint(end.latitude, end.longitude, kHeight);
  }
  return true;
}

MissionClient autopilot(TELEM);

void setup() {
  beginTelem(57600);
  autopilot.upload(fromFunction(gridItem, kItems));
}

void loop() { autopilot.update(); }
