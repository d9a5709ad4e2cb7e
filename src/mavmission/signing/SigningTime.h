// The timestamp of a signature: 48 bits, 10 us each, since 1st January 2015 GMT (MAVLink guide, Message Signing).
#pragma once

#include <stdint.h>

namespace mavmission {
namespace detail {

struct SigningTime {
  static constexpr uint8_t kLength = 6;  // on the wire [bytes], little-endian

  uint32_t high;  // the part that a TimestampStore keeps [0.65536 s]
  uint16_t low;   // [10 us]

  static SigningTime read(const uint8_t* wire) {
    SigningTime time;
    time.low = static_cast<uint16_t>(wire[0] | wire[1] << 8);
    const uint16_t middle = static_cast<uint16_t>(wire[2] | wire[3] << 8);
    time.high = static_cast<uint32_t>(static_cast<uint16_t>(wire[4] | wire[5] << 8)) << 16 | middle;
    return time;
  }

  void write(uint8_t* wire) const {
    wire[0] = static_cast<uint8_t>(low);
    wire[1] = static_cast<uint8_t>(low >> 8);
    wire[2] = static_cast<uint8_t>(high);
    wire[3] = static_cast<uint8_t>(high >> 8);
    wire[4] = static_cast<uint8_t>(high >> 16);
    wire[5] = static_cast<uint8_t>(high >> 24);
  }

  // The timestamp of a Unix time [s]; 0 before 2015. Right until March 2104, when 48 bits are used up.
  static SigningTime atUnixTime(uint32_t seconds) {
    constexpr uint32_t kEpoch = 1420070400;  // 1st January 2015 GMT
    seconds = seconds < kEpoch ? 0 : seconds - kEpoch;
    // 100,000 / 65,536 = 3,125 / 2,048, in two steps that fit into 32 bits.
    const uint32_t rest = seconds % 2048 * 3125;
    return SigningTime{seconds / 2048 * 3125 + rest / 2048, static_cast<uint16_t>(rest % 2048 * 32)};
  }

  // Timestamp 0 means none.
  bool isNone() const { return high == 0 && low == 0; }

  bool isBefore(const SigningTime& other) const { return high != other.high ? high < other.high : low < other.low; }

  // A minute later: a new stream may be behind by that much.
  SigningTime aMinuteLater() const {
    constexpr uint32_t kMinute = 6000000;  // [10 us]
    SigningTime later;
    later.low = static_cast<uint16_t>(low + static_cast<uint16_t>(kMinute));
    later.high = high + (kMinute >> 16) + (later.low < low ? 1 : 0);
    if (later.high < high) later.high = 0xFFFFFFFF;
    return later;
  }

  void advance() {
    if (++low == 0) ++high;
  }
};

}  // namespace detail
}  // namespace mavmission
