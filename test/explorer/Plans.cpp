#include "Plans.h"

#include <math.h>

#include "Px4Checksum.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

constexpr int32_t kLatitudeE7 = -353632621;
constexpr int32_t kLongitudeE7 = 1491652374;
constexpr float kAltitudeM = 20, kRadiusM = 100;

int32_t latitudeOf(uint8_t item) { return kLatitudeE7 + 1000 * item; }

// A waypoint, a circle of a fence or a rally point.
mavlink_mission_item_int_t placeOf(uint8_t item, uint8_t type, Firmwares firmware) {
  mavlink_mission_item_int_t message = mavlink_mission_item_int_t();
  message.command = item == kHome ? MAV_CMD_CONDITION_DELAY : MAV_CMD_NAV_WAYPOINT;
  message.autocontinue = 1;
  if (item == kHome) return message;
  message.frame = MAV_FRAME_GLOBAL_RELATIVE_ALT;
  message.x = latitudeOf(item);
  message.y = kLongitudeE7;
  message.z = kAltitudeM;
  message.mission_type = type;
  const bool hasYaw = isArduPilot(firmware) || (kIsBetaflightNamed && isGeneric(firmware));
  if (type == kMission && !hasYaw) message.param4 = NAN;
  if (type == kRally) message.command = kRallyPoint;
  if (type != kFence) return message;
  message.command = kFenceCircleInclusion;
  message.frame = MAV_FRAME_GLOBAL;
  message.param1 = kRadiusM;
  message.z = 0;
  return message;
}

}  // namespace

const MissionItem* sketchPlan(uint8_t plan, uint8_t type) {
  static MissionItem plans[3][4][kMostItems];
  static const bool filled = [] {
    for (uint8_t which = 0; which < 4; ++which) {
      for (uint16_t i = 0; i < kMostItems; ++i) {
        const Degrees latitude = Degrees::fromE7(latitudeOf(itemOf(which, i)));
        const Degrees longitude = Degrees::fromE7(kLongitudeE7);
        plans[kMission][which][i] = waypoint(latitude, longitude, 20_m);
        plans[kFence][which][i] = fenceInsideCircle(latitude, longitude, 100_m);
        plans[kRally][which][i] = rallyPoint(latitude, longitude, 20_m);
      }
    }
    return true;
  }();
  (void)filled;
  return plans[type][plan];
}

Bytes payloadOf(uint8_t item, uint16_t sequence, uint8_t type, Firmwares firmware, bool isReadBack) {
  mavlink_mission_item_int_t message = placeOf(item, type, firmware);
  message.seq = sequence;
  message.target_system = 1;
  message.target_component = isReadBack ? 191 : 1;
  if (isReadBack && item == kHome) {
    message.command = MAV_CMD_NAV_WAYPOINT;
    message.x = kLatitudeE7;
    message.y = kLongitudeE7;
    message.z = 584;
  }
  if (isReadBack && type != kMission) message.autocontinue = 0;
  if (isReadBack && firmware == Firmwares::Px4 && type != kFence) {
    message.frame = MAV_FRAME_GLOBAL_RELATIVE_ALT_INT;
    message.current = type == kMission && sequence == 0;
  }
  return bytesOf(message);
}

uint8_t itemIn(const Bytes& payload, Firmwares firmware) {
  const mavlink_mission_item_int_t message = messageIn<mavlink_mission_item_int_t>(payload);
  const int32_t steps = (message.x - kLatitudeE7) / 1000;
  const uint8_t item = message.x == 0 ? kHome : static_cast<uint8_t>(steps);
  if (item == kNoItemAtAll || (message.x != 0 && (steps < 0 || steps > 255))) return kNoItemAtAll;
  const Bytes meant = payloadOf(item, message.seq, message.mission_type, firmware, false);
  return bytesOf(message) == meant ? item : kNoItemAtAll;
}

uint8_t itemDownloaded(const MissionItem& item, bool isHome, uint8_t type) {
  if (isHome) {
    const bool isOurs = item.command == kNavWaypoint && item.x == kLatitudeE7 && item.y == kLongitudeE7;
    return isOurs ? kHome : kNoItemAtAll;
  }
  const int32_t steps = (item.x - kLatitudeE7) / 1000;
  if (steps <= 0 || steps > 255 || item.x != latitudeOf(static_cast<uint8_t>(steps))) return kNoItemAtAll;
  const uint8_t found = static_cast<uint8_t>(steps);
  const mavlink_mission_item_int_t meant = placeOf(found, type, Firmwares::Px4);
  const bool isOurs = item.y == meant.y && item.z == meant.z && item.command == meant.command &&
                      item.frame == (type == kFence ? CoordinateFrame::Global : CoordinateFrame::GlobalRelative);
  return isOurs ? found : kNoItemAtAll;
}

uint32_t checksummed(uint32_t sum, uint8_t item, uint8_t type) {
  return px4Checksum(sum, placeOf(item, type, Firmwares::Px4));
}
