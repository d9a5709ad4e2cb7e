// One outgoing frame, handed to the stream as fast as the stream takes it, never faster.
#pragma once

#include <Arduino.h>
#include <stdint.h>

#include "../Config.h"
#include "../OutgoingMessage.h"
#include "FrameParser.h"
#if MAVMISSION_SIGNING
#include "../signing/Signing.h"
#endif

namespace mavmission {
namespace detail {

class Outbox {
 public:
  // The longest payload that a message of ours has [bytes]: MISSION_ITEM_INT's; COMMAND_INT has 35.
  static constexpr uint8_t kMaxPayload = 38;

  // How long a stream must say that it takes nothing before it is believed not to implement availableForWrite() [ms].
  // A ring that is only full drains a byte in 1 ms at 9600 baud.
  static constexpr uint8_t kNotImplementedMs = 100;

  // Bytes that such a stream is given in one call: each may wait for the line [bytes].
  static constexpr uint8_t kBlindBytes = 8;

  // Zero bytes before a frame on a line that loses [bytes]. The other parser may be waiting for the rest of a frame
  // that has lost some: it would take the beginning of ours for that.
  static constexpr int8_t kFill = 12;

  // True when a frame may be put in: none is on its way.
  bool isEmpty() const { return sent_ == length_; }

  // Begins a frame. Only when isEmpty(). `version`: MAVLink 1 or 2.
  void begin(uint8_t version, uint8_t sequence, uint8_t systemId, uint8_t componentId);
  // Completes it with a message: its key, in flash, and a payload of key->length bytes. It is then held.
  void complete(const MessageKey* key, const uint8_t* payload);

  // Where a payload may be made, kMaxPayload bytes, aligned as its fields need it. Only when isEmpty() and not
  // isHeld(). complete() moves it from here to its place, which begins further to the front.
  void* draft() { return frame_ + kDraft; }

  // Completes it with a message of the sketch's own, whose payload stays where it is until it has been sent.
  void completeForeign(const OutgoingMessage& message);

  // A held frame is ready, and waits: it goes out after release(), or never if it is dropped or another one is begun.
  bool isHeld() const { return held_; }
  void release(bool isFilled = false) {
    held_ = false;
    sent_ = isFilled ? -kFill : 0;
#if MAVMISSION_SIGNING
    isUnsigned_ = signs_;
#endif
  }
  void drop() { held_ = false; }

  // True while the line is busy with what was handed to the stream last, `busyMs` ago.
  bool isLineBusy(Stream& stream, uint16_t nowMs, uint16_t& busyMs) const;

#if MAVMISSION_SIGNING
  // From now on frames are signed: one that has been released waits for startSigning() and, later, setSigned().
  void beginSigning() { signs_ = true; }
  bool isUnsigned() const { return isUnsigned_; }
  void startSigning(Signing& signing);
  void setSigned() {
    isUnsigned_ = false;
    length_ += kSignature;
  }
#endif

  // Writes what the stream takes now, `most` bytes at most. Only when there is a frame on its way.
  MAVMISSION_APART void flush(Stream& stream, uint16_t nowMs, uint8_t most);

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

  static void writeForeign(Outbox& outbox, Stream& stream, uint16_t room);

  int16_t length_;  // of the whole frame
  int16_t sent_;    // of it; below 0: of the zeros before it
  // Writes what comes next of a foreign frame; null for a frame of our own, which is one piece.
  void (*writeForeign_)(Outbox& outbox, Stream& stream, uint16_t room);
  uint16_t stuckMs_;  // when the stream was given something last, or since when it takes nothing
  bool stuck_;
  bool blind_;  // the stream does not say what it takes
#ifndef __AVR__
  bool hasSaid_;  // it has said so once: when it says that it takes nothing, that is so, as with flow control
#endif
  bool held_;
  int16_t idle_;  // what the stream takes when that is empty, as far as that was seen
#if MAVMISSION_SIGNING
  bool signs_;
  bool isUnsigned_;
#endif
  static constexpr uint8_t kDraft = 12;
  union {
    uint8_t frame_[10 + kMaxPayload + 2 + kSignature];
    Foreign foreign_;
    uint32_t alignment_;
  };
  static_assert(kDraft >= 10 && kDraft % 4 == 0 && kDraft + kMaxPayload <= sizeof(frame_),
                "behind the header, and aligned");
};

}  // namespace detail
}  // namespace mavmission
