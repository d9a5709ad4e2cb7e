// MAVLink 1 or 2.
#pragma once

#include <stdint.h>

namespace mavmission {

// Which MAVLink to speak.
enum class MavlinkVersion : uint8_t { AsAutopilot = 0, Version1 = 1, Version2 = 2 };

}  // namespace mavmission
