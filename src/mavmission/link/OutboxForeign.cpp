// Outbox for messages of the sketch's own; apart because not every sketch has some.
#include <Arduino.h>

#include "../base/Checksum.h"
#include "../base/MavlinkHeaders.h"
#include "Outbox.h"

namespace mavmission {
namespace detail {

void Outbox::completeForeign(const OutgoingMessage& message) {
  const uint8_t* const body = static_cast<const uint8_t*>(message.payload);
  uint8_t bodyLength = message.length;
  uint8_t* out = frame_ + 5;
  if (frame_[0] == MAVLINK_STX_MAVLINK1) {
    bodyLength = message.lengthV1;
    *out++ = static_cast<uint8_t>(message.id);
  } else {
    while (bodyLength > 1 && body[bodyLength - 1] == 0) --bodyLength;
    out += 2;  // the header is longer by its flags, which begin() has written
    *out++ = static_cast<uint8_t>(message.id);
    *out++ = static_cast<uint8_t>(message.id >> 8);
    *out++ = static_cast<uint8_t>(message.id >> 16);
  }
  frame_[1] = bodyLength;
  foreign_.headLength = static_cast<uint8_t>(out - frame_);

  uint16_t crc = checksum(kChecksumStart, frame_ + 1, static_cast<uint8_t>(out - frame_ - 1));
  crc = checksum(crc, body, bodyLength);
  crc = checksum(crc, &message.crcExtra, 1);
  *out++ = static_cast<uint8_t>(crc);
  *out++ = static_cast<uint8_t>(crc >> 8);
  length_ = static_cast<uint16_t>(out - frame_) + bodyLength;
  foreign_.body = body;
  foreign_.bodyLength = bodyLength;
  writeForeign_ = writeForeign;
  fill_ = kHeld;
}

// What lies before the payload, the payload, or what follows it.
void Outbox::writeForeign(Outbox& outbox, Stream& stream, uint16_t room) {
  const Foreign& foreign = outbox.foreign_;
  const uint16_t sent = outbox.sent_;
  const uint16_t bodyEnd = foreign.headLength + foreign.bodyLength;
  const uint8_t* piece;
  uint16_t left;
  if (sent < foreign.headLength) {
    piece = foreign.around + sent;
    left = foreign.headLength - sent;
  } else if (sent < bodyEnd) {
    piece = foreign.body + (sent - foreign.headLength);
    left = bodyEnd - sent;
  } else {
    piece = foreign.around + (sent - foreign.bodyLength);
    left = outbox.length_ - sent;
  }
  outbox.sent_ += stream.write(piece, room < left ? room : left);
}

}  // namespace detail
}  // namespace mavmission
