// What an autopilot needs of the items of a fence, or of rally points, and WirePlan does not see since it looks at one
// item: corners that make a polygon, circles with a radius, no other commands. PX4 accepts other items, and then
// enforces nothing of them. Of a circle the radius is looked at here alone.
#pragma once

#include <stdint.h>

#include "../autopilot/Commands.h"
#include "../base/ItemField.h"
#include "../base/Status.h"
#include "../item/MissionItem.h"

namespace mavmission {
namespace detail {

class Areas {
 public:
  // Why an item cannot be used, and which of its fields is the cause. Accepted: it can be used.
  struct Verdict {
    Status status;
    ItemField field;
  };

  // To be called before the first item of a fence, or of rally points, for this keeper.
  void begin(Keeper keeper);
  // Takes the next item.
  Verdict take(const MissionItem& item);
  // How many corners of an unfinished polygon have been taken; 0: none is unfinished. If an item is refused, or there
  // is none after the last one, the first of these corners is the item with the fault.
  uint8_t unfinished() const { return left_ != 0 ? static_cast<uint8_t>(corners_ - left_) : 0; }

 private:
  Keeper keeper_;
  uint8_t corners_;   // that the present polygon has
  uint8_t left_;      // of them, still to come
  bool hasReturn_;    // the return point has been
  uint16_t command_;  // of the corners
};

}  // namespace detail
}  // namespace mavmission
