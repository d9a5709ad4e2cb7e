#include "Checksum.h"

#ifdef __AVR__
#include <util/crc16.h>
#endif

namespace mavmission {
namespace detail {

uint16_t checksum(uint16_t crc, const uint8_t* bytes, uint8_t length) {
  for (; length != 0; --length) {
    uint8_t byte = *bytes++;
#ifdef __AVR__
    crc = _crc_ccitt_update(crc, byte);  // written in assembler
#else
    byte ^= static_cast<uint8_t>(crc);
    byte ^= static_cast<uint8_t>(byte << 4);
    crc = static_cast<uint16_t>(((byte << 8) | (crc >> 8)) ^ (byte >> 4) ^ (byte << 3));
#endif
  }
  return crc;
}

}  // namespace detail
}  // namespace mavmission
