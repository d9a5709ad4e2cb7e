// Where the time of signatures is kept while there is no power. A signature's timestamp must never be used twice, also
// not after a reset; so a time is reserved here before timestamps up to it are used.
#pragma once

#include <stdint.h>

namespace mavmission {

// Two functions of the sketch's; EepromTimestamps has ready ones.
struct TimestampStore {
  // The greatest time ever saved [2^16 * 10 us = 0.65536 s, since 1st January 2015 GMT]; 0 if there is none.
  uint32_t (*load)(void* context);

  // Saves a time, without waiting: does what can be done at once, and returns true when the time is safe. Until then it
  // is called again, from each update(), with the same time. A time is always greater than those before it.
  bool (*save)(void* context, uint32_t time);

  void* context;  // handed to both
};

}  // namespace mavmission
