// Is the item that was read back the item that was sent? Autopilots rewrite what they store: parameters are dropped,
// rounded or reduced to a sign, altitudes are cut to centimetres, frames are renumbered. The comparison knows what each of
// them does, command by command, and is no looser.
#pragma once

#include <stdint.h>

#include "Commands.h"
#include "Config.h"
#include "Field.h"
#include "MissionItem.h"
#include "PlanType.h"

namespace mavmission {

// The first field in which `read` is not what this autopilot makes of `sent`, or Field::None. `sent` is the item as it
// went out (WirePlan), `read` as it came back.
MAVMISSION_APART Field difference(const MissionItem& sent, const MissionItem& read, Firmware firmware, PlanType type);

}  // namespace mavmission
