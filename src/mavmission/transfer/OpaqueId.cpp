#include "OpaqueId.h"

namespace mavmission {
namespace detail {
namespace {

constexpr uint32_t kPolynomial = 0xEDB88320;

// One byte more, bit by bit.
uint32_t withByte(uint32_t crc, uint8_t byte) {
  crc ^= byte;
  uint8_t bits = 8;
#ifdef __AVR__
  // The loop below, in less time.
  asm("1: lsr %D0\n\t"
      "ror %C0\n\t"
      "ror %B0\n\t"
      "ror %A0\n\t"
      "brcc 2f\n\t"
      "eor %A0, %A2\n\t"
      "eor %B0, %B2\n\t"
      "eor %C0, %C2\n\t"
      "eor %D0, %D2\n\t"
      "2: dec %1\n\t"
      "brne 1b"
      : "+r"(crc), "+r"(bits)
      : "r"(kPolynomial));
#else
  for (; bits != 0; --bits) crc = (crc & 1) != 0 ? crc >> 1 ^ kPolynomial : crc >> 1;
#endif
  return crc;
}

}  // namespace

void OpaqueId::add(const void* bytes, uint8_t length) {
  const uint8_t* byte = static_cast<const uint8_t*>(bytes);
  uint32_t crc = crc_;
  for (; length != 0; --length) crc = withByte(crc, *byte++);
  crc_ = crc;
}

void OpaqueId::add(const void* frame, const void* command, const void* autocontinue, const void* params) {
  add(frame, 1);
  add(command, 2);
  add(autocontinue, 1);
  add(params, kPlaceBytes);
}

}  // namespace detail
}  // namespace mavmission
