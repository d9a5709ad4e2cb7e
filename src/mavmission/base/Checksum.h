// MAVLink's checksum: CRC-16/MCRF4XX (MAVLink guide, Packet Serialization), begun at 0xFFFF, no final inversion.
#pragma once

#include <stdint.h>

#include "Config.h"

namespace mavmission {
namespace detail {

constexpr uint16_t kChecksumStart = 0xFFFF;

// The checksum `crc` continued over `length` bytes. One function for all users, called once for many bytes.
MAVMISSION_APART uint16_t checksum(uint16_t crc, const uint8_t* bytes, uint8_t length);

}  // namespace detail
}  // namespace mavmission
