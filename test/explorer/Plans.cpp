#include "Plans.h"

#include <math.h>
#include <string.h>

#include "Px4Checksum.h"
#include "mavmission/base/MavlinkHeaders.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

constexpr int32_t kLatitudeE7 = -353632621;
constexpr int32_t kLongitudeE7 = 1491652374;
constexpr float kAltitudeM = 20;

int32_t latitudeOf(uint8_t item) { return kLatitudeE7 + 1000 * item; }

mavlink_mission_item_int_t waypointOf(uint8_t item, Firmwares firmware) {
  mavlink_mission_item_int_t message;
  memset(&message, 0, sizeof(message));
  message.command = item == kHome ? MAV_CMD_CONDITION_DELAY : MAV_CMD_NAV_WAYPOINT;
  message.autocontinue = 1;
  if (item == kHome) return message;
  message.frame = MAV_FRAME_GLOBAL_RELATIVE_ALT;
  message.param4 = isArduPilot(firmware) ? 0 : NAN;
  message.x = latitudeOf(item);
  message.y = kLongitudeE7;
  message.z = kAltitudeM;
  return message;
}

Bytes bytesOf(const mavlink_mission_item_int_t& message) {
  const uint8_t* begin = reinterpret_cast<const uint8_t*>(&message);
  return Bytes(begin, begin + sizeof(message));
}

}  // namespace

const MissionItem* sketchPlan(uint8_t plan) {
  static MissionItem plans[3][kMostItems];
  static const bool filled = [] {
    for (uint8_t which = 0; which < 3; ++which) {
      for (uint16_t i = 0; i < kMostItems; ++i) {
        plans[which][i] = waypoint(Degrees::fromE7(latitudeOf(itemOf(which, i))), Degrees::fromE7(kLongitudeE7), 20_m);
      }
    }
    return true;
  }();
  (void)filled;
  return plans[plan];
}

Bytes payloadOf(uint8_t item, uint16_t sequence, Firmwares firmware, bool isReadBack, bool isFirst) {
  mavlink_mission_item_int_t message = waypointOf(item, firmware);
  message.seq = sequence;
  message.target_system = 1;
  message.target_component = isReadBack ? 191 : 1;
  if (isReadBack && item == kHome) {
    message.command = MAV_CMD_NAV_WAYPOINT;
    message.x = kLatitudeE7;
    message.y = kLongitudeE7;
    message.z = 584;
  }
  if (isReadBack && firmware == Firmwares::Px4) {
    message.frame = MAV_FRAME_GLOBAL_RELATIVE_ALT_INT;
    message.current = isFirst;
  }
  return bytesOf(message);
}

uint8_t itemIn(const Bytes& payload, Firmwares firmware) {
  mavlink_mission_item_int_t message;
  memcpy(&message, payload.data(), sizeof(message));
  const int32_t steps = (message.x - kLatitudeE7) / 1000;
  const uint8_t item = message.x == 0 ? kHome : static_cast<uint8_t>(steps);
  if (item == kNoItemAtAll || (message.x != 0 && (steps < 0 || steps > 255))) return kNoItemAtAll;
  return payload == payloadOf(item, message.seq, firmware, false, false) ? item : kNoItemAtAll;
}

uint8_t itemDownloaded(const MissionItem& item, bool isHome) {
  if (item.command != kNavWaypoint) return kNoItemAtAll;
  if (isHome) return item.x == kLatitudeE7 && item.y == kLongitudeE7 ? kHome : kNoItemAtAll;
  const int32_t steps = (item.x - kLatitudeE7) / 1000;
  const bool isOurs = steps > 0 && steps < 256 && item.x == latitudeOf(static_cast<uint8_t>(steps)) &&
                      item.y == kLongitudeE7 && item.frame == Frame::GlobalRelative && item.z == kAltitudeM;
  return isOurs ? static_cast<uint8_t>(steps) : kNoItemAtAll;
}

uint32_t checksummed(uint32_t sum, uint8_t item) { return px4Checksum(sum, waypointOf(item, Firmwares::Px4)); }
