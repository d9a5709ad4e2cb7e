// MAVLink 1 or 2.
#pragma once

#include <stdint.h>

namespace mavmission {

// The version in which the library sends.
enum class MavlinkVersion : uint8_t { AsAutopilot = 0, Version1 = 1, Version2 = 2 };

}  // namespace mavmission
