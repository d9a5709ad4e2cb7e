// The checksum that PX4 computes over a plan and reports in MISSION_ACK.opaque_id. The sender computes the same
// checksum, and so knows from the final acknowledgement that every item arrived unchanged.
#pragma once

#include <stdint.h>

#include "../base/Config.h"
#include "../item/MissionItem.h"

namespace mavmission {
namespace detail {

// CRC-32 (reflected, polynomial 0xEDB88320, initial value 0, not inverted at the end) over the items in their order.
class OpaqueId {
 public:
  void begin() { crc_ = 0; }
  // Adds an item as it is sent. The arguments point at the bytes of the message, so that nothing is copied: 2 bytes at
  // `command`, kPlaceBytes (param1 to z) at `params`, 1 byte each at `frame` and `autocontinue`.
  void add(const void* frame, const void* command, const void* autocontinue, const void* params);
  uint32_t value() const { return crc_; }

 private:
  void add(const void* bytes, uint8_t length);
  uint32_t crc_;
};

}  // namespace detail
}  // namespace mavmission
