// What an operation of the client consists of.
#pragma once

#include <stdint.h>

#include "Port.h"

namespace mavmission {
namespace detail {

// The parts of an operation. Each operation is a struct that derives from this one, and has a time() and what else it
// has of these functions. They are called by name, so an operation costs one pointer to a function.
struct OperationParts {
  // The autopilot is found, which the client has waited for. True: time() follows in the same update(). An operation
  // that takes over a running one is not begun.
  static bool begin(Client&, uint16_t) { return true; }
  // A frame of the autopilot, while the operation is Transferring.
  static void frame(Client&, const FrameParser&, uint16_t) {}
  // static void time(Client& client, uint16_t nowMs): once in each update(), after the frames, for what is due and for
  // the timeouts.
};

// What update() calls with each frame, and with null for the time.
template <class Parts>
MAVMISSION_INLINE void operate(Client& client, const FrameParser* frame, uint16_t nowMs) {
  Port& port = Port::of(client);
  if (frame != nullptr) {
    if (port.outcome() == Status::Transferring) Parts::frame(client, *frame, nowMs);
    return;
  }
  if (port.outcome() == Status::WaitingForAutopilot) {
    port.waitForAutopilot();
    if (port.outcome() != Status::Checking || !Parts::begin(client, nowMs)) return;
  }
  Parts::time(client, nowMs);
}

}  // namespace detail
}  // namespace mavmission
