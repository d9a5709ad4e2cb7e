// Texts in flash, one for each value of an enumeration.
#pragma once

#include "Config.h"
#include "Flash.h"

namespace mavmission {
namespace detail {

// The text at `index` of a table that lies in flash, or null beyond its end.
MAVMISSION_APART FlashText textAt(const char* texts, uint8_t index);

}  // namespace detail
}  // namespace mavmission

// Defines NAME::kTexts, the table of a list such as MAVMISSION_STATUSES, whose rows are X(enumerator, "text"). The
// texts lie one after the other, each with its end, and an empty one after the last: a table of their addresses would
// take two bytes more for each.
#define MAVMISSION_TEXT_TABLE(NAME, LIST)                 \
  namespace NAME {                                        \
  const char kTexts[] PROGMEM = LIST(MAVMISSION_TEXT_OF); \
  }
#define MAVMISSION_TEXT_OF(name, text) text "\0"
