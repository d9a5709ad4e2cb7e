// How the autopilots find frames in bytes: by the C library of MAVLink, each in its own way of using it.
#pragma once

#include <stdint.h>

#include "mavmission/base/MavlinkHeaders.h"

// ArduPilot calls mavlink_frame_char_buffer(): a frame whose checksum is wrong is given up whole, and the parser waits
// for the next start. PX4 calls mavlink_parse_char(): the byte that ended such a frame is looked at again, as a start.
enum class HeardBy : uint8_t { ArduPilot = 0, Px4 = 1 };

class Hearing {
 public:
  explicit Hearing(HeardBy by);

  // Takes a byte; true when it ends an undamaged frame, which is then heard().
  bool take(uint8_t byte);
  const mavlink_message_t& heard() const { return heard_; }

  // That frame as it was on the line; the room for it is MAVLINK_MAX_PACKET_LEN. How many bytes it has.
  uint16_t bytesOf(uint8_t* into) const;

 private:
  const HeardBy by_;
  mavlink_message_t begun_;
  mavlink_status_t status_;
  mavlink_message_t heard_;
  mavlink_status_t told_;
};
