#include "AutopilotHeartbeat.h"

#include "../autopilot/AutopilotFinder.h"
#include "../base/Checksum.h"
#include "../base/MavlinkHeaders.h"

namespace mavmission {
namespace detail {
namespace {

constexpr uint8_t kHeaderV1 = MAVLINK_CORE_HEADER_MAVLINK1_LEN + 1, kHeaderV2 = MAVLINK_NUM_HEADER_BYTES;
constexpr uint8_t kPayload = MAVLINK_MSG_ID_HEARTBEAT_LEN;  // whole also in MAVLink 2: its last byte is never 0

// Reads so many bytes; false if the datagram ends before.
bool take(Stream& datagram, uint8_t* to, uint8_t count) {
  for (; count != 0; --count) {
    const int byte = datagram.read();
    if (byte < 0) return false;
    *to++ = static_cast<uint8_t>(byte);
  }
  return true;
}

bool isAutopilots(const uint8_t* frame, uint8_t header) {
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

bool readAutopilotHeartbeat(Stream& datagram) {
  uint8_t frame[kHeaderV2 + kPayload + MAVLINK_NUM_CHECKSUM_BYTES];
  while (take(datagram, frame, kHeaderV1)) {
    const bool isV2 = frame[0] == MAVLINK_STX;
    if (!isV2 && frame[0] != MAVLINK_STX_MAVLINK1) break;
    const uint8_t header = isV2 ? kHeaderV2 : kHeaderV1;
    if (!take(datagram, frame + kHeaderV1, header - kHeaderV1)) return false;
    uint16_t rest = frame[1] + MAVLINK_NUM_CHECKSUM_BYTES;
    if (isV2 && (frame[2] & MAVLINK_IFLAG_SIGNED) != 0) rest += MAVLINK_SIGNATURE_BLOCK_LEN;
    const bool isHeartbeat = isV2 ? (frame[7] | frame[8] | frame[9]) == 0 : frame[5] == 0;
    if (isHeartbeat && frame[1] == kPayload) {
      constexpr uint8_t kBody = kPayload + MAVLINK_NUM_CHECKSUM_BYTES;
      if (!take(datagram, frame + header, kBody)) return false;
      if (isAutopilots(frame, header)) return true;
      rest -= kBody;
    }
    for (; rest != 0; --rest) {
      if (datagram.read() < 0) return false;
    }
  }
  while (datagram.read() >= 0) {
  }
  return false;
}

}  // namespace detail
}  // namespace mavmission
