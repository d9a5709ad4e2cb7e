// PX4's checksum of a plan, one item after the other: a CRC-32 of the fields as they arrived.
#pragma once

#include <stdint.h>
#include <string.h>

#include "PlanFrames.h"

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

// Of these items, which have a place in frame 3 or none, as they are sent.
inline uint32_t px4Checksum(const mavmission::MissionItem* plan, uint16_t count) {
  using mavmission::CoordinateFrame;
  uint32_t sum = 0;
  for (uint16_t seq = 0; seq < count; ++seq) {
    mavmission::MissionItem item = plan[seq];
    item.frame =
        item.frame == CoordinateFrame::GlobalRelative ? CoordinateFrame::GlobalRelative : CoordinateFrame::Mission;
    sum = px4Checksum(sum, messageIn<mavlink_mission_item_int_t>(itemParts(seq, item).payload));
  }
  return sum;
}
