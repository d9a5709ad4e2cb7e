// MissionClient's items as floats, for autopilots that know no MISSION_ITEM_INT; a file of its own because few need it.
#include <Arduino.h>

#include "../MissionClient.h"
#include "../base/FloatBits.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;
namespace {

// x and y become floats: degrees, or parameters 5 and 6. The rest has the same layout.
void toFloats(void* itemMessage) {
  mavlink_mission_item_int_t& message = *static_cast<mavlink_mission_item_int_t*>(itemMessage);
  static_assert(sizeof(mavlink_mission_item_t) == sizeof(message), "both items have one layout");
  const uint32_t unit = message.frame == MAV_FRAME_MISSION ? 1 : 10000000;
  const float x = quotient(message.x, unit);
  const float y = quotient(message.y, unit);
  memcpy(&message.x, &x, sizeof(x));
  memcpy(&message.y, &y, sizeof(y));
}

}  // namespace

// Takes up the refusal of an autopilot that knows no MISSION_ITEM_INT: once more, with floats.
bool Client::tryFloats(Client& client, Status refusal, uint16_t nowMs) {
  if (refusal != Status::Unsupported || client.state_.floatItems) return false;
  if (client.plan_.firmware() != Firmware::Other || client.transfer_.itemsAskedFor() != 1) return false;
  client.state_.floatItems = true;
  client.beginUpload(nowMs);
  return true;
}

void MissionClient::useMissionItemFallback(bool always) {
  state_.toFloats = toFloats;
  rest_.unsupported = tryFloats;
  rest_.takeUp = takeUpEnd;
  state_.floatItems = always;
}

void Client::fromFloats(void* itemMessage) {
  mavlink_mission_item_int_t& message = *static_cast<mavlink_mission_item_int_t*>(itemMessage);
  const uint32_t unit = message.frame == MAV_FRAME_MISSION ? 1 : 10000000;
  message.x = timesWhole(message.x, unit);
  message.y = timesWhole(message.y, unit);
}

}  // namespace mavmission
