// The heartbeat of an autopilot in a datagram: the sender of that datagram is the way to the autopilot.
#pragma once

#include <Arduino.h>

namespace mavmission {
namespace detail {

// True if a datagram of whole frames has a heartbeat of an autopilot's with a right checksum; it has then been read up
// to the end of that, and otherwise to its own. `datagram`: read() gives a negative number at its end.
bool readAutopilotHeartbeat(Stream& datagram);

}  // namespace detail
}  // namespace mavmission
