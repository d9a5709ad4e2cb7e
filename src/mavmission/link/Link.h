// Frames over a Stream: who we are, whom we talk to, heartbeats, counters.
#pragma once

#include <Arduino.h>
#include <stdint.h>

#include "../LinkCounters.h"
#include "../MavlinkVersion.h"
#include "../autopilot/AutopilotFinder.h"
#include "../base/Pace.h"
#include "FrameParser.h"
#include "Outbox.h"
#if MAVMISSION_SIGNING
#include "../signing/Signing.h"
#endif

namespace mavmission {
namespace detail {

class Link {
 public:
  static constexpr uint16_t kHeartbeatMs = 1000;  // guide, Heartbeat/Connection Protocol: 1 Hz
  static constexpr uint8_t kComponentId = 191;    // MAV_COMP_ID_ONBOARD_COMPUTER

  // All zero is how a Link begins, but for these.
  void begin(Stream& stream) {
    stream_ = &stream;
    state_.pace.begin();
  }

  // Our own ids; 0, 0 is the default: the autopilot's system id and kComponentId.
  void setSourceIds(uint8_t systemId, uint8_t componentId);
  void setMavlinkVersion(MavlinkVersion speak) { state_.speak = speak; }

  // Goes on to the autopilot's next frame that is for us; false when nothing more has come or the budget is used up.
  bool receive(FrameParser::Budget& budget, uint16_t nowMs);

  // That frame, until the next call.
#if MAVMISSION_SIGNING
  const FrameParser& frame() const { return signing_.isOn() ? checked_ : parser_; }
#else
  const FrameParser& frame() const { return parser_; }
#endif

  // Counts time: the heartbeat, the autopilot's silence, a frame cut short.
  void onTime(uint16_t nowMs);

  // Adds one that hears frames beside us.
  void add(MoreKeys& listener);
  const MoreKeys* listeners() { return parser_.moreKeys(); }

  // True when send() can take a frame. It goes nowhere while nothing may be said, as on a line with nobody at its end.
  MAVMISSION_APART bool canSend() const;

  // Sends a message of the types in Messages.h, to the autopilot if it has a target. Only when canSend().
  template <typename T>
  void send(T& message);
  // The same for a payload that has the layout of T.
  template <typename T>
  void sendAs(void* payload);

  // The same in two steps, for a message that may be wanted soon: prepareAs() packs it, only when canSend(); release()
  // sends it, if isPrepared() still. It is gone when anything else is sent, and with the autopilot's next heartbeat,
  // which may be another version's or another autopilot's.
  template <typename T>
  void prepareAs(void* payload);
  bool isPrepared() const { return outbox_.isHeld(); }
  // Where the payload for prepareAs() may be made; what was prepared before is gone. Only when canSend().
  void* draft() {
    outbox_.drop();
    return outbox_.draft();
  }
  MAVMISSION_APART void release();

  // Sends a message of the sketch's own; false if that cannot be done now.
  bool sendForeign(const OutgoingMessage& message);
  bool isSent() const { return outbox_.isEmpty(); }

  // Writes what the stream takes, `most` bytes at most: each costs about as much as one received.
  void flush(uint16_t nowMs, uint8_t most) {
#ifndef __AVR__
    // A Pico's port never says that it has room for more than one byte, though its FIFO takes 32.
    for (; most > 1 && !outbox_.isEmpty() && stream_->availableForWrite() == 1; --most)
      outbox_.flush(*stream_, nowMs, 1);
#endif
    if (!outbox_.isEmpty()) outbox_.flush(*stream_, nowMs, most);
  }

  // How quickly the line answers, and whether it loses.
  Pace& pace() { return state_.pace; }

  Stream& stream() const { return *stream_; }
#if MAVMISSION_SIGNING
  void signWith(const SigningKey& key, uint8_t linkId, const TimestampStore& store);
  void setSigningTime(const SigningTime& time) { signing_.setTime(time); }
  const Signing& signing() const { return signing_; }
  // Hashes a piece of what is to be signed or checked. To be called once in each update(): true if this one has been
  // spent on that, and nothing more is to be done in it than flush().
  bool workOnSignatures();
#else
  static constexpr bool workOnSignatures() { return false; }
#endif

  AutopilotFinder& finder() { return finder_; }
  const AutopilotFinder& finder() const { return finder_; }
  uint8_t systemId() const;
  uint8_t componentId() const;
  uint8_t ownSystemId() const { return state_.ownSystemId; }  // as the sketch has set it
  // MAVLink 1 or 2, as we speak it now.
  uint8_t version() const;
  LinkCounters counters() const;

 private:
  // Nothing leaves before it is clear who is there, unless the sketch has given our ids.
  MAVMISSION_APART bool maySpeak() const;
  // Notes what a frame tells of the line; true if it is to be given.
  MAVMISSION_APART bool takeResult(FrameParser::Result result, uint16_t nowMs);
  void sendHeartbeat();
  void takeHeartbeat(uint16_t nowMs);
  void pack(uint8_t* payload, const MessageKey* key);
  void sendMessage(uint8_t* payload, const MessageKey* key);

  struct State {
    uint16_t heardByteMs;
    uint16_t heartbeatMs;
    uint32_t bytes;
    uint16_t frames;
    uint16_t unknownMessages;
    uint16_t framesLost;
    uint16_t framesSent;
    uint8_t sequence;
    uint8_t heardSequence;
    uint8_t ownSystemId;
    uint8_t ownComponentId;
    MavlinkVersion speak;
    bool heartbeatSent;
    bool sequenceKnown;
    uint8_t damage;  // what has been counted, its low 8 bits
    Pace pace;
  };

  Stream* stream_;
  State state_;
  AutopilotFinder finder_;
  Outbox outbox_;
  FrameParser parser_;

#if MAVMISSION_SIGNING
  // Rounds of SHA-256 in an update() that does nothing else (DESIGN.md, "Signing").
  static constexpr uint8_t kRoundsAtOnce = 16;
  // How many bytes may wait in the stream meanwhile: half of what a hardware serial port has room for.
  static constexpr uint8_t kMayWait = 32;

  enum class Check : uint8_t {
    None,
    Collecting,  // checked_ holds a frame, its signature is coming
    Due,
    Running,
    Accepted,
  };

  bool takeAccepted(uint16_t nowMs);
  bool mayRead();
  void takeUnchecked(FrameParser::Result result, uint16_t nowMs);
  bool matters();
  void noteSequence();

  Signing signing_;
  FrameParser checked_;  // with the frame that is being checked, or has been accepted, as parser_ had it
  Check check_;
  bool isWaiting_;   // parser_ has a frame that is to be checked when checked_ is free; no byte is read until then
  bool hashedLast_;  // the last update() was spent on hashing
#endif
};

}  // namespace detail
}  // namespace mavmission
