#include "Hearing.h"

#include <string.h>

Hearing::Hearing(HeardBy by) : by_(by) {
  memset(&begun_, 0, sizeof(begun_));
  memset(&status_, 0, sizeof(status_));
  memset(&heard_, 0, sizeof(heard_));
  memset(&told_, 0, sizeof(told_));
}

bool Hearing::take(uint8_t byte) {
  if (by_ == HeardBy::ArduPilot) {
    return mavlink_frame_char_buffer(&begun_, &status_, byte, &heard_, &told_) == MAVLINK_FRAMING_OK;
  }
  // The library keeps the state of each channel itself: it is lent ours for the time of a call.
  constexpr uint8_t kChannel = 0;
  *mavlink_get_channel_buffer(kChannel) = begun_;
  *mavlink_get_channel_status(kChannel) = status_;
  const bool isWhole = mavlink_parse_char(kChannel, byte, &heard_, &told_) == MAVLINK_FRAMING_OK;
  begun_ = *mavlink_get_channel_buffer(kChannel);
  status_ = *mavlink_get_channel_status(kChannel);
  return isWhole;
}

uint16_t Hearing::bytesOf(uint8_t* into) const {
  uint8_t* out = into;
  *out++ = heard_.magic;
  *out++ = heard_.len;
  if (heard_.magic == MAVLINK_STX) {
    *out++ = heard_.incompat_flags;
    *out++ = heard_.compat_flags;
  }
  *out++ = heard_.seq;
  *out++ = heard_.sysid;
  *out++ = heard_.compid;
  *out++ = static_cast<uint8_t>(heard_.msgid);
  if (heard_.magic == MAVLINK_STX) {
    *out++ = static_cast<uint8_t>(heard_.msgid >> 8);
    *out++ = static_cast<uint8_t>(heard_.msgid >> 16);
  }
  memcpy(out, _MAV_PAYLOAD(&heard_), heard_.len);
  out += heard_.len;
  *out++ = heard_.ck[0];
  *out++ = heard_.ck[1];
  if ((heard_.incompat_flags & MAVLINK_IFLAG_SIGNED) != 0) {
    memcpy(out, heard_.signature, MAVLINK_SIGNATURE_BLOCK_LEN);
    out += MAVLINK_SIGNATURE_BLOCK_LEN;
  }
  return static_cast<uint16_t>(out - into);
}
