// Callbacks and options of operations.
#pragma once

#include <stdint.h>

#include "../base/Status.h"

namespace mavmission {

// Called from update() when another item has been transferred: `done` of `total` items of the sketch. `done` never
// decreases within a transfer, and reaches `total` only when the autopilot has accepted the plan. The function may call
// cancel(), which takes effect at the end of that update(); until then the next operation is refused (Status::Busy).
typedef void (*ProgressFunction)(void* context, uint16_t done, uint16_t total);

// Called with the status of an operation that has ended: from update(), from cancel(), or from the function that began
// the operation. It may begin the next operation. docs/callbacks.md lists what each callback may call.
typedef void (*EndFunction)(void* context, Status status);

// X(StartStep, "text").
#define MAVMISSION_START_STEPS(X)            \
  X(None, "not begun")                       \
  X(ReadyMode, "setting the mode to arm in") \
  X(FirstItem, "setting the first item")     \
  X(Arm, "arming")                           \
  X(AutoMode, "setting the mission mode")    \
  X(Begin, "starting the mission")           \
  X(Confirm, "waiting until it flies") /* until the autopilot's messages show it */

// The steps of start(), in order. A vehicle needs only some of them.
enum class StartStep : uint8_t {
#define MAVMISSION_NAME(name, text) name,
  MAVMISSION_START_STEPS(MAVMISSION_NAME)
#undef MAVMISSION_NAME
};

// The step in words, for Serial.print(). Flash text; null for a value that is no StartStep.
FlashText toString(StartStep step);

// Whether start() has armed the aircraft. Armed: it has armed the aircraft, and left it armed. Disarmed: it has armed
// the aircraft, could not make it fly, and the aircraft is disarmed again.
enum class StartArming : uint8_t { Untouched, Armed, Disarmed };

// When an upload reads the plan back: only if the autopilot's answer does not prove that the plan is aboard, or always.
enum class Readback : uint8_t { InDoubt = 1, Always };

}  // namespace mavmission
