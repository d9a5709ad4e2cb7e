// What signatures have shown of the frames that were received.
#pragma once

#include <stdint.h>

namespace mavmission {

// What became of received frames. Each counts from the start, and wraps.
struct SigningCounters {
  uint16_t accepted;        // rightly signed, and new
  uint16_t notSigned;       // MAVLink 1, or MAVLink 2 without a signature
  uint16_t wrong;           // signed with another key, or changed on the way
  uint16_t replayed;        // older than what the same stream has sent already, or the same again
  uint16_t old;             // of a stream not heard before, more than a minute behind
  uint16_t tooManyStreams;  // more senders than are kept apart have been heard within a minute
};

}  // namespace mavmission
