#include "Message.h"

#include <map>
#include <tuple>

#include "FileWords.h"
#include "Names.h"
#include "PlanFrames.h"
#include "Plans.h"
#include "mavmission/base/MavlinkHeaders.h"

namespace {

const uint8_t kAutopilotSystem = 1, kAutopilotComponent = 1, kClientComponent = 191;

}  // namespace

FrameParts partsOf(const Message& message, Firmwares firmware) {
  switch (message.kind) {
    case Kind::Heartbeat: {
      const uint8_t autopilot = isGeneric(firmware)     ? MAV_AUTOPILOT_GENERIC
                                : isArduPilot(firmware) ? MAV_AUTOPILOT_ARDUPILOTMEGA
                                                        : MAV_AUTOPILOT_PX4;
      return heartbeatParts(autopilot, 0, 0, MAV_TYPE_QUADROTOR, 0);
    }
    case Kind::Count:
      return countParts(message.number, static_cast<mavmission::PlanType>(message.type), message.opaqueId);
    case Kind::Request: {
      const FrameParts request = requestParts(message.number, 1, kClientComponent, message.type);
      // ArduPilot asks by the older message, which has the same layout.
      return isArduPilot(firmware) ? FrameParts(MAVLINK_MSG_ID_MISSION_REQUEST, request.payload) : request;
    }
    case Kind::Item:
      return FrameParts(MAVLINK_MSG_ID_MISSION_ITEM_INT,
                        payloadOf(message.item, message.number, message.type, firmware, true));
    case Kind::FileReply: return FrameParts(MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL, fileReplyPayload(message, firmware));
    default: return ackParts(static_cast<uint8_t>(message.number), 1, kClientComponent, message.type, message.opaqueId);
  }
}

std::string inWords(const Message& message) {
  static const char* const kTypes[] = {"", " (fence)", " (rally)"};
  const std::string number = std::to_string(message.number) + kTypes[message.type];
  switch (message.kind) {
    case Kind::Heartbeat: return "HEARTBEAT";
    case Kind::Count: return "COUNT " + number;
    case Kind::Request: return "REQUEST " + number;
    case Kind::OlderRequest: return "older REQUEST " + number;
    case Kind::Item: {
      const std::string plan = message.item == kHome ? "home" : "of plan " + std::to_string(message.item / 16);
      return "ITEM " + number + " (" + plan + ")";
    }
    case Kind::Ack: return std::string("ACK ") + kMissionResults[message.number % 16] + kTypes[message.type];
    case Kind::List: return std::string("REQUEST_LIST") + kTypes[message.type];
    case Kind::ClearAll: return std::string("CLEAR_ALL") + kTypes[message.type];
    case Kind::File:
    case Kind::FileReply: return fileInWords(message);
  }
  return "";
}

const Bytes& frameOf(const Message& message, Firmwares firmware) {
  typedef std::tuple<uint8_t, uint8_t, uint8_t, uint16_t, uint32_t, uint8_t> Key;
  static std::map<Key, Bytes> made;
  Bytes& frame = made[Key(static_cast<uint8_t>(message.kind), message.type, message.item, message.number,
                          message.opaqueId, static_cast<uint8_t>(firmware))];
  if (frame.empty()) frame = packed(partsOf(message, firmware));
  return frame;
}

const char* decode(const Bytes& frame, Firmwares firmware, Message& decoded) {
  if (frame.size() < 12 || frame[0] != MAVLINK_STX) return "what is sent is no MAVLink 2 frame";
  if (frame.size() != frame[1] + 12u) return "a frame is sent with a wrong length";
  const FrameIn found = frameAt(frame);
  const FrameParts& parts = found.parts;
  const mavlink_msg_entry_t* const entry = mavlink_get_msg_entry(parts.messageId);
  if (entry == nullptr || frame[1] > entry->max_msg_len) return "a frame of an unknown message is sent";
  if (!found.isRight) return "a frame is sent with a wrong checksum";
  if (parts.systemId != kAutopilotSystem || parts.componentId != kClientComponent)
    return "a frame is sent with a wrong sender";
  const Bytes& payload = parts.payload;
  if (payload[entry->target_system_ofs] != kAutopilotSystem ||
      payload[entry->target_component_ofs] != kAutopilotComponent) {
    return "a frame is sent to somebody else";
  }
  uint8_t type = 0;
  switch (parts.messageId) {
    case MAVLINK_MSG_ID_MISSION_COUNT: {
      const mavlink_mission_count_t count = messageIn<mavlink_mission_count_t>(payload);
      if (count.opaque_id != 0) return "COUNT is sent with an opaque_id";
      decoded = message(Kind::Count, count.count);
      type = count.mission_type;
      break;
    }
    case MAVLINK_MSG_ID_MISSION_ITEM_INT: {
      const mavlink_mission_item_int_t sent = messageIn<mavlink_mission_item_int_t>(payload);
      decoded = message(Kind::Item, sent.seq, itemIn(payload, firmware));
      if (decoded.item == kNoItemAtAll) return "an item is sent that is in no plan";
      type = sent.mission_type;
      break;
    }
    case MAVLINK_MSG_ID_MISSION_REQUEST:
    case MAVLINK_MSG_ID_MISSION_REQUEST_INT: {
      const bool isOlder = parts.messageId == MAVLINK_MSG_ID_MISSION_REQUEST;
      if (isOlder && !isGeneric(firmware)) return "an item is asked for by MISSION_REQUEST";
      const mavlink_mission_request_int_t request = messageIn<mavlink_mission_request_int_t>(payload);
      decoded = message(isOlder ? Kind::OlderRequest : Kind::Request, request.seq);
      type = request.mission_type;
      break;
    }
    case MAVLINK_MSG_ID_MISSION_REQUEST_LIST:
    case MAVLINK_MSG_ID_MISSION_CLEAR_ALL:
      decoded = message(parts.messageId == MAVLINK_MSG_ID_MISSION_CLEAR_ALL ? Kind::ClearAll : Kind::List);
      type = messageIn<mavlink_mission_clear_all_t>(payload).mission_type;
      break;
    case MAVLINK_MSG_ID_MISSION_ACK: {
      const mavlink_mission_ack_t ack = messageIn<mavlink_mission_ack_t>(payload);
      if (ack.opaque_id != 0) return "ACK is sent with an opaque_id";
      decoded = message(Kind::Ack, ack.type);
      type = ack.mission_type;
      break;
    }
    case MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL: return decodeFile(payload, firmware, decoded);
    default: return "a message is sent that has no place in these operations";
  }
  if (type > kRally) return "a frame is sent with a type that no plan has";
  decoded.type = type & 3;
  return nullptr;
}
