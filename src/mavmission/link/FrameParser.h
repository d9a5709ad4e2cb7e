// Bytes to frames: finds MAVLink 1 and 2 frames in a stream that loses and damages bytes.
//
// How it keeps track. A frame of a message that is wanted is kept whole, as raw bytes, until its checksum is known; if
// that is wrong, the bytes behind its first one are looked at again, so a good frame that had begun inside is found. A
// frame of any other message is stepped over by its length, but that length is only advice: while stepping, a wanted
// frame inside is looked for all the same, and when its checksum is right, it was the length that was damaged. (Only in
// messages that carry other people's bytes it may be data that looks like a frame: there it is left alone.) The next
// undamaged wanted frame after any damage is thus found, at the latest when the line has been silent for kSilenceMs.
#pragma once

#include <stdint.h>
#include <string.h>

#include "../Config.h"
#include "../MessageKey.h"

class Stream;

namespace mavmission {
namespace detail {

class FrameParser;

// More messages that are wanted, by a listener; a list of them is walked through.
struct MoreKeys {
  const MessageKey* keys;  // in flash
  uint8_t count;
  MoreKeys* next;
  // What is done with the list that begins with this one. It is reached through the list alone, so that a sketch
  // without a listener has no code for it: the key of a message, in flash, or null; and a frame, to all that want it.
  const MessageKey* (*search)(const MoreKeys* list, uint16_t messageId);
  void (*tell)(const MoreKeys* list, const FrameParser& frame);

  // The key of a message, in flash, or null.
  const MessageKey* find(uint16_t messageId) const;
};

// The key, in flash, of a message that is wanted, or null. Defined beside the messages.
MAVMISSION_APART const MessageKey* wantedKey(uint16_t messageId);

class FrameParser {
 public:
  // The list of what else is wanted; null, the beginning, is nothing.
  MoreKeys*& moreKeys() { return moreKeys_; }

  // Silence after which a frame that has begun is given up [ms]. At 9600 baud a byte takes 1 ms.
  static constexpr uint8_t kSilenceMs = 20;

  enum class Result : uint8_t {
    Nothing,    // go on
    Wanted,     // a frame that is wanted, with a right checksum
    Unwanted,   // a frame of another message has been stepped over: only its sender and sequence are known
    Signature,  // with MAVMISSION_SIGNING: the signature of the frame that was Wanted last is whole
  };

  // How much may be looked at.
  struct Budget {
    uint8_t left;   // bytes, those that are looked at again included
    uint8_t heard;  // bytes that the last call has read
  };

  // Takes bytes of the stream until there is a frame, nothing more has come, or the budget is used up.
  MAVMISSION_APART Result pull(Stream& stream, Budget& budget);

  // Takes the next byte of the stream. Only when hasWaiting() is false.
  Result take(uint8_t byte);

  // True when bytes are to be looked at again: call takeWaiting() until it is false. Each call looks at one byte.
  bool hasWaiting() const { return read_ != end_; }
  Result takeWaiting();

  // To be called when the line has been silent for kSilenceMs: what has begun will not be completed.
  MAVMISSION_APART Result silence();

  // --- The frame that the last call gave, until the next call.

  // Messages whose id needs more than 16 bits are never wanted.
  uint16_t messageId() const { return messageId_; }
  uint8_t systemId() const { return sender_.systemId; }
  uint8_t componentId() const { return sender_.componentId; }
  uint8_t sequence() const { return sender_.sequence; }
  // MAVLink 1 or 2.
  uint8_t version() const { return isV2() ? 2 : 1; }
  // True if it carries a signature, which nobody here has checked.
  bool isSigned() const;
#if MAVMISSION_SIGNING
  bool keepsSignature() const { return stepping_ == Stepping::Signature && skip_ > 1; }
  Result keepSignature(uint8_t byte);
#else
  static constexpr bool keepsSignature() { return false; }
#endif
  // The payload as it came, `length()` bytes: in MAVLink 2 without its trailing zeros.
  const uint8_t* payload() const { return bytes_ + (isV2() ? kHeaderV2 : kHeaderV1); }
  uint8_t length() const { return bytes_[1]; }
  // A byte of it, 0 for one that was left out.
  uint8_t payloadByte(uint8_t index) const { return index < length() ? payload()[index] : 0; }
  // The number of two or four bytes that begins there.
  uint16_t payloadWord(uint8_t index) const;
  uint32_t payloadLong(uint8_t index) const;
  // True if it is addressed to this component, to everyone, or to no one.
  bool isFor(uint8_t systemId, uint8_t componentId) const;
  // Copies the payload to a message of `size` bytes; what the sender left out, or does not know, becomes 0.
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

  // Reported: a signature, or the rest of a message that has been given as Unwanted already. Signature: one that is
  // kept.
  enum class Stepping : uint8_t { Message, MessageWithBytes, Reported, Signature };

  bool takePlainly(uint8_t byte);
  void keep(uint8_t byte);
  Result grow(uint8_t byte);
  MAVMISSION_APART MAVMISSION_ONE_EXIT Result classify();
  MAVMISSION_APART MAVMISSION_ONE_EXIT Result complete();
  MAVMISSION_APART void noteSender();
  const MessageKey* keyOf(uint16_t messageId) const;
  bool isV2() const;
  // True if what has begun did so inside another frame.
  bool isInside() const { return skip_ != 0 || boundary_ != 0; }
  // Counts a byte that belongs to no frame.
  MAVMISSION_APART void skipByte();
  void giveUp();

  Index have_;    // bytes of the frame that has begun
  Index need_;    // its whole length, once its header has been understood; the header's before
  Index summed_;  // bytes that go into the checksum, its first one and crcExtra_ aside; 0 before
  Index read_;    // bytes_[read_] to bytes_[end_ - 1] are waiting
  Index end_;
  uint16_t skip_;   // stepping: bytes up to the first one behind what is stepped over, that one included
  Index boundary_;  // the place in bytes_ of the first byte behind what was stepped over meanwhile; 0: there is none
  uint16_t crc_;
  uint16_t messageId_;
  uint8_t crcExtra_;
  uint8_t target_;
  Stepping stepping_;
  bool inStep_;  // a frame has ended, and nothing but whole frames has come since
  uint16_t badChecksums_;
  uint16_t brokenFrames_;
  uint32_t bytesSkipped_;
  MoreKeys* moreKeys_;
  Sender sender_;  // of the frame that was given last, or is being stepped over
#if MAVMISSION_SIGNING
  uint8_t signature_[kSignature];
#endif
  uint8_t bytes_[kKept];  // the frame that has begun, then bytes waiting to be looked at again
};

}  // namespace detail
}  // namespace mavmission
