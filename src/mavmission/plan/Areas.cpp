#include "Areas.h"

#include <string.h>

#include "../base/FloatBits.h"

namespace mavmission {
namespace detail {

void Areas::begin(PlanType type) {
  type_ = type;
  left_ = 0;
  hasReturn_ = false;
}

Areas::Verdict Areas::take(const MissionItem& item) {
  constexpr Verdict kGood = {Status::Accepted, ItemField::None}, kUnknown = {Status::NotFlown, ItemField::Command},
                    kNoArea = {Status::BadFence, ItemField::Param1};
  if (type_ == PlanType::Rally) {
    if (item.command != kRallyPoint) return kUnknown;
    // ArduPilot takes such a point, and never gives it back.
    if ((item.x | item.y) == 0) return {Status::NeedsCoordinates, ItemField::Latitude};
    return kGood;
  }
  const int32_t corners = wholeNumber(&item.param1);
  switch (item.command) {
    case kFencePolygonInclusion:
    case kFencePolygonExclusion:
      if (left_ == 0) {
        if (corners < 3 || corners > 255) return kNoArea;
        command_ = item.command;
        corners_ = static_cast<uint8_t>(corners);
        left_ = corners_;
      }
      if (item.command != command_ || corners != corners_) return kNoArea;
      --left_;
      return kGood;
    case kFenceCircleInclusion:
    case kFenceCircleExclusion: {
      uint32_t radius;
      memcpy(&radius, &item.param1, sizeof(radius));
      return left_ != 0 || radius - 1 >= 0x7F800000 - 1 ? kNoArea : kGood;  // 0, below it, infinite or NaN
    }
    case kFenceReturnPoint:
      if (left_ != 0) return kNoArea;
      if (hasReturn_) return {Status::BadFence, ItemField::Command};
      hasReturn_ = true;
      return kGood;
    default: return kUnknown;
  }
}

}  // namespace detail
}  // namespace mavmission
