// The checksum that PX4 gives a plan: MISSION_ACK.opaque_id. Whoever sends the plan can compute it, and so knows from
// the final answer that every item arrived as it was meant.
#pragma once

#include <stdint.h>

#include "Config.h"
#include "MissionItem.h"

namespace mavmission {

// CRC-32 (reflected, polynomial 0xEDB88320, begun at 0, not inverted at the end) over the items in their order.
class OpaqueId {
 public:
  void begin() { crc_ = 0; }
  // Adds an item as it goes out; `params`: its param1 to z, kPlaceBytes bytes as in MISSION_ITEM_INT.
  void add(uint8_t frame, uint16_t command, uint8_t autocontinue, const void* params);
  uint32_t value() const { return crc_; }

 private:
  static constexpr uint32_t kPolynomial = 0xEDB88320;
  void add(const void* bytes, uint8_t length);
  uint32_t crc_;
};

}  // namespace mavmission
