#include "Evidence.h"

#include <math.h>

#include "Px4Checksum.h"
#include "mavmission/base/MavlinkHeaders.h"
#include "mavmission/plan/WirePlan.h"

using namespace mavmission;
using namespace mavmission::detail;

namespace {

bool isForUs(uint8_t system, uint8_t component) {
  return (system == 0 || system == kAutopilot) && (component == 0 || component == kClient);
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

size_t behindFill(const Bytes& bytes, size_t at) {
  constexpr size_t kFill = 12;
  size_t zeros = 0;
  while (zeros < kFill && at + zeros < bytes.size() && bytes[at + zeros] == 0) ++zeros;
  return zeros == kFill ? at + zeros : at;
}

std::vector<FrameParts> framesIn(const Bytes& bytes) {
  std::vector<FrameParts> frames;
  for (size_t at = 0; at < bytes.size(); ++at) {
    const FrameIn frame = frameAt(bytes, at);
    if (frame.isRight) frames.push_back(frame.parts);
  }
  return frames;
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

bool holdsAnswer(const Bytes& heard, bool isEmpty, uint16_t last) {
  bool isAsked = isEmpty;
  for (const FrameParts& frame : framesIn(heard)) {
    if (frame.messageId == MAVLINK_MSG_ID_MISSION_REQUEST || frame.messageId == MAVLINK_MSG_ID_MISSION_REQUEST_INT) {
      const mavlink_mission_request_int_t request = messageIn<mavlink_mission_request_int_t>(frame.payload);
      const bool isOurs = isForUs(request.target_system, request.target_component) && request.mission_type == 0;
      isAsked = isAsked || (isOurs && request.seq == last);
    }
    if (frame.messageId == MAVLINK_MSG_ID_MISSION_ACK && isAsked) {
      const mavlink_mission_ack_t ack = messageIn<mavlink_mission_ack_t>(frame.payload);
      if (isForUs(ack.target_system, ack.target_component) && ack.type == 0 && ack.mission_type == 0) return true;
    }
  }
  return false;
}

bool holdsReading(const Bytes& heard, const Bytes& asked, const WireItems& meant, Firmware firmware) {
  const bool isArduPilot = firmware == Firmware::ArduPilot;
  bool isCounted = false, isListed = false;
  std::vector<bool> isRead(meant.size()), isAskedFor(meant.size());
  for (const FrameParts& frame : framesIn(asked)) {
    const uint32_t id = frame.messageId;
    if (id == MAVLINK_MSG_ID_MISSION_REQUEST_LIST) isListed = true;
    if (id != MAVLINK_MSG_ID_MISSION_REQUEST && id != MAVLINK_MSG_ID_MISSION_REQUEST_INT) continue;
    const uint16_t seq = messageIn<mavlink_mission_request_int_t>(frame.payload).seq;
    if (seq < meant.size()) isAskedFor[seq] = true;
  }
  for (const FrameParts& frame : framesIn(heard)) {
    if (frame.messageId == MAVLINK_MSG_ID_MISSION_COUNT) {
      const mavlink_mission_count_t count = messageIn<mavlink_mission_count_t>(frame.payload);
      const bool isHomeAlone = isArduPilot && meant.empty() && count.count == 1;
      if (!isForUs(count.target_system, count.target_component) || count.mission_type != 0) continue;
      isCounted = isCounted || count.count == meant.size() || isHomeAlone;
    }
    if (frame.messageId == MAVLINK_MSG_ID_MISSION_ITEM_INT) {
      const mavlink_mission_item_int_t item = messageIn<mavlink_mission_item_int_t>(frame.payload);
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
  uint32_t sum = 0;
  for (const MissionItem& item : items)
    sum = px4Checksum(sum, messageIn<mavlink_mission_item_int_t>(itemParts(0, item).payload));
  return sum;
}

bool holdsName(const Bytes& heard, const WireItems& meant) {
  const uint32_t name = nameOf(meant);
  for (const FrameParts& frame : framesIn(heard)) {
    const mavlink_mission_count_t count = messageIn<mavlink_mission_count_t>(frame.payload);
    if (frame.messageId != MAVLINK_MSG_ID_MISSION_COUNT || count.mission_type != 0) continue;
    if (!isForUs(count.target_system, count.target_component)) continue;
    if (count.count == meant.size() && count.opaque_id == name) return true;
  }
  return false;
}

bool announces(const Bytes& written, uint16_t& announced) {
  bool isThere = false;
  for (const FrameParts& frame : framesIn(written)) {
    const bool isCount = frame.messageId == MAVLINK_MSG_ID_MISSION_COUNT;
    if (isCount) announced = messageIn<mavlink_mission_count_t>(frame.payload).count;
    isThere = isThere || isCount || frame.messageId == MAVLINK_MSG_ID_MISSION_WRITE_PARTIAL_LIST;
  }
  return isThere;
}

bool holdsMessage(const Bytes& bytes, uint32_t messageId) {
  for (const FrameParts& frame : framesIn(bytes)) {
    if (frame.messageId == messageId) return true;
  }
  return false;
}
