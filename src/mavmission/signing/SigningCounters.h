// Received frames, counted by the result of checking their signatures.
#pragma once

#include <stdint.h>

namespace mavmission {

// Accepted and refused frames. Each counter begins at the start of the program, and wraps.
struct SigningCounters {
  uint16_t accepted;        // signed with our key, and new
  uint16_t notSigned;       // MAVLink 1, or MAVLink 2 without a signature
  uint16_t wrong;           // signed with another key, or damaged
  uint16_t replayed;        // not newer than the last accepted frame of the same stream
  uint16_t old;             // of a new stream, and more than a minute older than our time
  uint16_t tooManyStreams;  // more streams within a minute than there is room for
};

}  // namespace mavmission
