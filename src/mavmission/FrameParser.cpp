#include "FrameParser.h"

#include <string.h>

#include "Checksum.h"
#include "Flash.h"
#include "Messages.h"

namespace mavmission {
namespace {

bool isMagic(uint8_t byte) { return byte == MAVLINK_STX || byte == MAVLINK_STX_MAVLINK1; }

// Messages that carry bytes of others, among which a whole frame may be.
const uint16_t kCarriers[] PROGMEM = {
    MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL,
    MAVLINK_MSG_ID_LOG_DATA,
    MAVLINK_MSG_ID_GPS_INJECT_DATA,
    MAVLINK_MSG_ID_SERIAL_CONTROL,
    MAVLINK_MSG_ID_ENCAPSULATED_DATA,
    MAVLINK_MSG_ID_GPS_RTCM_DATA,
    MAVLINK_MSG_ID_V2_EXTENSION,
    MAVLINK_MSG_ID_MEMORY_VECT,
    MAVLINK_MSG_ID_LOGGING_DATA,
    MAVLINK_MSG_ID_LOGGING_DATA_ACKED,
    MAVLINK_MSG_ID_TUNNEL,
    MAVLINK_MSG_ID_CAN_FRAME,
    MAVLINK_MSG_ID_CANFD_FRAME,
};

bool isCarrier(uint16_t messageId) {
  for (const uint16_t& carrier : kCarriers) {
    if (fromFlash(&carrier) == messageId) return true;
  }
  return false;
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

void FrameParser::noteSender() { memcpy(&sender_, bytes_ + (isV2() ? 4 : 2), sizeof(sender_)); }

uint16_t FrameParser::payloadWord(uint8_t index) const {
  return static_cast<uint16_t>(payloadByte(index) | payloadByte(index + 1) << 8);
}

uint32_t FrameParser::payloadLong(uint8_t index) const {
  union {  // 12 bytes less than a shift
    uint16_t words[2];
    uint32_t value;
  } both;
  both.words[0] = payloadWord(index);
  both.words[1] = payloadWord(index + 2);
  return both.value;
}

void FrameParser::copyPayload(void* message, uint8_t size) const {
  uint8_t* to = static_cast<uint8_t*>(message);
  for (uint8_t i = 0; i < size; ++i) *to++ = payloadByte(i);
}

bool FrameParser::isFor(uint8_t systemId, uint8_t componentId) const {
  if (target_ == MessageKey::kNoTarget) return true;
  const uint8_t system = payloadByte(target_);
  const uint8_t component = payloadByte(target_ + 1);
  return (system == 0 || system == systemId) && (component == 0 || component == componentId);
}

FrameParser::Result FrameParser::takeWaiting() {
  const uint8_t byte = bytes_[read_++];
  return take(byte);
}

FrameParser::Result FrameParser::take(uint8_t byte) {
  if (skip_ == 0 || --skip_ != 0) return grow(byte);
  // This is the first byte behind what was stepped over: where another frame begins, the length was right.
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
  if (have_ == 0) {
    if (isMagic(byte)) {
      bytes_[0] = byte;
      have_ = 1;
      need_ = 0;
      boundary_ = 0;
      crc_ = kChecksumStart;
    } else if (skip_ == 0) {
      skipByte();
    }
    return Result::Nothing;
  }
  bytes_[have_++] = byte;
  if (need_ != 0) {
    if (have_ == need_) return complete();
    if (have_ != static_cast<Index>(need_ - 1)) crc_ = checksum(crc_, byte);
    return Result::Nothing;
  }
  crc_ = checksum(crc_, byte);
  if (isV2()) {
    if (have_ == kHeaderV2) return classify();
    // A frame with incompatibility flags that are not understood must be discarded (guide, Packet Serialization).
    if (have_ == 3 && (byte & ~MAVLINK_IFLAG_SIGNED) != 0) giveUp();
  } else if (have_ == kHeaderV1) {
    return classify();
  }
  return Result::Nothing;
}

FrameParser::Result FrameParser::classify() {
  const uint8_t length = bytes_[1];
  const bool v2 = isV2();
  const uint16_t id = v2 ? bytes_[7] | bytes_[8] << 8 : bytes_[5];
  const MessageKey* const key = v2 && bytes_[9] != 0 ? nullptr : keyOf(id);
  if (key != nullptr) {
    if (!v2 && length != fromFlash(&key->lengthV1)) {
      giveUp();
      return Result::Nothing;
    }
    if (uint16_t{length} <= MAVMISSION_MAX_PAYLOAD) {
      messageId_ = id;
      crcExtra_ = fromFlash(&key->crcExtra);
      target_ = fromFlash(&key->target);
      need_ = have_ + length + kChecksum;
      return Result::Nothing;
    }
  }
  // What began inside another frame can only be a wanted one, which its checksum will prove.
  if (skip_ != 0 || boundary_ != 0) {
    giveUp();
    return Result::Nothing;
  }
  noteSender();
  uint16_t skip = length + kChecksum + 1;
  if (isSigned()) skip += kSignature;
  skip_ = skip;
  // Data that looks like a carrier's header is common after damage: it must begin where a frame is due, and have a
  // sender (0 is none).
  const bool carries = inStep_ && sender_.systemId != 0 && !(v2 && bytes_[9] != 0) && isCarrier(id);
  stepping_ = carries ? Stepping::MessageWithBytes : Stepping::Message;
  for (uint8_t i = have_ - 1; i != 0; --i) {
    if (!isMagic(bytes_[i])) continue;
    giveUp();  // a frame may have begun within what was taken for a header
    return Result::Nothing;
  }
  have_ = 0;
  return Result::Nothing;
}

FrameParser::Result FrameParser::complete() {
  const uint16_t crc = checksum(crc_, crcExtra_);
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
    stepping_ = Stepping::Reported;
  }
  have_ = 0;  // the bytes stay where they are until the next one is taken
  return Result::Wanted;
}

void FrameParser::skipByte() {
  inStep_ = false;
  ++bytesSkipped_;
}

void FrameParser::giveUp() {
  // The first byte began nothing. Those behind it are looked at again, then those that were waiting already.
  if (skip_ != 0) {
    skip_ += have_ - 1;  // they will be counted once more
  } else if (boundary_ != 0) {
    skip_ = boundary_;  // it began inside a frame that has ended: so do those behind it, as far as that frame went
    stepping_ = Stepping::Reported;
  } else {
    skipByte();
  }
  const Index waiting = end_ - read_;
  memmove(bytes_ + have_, bytes_ + read_, waiting);
  read_ = 1;
  end_ = have_ + waiting;
  have_ = 0;
}

FrameParser::Result FrameParser::silence() {
  Result result = Result::Nothing;
  if (skip_ != 0) {
    if (skip_ > 1) {
      ++brokenFrames_;
    } else if (stepping_ != Stepping::Reported) {
      result = Result::Unwanted;
    }
    skip_ = 0;
  }
  if (have_ != 0) giveUp();
  return result;
}

}  // namespace mavmission
