// What an autopilot would make of a value that it does not keep.
#include "Comparison.h"
#include "FloatBits.h"
#include "Rules.h"

namespace mavmission {

float keptValue(const MissionItem&, Field, Keeper) { return 0; }

}  // namespace mavmission
