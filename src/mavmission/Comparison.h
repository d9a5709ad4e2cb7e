// Is the item that was read back the item that was sent? Autopilots rewrite what they store: parameters are dropped,
// rounded or reduced to a sign, altitudes are cut to centimetres, frames are renumbered. The comparison knows what each
// of them does, command by command, and is no looser. What would not mean the same any more is not sent (WirePlan).
#pragma once

#include <stdint.h>

#include "Commands.h"
#include "Config.h"
#include "Flash.h"
#include "MissionItem.h"
#include "PlanType.h"

namespace mavmission {

// The part of a plan that differs.
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
enum class Field : uint8_t {
#define MAVMISSION_NAME(name, text) name,
  MAVMISSION_FIELDS(MAVMISSION_NAME)
#undef MAVMISSION_NAME
};

// The field in words, for Serial.print(). Flash text; null for a value that is no Field.
FlashText toString(Field field);

// The first field in which `read` is not what this keeper makes of `sent`, nor what was sent, or which it does not keep
// in its meaning; Field::None. `sent` is the item as it went out (WirePlan), `read` as it came back.
MAVMISSION_APART Field difference(const MissionItem& sent, const MissionItem& read, Keeper keeper);

// The first field of an item, as it goes out, which the keeper would not keep in its meaning, or Field::None.
inline Field notKept(const MissionItem& item, Keeper keeper) { return difference(item, item, keeper); }

// What the keeper would make of a field that notKept() names. NaN where that is not known: it does not take the value,
// or what becomes of it depends on the board (a negative number that is to be an unsigned one, a number beyond 2^31).
float keptValue(const MissionItem& item, Field field, Keeper keeper);

}  // namespace mavmission
