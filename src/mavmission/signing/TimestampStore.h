// Keeps the time of signatures without power. A signature's timestamp must never be used twice, not even after a reset;
// so a time is reserved here before the timestamps up to it are used.
#pragma once

#include <stdint.h>

namespace mavmission {

// Two functions that the sketch provides; EepromTimestamps is one that is ready to use.
struct TimestampStore {
  // The greatest saved time [2^16 * 10 us = 0.65536 s, since 1st January 2015 GMT]; 0 if there is none.
  uint32_t (*load)(void* context);

  // Saves a time without waiting: it does what can be done at once, and returns true when the time is safely stored.
  // Until then it is called again, from each update(), with the same time. Each new time is greater than the ones
  // before.
  bool (*save)(void* context, uint32_t time);

  void* context;  // handed to both
};

}  // namespace mavmission
