#include "FlashTable.h"

namespace mavmission {
namespace detail {

FlashText textAt(const char* texts, uint8_t index) {
  const uint8_t* byte = reinterpret_cast<const uint8_t*>(texts);
  for (; fromFlash(byte) != 0; --index) {
    if (index == 0) return reinterpret_cast<FlashText>(byte);
    while (fromFlash(byte++) != 0) {
    }
  }
  return nullptr;
}

}  // namespace detail
}  // namespace mavmission
