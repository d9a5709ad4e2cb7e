#include "Evidence.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mavmission/base/MavlinkHeaders.h"
#include "mavmission/plan/WirePlan.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

bool isForUs(uint8_t system, uint8_t component) {
  return (system == 0 || system == kAutopilot) && (component == 0 || component == kClient);
}

template <typename T>
T messageIn(const Bytes& payload) {
  T message;
  memcpy(&message, payload.data(), sizeof(message));
  return message;
}

bool isSameNumber(float sent, float read) { return sent == read || (isnan(sent) && isnan(read)); }

// The frames with "INT" in their names are older names of the same.
uint8_t modernFrame(uint8_t frame) { return frame == 5 ? 0 : frame == 6 ? 3 : frame == 11 ? 10 : frame; }

// Nothing in the plan here is of what autopilots drop or round, but for ArduPilot's centimetres.
bool isSameItem(const MissionItem& meant, const mavlink_mission_item_int_t& read, bool isArduPilot) {
  const uint8_t frame = static_cast<uint8_t>(meant.frame);
  const bool isPlaceless = isArduPilot && read.frame == 0 && frame == 2;
  const bool isNear = isArduPilot && fabs(static_cast<double>(meant.z) - static_cast<double>(read.z)) <= 0.01;
  return read.command == meant.command && (isPlaceless || modernFrame(read.frame) == modernFrame(frame)) &&
         isSameNumber(meant.param1, read.param1) && isSameNumber(meant.param2, read.param2) &&
         isSameNumber(meant.param3, read.param3) && isSameNumber(meant.param4, read.param4) && read.x == meant.x &&
         read.y == meant.y && (isNear || isSameNumber(meant.z, read.z)) &&
         (read.autocontinue == meant.autocontinue || (isArduPilot && read.autocontinue == 1));
}

}  // namespace

void demand(bool holds, const char* what) {
  if (holds) return;
  fprintf(stderr, "%s\n", what);
  abort();
}

size_t behindFill(const Bytes& bytes, size_t at) {
  constexpr size_t kFill = 12;
  size_t zeros = 0;
  while (zeros < kFill && at + zeros < bytes.size() && bytes[at + zeros] == 0) ++zeros;
  return zeros == kFill ? at + zeros : at;
}

bool isRight(const Bytes& bytes, size_t at, uint32_t& id, Bytes& payload, size_t& size) {
  const bool v2 = bytes[at] == 0xFD;
  const size_t header = v2 ? 10 : 6;
  if ((!v2 && bytes[at] != 0xFE) || bytes.size() - at < header + 2) return false;
  const size_t length = bytes[at + 1];
  size = header + length + 2;
  if (bytes.size() - at < size) return false;
  id = v2 ? static_cast<uint32_t>(bytes[at + 7] | bytes[at + 8] << 8 | bytes[at + 9] << 16) : bytes[at + 5];
  const mavlink_msg_entry_t* entry = mavlink_get_msg_entry(id);
  if (entry == nullptr) return false;
  uint16_t crc = X25_INIT_CRC;
  for (size_t i = 1; i < size - 2; ++i) crc_accumulate(bytes[at + i], &crc);
  crc_accumulate(entry->crc_extra, &crc);
  if (bytes[at + size - 2] != (crc & 0xFF) || bytes[at + size - 1] != crc >> 8) return false;
  payload.assign(bytes.begin() + static_cast<long>(at + header),
                 bytes.begin() + static_cast<long>(at + header + length));
  payload.resize(255, 0);
  return true;
}

WireItems wireItems(const MissionItem* plan, uint16_t count, Firmware firmware) {
  WirePlan wire = WirePlan();
  wire.setSource(inRam(plan, count));
  wire.begin(firmware, 2, PlanType::Mission, false);
  WireItems items(wire.wireCount());
  for (uint16_t i = 0; i < wire.wireCount(); ++i) {
    while (wire.read(i, items[i]) == Status::Checking) {
    }
  }
  return items;
}

FrameParts itemParts(const MissionItem& item, uint16_t sequence) {
  mavlink_mission_item_int_t message = mavlink_mission_item_int_t();
  message.seq = sequence;
  message.target_system = kAutopilot;
  message.target_component = kClient;
  message.command = item.command;
  message.frame = static_cast<uint8_t>(item.frame);
  message.autocontinue = item.autocontinue;
  message.param1 = item.param1;
  message.param2 = item.param2;
  message.param3 = item.param3;
  message.param4 = item.param4;
  message.x = item.x;
  message.y = item.y;
  message.z = item.z;
  return FrameParts(MAVLINK_MSG_ID_MISSION_ITEM_INT, bytesOf(message), MAVLINK_MSG_ID_MISSION_ITEM_INT_CRC);
}

FrameParts countParts(uint16_t count, uint32_t opaqueId) {
  mavlink_mission_count_t message = mavlink_mission_count_t();
  message.count = count;
  message.target_system = kAutopilot;
  message.target_component = kClient;
  message.opaque_id = opaqueId;
  return FrameParts(MAVLINK_MSG_ID_MISSION_COUNT, bytesOf(message), MAVLINK_MSG_ID_MISSION_COUNT_CRC);
}

