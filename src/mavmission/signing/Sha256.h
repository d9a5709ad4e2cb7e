// SHA-256 (FIPS 180-4), a few rounds at a time: on an AVR a block of 64 bytes takes longer than an update() may take
// (docs/design/signing.md).
//
//   Sha256 sum;
//   sum.begin();
//   while (count != 0) {
//     const uint16_t taken = sum.add(bytes, count);
//     bytes += taken, count -= taken;
//     while (!sum.work(8)) {}  // or return here, and go on in the next update()
//   }
//   sum.finish();
//   while (!sum.work(8)) {}
//   sum.digest(0);
#pragma once

#include <stdint.h>

namespace mavmission {
namespace detail {

class Sha256 {
 public:
  static constexpr uint8_t kBlock = 64;        // [bytes]
  static constexpr uint8_t kDigest = 32;       // [bytes]
  static constexpr uint16_t kLongest = 8191;   // message [bytes]: its length in bits is kept in 16 bits
  static constexpr uint8_t kRounds = 64;       // of a block
  static constexpr uint8_t kRoundsAtOnce = 8;  // work() does its rounds in groups of this size

  // Begins a message, and forgets the one before.
  void begin();

  // Takes the message's next bytes, as many as the block has room for; returns how many. Only when isReady().
  uint16_t add(const uint8_t* bytes, uint16_t count);

  // Ends the message. Only when isReady(), and once.
  void finish();

  // True when there is no work to do.
  bool isReady() const { return roundsLeft_ == 0; }

  // Does up to `rounds` rounds, a multiple of kRoundsAtOnce; true when none is left.
  bool work(uint8_t rounds);

  // A byte of the digest, 0 to 31. Valid when the work after finish() is done.
  uint8_t digest(uint8_t index) const;

 private:
  void beginBlock();
  void endBlock();
  void expand(uint8_t first);
  void doRounds(uint8_t first);
  uint8_t& blockByte(uint8_t index);
  uint32_t& wordAt(uint8_t place);

  uint32_t hash_[8];
  uint32_t words_[16];  // the block, then the 16 words of the schedule that are needed next
  // The working variables a to h, at first at the end; a round puts the new a in front of them. After 8 rounds they lie
  // at the beginning. So a round moves only one word.
  uint32_t window_[16];
  uint16_t length_;     // of the message so far [bytes]
  uint8_t roundsLeft_;  // of this block; 0: the block is being filled
  bool lengthDue_;      // one more block follows, which holds the message's length
};

}  // namespace detail
}  // namespace mavmission
