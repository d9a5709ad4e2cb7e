#include "Outbox.h"

#include <Arduino.h>

#include "../base/Checksum.h"
#include "../base/Clock.h"
#include "../base/Flash.h"
#include "../base/MavlinkHeaders.h"

namespace mavmission {
namespace detail {
namespace {

// Copies bytes towards the front, and returns the place after the copy.
uint8_t* copyToFront(uint8_t* to, const uint8_t* from, uint8_t length) {
  if (length != 0) {
    do *to++ = *from++;
    while (--length != 0);  // quicker than a loop that asks first
  }
  return to;
}

}  // namespace

void Outbox::begin(bool isV1, uint8_t sequence, uint8_t systemId, uint8_t componentId) {
  uint8_t* out = frame_;
  if (isV1) {
    *out++ = MAVLINK_STX_MAVLINK1;
  } else {
    *out++ = MAVLINK_STX;
    *++out = 0;  // incompatibility flags
#if MAVMISSION_SIGNING
    if (signs_) *out = MAVLINK_IFLAG_SIGNED;
#endif
    *++out = 0;  // compatibility flags
  }
  *++out = sequence;
  *++out = systemId;
  *++out = componentId;
}

void Outbox::complete(const MessageKey* key, const uint8_t* payload) {
  const uint16_t id = fromFlash(&key->id);
  uint8_t length;
  uint8_t* out = frame_ + 5;
  if (frame_[0] == MAVLINK_STX_MAVLINK1) {
    length = fromFlash(&key->lengthV1);
    *out++ = static_cast<uint8_t>(id);
  } else {
    length = fromFlash(&key->length);
    while (length > 1 && payload[length - 1] == 0) --length;  // MAVLink 2 drops trailing zeros, never the first byte
    out += 2;
    *out++ = static_cast<uint8_t>(id);
    *out++ = static_cast<uint8_t>(id >> 8);
    *out++ = 0;
  }
  frame_[1] = length;
  out = copyToFront(out, payload, length);
  *out = fromFlash(&key->crcExtra);  // the last byte that the checksum covers; the checksum then overwrites it
  const uint16_t crc = checksum(kChecksumStart, frame_ + 1, static_cast<uint8_t>(out - frame_));
  *out++ = static_cast<uint8_t>(crc);
  *out++ = static_cast<uint8_t>(crc >> 8);
  length_ = static_cast<uint16_t>(out - frame_);
  writeForeign_ = nullptr;
  sent_ = length_;
  fill_ = kHeld;
}

void Outbox::flush(Stream& stream, uint16_t nowMs, uint8_t most) {
#if MAVMISSION_SIGNING
  if (isUnsigned_) return;
#endif
  const int said = room_.of(stream, nowMs, kBlindBytes);
  if (said == 0) return;
  constexpr Room kMostRoom = static_cast<Room>(-1);
  const Room room = said < kMostRoom ? static_cast<Room>(said) : kMostRoom;
  if (room > idle_) idle_ = room;
  if (room < most) most = static_cast<uint8_t>(room);
  for (; fill_ != 0 && most != 0; --most, --fill_) stream.write(static_cast<uint8_t>(0));
  if (writeForeign_ != nullptr) return writeForeign_(*this, stream, most);
  const uint8_t left = static_cast<uint8_t>(length_ - sent_);
  sent_ += stream.write(frame_ + sent_, most < left ? most : left);
}

uint8_t Outbox::busyMs(Stream& stream, uint16_t nowMs) const {
  if (stream.availableForWrite() >= idle_) return 0;
  return static_cast<uint8_t>(since(room_.roomMs(), nowMs));
}

}  // namespace detail
}  // namespace mavmission
