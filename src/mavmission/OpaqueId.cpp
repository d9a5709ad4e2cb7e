#include "OpaqueId.h"

namespace mavmission {
void OpaqueId::add(const void* bytes, uint8_t length) {
  const uint8_t* byte = static_cast<const uint8_t*>(bytes);
  uint32_t crc = crc_;
  for (; length != 0; --length) {
    crc ^= *byte++;
    // Bit by bit: 4,000 cycles an item, after the item has left. A table would save half of them for 250 bytes of flash.
    for (uint8_t bit = 0; bit < 8; ++bit) {
      const uint8_t lowest = static_cast<uint8_t>(crc);  // a test of 32 bits would be 32 bytes more
      crc >>= 1;
      if (lowest & 1) crc ^= kPolynomial;
    }
  }
  crc_ = crc;
}

void OpaqueId::add(const void* frame, const void* command, const void* autocontinue, const void* params) {
  add(frame, 1);
  add(command, 2);
  add(autocontinue, 1);
  add(params, kPlaceBytes);
}

}  // namespace mavmission
