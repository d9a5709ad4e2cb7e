// Bytes to frames: finds MAVLink 1 and 2 frames in a stream that loses and damages bytes.
//
// Resynchronisation. A frame of a wanted message is kept whole, as raw bytes, until its checksum is known; if the
// checksum is wrong, the bytes after the first one are looked at again, so that a good frame that began inside is
// found. A frame of any other message is stepped over by its length, but that length is only advice: a wanted frame
// that begins inside is looked for too, and if its checksum is right, the length was damaged. (In messages that carry
// other people's bytes, data may look like a frame: there it is left alone.) So the next undamaged wanted frame after
// any damage is found, at the latest when the line has been silent for kSilenceMs.
#pragma once

#include <Arduino.h>
#include <stdint.h>
#include <string.h>

#include "../base/Config.h"
#include "../base/RetryRules.h"
#include "MessageKey.h"

namespace mavmission {
namespace detail {

class FrameParser;

// Further wanted messages, those of a listener; an element of a linked list.
struct MoreKeys {
  const MessageKey* keys;  // in flash
  uint8_t count;
  MoreKeys* next;
  // Operations on the list that begins here. They are reached through the list alone, so that a sketch without a
  // listener has no code for them. search: the key of a message, in flash, or null. tell: hands a frame to all that
  // want it.
  const MessageKey* (*search)(const MoreKeys* list, uint16_t messageId);
  void (*tell)(const MoreKeys* list, const FrameParser& frame);

  // The key of a message, in flash, or null.
  const MessageKey* find(uint16_t messageId) const;
};

// The key, in flash, of a message that the library wants, or null. Defined in Messages.cpp.
const MessageKey* wantedKey(uint16_t messageId);

class FrameParser : public ParserRules {
 public:
  // The list of further wanted messages; null, as at the beginning: none.
  MoreKeys*& moreKeys() { return moreKeys_; }

  enum class Result : uint8_t {
    Nothing,    // go on
    Wanted,     // a frame that is wanted, with a right checksum
    Unwanted,   // a frame of another message was stepped over: only its sender and sequence are known
    Signature,  // with MAVMISSION_SIGNING: the signature of the last Wanted frame is complete
  };

  // How many bytes one call may look at.
  struct Budget {
    uint8_t left;   // bytes left, those that are looked at again included
    uint8_t heard;  // bytes that the last call read from the stream
  };

  // Takes bytes from the stream until there is a frame, no byte is left, or the budget is used up.
  MAVMISSION_APART Result pull(Stream& stream, Budget& budget);

  // Takes the next byte of the stream. Only when hasWaiting() is false.
  Result take(uint8_t byte);

  // True when bytes must be looked at again: call takeWaiting(), which looks at one byte, until this is false.
  bool hasWaiting() const { return read_ != end_; }
  Result takeWaiting();

  // To be called when the line has been silent for kSilenceMs: gives up an unfinished frame.
  MAVMISSION_APART Result silence();

  // --- The last frame, valid until the next call.

  // Messages whose id needs more than 16 bits are never wanted.
  uint16_t messageId() const { return messageId_; }
  uint8_t systemId() const { return sender_.systemId; }
  uint8_t componentId() const { return sender_.componentId; }
  uint8_t sequence() const { return sender_.sequence; }
  bool isV2() const;
  // MAVLink 1 or 2.
  uint8_t version() const { return isV2() ? 2 : 1; }
  // True if it carries a signature, which the parser does not check.
  bool isSigned() const;
#if MAVMISSION_SIGNING
  bool keepsSignature() const { return stepping_ == Stepping::Signature && skip_ > 1; }
  Result keepSignature(uint8_t byte);
#else
  static constexpr bool keepsSignature() { return false; }
#endif
  // The payload as received, `length()` bytes: in MAVLink 2 without its trailing zeros.
  const uint8_t* payload() const { return bytes_ + (isV2() ? kHeaderV2 : kHeaderV1); }
  uint8_t length() const { return bytes_[1]; }
  // A byte of the payload; 0 for an omitted one.
  uint8_t payloadByte(uint8_t index) const { return index < length() ? payload()[index] : 0; }
  // The number of two or four bytes that begins at `index`.
  uint16_t payloadWord(uint8_t index) const;
  MAVMISSION_APART uint32_t payloadLong(uint8_t index) const;
  // True if it is addressed to this component, to everyone, or to no one.
  bool isFor(uint8_t systemId, uint8_t componentId) const;
  // Copies the payload to a message of `size` bytes; bytes that the sender omitted, or does not know, become 0.
  void copyPayload(void* message, uint8_t size) const;

#if MAVMISSION_SIGNING
  // True if a signature follows.
  bool hasSignature() const { return isSigned(); }
  // The frame from its first byte to its checksum.
  const uint8_t* bytes() const { return bytes_; }
  uint16_t frameLength() const { return need_; }
  // Its signature, after Result::Signature.
  const uint8_t* signature() const { return signature_; }
  void takeSignatureOf(const FrameParser& other) { memcpy(signature_, other.signature_, sizeof signature_); }
#endif

