// What a link has received and sent, and lost.
#pragma once

#include <stdint.h>

namespace mavmission {

// What makes a fault of the line visible. Each counts from the start, and wraps.
struct LinkCounters {
  uint32_t bytes;            // received
  uint32_t bytesSkipped;     // received, but part of no frame: another baud rate, text, rings that overflowed
  uint16_t frames;           // received of messages that the library knows, undamaged
  uint16_t unknownMessages;  // frames of other messages, stepped over
  uint16_t badChecksums;     // frames of known messages with a wrong checksum
  uint16_t brokenFrames;     // frames of other messages that did not end where they should
  uint16_t framesLost;       // of the autopilot's, by the gaps in their sequence numbers
  uint16_t framesSent;       // of all messages
};

}  // namespace mavmission
