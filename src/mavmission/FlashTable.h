// Texts in flash by their index.
#pragma once

#include "Flash.h"

namespace mavmission {

template <uint8_t N>
FlashText textAt(const char* const (&texts)[N], uint8_t index) {
  return index < N ? reinterpret_cast<FlashText>(fromFlash(&texts[index])) : nullptr;
}

}  // namespace mavmission
