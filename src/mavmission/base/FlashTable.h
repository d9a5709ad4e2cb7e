// Texts in flash, one for each value of an enumeration.
#pragma once

#include "Flash.h"

namespace mavmission {
namespace detail {

// The text at `index` of a table that lies in flash, or null beyond its end.
template <uint8_t N>
FlashText textAt(const char* const (&texts)[N], uint8_t index) {
  return index < N ? reinterpret_cast<FlashText>(fromFlash(&texts[index])) : nullptr;
}

}  // namespace detail
}  // namespace mavmission

// Defines NAME::kTexts, the table of a list such as MAVMISSION_STATUSES, whose rows are X(enumerator, "text").
#define MAVMISSION_TEXT_TABLE(NAME, LIST)                               \
  namespace NAME {                                                      \
  LIST(MAVMISSION_TEXT_OF)                                              \
  const char* const kTexts[] PROGMEM = {LIST(MAVMISSION_TEXT_ADDRESS)}; \
  }
#define MAVMISSION_TEXT_OF(name, text) const char kText##name[] PROGMEM = text;
#define MAVMISSION_TEXT_ADDRESS(name, text) kText##name,
