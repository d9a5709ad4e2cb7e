// What a link has received, sent and lost.
#pragma once

#include <stdint.h>

namespace mavmission {

// Counters that show faults of the link. Each counts from the start of the program, and wraps.
struct LinkCounters {
  uint32_t bytes;            // received
  uint32_t bytesSkipped;     // received, but part of no frame: another baud rate, text, a full buffer
  uint16_t frames;           // undamaged ones of messages that the library knows
  uint16_t unknownMessages;  // frames of other messages
  uint16_t badChecksums;     // frames of known messages with a wrong checksum
  uint16_t brokenFrames;     // frames of other messages that did not end where they should
  uint16_t framesLost;       // of the autopilot's, by the gaps in their sequence numbers
  uint16_t framesSent;       // of all messages
};

}  // namespace mavmission
