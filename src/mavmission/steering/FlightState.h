// The states of a Flight, and who has ended it, in words.
#pragma once

#include <stdint.h>

#include "../base/FlashText.h"

namespace mavmission {

// X(FlightState, "text").
#define MAVMISSION_FLIGHT_STATES(X)                                                                   \
  X(Idle, "idle")           /* no flight has been asked for */                                        \
  X(Preparing, "preparing") /* the plan is uploaded, the aircraft is armed */                         \
  X(NotReady, "not ready")  /* the autopilot refuses for now: why() and reason() */                   \
  X(Flying, "flying")                                                                                 \
  X(AtStop, "at the stop") /* it stands at a stop, or at the place or the height of the last order */ \
  X(Landed, "landed")      /* at the end of its plan, or as it was told to; and disarmed */           \
  X(Ended, "ended")        /* endedBy() says by whom: nothing is armed or moved any more */

// Where a flight is.
enum class FlightState : uint8_t {
#define MAVMISSION_NAME(name, text) name,
  MAVMISSION_FLIGHT_STATES(MAVMISSION_NAME)
#undef MAVMISSION_NAME
};

// X(EndedBy, "text").
#define MAVMISSION_ENDED_BY(X)                                                                    \
  X(Nobody, "nobody")                          /* it has not ended */                             \
  X(Itself, "itself")                          /* FlightState::Landed */                          \
  X(Sketch, "the sketch")                      /* giveUp() */                                     \
  X(Pilot, "a pilot")                          /* another mode, or armed or disarmed by hand */   \
  X(Failsafe, "a failsafe or another station") /* it returns or lands without an order of ours */ \
  X(OtherStation, "another station's plan")                                                       \
  X(Refusal, "a refusal") /* why() says which one */                                              \
  X(Silence, "silence")   /* not heard for 5 s: who had it then is not known */

// Who has ended a flight.
enum class EndedBy : uint8_t {
#define MAVMISSION_NAME(name, text) name,
  MAVMISSION_ENDED_BY(MAVMISSION_NAME)
#undef MAVMISSION_NAME
};

// In words, for Serial.print(). Flash text; null for a value that is none of the enumeration.
FlashText toString(FlightState state);
FlashText toString(EndedBy who);

}  // namespace mavmission
