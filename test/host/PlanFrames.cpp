#include "PlanFrames.h"

#include <string.h>

#include "mavmission/base/MavlinkHeaders.h"

FrameParts countParts(uint16_t items, mavmission::PlanType type, uint32_t opaqueId) {
  Bytes payload = {static_cast<uint8_t>(items), static_cast<uint8_t>(items >> 8), 1, 191, static_cast<uint8_t>(type)};
  for (int shift = 0; shift < 32; shift += 8) payload.push_back(static_cast<uint8_t>(opaqueId >> shift));
  return FrameParts(MAVLINK_MSG_ID_MISSION_COUNT, payload, MAVLINK_MSG_ID_MISSION_COUNT_CRC);
}

FrameParts itemParts(uint16_t seq, const mavmission::MissionItem& item, mavmission::PlanType type) {
  mavlink_mission_item_int_t message = mavlink_mission_item_int_t();
  message.param1 = item.param1;
  message.param2 = item.param2;
  message.param3 = item.param3;
  message.param4 = item.param4;
  message.x = item.x;
  message.y = item.y;
  message.z = item.z;
  message.seq = seq;
  message.command = item.command;
  message.target_system = 1;
  message.target_component = 191;
  message.frame = static_cast<uint8_t>(item.frame);
  message.current = item.current;
  message.autocontinue = item.autocontinue;
  message.mission_type = static_cast<uint8_t>(type);
  const uint8_t* begin = reinterpret_cast<const uint8_t*>(&message);
  return FrameParts(MAVLINK_MSG_ID_MISSION_ITEM_INT, Bytes(begin, begin + sizeof(message)),
                    MAVLINK_MSG_ID_MISSION_ITEM_INT_CRC);
}

FrameParts floatItemParts(uint16_t seq, const mavmission::MissionItem& item, float x, float y) {
  FrameParts parts = itemParts(seq, item);
  memcpy(&parts.payload[16], &x, sizeof(x));
  memcpy(&parts.payload[20], &y, sizeof(y));
  parts.messageId = MAVLINK_MSG_ID_MISSION_ITEM;
  parts.crcExtra = MAVLINK_MSG_ID_MISSION_ITEM_CRC;
  return parts;
}

mavmission::MissionItem homeItem() {
  using namespace mavmission;
  return anyCommandAt(kNavWaypoint, -35.3632621_deg, 149.1652374_deg, aboveSeaLevel(584_m));
}

FrameParts commandAckParts(uint16_t command, uint8_t result) {
  const uint8_t low = static_cast<uint8_t>(command), high = static_cast<uint8_t>(command >> 8);
  return FrameParts(MAVLINK_MSG_ID_COMMAND_ACK, {low, high, result, 0, 0, 0, 0, 0, 1, 191},
                    MAVLINK_MSG_ID_COMMAND_ACK_CRC);
}
