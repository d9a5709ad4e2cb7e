// Hearing for Python: fake_autopilot/hearing.py.
#include "Hearing.h"

extern "C" {

void* hearing_new(uint8_t by) { return new Hearing(static_cast<HeardBy>(by)); }

void hearing_free(void* hearing) { delete static_cast<Hearing*>(hearing); }

// Takes `length` bytes up to the end of the first frame; how many were taken. `frame` and `frameLength` are that frame,
// or 0.
uint32_t hearing_take(void* hearing, const uint8_t* bytes, uint32_t length, uint8_t* frame, uint16_t* frameLength) {
  Hearing& one = *static_cast<Hearing*>(hearing);
  *frameLength = 0;
  for (uint32_t taken = 0; taken < length; ++taken) {
    if (!one.take(bytes[taken])) continue;
    *frameLength = one.bytesOf(frame);
    return taken + 1;
  }
  return length;
}
}
