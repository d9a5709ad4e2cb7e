// Where the items of a plan go that is read from the autopilot: a function, or an array with a limit.
#pragma once

#include <stddef.h>

#include "MissionItem.h"

namespace mavmission {

// Takes item `index` of the autopilot's plan, and returns true; false ends the download with Status::SinkFull. Called
// from update(), once for each item, in their order. On ArduPilot it is called first with kHomeIndex and the home
// position, which is no item of the plan.
typedef bool (*ItemSinkFunction)(void* context, uint16_t index, const MissionItem& item);

// The number with which a sink is given the home position.
constexpr uint16_t kHomeIndex = 0xFFFF;

// A sink as a function, its context, and how many items it takes at most. Kept by value.
struct ItemSink {
  ItemSinkFunction write;  // not null
  void* context;           // handed to the function; may be null
  uint16_t limit;          // items; a longer plan is not begun with (Status::SinkFull)
  // False: write() would not take an item now; the autopilot is asked for it again 250 ms later, 5 times. Null: always.
  bool (*isReady)(void* context);
};

// Puts an item into an array, for toRam().
bool writeItemToRam(void* array, uint16_t index, const MissionItem& item);

// An array in RAM; itemsDone() says how many items it holds when the download has ended.
template <size_t N>
ItemSink toRam(MissionItem (&plan)[N]) {
  static_assert(N < kHomeIndex, "a plan has fewer items");
  return ItemSink{writeItemToRam, plan, N, nullptr};
}

// A function, with `context` handed to it, which may be null.
inline ItemSink toFunction(ItemSinkFunction function, void* context = nullptr, uint16_t limit = kHomeIndex - 1) {
  return ItemSink{function, context, limit, nullptr};
}

}  // namespace mavmission
