#include "PlainClient.h"

#include <string.h>

#include "../explorer/Plans.h"
#include "mavmission/base/MavlinkHeaders.h"

namespace {

constexpr uint8_t kUs = 191;

template <typename T>
Bytes bytesOf(const T& message) {
  const uint8_t* begin = reinterpret_cast<const uint8_t*>(&message);
  Bytes bytes(begin, begin + sizeof(message));
  while (bytes.size() > 1 && bytes.back() == 0) bytes.pop_back();
  return bytes;
}

FrameParts partsOf(Kind kind, uint16_t number, uint8_t item, Firmwares firmware) {
  if (kind == Kind::Count) {
    mavlink_mission_count_t count = mavlink_mission_count_t();
    count.target_system = count.target_component = 1;
    count.count = number;
    return FrameParts(MAVLINK_MSG_ID_MISSION_COUNT, bytesOf(count), MAVLINK_MSG_ID_MISSION_COUNT_CRC);
  }
  if (kind == Kind::Item) {
    Bytes payload = payloadOf(item, number, firmware, false, false);
    while (payload.size() > 1 && payload.back() == 0) payload.pop_back();
    return FrameParts(MAVLINK_MSG_ID_MISSION_ITEM_INT, payload, MAVLINK_MSG_ID_MISSION_ITEM_INT_CRC);
  }
  mavlink_heartbeat_t beat = mavlink_heartbeat_t();
  beat.type = MAV_TYPE_ONBOARD_CONTROLLER;
  beat.autopilot = MAV_AUTOPILOT_INVALID;
  beat.mavlink_version = 3;
  return FrameParts(MAVLINK_MSG_ID_HEARTBEAT, bytesOf(beat), MAVLINK_MSG_ID_HEARTBEAT_CRC);
}

}  // namespace

void PlainClient::hear(const Bytes& bytes, uint32_t nowMs) {
  std::vector<Found> found;
  if (nowMs - heardMs_ >= kSilenceMs) found = parser_.silence();
  heardMs_ = nowMs;
  for (const Found& one : parser_.take(bytes)) found.push_back(one);
  for (const Found& one : wanted(found)) {
    Bytes payload = one.payload;
    payload.resize(40, 0);
    const uint16_t number = static_cast<uint16_t>(payload[0] | payload[1] << 8);
    switch (one.messageId) {
      case MAVLINK_MSG_ID_MISSION_REQUEST:
      case MAVLINK_MSG_ID_MISSION_REQUEST_INT:
        if (number < items_.size()) hear(message(Kind::Request, number), nowMs);
        break;
      case MAVLINK_MSG_ID_MISSION_ACK: hear(message(Kind::Ack, payload[2]), nowMs); break;
      default: break;
    }
  }
}

void PlainClient::send(Kind kind, uint16_t number, uint8_t zerosBefore) {
  FrameParts parts = partsOf(kind, number, kind == Kind::Item ? items_[number] : kNoItemAtAll, firmware_);
  parts.sequence = sequence_++;
  parts.componentId = kUs;
  out_.resize(out_.size() + zerosBefore, 0);
  out_ = out_ + packed(parts);
}

Bytes PlainClient::run(uint32_t nowMs, size_t room) {
  if (nowMs != actedMs_) {
    actedMs_ = nowMs;
    if (nowMs % kHeartbeatMs == 0) send(Kind::Heartbeat);
    act(nowMs);
  }
  const long taken = static_cast<long>(room < out_.size() ? room : out_.size());
  const Bytes bytes(out_.begin(), out_.begin() + taken);
  out_.erase(out_.begin(), out_.begin() + taken);
  return bytes;
}
