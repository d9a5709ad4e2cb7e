// Where the items of a plan come from: an array in flash, an array in RAM, or a function. The library reads an item
// when the autopilot requests it, so a plan takes no RAM in the library, however long it is.
#pragma once

#include <stddef.h>

#include "../item/MissionItem.h"

namespace mavmission {

// Fills `item` with item `index` (0 to count - 1) of a plan, and returns true; false ends the transfer with
// Status::SourceRefused. It is called from update(), in any order, and more than once for an item (the plan is checked
// first, and an item may be requested again): the same index must always give the same item. It must not block. It may
// call cancel(), which takes effect at the end of that update(); an operation that it tries to begin is refused
// (Status::Busy).
typedef bool (*ItemFunction)(void* context, uint16_t index, MissionItem& item);

// A plan: a function, its context, and the number of items. The library keeps a copy of this small struct. What it
// points at belongs to the sketch, and must live until the transfer has ended.
struct ItemSource {
  ItemFunction read;  // null with a count of 0
  void* context;      // handed to the function; may be null
  uint32_t count;     // items; more than 65,535 is refused (Status::TooManyItems)
};

// Read an item of an array, for inFlash() and inRam().
bool readItemFromFlash(void* array, uint16_t index, MissionItem& item);
bool readItemFromRam(void* array, uint16_t index, MissionItem& item);

// A plan in flash: constexpr MissionItem plan[] PROGMEM = {...}. Write `constexpr`, not `const`: with `const`, one
// value that is not a constant puts the array into RAM without a warning.
template <size_t N>
ItemSource inFlash(const MissionItem (&plan)[N]) {
  return ItemSource{readItemFromFlash, const_cast<MissionItem*>(plan), N};
}

// An array that is not constant is in RAM, and is refused here.
template <size_t N>
ItemSource inFlash(MissionItem (&)[N]) {
  static_assert(N == 0,
                "this plan is in RAM: write inRam(plan), or declare it as constexpr MissionItem plan[] PROGMEM");
  return ItemSource{nullptr, nullptr, 0};
}

// A plan in RAM: the whole array...
#ifdef __AVR__
template <size_t N>
ItemSource inRam(MissionItem (&plan)[N]) {
  return ItemSource{readItemFromRam, plan, N};
}
// A constant array is refused: on an AVR it nearly always has PROGMEM, and is in flash.
template <size_t N>
ItemSource inRam(const MissionItem (&)[N]) {
  static_assert(N == 0, "write inFlash(plan) for a plan with PROGMEM, inRam(plan, count) for a constant plan without");
  return ItemSource{nullptr, nullptr, 0};
}
#else
template <size_t N>
ItemSource inRam(const MissionItem (&plan)[N]) {
  return ItemSource{readItemFromRam, const_cast<MissionItem*>(plan), N};
}
#endif
// ... or its first `count` items.
inline ItemSource inRam(const MissionItem* plan, uint32_t count) {
  return ItemSource{readItemFromRam, const_cast<MissionItem*>(plan), count};
}

// A plan of `count` items that a function computes. `context` is handed to the function and may be null.
inline ItemSource fromFunction(ItemFunction function, uint32_t count, void* context = nullptr) {
  return ItemSource{function, context, count};
}

// A plan without items: uploading it leaves the autopilot without a plan.
inline ItemSource emptyPlan() { return ItemSource{nullptr, nullptr, 0}; }

}  // namespace mavmission
