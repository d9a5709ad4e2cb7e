// Frames over a Stream: our own ids, the autopilot that we talk to, heartbeats, counters.
#pragma once

#include <Arduino.h>
#include <stdint.h>

#include "../autopilot/AutopilotFinder.h"
#include "../base/Pace.h"
#include "../base/RetryRules.h"
#include "FrameParser.h"
#include "LinkCounters.h"
#include "MavlinkVersion.h"
#include "Outbox.h"
#if MAVMISSION_SIGNING
#include "../signing/Signing.h"
#endif

namespace mavmission {
namespace detail {

class Link : public LinkRules {
 public:
  static constexpr uint8_t kComponentId = 191;  // MAV_COMP_ID_ONBOARD_COMPUTER

  // Sets the stream. All other members of a Link begin as zero.
  void begin(Stream& stream) {
    stream_ = &stream;
    state_.ownComponentId = kComponentId;
  }

  // Sets our own ids. 0, 0 is the default: the autopilot's system id, and kComponentId.
  void setSourceIds(uint8_t systemId, uint8_t componentId);
  void setMavlinkVersion(MavlinkVersion speak);

  // --- How old is what is read
  //
  // What waits in the receive buffer may have been there since loop() stood still, however long that was, and on every
  // board for as long as its buffer is large. A clock does not tell: but what is read now has come after the buffer was
  // last seen empty.

  // To be called when update() begins, with millis().
  MAVMISSION_APART void look(uint32_t nowMs);
  // All bytes that had come were read.
  MAVMISSION_APART void noteEmpty(uint32_t nowMs);
  // True while what is read may be older than kOldMs: no order leaves after such a heartbeat.
  bool isOld() const { return state_.gap >= kOldMs / kGapMs; }
  // The same for kBlindMs.
  bool isBlind() const { return state_.gap >= kBlindMs / kGapMs; }
  // True if a heartbeat of the autopilot has come since loop() stood still last: what it shows is how it is.
  bool isCurrent() const { return state_.isCurrent; }
  // The same for somebody who asks between two calls of update(), perhaps after a standstill that it has not seen yet.
  MAVMISSION_APART bool isCurrentAt(uint32_t nowMs) const {
    return state_.isCurrent && nowMs - state_.emptyMs < kBlindMs;
  }

  // Reads on to the autopilot's next frame that is addressed to us; false when no more bytes have come or the budget is
  // used up.
  bool receive(FrameParser::Budget& budget, uint16_t nowMs);

  // The frame that receive() has found, until its next call.
#if MAVMISSION_SIGNING
  const FrameParser& frame() const { return signing_.isOn() ? checked_ : parser_; }
#else
  const FrameParser& frame() const { return parser_; }
#endif

  // Does what depends on the time: sends our heartbeat, and notices when the autopilot falls silent.
  void onTime(uint16_t nowMs);

  // Adds a listener, which is given the frames as well.
  void add(MoreKeys& listener);

  // True when send() can take a frame, and it is not in doubt whose the link is. The frame is dropped while we must
  // not send yet (maySpeak()).
  MAVMISSION_APART bool canSend() const;

  // Sends a message of one of the types in Messages.h; if the type has target ids, they are set to the autopilot's. To
  // be called only when canSend().
  template <typename T>
  void send(T& message);
  // Sends a payload that has the layout of T.
  template <typename T>
  void sendAs(void* payload);
  // Sends a payload of key->length bytes, which may lie in draft(). The key lies in flash.
  MAVMISSION_APART void sendMessage(uint8_t* payload, const MessageKey* key);
  // Sends a message whose payload is made while it goes out. To be called only when canSend(), in MAVLink 2, and where
  // nothing is signed.
  void sendStreamed(const MessageKey* key, uint8_t length, Outbox::NextPiece next, void* context);

  // Sends a message that is not in Messages.h, with its key, in flash.
  void send(void* payload, const MessageKey& key) { sendMessage(static_cast<uint8_t*>(payload), &key); }

  // Sends in two steps, for a message that may be needed soon: prepareAs() packs the message, to be called only when
  // canSend(); release() sends it, to be called only while isPrepared(). The prepared message is dropped when anything
  // else is sent, and at the autopilot's next heartbeat, which may have another MAVLink version or come from another
  // autopilot.
  template <typename T>
  void prepareAs(void* payload);
  bool isPrepared() const { return outbox_.isHeld(); }
  // The buffer in which the payload for prepareAs() may be made; a message prepared before is dropped. To be called
  // only when canSend().
  void* draft() {
    outbox_.drop();
    return outbox_.draft();
  }
  // The same for a message that is sent at once: that drops what was prepared, too.
  void* draftToSend() { return outbox_.draft(); }
  MAVMISSION_APART void release();

  // Sends a message of the sketch's own; false if that cannot be done now.
  bool sendForeign(const OutgoingMessage& message);
  // Withdraws that message, if it is still going out: what it says is no longer true.
  void withdrawForeign(const void* payload) { outbox_.withdrawForeign(payload); }
  void withdraw() { outbox_.withdraw(); }
  // What is being sent is for an autopilot that is not ours any more: the rest of it does not leave.
  void cut() { outbox_.cut(); }
  bool isSent() const { return outbox_.isEmpty(); }

