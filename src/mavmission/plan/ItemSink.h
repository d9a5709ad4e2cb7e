// Where the items of a downloaded plan go: a function, or an array with a limit.
#pragma once

#include <stddef.h>

#include "../item/MissionItem.h"

namespace mavmission {

// Takes item `index` of the autopilot's plan, and returns true; false ends the download with Status::SinkFull. It is
// called from update(), once for each item, in order. On ArduPilot it is called first with kHomeIndex and the home
// position, which is not an item of the plan. It may call cancel(), which takes effect at the end of that update(); an
// operation that it tries to begin is refused (Status::Busy).
typedef bool (*ItemSinkFunction)(void* context, uint16_t index, const MissionItem& item);

// The index with which a sink is given the home position.
constexpr uint16_t kHomeIndex = 0xFFFF;

// A sink: a function, its context, and the greatest number of items. The library keeps a copy of this struct.
struct ItemSink {
  ItemSinkFunction write;  // not null
  void* context;           // handed to the function; may be null
  uint16_t limit;          // items; a longer plan is not downloaded (Status::SinkFull)
  // Returns false if write() cannot take an item now: the item is then requested again every 250 ms, up to 8 times, as
  // if it had been lost. A null pointer means that the sink is always ready.
  bool (*isReady)(void* context);
};

// Writes an item into an array, for toRam().
bool writeItemToRam(void* array, uint16_t index, const MissionItem& item);

// An array in RAM; itemsDone() says how many items it holds when the download has ended.
template <size_t N>
ItemSink toRam(MissionItem (&plan)[N]) {
  static_assert(N < kHomeIndex, "use an array of at most 65534 items: no plan has more");
  return ItemSink{writeItemToRam, plan, N, nullptr};
}

// A function; `context` is handed to it and may be null.
inline ItemSink toFunction(ItemSinkFunction function, void* context = nullptr, uint16_t limit = kHomeIndex - 1) {
  return ItemSink{function, context, limit, nullptr};
}

}  // namespace mavmission
