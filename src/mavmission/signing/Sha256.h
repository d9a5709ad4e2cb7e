// SHA-256 (FIPS 180-4), a few rounds at a time: a block of 64 bytes takes an AVR longer than anybody is to
// wait (DESIGN.md, "Signing").
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
  static constexpr uint8_t kRoundsAtOnce = 8;  // work() does its rounds in groups of so many

  // Begins a message. All that was before is forgotten.
  void begin();

  // Takes the message's next bytes, as many as the block has room for; returns how many. Only when isReady().
  uint16_t add(const uint8_t* bytes, uint16_t count);

  // Ends the message. Only when isReady(), and once.
  void finish();

  // True when there is no work to do.
  bool isReady() const { return roundsLeft_ == 0; }

  // Does up to `rounds` rounds, a multiple of kRoundsAtOnce; true when none is left.
  bool work(uint8_t rounds);

  // A byte of the digest, 0 to 31. When work() is done after finish().
  uint8_t digest(uint8_t index) const;

 private:
  void beginBlock();
  void endBlock();
  void expand(uint8_t first);
  void doRounds(uint8_t first);
  uint8_t& blockByte(uint8_t index);
  uint32_t& wordAt(uint8_t place);

  uint32_t hash_[8];
  uint32_t words_[16];  // the block, then the 16 words of its schedule that are due
  // The working variables a to h, at the end of it; a round puts its new a before them. After 8 rounds they lie at the
  // beginning: so nothing but one word is moved in a round.
  uint32_t window_[16];
  uint16_t length_;     // of the message so far [bytes]
  uint8_t roundsLeft_;  // of this block; 0: it is being filled
  bool lengthDue_;      // one more block follows, which holds the message's length
};

}  // namespace detail
}  // namespace mavmission
