#include "Message.h"

#include <string.h>

#include <map>
#include <tuple>

#include "FileWords.h"
#include "Plans.h"
#include "mavmission/base/Checksum.h"
#include "mavmission/base/MavlinkHeaders.h"

namespace {

const uint8_t kAutopilotSystem = 1, kAutopilotComponent = 1, kClientComponent = 191;

const char* resultName(uint16_t result) {
  switch (result) {
    case kAccepted: return "accepted";
    case kError: return "error";
    case kUnsupported: return "unsupported";
    case kInvalidSequence: return "invalid sequence";
    case kDenied: return "denied";
    case kCancelled: return "cancelled";
    default: return "another result";
  }
}

const char* setType(Message& message, uint8_t type) {
  if (type > kRally) return "a frame is sent with a type that no plan has";
  message.type = type;
  return nullptr;
}

FrameParts partsOf(const Message& message, Firmwares firmware) {
  switch (message.kind) {
    case Kind::Heartbeat: {
      mavlink_heartbeat_t beat = mavlink_heartbeat_t();
      beat.type = MAV_TYPE_QUADROTOR;
      beat.autopilot = isGeneric(firmware)     ? MAV_AUTOPILOT_GENERIC
                       : isArduPilot(firmware) ? MAV_AUTOPILOT_ARDUPILOTMEGA
                                               : MAV_AUTOPILOT_PX4;
      beat.mavlink_version = 3;
      return FrameParts(MAVLINK_MSG_ID_HEARTBEAT, beat, MAVLINK_MSG_ID_HEARTBEAT_CRC);
    }
    case Kind::Count: {
      mavlink_mission_count_t count = mavlink_mission_count_t();
      count.target_system = 1;
      count.target_component = kClientComponent;
      count.count = message.number;
      count.opaque_id = message.opaqueId;
      count.mission_type = message.type;
      return FrameParts(MAVLINK_MSG_ID_MISSION_COUNT, count, MAVLINK_MSG_ID_MISSION_COUNT_CRC);
    }
    case Kind::Request:
      // ArduPilot asks by the older message, which has the same layout.
      if (!isArduPilot(firmware)) return requestParts(message.number, 1, kClientComponent, message.type);
      return FrameParts(MAVLINK_MSG_ID_MISSION_REQUEST,
                        requestParts(message.number, 1, kClientComponent, message.type).payload,
                        MAVLINK_MSG_ID_MISSION_REQUEST_CRC);
    case Kind::Item:
      return FrameParts(MAVLINK_MSG_ID_MISSION_ITEM_INT,
                        payloadOf(message.item, message.number, message.type, firmware, true),
                        MAVLINK_MSG_ID_MISSION_ITEM_INT_CRC);
    case Kind::FileReply:
      return FrameParts(MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL, fileReplyPayload(message, firmware),
                        MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL_CRC);
    case Kind::Ack:
    case Kind::OlderRequest:
    case Kind::List:
    case Kind::ClearAll:
    case Kind::File: break;
  }
  return ackParts(static_cast<uint8_t>(message.number), 1, kClientComponent, message.type, message.opaqueId);
}

}  // namespace

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
    case Kind::Ack: return std::string("ACK ") + resultName(message.number) + kTypes[message.type];
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

const char* decode(const uint8_t* frame, size_t length, Firmwares firmware, Message& decoded) {
  if (length < 12 || frame[0] != MAVLINK_STX) return "what is sent is no MAVLink 2 frame";
  if (length != frame[1] + 12u) return "a frame is sent with a wrong length";
  const uint32_t id = frame[7] | frame[8] << 8 | frame[9] << 16;
  const mavlink_msg_entry_t* const entry = mavlink_get_msg_entry(id);
  if (entry == nullptr || frame[1] > entry->max_msg_len) return "a frame of an unknown message is sent";
  uint16_t crc = X25_INIT_CRC;
  for (size_t i = 1; i < length - 2; ++i) crc_accumulate(frame[i], &crc);
  crc_accumulate(entry->crc_extra, &crc);
  if (frame[length - 2] != (crc & 0xFF) || frame[length - 1] != crc >> 8)
    return "a frame is sent with a wrong checksum";
  if (frame[5] != kAutopilotSystem || frame[6] != kClientComponent) return "a frame is sent with a wrong sender";
  Bytes payload(frame + 10, frame + 10 + frame[1]);
  payload.resize(entry->max_msg_len, 0);
  if (payload[entry->target_system_ofs] != kAutopilotSystem ||
      payload[entry->target_component_ofs] != kAutopilotComponent) {
    return "a frame is sent to somebody else";
  }
  switch (id) {
    case MAVLINK_MSG_ID_MISSION_COUNT: {
      mavlink_mission_count_t count;
      memcpy(&count, payload.data(), sizeof(count));
      if (count.opaque_id != 0) return "COUNT is sent with an opaque_id";
      decoded = message(Kind::Count, count.count);
      return setType(decoded, count.mission_type);
    }
    case MAVLINK_MSG_ID_MISSION_ITEM_INT: {
      const uint8_t item = itemIn(payload, firmware);
      if (item == kNoItemAtAll) return "an item is sent that is in no plan";
      decoded = message(Kind::Item, static_cast<uint16_t>(payload[28] | payload[29] << 8), item);
      return setType(decoded, payload[37]);
    }
    case MAVLINK_MSG_ID_MISSION_REQUEST_INT: {
      mavlink_mission_request_int_t request;
      memcpy(&request, payload.data(), sizeof(request));
      decoded = message(Kind::Request, request.seq);
      return setType(decoded, request.mission_type);
    }
    case MAVLINK_MSG_ID_MISSION_REQUEST: {
      if (!isGeneric(firmware)) return "an item is asked for by MISSION_REQUEST";
      mavlink_mission_request_t request;
      memcpy(&request, payload.data(), sizeof(request));
      decoded = message(Kind::OlderRequest, request.seq);
      return setType(decoded, request.mission_type);
    }
    case MAVLINK_MSG_ID_MISSION_REQUEST_LIST: decoded = message(Kind::List); return setType(decoded, payload[2]);
    case MAVLINK_MSG_ID_MISSION_CLEAR_ALL: decoded = message(Kind::ClearAll); return setType(decoded, payload[2]);
    case MAVLINK_MSG_ID_MISSION_ACK: {
      mavlink_mission_ack_t ack;
      memcpy(&ack, payload.data(), sizeof(ack));
      if (ack.opaque_id != 0) return "ACK is sent with an opaque_id";
      decoded = message(Kind::Ack, ack.type);
      return setType(decoded, ack.mission_type);
    }
    case MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL: return decodeFile(payload, firmware, decoded);
    default: return "a message is sent that has no place in these operations";
  }
}
