// MAVLink's checksum: CRC-16/MCRF4XX (MAVLink guide, Packet Serialization), begun at 0xFFFF, no final inversion.
#pragma once

#include <stdint.h>

#ifdef __AVR__
#include <util/crc16.h>
#endif

namespace mavmission {

constexpr uint16_t kChecksumStart = 0xFFFF;

inline uint16_t checksum(uint16_t crc, uint8_t byte) {
#ifdef __AVR__
  return _crc_ccitt_update(crc, byte);  // 15 cycles, written in assembler
#else
  byte ^= static_cast<uint8_t>(crc);
  byte ^= static_cast<uint8_t>(byte << 4);
  return static_cast<uint16_t>(((byte << 8) | (crc >> 8)) ^ (byte >> 4) ^ (byte << 3));
#endif
}

}  // namespace mavmission
