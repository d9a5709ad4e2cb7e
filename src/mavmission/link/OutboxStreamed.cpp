// Frames that are longer than the outbox: the payload is made piece by piece. Apart because not every sketch has some.
#include <Arduino.h>
#include <string.h>

#include "../base/Checksum.h"
#include "../base/Flash.h"
#include "Link.h"
#include "Outbox.h"

namespace mavmission {
namespace detail {

void Link::sendStreamed(const MessageKey* key, uint8_t length, Outbox::NextPiece next, void* context) {
  outbox_.begin(false, sequence(), systemId(), componentId());
  outbox_.completeStreamed(key, length, next, context);
  release();
}

void Outbox::completeStreamed(const MessageKey* key, uint8_t length, NextPiece next, void* context) {
  constexpr uint8_t kHeader = 10;
  const uint16_t id = fromFlash(&key->id);
  streamed_.piece[1] = length;
  streamed_.piece[7] = static_cast<uint8_t>(id);
  streamed_.piece[8] = static_cast<uint8_t>(id >> 8);
  streamed_.piece[9] = 0;
  streamed_.length = kHeader;
  streamed_.sent = 0;
  streamed_.crc = checksum(kChecksumStart, streamed_.piece + 1, kHeader - 1);
  streamed_.next = next;
  streamed_.context = context;
  streamed_.extra = fromFlash(&key->crcExtra);
  length_ = kHeader + length + 2;
  writeForeign_ = writeStreamed;
  sent_ = length_;
  fill_ = kHeld;
}

void Outbox::writeStreamed(Outbox& outbox, Stream& stream, uint16_t room) {
  Streamed& streamed = outbox.streamed_;
  if (streamed.sent == streamed.length) {
    const uint16_t left = outbox.length_ - 2 - outbox.sent_;  // of the payload
    uint8_t length;
    if (left == 0) {
      streamed.crc = checksum(streamed.crc, &streamed.extra, 1);
      memcpy(streamed.piece, &streamed.crc, 2);
      length = 2;
    } else {
      length = streamed.next(streamed.context, streamed.piece);
      if (length == kNotNow) return;
      if (length == kBroken) {
        memset(streamed.piece, 0, kMaxPayload);
        length = kMaxPayload;
        ++streamed.extra;
      }
      if (length > left) length = static_cast<uint8_t>(left);
      streamed.crc = checksum(streamed.crc, streamed.piece, length);
    }
    streamed.length = length;
    streamed.sent = 0;
  }
  const uint8_t left = streamed.length - streamed.sent;
  const uint8_t written = static_cast<uint8_t>(stream.write(streamed.piece + streamed.sent, room < left ? room : left));
  streamed.sent += written;
  outbox.sent_ += written;
}

}  // namespace detail
}  // namespace mavmission
