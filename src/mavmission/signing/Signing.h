// MAVLink 2 message signing (MAVLink guide, Message Signing): signs frames, and tells which were signed with our key,
// by whom else it may be, and now.
//
// A signature is 13 bytes behind a frame: link id, timestamp (48 bits, 10 us each since 2015), and the first 48 bits of
// the SHA-256 of key, frame, link id and timestamp. Each system, component and link id is a stream, whose timestamps
// must rise. Ours rise over all: by one with each frame that we sign, and to that of any frame that is accepted.
//
// One frame at a time, and a few rounds of SHA-256 at a time.
#pragma once

#include <stdint.h>

#include "../SigningCounters.h"
#include "../SigningKey.h"
#include "../TimestampStore.h"
#include "Sha256.h"
#include "SigningTime.h"

namespace mavmission {
namespace detail {

class Signing {
 public:
  static constexpr uint8_t kLinkAndTime = 1 + SigningTime::kLength;  // of a signature, these are signed too [bytes]
  static constexpr uint8_t kSum = 6;                                 // the rest of it [bytes]
  static constexpr uint8_t kLength = kLinkAndTime + kSum;            // the whole signature [bytes]

  // Streams whose time is remembered. One that has not been heard for a minute gives way: whatever of it was recorded
  // is too old to be taken for a new one.
  static constexpr uint8_t kStreams = 4;

  // What is reserved ahead of our time [0.65536 s]: 42 s. Less than the minute that is granted to the autopilot, which
  // is behind us by that after a reset, since what was reserved may have been used.
  static constexpr uint8_t kReserve = 64;
  // How much of it is left when more is reserved [0.65536 s].
  static constexpr uint8_t kReserveLeft = 4;
  // The same while our time stands, since nobody with a clock has been heard: 65,536 signatures. So a client that is
  // reset again and again, and heard by nobody, does not run a minute ahead of an autopilot whose time stands too.
  static constexpr uint8_t kLeastReserve = 1;

  // Bytes that are signed together, though they lie apart: `count` pieces, one behind the other. They stay where they
  // are, and as they are, until the work is done.
  struct Piece {
    const uint8_t* bytes;
    uint16_t length;
  };
  static constexpr uint8_t kPieces = 3;

  enum class Done : uint8_t {
    Nothing,  // go on
    Signed,
    Accepted,
    Refused,
  };

  // All zero is how it begins: off.
  void begin(const SigningKey& key, uint8_t linkId, const TimestampStore& store);
  bool isOn() const { return store_.load != nullptr; }

  // Moves our time forward to that of a clock; does nothing if it is there already.
  void setTime(const SigningTime& time) { moveTo(time); }

  // True while a frame is being signed or checked.
  bool isBusy() const { return job_ != Job::None; }

  // --- Signing. True if it may begin: the time that it takes has been reserved. If not, keepTime() is reserving it.
  bool maySign();
  // Puts link id and timestamp into the signature, which is the kLength bytes right behind the last piece; the rest of
  // it follows when work() says Signed. Only when maySign() and not isBusy(). `pieces`: of the frame, from its first
  // byte to its checksum, at most kPieces.
  void sign(const Piece* pieces, uint8_t count);

  // --- Checking. False if the frame is refused at once, for its time. Only when not isBusy(). `frame` as it came, from
  // its first byte to its checksum.
  bool check(const uint8_t* frame, uint16_t length, uint8_t systemId, uint8_t componentId, const uint8_t* signature);
  // A frame without a signature has been refused.
  void noteNotSigned() { ++counters_.notSigned; }

  // Goes on with the hashing: at most `rounds` rounds of SHA-256 (64 to a block), a multiple of Sha256::kRoundsAtOnce.
  Done work(uint8_t rounds);

  // Lets the store save what is to be saved; to be called now and then.
  void keepTime();

  const SigningTime& time() const { return time_; }
  const SigningCounters& counters() const { return counters_; }

 private:
  enum class Job : uint8_t { None, Signing, Checking };

  struct Stream {
    SigningTime time;  // of its last frame; none: nobody's
    uint8_t systemId, componentId, linkId;
  };

  Stream* streamOf(uint8_t systemId, uint8_t componentId, uint8_t linkId);
  Stream* freeStream();
  bool isTimely(Stream* stream, const SigningTime& time);
  void start(Job job);
  bool hash(uint8_t rounds);
  Done finishChecking();
  void fill();
  void moveTo(const SigningTime& time);

  TimestampStore store_;
  SigningTime time_;   // of the last signature
  uint32_t reserved_;  // timestamps before this are safe to use [0.65536 s]
  uint32_t saving_;    // what the store is saving; 0: nothing
  SigningCounters counters_;
  Stream streams_[kStreams];
  SigningKey key_;
  uint8_t linkId_;
  bool hasMoved_;  // our time, to that of a clock or of an accepted frame, since it was reserved last
  Job job_;
  // Of the frame that is being signed or checked.
  uint8_t piece_;  // the next one
  bool finished_;  // nothing is left but rounds
  uint8_t systemId_, componentId_;
  const uint8_t* signature_;
  uint8_t* toFill_;  // where the sum goes
  Piece pieces_[1 + kPieces];
  Sha256 sum_;
};

}  // namespace detail
}  // namespace mavmission
