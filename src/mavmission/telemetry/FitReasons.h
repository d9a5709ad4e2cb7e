// What the listeners that judge an aircraft's fitness have in common.
#pragma once

#include "../link/FrameParser.h"
#include "Fitness.h"

namespace mavmission {
namespace detail {

constexpr uint32_t kStaleMs = 10000;  // a message that is older says nothing

// What a message that came so long ago says now.
inline FitReason reasonAt(uint32_t ageMs, FitReason reason) { return ageMs > kStaleMs ? FitReason::NotHeard : reason; }

// The greatest of the floats that lie at `first` and after it in a payload, as bits, which are in the order of the
// numbers. Numbers below 0, and those that are none, are left out.
uint32_t greatestBits(const FrameParser& frame, uint8_t first, uint8_t count);

}  // namespace detail
}  // namespace mavmission
