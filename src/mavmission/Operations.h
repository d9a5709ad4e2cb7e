// What operations report and how they are asked for.
#pragma once

#include <stdint.h>

#include "Status.h"

namespace mavmission {

// Called from update() when an item more is aboard: `done` of `total`, in the sketch's items. Never goes back within a
// transfer; reaches `total` only when the autopilot has accepted the plan. May call cancel().
typedef void (*ProgressFunction)(void* context, uint16_t done, uint16_t total);

// Called from update() when an operation has ended, with its status. May start the next operation.
typedef void (*EndFunction)(void* context, Status status);

// The steps of start(), in their order; a vehicle needs some of them.
enum class StartStep : uint8_t { None, ReadyMode, FirstItem, Arm, AutoMode, Begin, Confirm };

// What start() has done about the arming. Armed: it has armed the aircraft, and left it so. Disarmed: it has armed it,
// could not fly it, and it is disarmed again.
enum class StartArming : uint8_t { Untouched, Armed, Disarmed };

// When an upload reads the plan back: when the autopilot's answer leaves a doubt, or always.
enum class Readback : uint8_t { InDoubt = 1, Always };

}  // namespace mavmission
