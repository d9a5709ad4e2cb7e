// Is the item that was read back the item that was sent? Autopilots rewrite what they store: parameters are dropped,
// rounded or reduced to a sign, altitudes are cut to centimetres, frames are renumbered. The comparison knows what each of
// them does, command by command, and is no looser.
#pragma once

#include <stdint.h>

#include "Commands.h"
#include "Config.h"
#include "Flash.h"
#include "MissionItem.h"
#include "PlanType.h"

namespace mavmission {

// The part of a plan that differs.
#define MAVMISSION_FIELDS(X)              \
  X(None, "nothing")                      \
  X(Count, "number of items")             \
  X(Command, "command")                   \
  X(Reference, "frame")                   \
  X(Param1, "param1")                     \
  X(Param2, "param2")                     \
  X(Param3, "param3")                     \
  X(Param4, "param4")                     \
  X(Latitude, "x (latitude)")             \
  X(Longitude, "y (longitude)")           \
  X(Height, "z (altitude)")               \
  X(Autocontinue, "autocontinue")

// A field of an item, as MISSION_ITEM_INT has it, or the number of items.
enum class Field : uint8_t {
#define MAVMISSION_NAME(name, text) name,
  MAVMISSION_FIELDS(MAVMISSION_NAME)
#undef MAVMISSION_NAME
};

// The field in words, for Serial.print(). Flash text; null for a value that is no Field.
FlashText toString(Field field);

// The first field in which `read` is not what this autopilot makes of `sent`, or Field::None. `sent` is the item as it
// went out (WirePlan), `read` as it came back.
MAVMISSION_APART Field difference(const MissionItem& sent, const MissionItem& read, Firmware firmware, PlanType type);

}  // namespace mavmission
