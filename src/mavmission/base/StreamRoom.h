// How many bytes may be written to a stream without waiting, also where availableForWrite() is not implemented.
#pragma once

#include <Arduino.h>
#include <stdint.h>

#include "RetryRules.h"

namespace mavmission {
namespace detail {

// All zero at the start. docs/design/parts.md, "Other boards", says which ports return what.
class StreamRoom : public StreamRules {
 public:
  // The bytes that may be written now. `blindBytes`: the answer for a stream without availableForWrite(), which always
  // returns 0; each of these bytes may wait for the line. To be called only when there is something to write, since the
  // time during which the stream has no room is counted from here.
  int of(Stream& stream, uint16_t nowMs, uint8_t blindBytes);

  // True for a stream with room for a byte that may have room for more after it: a Pico's port never says that it has
  // room for more than one byte, though its FIFO takes 32. To be asked again after each byte.
#ifdef __AVR__
  static constexpr bool saysOne(Stream&) { return false; }
#else
  static bool saysOne(Stream& stream) { return stream.availableForWrite() == 1; }
#endif

  // When there was room, at the last call of of().
  uint16_t roomMs() const { return roomMs_; }

 private:
  uint16_t roomMs_;  // when there was room, at the last call; or when availableForWrite() began to return 0
  bool stuck_ : 1;
  bool blind_ : 1;  // availableForWrite() is taken as not implemented
#ifndef __AVR__
  bool hasSaid_;  // availableForWrite() has returned more than 0 once: a 0 is then true, as with flow control
#endif
};

}  // namespace detail
}  // namespace mavmission
