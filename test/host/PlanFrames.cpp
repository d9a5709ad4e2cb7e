#include "PlanFrames.h"

#include <string.h>

#include "mavmission/base/MavlinkHeaders.h"

FrameParts countParts(uint16_t items, mavmission::PlanType type, uint32_t opaqueId, uint8_t targetSystem) {
  mavlink_mission_count_t message = mavlink_mission_count_t();
  message.count = items;
  message.target_system = targetSystem;
  message.target_component = 191;
  message.mission_type = static_cast<uint8_t>(type);
  message.opaque_id = opaqueId;
  return FrameParts(MAVLINK_MSG_ID_MISSION_COUNT, message);
}

FrameParts itemParts(uint16_t seq, const mavmission::MissionItem& item, mavmission::PlanType type,
                     uint8_t targetSystem) {
  mavlink_mission_item_int_t message = mavlink_mission_item_int_t();
  memcpy(static_cast<void*>(&message), &item, 28);  // param1 to z lie alike in both
  message.seq = seq;
  message.command = item.command;
  message.target_system = targetSystem;
  message.target_component = 191;
  message.frame = static_cast<uint8_t>(item.frame);
  message.current = item.current;
  message.autocontinue = item.autocontinue;
  message.mission_type = static_cast<uint8_t>(type);
  return FrameParts(MAVLINK_MSG_ID_MISSION_ITEM_INT, message);
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

FrameParts commandAckParts(uint16_t command, uint8_t result, uint8_t targetSystem) {
  mavlink_command_ack_t message = mavlink_command_ack_t();
  message.command = command;
  message.result = result;
  message.target_system = targetSystem;
  message.target_component = 191;
  return FrameParts(MAVLINK_MSG_ID_COMMAND_ACK, message);
}

FrameParts currentParts(uint16_t item, uint16_t total, uint8_t state, uint32_t planId) {
  mavlink_mission_current_t message = mavlink_mission_current_t();
  message.seq = item;
  message.total = total;
  message.mission_state = state;
  message.mission_id = planId;
  return FrameParts(MAVLINK_MSG_ID_MISSION_CURRENT, message);
}
