// A Flight in words. A program that prints none of them does not contain them.
#include <Arduino.h>

#include "../base/FlashTable.h"
#include "Flight.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TEXT_TABLE(states, MAVMISSION_FLIGHT_STATES)

MAVMISSION_TEXT_TABLE(enders, MAVMISSION_ENDED_BY)

}  // namespace

FlashText toString(FlightState state) { return textAt(states::kTexts, static_cast<uint8_t>(state)); }

FlashText toString(EndedBy who) { return textAt(enders::kTexts, static_cast<uint8_t>(who)); }

void Flight::printTo(Print& out) const {
  out.print(toString(state()));
  if (stop() != MissionClient::kNoItem && !isSteered_) {
    out.print(F(" of item "));
    out.print(stop());
  }
  if (state() == FlightState::Ended) {
    out.print(F(" by "));
    out.print(toString(endedBy()));
  }
  const bool isRefusal = state() == FlightState::Ended && endedBy() == EndedBy::Refusal;
  const bool isOrder = state() == FlightState::AtStop && why() != Status::Done;  // that was refused
  if (!isRefusal && !isOrder && state() != FlightState::NotReady) return static_cast<void>(out.println());
  out.print(F(": "));
  // The autopilot's own words say more than the status of its refusal.
  if (reason_[0] != 0 && !wantsReason_ && !isOrder) {
    out.println(reason_);
  } else {
    out.println(toString(why()));
  }
}

}  // namespace mavmission
