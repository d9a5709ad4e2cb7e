// PX4's checksum of a plan, one item after the other: a CRC-32 of the fields as they arrived.
#pragma once

#include <stdint.h>
#include <string.h>

#include "mavmission/base/MavlinkHeaders.h"

inline uint32_t px4Checksum(uint32_t sum, const mavlink_mission_item_int_t& item) {
  uint8_t bytes[32] = {item.frame};
  memcpy(bytes + 1, &item.command, 2);
  bytes[3] = item.autocontinue;
  memcpy(bytes + 4, &item, 28);
  for (uint8_t byte : bytes) {
    sum ^= byte;
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ ((sum & 1) != 0 ? 0xEDB88320u : 0u);
  }
  return sum;
}
