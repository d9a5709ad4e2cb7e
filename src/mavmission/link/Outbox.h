// One outgoing frame, written to the stream as fast as the stream takes it, never faster.
#pragma once

#include <Arduino.h>
#include <stdint.h>

#include "../base/Config.h"
#include "../base/StreamRoom.h"
#include "FrameParser.h"
#include "OutgoingMessage.h"
#if MAVMISSION_SIGNING
#include "../signing/Signing.h"
#endif

namespace mavmission {
namespace detail {

class Outbox {
 public:
  // The longest payload among our messages [bytes]: that of MISSION_ITEM_INT; COMMAND_INT has 35.
  static constexpr uint8_t kMaxPayload = 38;

  // What a stream without availableForWrite() is given in one call: each byte may wait for the line [bytes].
  static constexpr uint8_t kBlindBytes = 8;

  // Zero bytes before a frame on a lossy link [bytes]. The autopilot's parser may still wait for the rest of
  // a frame that has lost some bytes: it then takes the zeros for that rest, and not the beginning of our frame.
  static constexpr uint8_t kFill = 12;

  // True when no frame is being sent, so that a new one may be begun.
  bool isEmpty() const { return sent_ == length_; }

  // Begins a frame. To be called only when isEmpty(). `isV1`: in MAVLink 1, else in 2.
  void begin(bool isV1, uint8_t sequence, uint8_t systemId, uint8_t componentId);
  // Completes the frame with a message: its key, in flash, and a payload of key->length bytes. The frame is then held.
  void complete(const MessageKey* key, const uint8_t* payload);

  // A buffer of kMaxPayload bytes in which a payload may be made, aligned for its fields. To be used only when
  // isEmpty() and not isHeld(). complete() moves the payload from here to its place in the frame, which begins further
  // to the front.
  void* draft() { return frame_ + kDraft; }

  // Completes the frame with a message of the sketch's own. The payload is not copied: it must stay unchanged until the
  // frame has been sent.
  void completeForeign(const OutgoingMessage& message);

  // Makes the frame with this payload, if it is still going out, one that nobody accepts.
  void withdrawForeign(const void* payload) {
    if (isEmpty() || writeForeign_ != writeForeign || foreign_.body != payload) return;
    uint8_t* const crc = foreign_.around + foreign_.headLength;
    crc[0] ^= 0xFF;
    crc[1] ^= 0xFF;  // the first one may have left
  }

  // Makes the next piece of a payload, up to kMaxPayload bytes, and returns its length; kNotNow: ask again; kBroken:
  // the payload cannot be completed, and the frame becomes one that nobody accepts.
  typedef uint8_t (*NextPiece)(void* context, uint8_t* piece);
  static constexpr uint8_t kNotNow = 0, kBroken = 255;

  // The same for a frame of ours: its last byte leaves last.
  void withdraw() {
    if (!isEmpty() && writeForeign_ == nullptr) frame_[length_ - 1] ^= 0xFF;
  }

  // The rest of a frame that is being sent does not leave.
  void cut() {
    length_ = sent_;
    drop();
  }

  // Completes a MAVLink 2 frame with a message whose payload of `length` bytes is made piece by piece while it goes
  // out. Such a frame cannot be signed.
  void completeStreamed(const MessageKey* key, uint8_t length, NextPiece next, void* context);

  // A held frame is complete and waits: it is sent after release(), or never if it is dropped or another one is begun.
  bool isHeld() const { return fill_ == kHeld; }
  void release(bool isFilled = false) {
    sent_ = 0;
    fill_ = isFilled ? kFill : 0;
#if MAVMISSION_SIGNING
    isUnsigned_ = signs_;
#endif
  }
  // To be called only when isEmpty().
  void drop() { fill_ = 0; }

  // For how long the line has been busy with what was handed to the stream last [ms]; 0 when it is idle.
  uint8_t busyMs(Stream& stream, uint16_t nowMs) const;

#if MAVMISSION_SIGNING
  // From now on frames are signed: after release() a frame waits for startSigning() and then for setSigned().
  void beginSigning() { signs_ = true; }
  bool isUnsigned() const { return isUnsigned_; }
  void startSigning(Signing& signing);
  void setSigned() {
    isUnsigned_ = false;
    length_ += kSignature;
  }
#endif

  // Writes what the stream takes now, up to `most` bytes. To be called only when a frame is being sent.
  MAVMISSION_APART MAVMISSION_ONE_EXIT void flush(Stream& stream, uint16_t nowMs, uint8_t most);

 private:
#if MAVMISSION_SIGNING
  static constexpr uint8_t kSignature = Signing::kLength;
#else
  static constexpr uint8_t kSignature = 0;
#endif

  // A frame whose payload lies elsewhere.
  struct Foreign {
    uint8_t around[12 + kSignature];  // header, then checksum and signature
    uint8_t headLength;
    uint8_t bodyLength;
    const uint8_t* body;
  };

  // A frame of which only one piece lies here: at first its header.
  struct Streamed {
    uint8_t piece[kMaxPayload];
    uint8_t length;
    uint8_t sent;
    uint8_t extra;  // CRC_EXTRA
    uint16_t crc;
    NextPiece next;
    void* context;
  };

  static void writeForeign(Outbox& outbox, Stream& stream, uint16_t room);
  static void writeStreamed(Outbox& outbox, Stream& stream, uint16_t room);

  uint16_t length_;  // length of the whole frame
  uint16_t sent_;
  // Writes the next bytes of a frame with the sketch's own message, or of one that is made while it goes out; null for
  // a frame that lies in one piece.
  void (*writeForeign_)(Outbox& outbox, Stream& stream, uint16_t room);
  StreamRoom room_;
  static constexpr uint8_t kHeld = 255;
  uint8_t fill_;  // zeros that are still to be written before the frame; kHeld: the frame waits for release()
  // What the stream takes when that is empty, as far as that was seen. (An AVR's ring has 63 bytes; where a sketch has
  // made it larger than 255, so many count as empty.)
#ifdef __AVR__
  typedef uint8_t Room;
#else
  typedef uint16_t Room;
#endif
  Room idle_;
#if MAVMISSION_SIGNING
  bool signs_;
  bool isUnsigned_;
#endif
  static constexpr uint8_t kDraft = 12;
  union {
    uint8_t frame_[10 + kMaxPayload + 2 + kSignature];
    Foreign foreign_;
    Streamed streamed_;
    uint32_t alignment_;
  };
  static_assert(kDraft >= 10 && kDraft % 4 == 0 && kDraft + kMaxPayload <= sizeof(frame_),
                "the draft must begin after the header, at a multiple of 4, and end within the frame");
};

}  // namespace detail
}  // namespace mavmission
