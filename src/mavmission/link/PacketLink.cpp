#include "PacketLink.h"

#include <string.h>

#include "../base/MavlinkHeaders.h"

namespace mavmission {
namespace {

constexpr uint8_t kLengthKnown = 3;  // bytes of a frame, from which its length is known

uint16_t lengthOf(const uint8_t* frame) {
  if (frame[0] == MAVLINK_STX_MAVLINK1) return 8 + uint16_t{frame[1]};
  return 12 + uint16_t{frame[1]} + ((frame[2] & MAVLINK_IFLAG_SIGNED) != 0 ? MAVLINK_SIGNATURE_BLOCK_LEN : 0);
}

}  // namespace

int PacketLink::availableForWrite() {
  flush();
  return static_cast<int>(size_ - length_);
}

size_t PacketLink::write(uint8_t byte) {
  if (skip_ != 0) {
    --skip_;
    return 1;
  }
  if (length_ == whole_ && byte != MAVLINK_STX && byte != MAVLINK_STX_MAVLINK1) return 1;
  if (length_ == size_) flush();
  if (length_ == size_) return 0;
  buffer_[length_++] = byte;
  const uint16_t begun = length_ - whole_;
  if (begun < kLengthKnown) return 1;
  const uint16_t needed = lengthOf(buffer_ + whole_);
  if (needed > size_) {
    ++unsent_;
    skip_ = needed - begun;
    length_ = whole_;
  } else if (begun == needed) {
    whole_ = length_;
    flush();
  }
  return 1;
}

size_t PacketLink::write(const uint8_t* bytes, size_t size) {
  size_t taken = 0;
  while (taken != size && write(bytes[taken]) == 1) ++taken;
  return taken;
}

void PacketLink::flush() {
  if (whole_ == 0 || !isFree()) return;
  if (sendPacket(buffer_, whole_)) {
    ++packetsSent_;
  } else {
    ++unsent_;
  }
  length_ -= whole_;
  memmove(buffer_, buffer_ + whole_, length_);
  whole_ = 0;
}

}  // namespace mavmission