  // ---

  // True between frames, where silence() would change nothing.
  bool isIdle() const { return have_ == 0 && skip_ == 0 && !hasWaiting(); }

  uint16_t badChecksums() const { return badChecksums_; }  // frames of wanted messages with a wrong checksum
  uint16_t brokenFrames() const { return brokenFrames_; }  // stepped-over frames that did not end where they should
  uint32_t bytesSkipped() const { return bytesSkipped_; }  // bytes that belong to no frame

 private:
  static constexpr uint8_t kHeaderV1 = 6, kHeaderV2 = 10, kChecksum = 2, kSignature = 13;
  static constexpr uint16_t kKept = kHeaderV2 + MAVMISSION_MAX_PAYLOAD + kChecksum;

  template <bool fitsByte, int = 0>
  struct IndexType {
    typedef uint8_t type;
  };
  template <int dummy>
  struct IndexType<false, dummy> {
    typedef uint16_t type;
  };
  typedef IndexType<kKept <= 255>::type Index;

  struct Sender {
    uint8_t sequence, systemId, componentId;
  };

  // Reported: a signature, or the rest of a message that was given as Unwanted already. Signature: one that is kept.
  enum class Stepping : uint8_t { Message, MessageWithBytes, Reported, Signature };

  bool takePlainly(uint8_t byte);
  void keep(uint8_t byte);
  MAVMISSION_ONE_EXIT Result grow(uint8_t byte);
  MAVMISSION_APART MAVMISSION_ONE_EXIT Result classify();
  MAVMISSION_APART MAVMISSION_ONE_EXIT Result complete();
  MAVMISSION_APART void noteSender();
  const MessageKey* keyOf(uint16_t messageId) const;
  // True if the frame that has begun lies inside another frame.
  bool isInside() const { return skip_ != 0 || boundary_ != 0; }
  // Counts a byte that belongs to no frame.
  MAVMISSION_APART void skipByte();
  void giveUp();

  // What Link asks for with each frame lies first, where avr-gcc reaches it cheaply.
  uint16_t messageId_;
  Sender sender_;  // of the last frame, or of the one being stepped over
  uint8_t target_;
  MoreKeys* moreKeys_;
  Index have_;    // bytes of the frame that has begun
  Index need_;    // its whole length, once the header has been read; before that the header's
  Index summed_;  // bytes in the checksum, without the first one and crcExtra_; 0: header not read yet
  Index read_;    // bytes_[read_] to bytes_[end_ - 1] are waiting
  Index end_;
  uint16_t skip_;   // stepping: bytes left, up to and including the first one after the frame
  Index boundary_;  // where in bytes_ the first byte after a stepped-over frame is; 0: nowhere
  uint16_t crc_;
  uint8_t crcExtra_;
  Stepping stepping_;
  bool inStep_;  // nothing but whole frames has come since the end of a frame
  uint16_t badChecksums_;
  uint16_t brokenFrames_;
  uint32_t bytesSkipped_;
#if MAVMISSION_SIGNING
  uint8_t signature_[kSignature];
#endif
  uint8_t bytes_[kKept];  // the frame that has begun, then bytes waiting to be looked at again
};

}  // namespace detail
}  // namespace mavmission
