// Is the item that was read back the item that was sent? Autopilots rewrite what they store: parameters are dropped,
// rounded or reduced to a sign, altitudes are cut to centimetres, frames are renumbered. The comparison knows what each
// of them does, command by command, and is no looser. What would not mean the same any more is not sent (WirePlan).
#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../ItemField.h"
#include "../MissionItem.h"
#include "../PlanType.h"
#include "../autopilot/Commands.h"

namespace mavmission {
namespace detail {

// The first field in which `read` is not what this keeper makes of `sent`, nor what was sent, or which it does not keep
// in its meaning; ItemField::None. `sent` is the item as it went out (WirePlan), `read` as it came back.
MAVMISSION_APART ItemField difference(const MissionItem& sent, const MissionItem& read, Keeper keeper);

// The first field of an item, as it goes out, which the keeper would not keep in its meaning, or ItemField::None.
inline ItemField notKept(const MissionItem& item, Keeper keeper) { return difference(item, item, keeper); }

// What the keeper would make of a field that notKept() names. NaN where that is not known: it does not take the value,
// or what becomes of it depends on the board (a negative number that is to be an unsigned one, a number beyond 2^31).
float keptValue(const MissionItem& item, ItemField field, Keeper keeper);

}  // namespace detail
}  // namespace mavmission
