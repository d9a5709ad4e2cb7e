#include "Areas.h"

#include <string.h>

#include "../base/FloatBits.h"

namespace mavmission {
namespace detail {

namespace {

// Whether ArduPilot keeps the bits of a radius above 0: one that is less than a millimetre above a whole number of
// metres is cut to that number, even to 0.
bool isRadiusKept(uint32_t radius) {
  if (radius < 0x3A83126F) return false;                                                     // 0.001
  uint8_t doublings = static_cast<uint8_t>(static_cast<uint16_t>(radius >> 16) >> 7) - 127;  // if at least 1 m
  if (doublings >= 14) return true;  // below 1 m, or so large that a float has steps above 1 mm
  for (; doublings != 0; --doublings) radius <<= 1;
  radius &= 0x7FFFFF;  // what is above whole metres [2^-23 m]: 8388 are a millimetre
  return radius == 0 || radius > 8388;
}

}  // namespace

void Areas::begin(Keeper keeper) {
  keeper_ = keeper;
  left_ = 0;
  hasReturn_ = false;
}

Areas::Verdict Areas::take(const MissionItem& item) {
  constexpr Verdict kGood = {Status::Accepted, ItemField::None}, kUnknown = {Status::NotFlown, ItemField::Command},
                    kNoArea = {Status::BadFence, ItemField::Param1};
  if ((keeper_ & kOfRally) != 0) {
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
      if (left_ != 0 || radius - 1 >= 0x7F800000 - 1) return kNoArea;  // 0, below it, infinite or NaN
      if (isByArduPilot(keeper_) && !isRadiusKept(radius)) return {Status::NotKept, ItemField::Param1};
      return kGood;
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
