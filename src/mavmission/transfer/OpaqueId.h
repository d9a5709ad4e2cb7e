// The checksum that PX4 gives a plan: MISSION_ACK.opaque_id. Whoever sends the plan can compute it, and so knows from
// the final answer that every item arrived as it was meant.
#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../MissionItem.h"

namespace mavmission {
namespace detail {

// CRC-32 (reflected, polynomial 0xEDB88320, begun at 0, not inverted at the end) over the items in their order.
class OpaqueId {
 public:
  void begin() { crc_ = 0; }
  // Adds an item as it goes out. Each points at the bytes of the message, so that nothing is copied: the command's two,
  // kPlaceBytes of param1 to z at `params`, one of the others.
  void add(const void* frame, const void* command, const void* autocontinue, const void* params);
  uint32_t value() const { return crc_; }

 private:
  void add(const void* bytes, uint8_t length);
  uint32_t crc_;
};

}  // namespace detail
}  // namespace mavmission