  // Writes what the stream takes, up to `most` bytes: writing a byte takes about as much time as receiving one.
  void flush(uint16_t nowMs, uint8_t most) {
    for (; most > 1 && !outbox_.isEmpty() && StreamRoom::saysOne(*stream_); --most) outbox_.flush(*stream_, nowMs, 1);
    if (!outbox_.isEmpty()) outbox_.flush(*stream_, nowMs, most);
  }

  // True if update() is called often, and nothing is lost: what comes without a pause fits into the receive buffer.
  bool isQuick() const { return state_.gap == 0 && !pace_.isLossy(); }

  // How quickly the line answers, and whether it loses.
  Pace& pace() { return pace_; }

  // True if the line has brought a frame twice, or after a later one, since that was forgotten.
  bool hasTwoWays() const { return state_.hasTwoWays; }
  void forgetTwoWays() { state_.hasTwoWays = false; }

  Stream& stream() const { return *stream_; }
#if MAVMISSION_SIGNING
  void signWith(const SigningKey& key, uint8_t linkId, const TimestampStore& store);
  void setSigningTime(const SigningTime& time) { signing_.setTime(time); }
  const Signing& signing() const { return signing_; }
  // Hashes a piece of the frame that must be signed or checked. To be called once in every update(). True if the time
  // of this update() has been spent on hashing: only flush() may follow.
  bool workOnSignatures();
#else
  static constexpr bool workOnSignatures() { return false; }
#endif

  AutopilotFinder& finder() { return finder_; }
  const AutopilotFinder& finder() const { return finder_; }
  uint8_t systemId() const;
  uint8_t componentId() const;
  uint8_t ownSystemId() const { return state_.ownSystemId; }  // as the sketch has set it
  // True if we send in MAVLink 1 now, else in MAVLink 2.
  bool speaksV1() const;
  LinkCounters counters() const;

 private:
  // True if we may send: when it is clear which autopilot is there, or when the sketch has set our system id and no
  // more than one autopilot is heard.
  MAVMISSION_APART bool maySpeak() const;
  // The number of our next frame.
  uint8_t sequence() const { return static_cast<uint8_t>(state_.framesSent); }
  // How many numbers lie between the autopilot's last frame and this one.
  uint8_t numbersBefore() const { return static_cast<uint8_t>(parser_.sequence() - state_.heardSequence - 1); }
  // True if later ones have come already, or if it comes twice.
  bool isOvertaken(uint8_t left, uint16_t nowMs) const;
  // Counts the autopilot's frames that were lost: so many numbers lie before the number of this one.
  void noteSequence(uint8_t left);
  // Counts a frame and notes its sequence number; true if receive() must return the frame.
  MAVMISSION_APART bool takeResult(FrameParser::Result result, uint16_t nowMs);
  MAVMISSION_APART void sendHeartbeat();
  bool takeHeartbeat(uint16_t nowMs);  // true if it is the autopilot's
  void pack(uint8_t* payload, const MessageKey* key);

  static constexpr uint8_t kGapMs = 4;
  // By its number, a frame that up to kLateFrames later ones have overtaken is late, and one with the last number comes
  // twice.
  static constexpr uint8_t kLateFrames = 63;
  static constexpr uint16_t kLateMs = 900;  // less than from one heartbeat to the next

  struct State {
    uint32_t emptyMs;  // when the receive buffer was last seen empty
    uint16_t heardByteMs;
    uint16_t heartbeatMs;
    uint32_t bytes;
    uint16_t frames;
    uint16_t unknownMessages;
    uint16_t framesLost;
    uint16_t framesSent;  // its low byte is the number of the next frame
    uint8_t heardSequence;
    uint8_t ownSystemId;
    uint8_t ownComponentId;
    bool isVersionSet : 1;  // by the sketch
    bool speaksV1 : 1;
    bool heartbeatSent : 1;
    bool sequenceKnown : 1;
    bool hearsV1 : 1;  // the autopilot's last heartbeat was a MAVLink 1 frame
    bool isCurrent : 1;
    bool hasTwoWays : 1;
    uint8_t gap;  // how long ago the receive buffer was seen empty when this update() began; at most 255 [kGapMs]
  };

  // What is asked for in every update() lies first, where avr-gcc reaches it cheaply, also as a part of Client.
  AutopilotFinder finder_;
  Stream* stream_;
  Pace pace_;
  State state_;
  Outbox outbox_;
  uint8_t damage_;  // low byte of what has been counted as skipped or lost
  FrameParser parser_;

#if MAVMISSION_SIGNING
  // Rounds of SHA-256 in an update() that is spent on hashing (docs/design/signing.md).
  static constexpr uint8_t kRoundsAtOnce = 16;
  // Bytes that may wait in the stream during hashing: half the receive buffer of a hardware serial port [bytes].
  static constexpr uint8_t kMayWait = 32;

  enum class Check : uint8_t{
      None,
      Collecting,  // checked_ holds a frame, its signature is coming
      Due,        Running, Accepted,
  };

  bool takeAccepted(uint16_t nowMs);
  bool mayRead();
  void takeUnchecked(FrameParser::Result result, uint16_t nowMs);
  bool matters();

  Signing signing_;
  FrameParser checked_;  // a copy of parser_ with the frame that is being checked, or has been accepted
  Check check_;
  bool isWaiting_;   // parser_ has a frame that waits until checked_ is free; no byte is read until then
  bool hashedLast_;  // the last update() was spent on hashing
#endif
};

}  // namespace detail
}  // namespace mavmission
