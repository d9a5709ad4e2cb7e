// The fields of an item, for the statuses that concern one of them.
#pragma once

#include <stdint.h>

#include "FlashText.h"

namespace mavmission {

// The fields, with their wording.
#define MAVMISSION_FIELDS(X)    \
  X(None, "nothing")            \
  X(Count, "number of items")   \
  X(Command, "command")         \
  X(Reference, "frame")         \
  X(Param1, "param1")           \
  X(Param2, "param2")           \
  X(Param3, "param3")           \
  X(Param4, "param4")           \
  X(Latitude, "x (latitude)")   \
  X(Longitude, "y (longitude)") \
  X(Height, "z (altitude)")     \
  X(Autocontinue, "autocontinue")

// A field of an item, as MISSION_ITEM_INT has it, or the number of items.
enum class ItemField : uint8_t {
#define MAVMISSION_NAME(name, text) name,
  MAVMISSION_FIELDS(MAVMISSION_NAME)
#undef MAVMISSION_NAME
};

// The field in words, for Serial.print(). Flash text; null for a value that is no ItemField.
FlashText toString(ItemField field);

}  // namespace mavmission
