// The vendored MAVLink headers, compiled as they come: as a system header, because their warnings are not ours.
#pragma once
#pragma GCC system_header

#include "mavlink/common/mavlink.h"