bool holdsAnswer(const Bytes& heard, bool isEmpty, uint16_t last) {
  bool isAsked = isEmpty;
  for (size_t at = 0; at < heard.size(); ++at) {
    uint32_t id;
    Bytes payload;
    size_t size;
    if (!isRight(heard, at, id, payload, size)) continue;
    if (id == MAVLINK_MSG_ID_MISSION_REQUEST || id == MAVLINK_MSG_ID_MISSION_REQUEST_INT) {
      const mavlink_mission_request_int_t request = messageIn<mavlink_mission_request_int_t>(payload);
      const bool isOurs = isForUs(request.target_system, request.target_component) && request.mission_type == 0;
      isAsked = isAsked || (isOurs && request.seq == last);
    }
    if (id == MAVLINK_MSG_ID_MISSION_ACK && isAsked) {
      const mavlink_mission_ack_t ack = messageIn<mavlink_mission_ack_t>(payload);
      if (isForUs(ack.target_system, ack.target_component) && ack.type == 0 && ack.mission_type == 0) return true;
    }
  }
  return false;
}

bool holdsReading(const Bytes& heard, const Bytes& asked, const WireItems& meant, Firmware firmware) {
  const bool isArduPilot = firmware == Firmware::ArduPilot;
  bool isCounted = false, isListed = false;
  std::vector<bool> isRead(meant.size()), isAskedFor(meant.size());
  uint32_t id;
  Bytes payload;
  size_t size;
  for (size_t at = 0; at < asked.size(); ++at) {
    if (!isRight(asked, at, id, payload, size)) continue;
    if (id == MAVLINK_MSG_ID_MISSION_REQUEST_LIST) isListed = true;
    if (id != MAVLINK_MSG_ID_MISSION_REQUEST && id != MAVLINK_MSG_ID_MISSION_REQUEST_INT) continue;
    const uint16_t seq = messageIn<mavlink_mission_request_int_t>(payload).seq;
    if (seq < meant.size()) isAskedFor[seq] = true;
  }
  for (size_t at = 0; at < heard.size(); ++at) {
    if (!isRight(heard, at, id, payload, size)) continue;
    if (id == MAVLINK_MSG_ID_MISSION_COUNT) {
      const mavlink_mission_count_t count = messageIn<mavlink_mission_count_t>(payload);
      const bool isHomeAlone = isArduPilot && meant.empty() && count.count == 1;
      if (!isForUs(count.target_system, count.target_component) || count.mission_type != 0) continue;
      isCounted = isCounted || count.count == meant.size() || isHomeAlone;
    }
    if (id == MAVLINK_MSG_ID_MISSION_ITEM_INT) {
      const mavlink_mission_item_int_t item = messageIn<mavlink_mission_item_int_t>(payload);
      if (!isForUs(item.target_system, item.target_component) || item.mission_type != 0) continue;
      if (item.seq >= meant.size()) continue;
      if ((isArduPilot && item.seq == 0) || isSameItem(meant[item.seq], item, isArduPilot)) isRead[item.seq] = true;
    }
  }
  for (size_t i = 0; i < meant.size(); ++i) {
    if (!isAskedFor[i] || !isRead[i]) return false;
  }
  return isListed && isCounted;
}

uint32_t nameOf(const WireItems& items) {
  Bytes bytes;
  for (const MissionItem& item : items) {
    const mavlink_mission_item_int_t message = messageIn<mavlink_mission_item_int_t>(itemParts(item, 0).payload);
    const Bytes place = bytesOf(message);
    bytes.push_back(message.frame);
    bytes.push_back(static_cast<uint8_t>(message.command));
    bytes.push_back(static_cast<uint8_t>(message.command >> 8));
    bytes.push_back(message.autocontinue);
    bytes.insert(bytes.end(), place.begin(), place.begin() + 28);  // param1 to z
  }
  uint32_t sum = 0;
  for (uint8_t byte : bytes) {
    for (int bit = 0; bit < 8; ++bit) {
      const bool isSet = ((sum ^ static_cast<uint32_t>(byte >> bit)) & 1) != 0;
      sum = (sum >> 1) ^ (isSet ? 0xEDB88320u : 0u);
    }
  }
  return sum;
}

bool holdsName(const Bytes& heard, const WireItems& meant) {
  const uint32_t name = nameOf(meant);
  for (size_t at = 0; at < heard.size(); ++at) {
    uint32_t id;
    Bytes payload;
    size_t size;
    if (!isRight(heard, at, id, payload, size) || id != MAVLINK_MSG_ID_MISSION_COUNT) continue;
    const mavlink_mission_count_t count = messageIn<mavlink_mission_count_t>(payload);
    if (!isForUs(count.target_system, count.target_component) || count.mission_type != 0) continue;
    if (count.count == meant.size() && count.opaque_id == name) return true;
  }
  return false;
}

bool announces(const Bytes& written, uint16_t& announced) {
  bool isThere = false;
  for (size_t at = 0; at < written.size(); ++at) {
    uint32_t id;
    Bytes payload;
    size_t size;
    if (!isRight(written, at, id, payload, size)) continue;
    if (id == MAVLINK_MSG_ID_MISSION_COUNT) announced = messageIn<mavlink_mission_count_t>(payload).count;
    isThere = isThere || id == MAVLINK_MSG_ID_MISSION_COUNT || id == MAVLINK_MSG_ID_MISSION_WRITE_PARTIAL_LIST;
  }
  return isThere;
}

bool holdsMessage(const Bytes& bytes, uint32_t messageId) {
  for (size_t at = 0; at < bytes.size(); ++at) {
    uint32_t id;
    Bytes payload;
    size_t size;
    if (isRight(bytes, at, id, payload, size) && id == messageId) return true;
  }
  return false;
}
