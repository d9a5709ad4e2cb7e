// MissionClient's MISSION_ITEM fallback, for autopilots without MISSION_ITEM_INT. A file of its own, since few sketches
// need it.
#include <Arduino.h>

#include "../base/FloatBits.h"
#include "../link/Messages.h"
#include "MissionClient.h"
#include "Uploading.h"

namespace mavmission {
using namespace detail;
namespace {

// x and y become floats: degrees, or parameters 5 and 6. The other fields have the same layout.
void toFloats(void* itemMessage) {
  mavlink_mission_item_int_t& message = *static_cast<mavlink_mission_item_int_t*>(itemMessage);
  static_assert(sizeof(mavlink_mission_item_t) == sizeof(message),
                "MISSION_ITEM and MISSION_ITEM_INT must have the same layout");
  const uint32_t unit = message.frame == MAV_FRAME_MISSION ? 1 : 10000000;
  const float x = quotient(message.x, unit);
  const float y = quotient(message.y, unit);
  memcpy(&message.x, &x, sizeof(x));
  memcpy(&message.y, &y, sizeof(y));
}

}  // namespace

// After the refusal by an autopilot without MISSION_ITEM_INT: uploads once more, as MISSION_ITEM.
bool Client::Uploading::fallBackToFloats(Client& client, Status status, uint16_t nowMs) {
  if (status != Status::Unsupported || client.state_.floatItems || !client.plan_.has(kMayBeOld) ||
      client.transfer_.itemsAskedFor() != 1) {
    return backsOff(client, status, nowMs);
  }
  client.state_.floatItems = true;
  begin(client, nowMs);
  client.state_.isDoubtful = true;
  return true;
}

void MissionClient::useMissionItemFallback(bool always) {
  session_.options.toFloats = toFloats;
  session_.options.goOn = Uploading::fallBackToFloats;
  session_.options.continueAfter = Uploading::continueAfter;
  state_.floatItems = always;
}

void Client::fromFloats(void* itemMessage) {
  mavlink_mission_item_int_t& message = *static_cast<mavlink_mission_item_int_t*>(itemMessage);
  const uint32_t unit = message.frame == MAV_FRAME_MISSION ? 1 : 10000000;
  message.x = timesWhole(message.x, unit);
  message.y = timesWhole(message.y, unit);
}

}  // namespace mavmission
