// The heartbeat of an autopilot in the datagrams of a sender: that sender is the way to the autopilot.
#pragma once

#include <Arduino.h>

namespace mavmission {
namespace detail {

// The search in the datagrams of one sender, which may cut its frames anywhere. A heartbeat is looked for at every
// byte, not only where a frame ends: a datagram may begin within a frame, and a frame before it may have been lost.
class HeartbeatSearch {
 public:
  // Takes the sender's next datagram. True if a heartbeat of an autopilot's with a right checksum ends in it: it has
  // then been read up to the end of that, and otherwise to its own. `datagram`: read() gives a negative number at its
  // end.
  bool readsAutopilot(Stream& datagram);
  // True if the last datagram ended within what may be a heartbeat.
  bool isBegun() const { return length_ != 0; }

 private:
  static constexpr uint8_t kLongest = 21;  // [bytes] of MAVLink 2, without a signature

  bool fits() const;

  uint8_t length_ = 0;
  uint8_t frame_[kLongest] = {};
};

}  // namespace detail
}  // namespace mavmission
