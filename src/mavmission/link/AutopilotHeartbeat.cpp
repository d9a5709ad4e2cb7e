#include "AutopilotHeartbeat.h"

#include "../autopilot/AutopilotFinder.h"
#include "../base/Checksum.h"
#include "../base/MavlinkHeaders.h"

namespace mavmission {
namespace detail {
namespace {

constexpr uint8_t kHeaderV1 = MAVLINK_CORE_HEADER_MAVLINK1_LEN + 1, kHeaderV2 = MAVLINK_NUM_HEADER_BYTES;
constexpr uint8_t kPayload = MAVLINK_MSG_ID_HEARTBEAT_LEN;  // whole also in MAVLink 2: its last byte is never 0
constexpr uint8_t kBody = kPayload + MAVLINK_NUM_CHECKSUM_BYTES;

uint8_t headerOf(const uint8_t* frame) { return frame[0] == MAVLINK_STX ? kHeaderV2 : kHeaderV1; }

bool isAutopilots(const uint8_t* frame) {
  const uint8_t header = headerOf(frame);
  const uint8_t* const payload = frame + header;
  const uint8_t extra = MAVLINK_MSG_ID_HEARTBEAT_CRC;
  uint16_t crc = checksum(kChecksumStart, frame + 1, header + kPayload - 1);
  crc = checksum(crc, &extra, 1);
  const uint8_t* const sum = payload + kPayload;
  if (static_cast<uint16_t>(sum[0] | sum[1] << 8) != crc) return false;
  const uint8_t* const ids = payload - (header == kHeaderV2 ? 5 : 3);
  AutopilotFinder finder = AutopilotFinder();
  return finder.onHeartbeat(ids[0], ids[1], payload[offsetof(mavlink_heartbeat_t, autopilot)],
                            payload[offsetof(mavlink_heartbeat_t, type)], 0);
}

}  // namespace

// Whether the bytes that are there may be the beginning of an autopilot's heartbeat; if all are there, whether they are
// one.
bool HeartbeatSearch::fits() const {
  const bool isV2 = frame_[0] == MAVLINK_STX;
  if (!isV2 && frame_[0] != MAVLINK_STX_MAVLINK1) return false;
  if (length_ > 1 && frame_[1] != kPayload) return false;
  const uint8_t header = headerOf(frame_);
  // The message's number, 0, is the last of the header: three bytes in MAVLink 2, one in MAVLink 1.
  for (uint8_t i = header - (isV2 ? 3 : 1); i < header && i < length_; ++i) {
    if (frame_[i] != 0) return false;
  }
  return length_ < header + kBody || isAutopilots(frame_);
}

bool HeartbeatSearch::readsAutopilot(Stream& datagram) {
  static_assert(kLongest == kHeaderV2 + kBody, "the longest heartbeat without a signature");
  for (int byte; (byte = datagram.read()) >= 0;) {
    frame_[length_++] = static_cast<uint8_t>(byte);
    // Another beginning may be among the bytes that were taken for the rest of this one.
    while (length_ != 0 && !fits()) memmove(frame_, frame_ + 1, --length_);
    if (length_ != 0 && length_ == headerOf(frame_) + kBody) {
      length_ = 0;
      return true;
    }
  }
  return false;
}

}  // namespace detail
}  // namespace mavmission
