// MAVLink 2 message signing (MAVLink guide, Message Signing): signs frames, and recognises received frames that were
// signed with our key, and recently.
//
// A signature is 13 bytes after a frame: link id, timestamp (48 bits, 10 us each since 2015), and the first 48 bits of
// the SHA-256 of key, frame, link id and timestamp. Each combination of system, component and link id is a stream,
// whose timestamps must rise. Our own timestamp rises by one with each frame that we sign, and to that of any later
// frame that is accepted.
//
// One frame at a time, and a few rounds of SHA-256 at a time.
#pragma once

#include <stdint.h>

#include "Sha256.h"
#include "SigningCounters.h"
#include "SigningKey.h"
#include "SigningTime.h"
#include "TimestampStore.h"

namespace mavmission {
namespace detail {

class Signing {
 public:
  static constexpr uint8_t kLinkAndTime = 1 + SigningTime::kLength;  // of a signature, signed too [bytes]
  static constexpr uint8_t kSum = 6;                                 // the rest of a signature [bytes]
  static constexpr uint8_t kLength = kLinkAndTime + kSum;            // the whole signature [bytes]

  // The number of streams whose time is remembered. A stream that has been silent for a minute gives way: recorded
  // frames of it are by then too old for a new stream.
  static constexpr uint8_t kStreams = 4;

  // How far ahead of our time is reserved [0.65536 s]: 42 s. After a reset we skip the reserved times, which may have
  // been used, and the autopilot is behind us by so much: less than the minute that is granted.
  static constexpr uint8_t kReserve = 64;
  // The rest at which more is reserved [0.65536 s].
  static constexpr uint8_t kReserveLeft = 4;
  // The reserve while our time stands still, since nobody with a clock has been heard: 65,536 signatures. So a client
  // that is reset again and again, and heard by nobody, does not run a minute ahead of an autopilot whose time stands
  // still too.
  static constexpr uint8_t kLeastReserve = 1;

  // Bytes that are signed together, but lie in `count` separate pieces. They must stay unchanged until the work is
  // done.
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

  // Begins as all zeros: off.
  void begin(const SigningKey& key, uint8_t linkId, const TimestampStore& store);
  bool isOn() const { return store_.load != nullptr; }

  // Moves our time forward to that of a clock, if it is behind.
  void setTime(const SigningTime& time) { moveTo(time); }

  // True while a frame is being signed or checked.
  bool isBusy() const { return job_ != Job::None; }

  // --- Signing. True if it may begin, since its timestamp is reserved. Otherwise keepTime() is reserving it.
  bool maySign();
  // Writes link id and timestamp into the signature, the kLength bytes right after the last piece; the hash follows
  // when work() returns Signed. Only when maySign() and not isBusy(). `pieces`: at most kPieces, from the frame's first
  // byte to its checksum.
  void sign(const Piece* pieces, uint8_t count);

  // --- Checking. False if the frame is refused at once because of its timestamp. Only when not isBusy(). `frame`: as
  // received, from its first byte to its checksum.
  bool check(const uint8_t* frame, uint16_t length, uint8_t systemId, uint8_t componentId, const uint8_t* signature);
  // To be called when a frame without a signature was refused.
  void noteNotSigned() { ++counters_.notSigned; }

  // Continues the hashing: at most `rounds` rounds of SHA-256 (64 to a block), a multiple of Sha256::kRoundsAtOnce.
  Done work(uint8_t rounds);

  // Lets the store save a time that is due; to be called now and then.
  void keepTime();

  const SigningTime& time() const { return time_; }
  const SigningCounters& counters() const { return counters_; }

 private:
  enum class Job : uint8_t { None, Signing, Checking };

  struct Stream {
    SigningTime time;  // of the stream's last frame; none: the place is free
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
  uint32_t saving_;    // the time that the store is saving; 0: none
  SigningCounters counters_;
  Stream streams_[kStreams];
  SigningKey key_;
  uint8_t linkId_;
  bool hasMoved_;  // our time has moved to that of a clock or of an accepted frame since the last reservation
  Job job_;
  // Of the frame that is being signed or checked.
  uint8_t piece_;  // the next one
  bool finished_;  // nothing is left but rounds
  uint8_t systemId_, componentId_;
  const uint8_t* signature_;
  uint8_t* toFill_;  // where the hash is to be written
  Piece pieces_[1 + kPieces];
  Sha256 sum_;
};

}  // namespace detail
}  // namespace mavmission
