// Compares the item that was read back with the item that was sent. Autopilots change the items that they store:
// parameters are dropped, rounded or reduced to a sign, altitudes are cut to centimetres, frames are renumbered. The
// comparison knows what each autopilot does to each command, and allows no other difference. An item that would not
// mean the same after such a change is not sent at all: notKept().
#pragma once

#include <stdint.h>

#include "../autopilot/Commands.h"
#include "../base/Config.h"
#include "../base/ItemField.h"
#include "../item/MissionItem.h"
#include "../item/PlanType.h"

namespace mavmission {
namespace detail {

// The first field in which `read` is neither what was sent nor what this keeper makes of it, or which this keeper does
// not keep in its meaning; ItemField::None if there is no such field. `sent` is the item as it was sent (WirePlan),
// `read` the item as it was read back.
MAVMISSION_APART ItemField difference(const MissionItem& sent, const MissionItem& read, Keeper keeper);

// The first field of an item, as it is sent, which the keeper would not keep in its meaning, or ItemField::None.
inline ItemField notKept(const MissionItem& item, Keeper keeper) { return difference(item, item, keeper); }

// The value that the keeper would keep of a field that notKept() has named. NaN if that value is not known: the keeper
// does not take the field's value, or the result depends on the autopilot's board (a negative number converted to an
// unsigned integer, a number beyond 2^31).
float keptValue(const MissionItem& item, ItemField field, Keeper keeper);

}  // namespace detail
}  // namespace mavmission
