#include "FrameParser.h"

#include <Arduino.h>
#include <string.h>

#include "../base/Checksum.h"
#include "../base/Flash.h"
#include "../base/MavlinkHeaders.h"

namespace mavmission {
namespace detail {
namespace {

bool isMagic(uint8_t byte) { return byte == MAVLINK_STX || byte == MAVLINK_STX_MAVLINK1; }

// Messages that carry other people's bytes, which may contain a whole frame. (A switch becomes a tree of comparisons,
// which is quicker than a table in flash.)
bool isCarrier(uint16_t messageId) {
  switch (messageId) {
    case MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL:
    case MAVLINK_MSG_ID_LOG_DATA:
    case MAVLINK_MSG_ID_GPS_INJECT_DATA:
    case MAVLINK_MSG_ID_SERIAL_CONTROL:
    case MAVLINK_MSG_ID_ENCAPSULATED_DATA:
    case MAVLINK_MSG_ID_GPS_RTCM_DATA:
    case MAVLINK_MSG_ID_V2_EXTENSION:
    case MAVLINK_MSG_ID_MEMORY_VECT:
    case MAVLINK_MSG_ID_LOGGING_DATA:
    case MAVLINK_MSG_ID_LOGGING_DATA_ACKED:
    case MAVLINK_MSG_ID_TUNNEL:
    case MAVLINK_MSG_ID_CAN_FRAME:
    case MAVLINK_MSG_ID_CANFD_FRAME: return true;
    default: return false;
  }
}

}  // namespace

const MessageKey* MoreKeys::find(uint16_t messageId) const {
  for (uint8_t i = 0; i < count; ++i) {
    if (fromFlash(&keys[i].id) == messageId) return &keys[i];
  }
  return nullptr;
}

const MessageKey* FrameParser::keyOf(uint16_t messageId) const {
  const MessageKey* key = wantedKey(messageId);
  return key == nullptr && moreKeys_ != nullptr ? moreKeys_->search(moreKeys_, messageId) : key;
}

bool FrameParser::isV2() const { return bytes_[0] == MAVLINK_STX; }

bool FrameParser::isSigned() const { return isV2() && (bytes_[2] & MAVLINK_IFLAG_SIGNED) != 0; }

void FrameParser::noteSender() {
  const uint8_t* const from = bytes_ + (isV2() ? 4 : 2);
  sender_.sequence = from[0];
  sender_.systemId = from[1];
  sender_.componentId = from[2];
}

uint16_t FrameParser::payloadWord(uint8_t index) const {
  const uint8_t* const bytes = payload() + index;
  const uint8_t left = length();
  const uint8_t low = index < left ? bytes[0] : 0;
  const uint8_t high = index + 1 < left ? bytes[1] : 0;
  return static_cast<uint16_t>(low | high << 8);
}

uint32_t FrameParser::payloadLong(uint8_t index) const {
  union {  // less code than a shift
    uint16_t words[2];
    uint32_t value;
  } both;
  both.words[0] = payloadWord(index);
  both.words[1] = payloadWord(index + 2);
  return both.value;
}

void FrameParser::copyPayload(void* message, uint8_t size) const {
  uint8_t* to = static_cast<uint8_t*>(message);
  const uint8_t* from = payload();
  for (uint8_t left = length(); size != 0; --size) {
    uint8_t byte = 0;
    if (left != 0) {
      byte = *from++;
      --left;
    }
    *to++ = byte;
  }
}

bool FrameParser::isFor(uint8_t systemId, uint8_t componentId) const {
  const uint16_t target = payloadWord(target_);  // 0, everyone, where there is none: no payload is so long
  const uint8_t system = static_cast<uint8_t>(target);
  const uint8_t component = static_cast<uint8_t>(target >> 8);
  return (system == 0 || system == systemId) && (component == 0 || component == componentId);
}

// Appends a byte to the frame that has begun.
MAVMISSION_INLINE void FrameParser::keep(uint8_t byte) {
  Index have = have_;
  uint8_t* const place = bytes_ + have;
  *place = byte;
  have_ = ++have;
  if (have <= summed_) crc_ = checksum(crc_, place, 1);
}

// Takes a byte from the inside of a frame, stepped over or kept, which needs no decision; most bytes are such. False if
// this one is not.
inline bool FrameParser::takePlainly(uint8_t byte) {
  const Index have = have_;
  uint8_t& low = *reinterpret_cast<uint8_t*>(&skip_);  // the low byte suffices until it is used up
  if (have == 0) {
    if (low < 2 || isMagic(byte) || keepsSignature()) return false;
    --low;
    return true;
  }
  if (static_cast<Index>(have + 1) == need_) return false;
  if (skip_ != 0) {
    if (have == 1 || low < 2 || keepsSignature()) return false;
    --low;
  }
  keep(byte);
  return true;
}

// A loop of its own, so that everything is in registers: most bytes of telemetry need no decision.
FrameParser::Result FrameParser::pull(Stream& stream, Budget& budget) {
  uint8_t left = budget.left;
  uint8_t heard = 0;
  Result result = Result::Nothing;
  int byte = 0;
  while (left != 0 && byte >= 0 && result == Result::Nothing) {
    if (hasWaiting()) {
      --left;
      result = takeWaiting();
      continue;
    }
    while ((byte = stream.read()) >= 0) {
      --left;
      ++heard;
      if (!takePlainly(static_cast<uint8_t>(byte))) {
        result = take(static_cast<uint8_t>(byte));
        break;
      }
      if (left == 0) break;
    }
  }
  budget.left = left;
  budget.heard = heard;
  return result;
}

FrameParser::Result FrameParser::takeWaiting() {
  const uint8_t byte = bytes_[read_++];
  return take(byte);
}

FrameParser::Result FrameParser::take(uint8_t byte) {
#if MAVMISSION_SIGNING
  if (keepsSignature()) return keepSignature(byte);
#endif
  if (skip_ == 0 || --skip_ != 0) return grow(byte);
  // This is the first byte after a stepped-over frame: if another frame begins here, the length was right.
  boundary_ = have_;
  if (stepping_ == Stepping::Reported) return grow(byte);
  inStep_ = isMagic(byte);
  if (!inStep_) {
    ++brokenFrames_;
    return grow(byte);
  }
  const Result grown = grow(byte);
  return grown == Result::Nothing ? Result::Unwanted : grown;
}

FrameParser::Result FrameParser::grow(uint8_t byte) {
  Index have = have_;
  if (have == 0) {
    if (isMagic(byte)) {
      bytes_[0] = byte;
      have_ = 1;
      need_ = byte == MAVLINK_STX ? kHeaderV2 : kHeaderV1;
      summed_ = 0;
      boundary_ = 0;
    } else if (skip_ == 0) {
      skipByte();
    }
    return Result::Nothing;
  }
  keep(byte);
  have = have_;
  if (have == need_) return summed_ == 0 ? classify() : complete();
  // A frame inside another one is kept only if it is wanted. Most such bytes are data, and the length shows it.
  if (have == 2 && uint16_t{byte} > MAVMISSION_MAX_PAYLOAD && isInside()) giveUp();
  return Result::Nothing;
}

FrameParser::Result FrameParser::classify() {
  const uint8_t length = bytes_[1];
  const bool v2 = isV2();
  // A frame with incompatibility flags that are not understood must be discarded (guide, Packet Serialization).
  if (v2 && (bytes_[2] & ~MAVLINK_IFLAG_SIGNED) != 0) {
    giveUp();
    return Result::Nothing;
  }
  const uint16_t id = v2 ? bytes_[7] | bytes_[8] << 8 : bytes_[5];
  const bool isIdLong = v2 && bytes_[9] != 0;  // such messages are never wanted
  const MessageKey* const key = isIdLong ? nullptr : keyOf(id);
  if (key != nullptr) {
    if (!v2 && length != fromFlash(&key->lengthV1)) {
      giveUp();
      return Result::Nothing;
    }
    if (uint16_t{length} <= MAVMISSION_MAX_PAYLOAD) {
      messageId_ = id;
      crcExtra_ = fromFlash(&key->crcExtra);
      target_ = fromFlash(&key->target);
      summed_ = have_ + length;
      need_ = summed_ + kChecksum;
      // The checksum begins only here, since the headers of unwanted messages need none.
      crc_ = checksum(kChecksumStart, bytes_ + 1, have_ - 1);
      return Result::Nothing;
    }
  }
  // A frame inside another one is kept only if it is wanted; its checksum will decide.
  if (isInside()) {
    giveUp();
    return Result::Nothing;
  }
  noteSender();
  uint16_t skip = length + kChecksum + 1;
  if (v2 && bytes_[2] != 0) skip += kSignature;  // the one flag that gets here
  skip_ = skip;
  // Data that looks like a carrier's header is common after damage: it must begin where a frame is due, and have a
  // sender (0 is none).
  const bool carries = inStep_ && sender_.systemId != 0 && !isIdLong && isCarrier(id);
  stepping_ = carries ? Stepping::MessageWithBytes : Stepping::Message;
  const uint8_t* byte = bytes_ + have_;
  for (uint8_t left = have_ - 1; left != 0; --left) {
    if (!isMagic(*--byte)) continue;
    giveUp();  // a frame may have begun within this supposed header
    return Result::Nothing;
  }
  have_ = 0;
  return Result::Nothing;
}

FrameParser::Result FrameParser::complete() {
  const uint16_t crc = checksum(crc_, &crcExtra_, 1);
  const uint8_t* const sum = bytes_ + need_ - kChecksum;
  if (static_cast<uint16_t>(sum[0] | sum[1] << 8) != crc) {
    ++badChecksums_;
    giveUp();
    return Result::Nothing;
  }
  if (skip_ != 0 && stepping_ == Stepping::MessageWithBytes) {
    have_ = 0;
    return Result::Nothing;
  }
  if (skip_ != 0) ++brokenFrames_;
  noteSender();
  skip_ = 0;
  inStep_ = true;
  if (isSigned()) {
    skip_ = kSignature + 1;
    stepping_ = MAVMISSION_SIGNING ? Stepping::Signature : Stepping::Reported;
  }
  have_ = 0;  // the bytes stay where they are until the next one is taken
  return Result::Wanted;
}

#if MAVMISSION_SIGNING
// A signature is stepped over like any other bytes after a frame, so that a frame that begins inside is found if bytes
// were lost there. Bytes that are looked at again come here too.
FrameParser::Result FrameParser::keepSignature(uint8_t byte) {
  signature_[kSignature + 1 - skip_] = byte;
  if (--skip_ != 1) return grow(byte);
  stepping_ = Stepping::Reported;
  const Result grown = grow(byte);
  return grown == Result::Nothing ? Result::Signature : grown;
}
#endif

void FrameParser::skipByte() {
  inStep_ = false;
  ++bytesSkipped_;
}

void FrameParser::giveUp() {
  // No frame began with the first byte. The bytes after it are looked at again, then those that were waiting already.
  if (skip_ != 0) {
    skip_ += have_ - 1;  // these bytes will be counted again
  } else if (boundary_ != 0) {
    skip_ = boundary_;  // it began inside a frame that has ended, as did the bytes after it up to that end
    stepping_ = Stepping::Reported;
  } else {
    skipByte();
  }
  const Index waiting = end_ - read_;
  uint8_t* to = bytes_ + have_;
  const uint8_t* from = bytes_ + read_;
  Index left = waiting;
  if (left != 0) {
    do *to++ = *from++;
    while (--left != 0);  // quicker than a loop that asks first
  }
  read_ = 1;
  end_ = have_ + waiting;
  have_ = 0;
}

FrameParser::Result FrameParser::silence() {
  Result result = Result::Nothing;
  if (skip_ != 0) {
    if (skip_ > 1) {
      ++brokenFrames_;
    } else {
      if (stepping_ != Stepping::Reported) result = Result::Unwanted;
      boundary_ = have_;  // the frame is complete: what seemed to begin inside is part of it
    }
    skip_ = 0;
  }
  if (have_ != 0) giveUp();
  return result;
}

}  // namespace detail
}  // namespace mavmission
