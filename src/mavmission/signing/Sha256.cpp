#include "Sha256.h"

#include <string.h>

#include "../base/Config.h"
#include "../base/Flash.h"

namespace mavmission {
namespace detail {
namespace {

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "Sha256 takes bytes into words on little-endian processors only"
#endif

const uint32_t kStart[8] PROGMEM = {
    0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19,
};

const uint32_t kRoundConstants[Sha256::kRounds] PROGMEM = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2,
};

// An AVR rotates a word by one bit with one instruction for each byte, and by whole bytes by moving them; for any other
// number of bits avr-gcc makes a loop. So each rotation is composed of these two, and steps that two rotations share
// are done once.
inline uint32_t left1(uint32_t x) { return x << 1 | x >> 31; }
inline uint32_t right1(uint32_t x) { return x >> 1 | x << 31; }
inline uint32_t right8(uint32_t x) { return x >> 8 | x << 24; }
inline uint32_t right16(uint32_t x) { return x >> 16 | x << 16; }
inline uint32_t right24(uint32_t x) { return x >> 24 | x << 8; }

// Rotated right by 2, 13 and 22.
inline uint32_t sum0(uint32_t x) {
  const uint32_t by22and13 = left1(left1(right24(x) ^ left1(right16(x))));
  return by22and13 ^ right1(right1(x));
}

// Rotated right by 6, 11 and 25.
inline uint32_t sum1(uint32_t x) {
  const uint32_t by8 = right8(x);
  return left1(left1(by8)) ^ right1(right24(x) ^ right1(right1(by8)));
}

// Rotated right by 7 and 18, shifted right by 3.
inline uint32_t mix0(uint32_t x) {
  const uint32_t by18and3 = right1(right1(right16(x) ^ right1(x)));
  const uint32_t wrapped = static_cast<uint32_t>(static_cast<uint8_t>(x << 5)) << 24;
  return left1(right8(x)) ^ by18and3 ^ wrapped;
}

// Rotated right by 17 and 19, shifted right by 10.
inline uint32_t mix1(uint32_t x) {
  const uint32_t by16 = right16(x);
  const uint32_t rotated = right1(by16 ^ right1(right8(x) ^ right1(by16)));
  const uint8_t wrapped1 = static_cast<uint8_t>(static_cast<uint16_t>(x) >> 2);
  const uint8_t wrapped2 = static_cast<uint8_t>(static_cast<uint8_t>(x) << 6);
  return rotated ^ (static_cast<uint32_t>(wrapped1) << 24 | static_cast<uint32_t>(wrapped2) << 16);
}

inline uint32_t readWord(const uint32_t* flash) {
#ifdef __AVR__
  return pgm_read_dword(flash);  // a third of memcpy_P's time
#else
  return *flash;
#endif
}

}  // namespace

void Sha256::begin() {
  memcpy_P(hash_, kStart, sizeof hash_);
  length_ = 0;
  roundsLeft_ = 0;
  lengthDue_ = false;
}

// A word by its offset in bytes, which wraps at the end: on an AVR cheaper than an index.
inline uint32_t& Sha256::wordAt(uint8_t place) {
  return *reinterpret_cast<uint32_t*>(reinterpret_cast<uint8_t*>(words_) + (place & (kBlock - 4)));
}

// The words are big-endian.
inline uint8_t& Sha256::blockByte(uint8_t index) { return reinterpret_cast<uint8_t*>(words_)[index ^ 3]; }

uint16_t Sha256::add(const uint8_t* bytes, uint16_t count) {
  uint8_t at = length_ % kBlock;
  if (count > static_cast<uint8_t>(kBlock - at)) count = static_cast<uint8_t>(kBlock - at);
  length_ += count;
  for (uint8_t left = static_cast<uint8_t>(count); left != 0; --left) blockByte(at++) = *bytes++;
  if (at == kBlock) beginBlock();
  return count;
}

void Sha256::finish() {
  uint8_t end = length_ % kBlock;
  blockByte(end++) = 0x80;
  lengthDue_ = end > kBlock - 8;
  while (end != kBlock) blockByte(end++) = 0;
  if (!lengthDue_) words_[15] = static_cast<uint32_t>(length_) << 3;
  beginBlock();
}

void Sha256::beginBlock() {
  memcpy(window_ + 8, hash_, sizeof hash_);
  roundsLeft_ = kRounds;
}

void Sha256::endBlock() {
  for (uint8_t i = 0; i < 8; ++i) hash_[i] += window_[8 + i];
  if (!lengthDue_) return;
  lengthDue_ = false;
  memset(words_, 0, sizeof words_);
  words_[15] = static_cast<uint32_t>(length_) << 3;
  beginBlock();
}

bool Sha256::work(uint8_t rounds) {
  for (; rounds != 0 && roundsLeft_ != 0; rounds -= kRoundsAtOnce) {
    const uint8_t first = kRounds - roundsLeft_;
    if (first >= 16) expand(first % 16);
    doRounds(first);
    roundsLeft_ -= kRoundsAtOnce;
    if (roundsLeft_ == 0) endBlock();
  }
  return isReady();
}

// Computes the next 8 words of the schedule, from `first` on, in the place of those of 16 rounds ago.
void Sha256::expand(uint8_t first) {
  uint8_t at = first * 4;
  do {
    const uint32_t sum = mix0(wordAt(at + 1 * 4)) + wordAt(at + 9 * 4) + mix1(wordAt(at + 14 * 4));
    wordAt(at) += sum;
    at += 4;
  } while (at % (4 * kRoundsAtOnce) != 0);
}

void Sha256::doRounds(uint8_t first) {
  const uint32_t* constant = kRoundConstants + first;
  const uint32_t* word = words_ + first % 16;
  uint32_t* v = window_ + 8;  // a to h
  for (uint8_t i = kRoundsAtOnce; i != 0; --i) {
    const uint32_t e = v[4];
    const uint32_t choice = v[6] ^ (e & (v[5] ^ v[6]));
    const uint32_t t = v[7] + sum1(e) + choice + readWord(constant++) + *word++;
    v[3] += t;
    const uint32_t a = v[0];
    const uint32_t majority = (a & v[1]) | (v[2] & (a | v[1]));
    *--v = t + sum0(a) + majority;
  }
  // The ranges touch, but do not overlap: eight words of 4 bytes each.
  memcpy(window_ + 8, window_, 8 * sizeof *window_);
}

uint8_t Sha256::digest(uint8_t index) const { return reinterpret_cast<const uint8_t*>(hash_)[index ^ 3]; }

}  // namespace detail
}  // namespace mavmission
