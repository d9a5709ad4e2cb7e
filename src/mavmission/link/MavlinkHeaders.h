// The vendored MAVLink headers, compiled as they come: as a system header, because their warnings are not ours.
#pragma once
#pragma GCC system_header

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

// A message is used as the wire has it, also on a processor that would align its fields. (On AVR nothing changes.) What
// those headers include of the C library has been included above, so that it stays as it is.
#pragma pack(push, 1)
#include "../mavlink/common/mavlink.h"
#pragma pack(pop)
