#include "StreamRoom.h"

#include "Clock.h"

namespace mavmission {
namespace detail {

int StreamRoom::of(Stream& stream, uint16_t nowMs, uint8_t blindBytes) {
  int room = stream.availableForWrite();
  if (room > 0) {
    blind_ = false;
#ifndef __AVR__
    hasSaid_ = true;
  } else if (hasSaid_) {
    return 0;
#endif
  } else if (blind_) {
    room = blindBytes;
  } else {
    if (!stuck_) {
      stuck_ = true;
      roomMs_ = nowMs;
    }
    if (since(roomMs_, nowMs) >= kNotImplementedMs) blind_ = true;
    return 0;
  }
  stuck_ = false;
  roomMs_ = nowMs;
  return room;
}

}  // namespace detail
}  // namespace mavmission
