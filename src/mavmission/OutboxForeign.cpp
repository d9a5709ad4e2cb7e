// Outbox for messages of the sketch's own; apart because not every sketch has some.
#include "Checksum.h"
#include "MavlinkHeaders.h"
#include "Outbox.h"

namespace mavmission {

void Outbox::completeForeign(const OutgoingMessage& message) {
  body_ = static_cast<const uint8_t*>(message.payload);
  bodyLength_ = message.length;
  uint8_t* out = frame_ + 5;
  if (frame_[0] == MAVLINK_STX_MAVLINK1) {
    bodyLength_ = message.lengthV1;
    *out++ = static_cast<uint8_t>(message.id);
  } else {
    while (bodyLength_ > 1 && body_[bodyLength_ - 1] == 0) --bodyLength_;
    out += 2;  // the header is longer by its flags, which begin() has written
    *out++ = static_cast<uint8_t>(message.id);
    *out++ = static_cast<uint8_t>(message.id >> 8);
    *out++ = static_cast<uint8_t>(message.id >> 16);
  }
  frame_[1] = bodyLength_;
  headLength_ = static_cast<uint8_t>(out - frame_);

  uint16_t crc = kChecksumStart;
  for (const uint8_t* byte = frame_ + 1; byte != out; ++byte) crc = checksum(crc, *byte);
  for (uint8_t i = 0; i < bodyLength_; ++i) crc = checksum(crc, body_[i]);
  crc = checksum(crc, message.crcExtra);
  *out++ = static_cast<uint8_t>(crc);
  *out++ = static_cast<uint8_t>(crc >> 8);
  length_ = static_cast<uint16_t>(out - frame_) + bodyLength_;
  sent_ = 0;
}

}  // namespace mavmission
