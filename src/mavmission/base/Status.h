// Every state in which an operation can be or end, and which plan is aboard afterwards. The texts are in flash; a
// program that prints none of them does not contain them.
#pragma once

#include <stdint.h>

#include "FlashText.h"

namespace mavmission {

// One line for each status: this list is both the enumeration and its texts, so that they cannot drift apart.
// clang-format off
#define MAVMISSION_STATUSES(X) \
  /* not ended */ \
  X(Idle, "idle")                                   /* no operation has been started yet */ \
  X(WaitingForAutopilot, "waiting for an autopilot") /* none heard yet, or two heard and none named */ \
  X(BackingOff, "waiting: another station is transferring") /* see retryWhenBusy() */ \
  X(Checking, "checking the plan")                  /* before the first byte is sent */ \
  X(Transferring, "transferring")                   /* exchanging messages with the autopilot */ \
  /* ended well */ \
  X(Accepted, "accepted: the plan is aboard")       /* the autopilot acknowledged the whole plan */ \
  X(AlreadyAboard, "already aboard: nothing was uploaded") /* ensure() found the plan there */ \
  X(Downloaded, "downloaded: the plan has been read")  /* every item has been given to the sink */ \
  X(Verified, "verified: what is aboard is the plan")  /* read back and compared */ \
  X(Cleared, "cleared: no plan is aboard")          /* acknowledged by the autopilot */ \
  X(Done, "done: the autopilot confirmed it")        /* a command, or all steps of start() */ \
  /* ended with an unknown outcome */ \
  X(Unconfirmed, "sent, and not confirmed") /* the plan may or may not be aboard */ \
  /* ended by the sketch */ \
  X(Cancelled, "cancelled by the sketch") \
  /* refused before the first byte was sent: nothing aboard has changed */ \
  X(Busy, "busy with another operation")            /* only returned: the running operation keeps its own status */ \
  X(NoAutopilot, "no autopilot heard in time") \
  X(SeveralAutopilots, "several autopilots: setTargetIds()") \
  X(SameIdsAsAutopilot, "our ids are the autopilot's") \
  X(OtherAutopilot, "refused: compiled for another autopilot") /* MAVMISSION_ONLY_ARDUPILOT, _PX4: Config.h */ \
  X(NeedsMavlink2, "refused: this needs MAVLink 2") \
  X(Armed, "the autopilot is armed")       /* allowWhileArmed() allows it */ \
  X(TooManyItems, "refused: more than 65535 items") \
  X(BadLatitude, "refused: a latitude beyond 90 degrees") \
  X(BadLongitude, "refused: a longitude beyond 180 degrees") \
  X(NotANumber, "refused: a NaN where none is allowed") \
  X(NotFinite, "refused: an infinite number") \
  X(BadCurrent, "refused: current above 1") \
  X(BadJump, "refused: a jump out of the plan") \
  X(BadRange, "refused: the part is beyond the plan") \
  X(BadPlanType, "refused: PlanType::All") \
  X(WholePlansOnly, "refused: whole plans only") \
  X(BadFrame, "refused: no such altitude reference") \
  X(NotFlown, "refused: the autopilot takes no such command") \
  X(NeedsCoordinates, "refused: the item needs coordinates") \
  X(BadAltitude, "refused: an altitude out of range") \
  X(BadFence, "refused: its corners or radius make no area") \
  X(NotKept, "refused: it would be stored as another value") /* keptValue() of differingField() */ \
  /* failed on our side */ \
  X(Differs, "what is aboard is not the plan")      /* failedItem() and differingField() say where */ \
  X(SinkFull, "the plan aboard is too large for the sink") \
  X(SourceRefused, "the plan's source gave no item") \
  X(NoAnswer, "the autopilot did not answer") \
  X(TimedOut, "the autopilot fell silent, or repeats one request") \
  X(TookTooLong, "it took too long") \
  X(AcceptedEarly, "accepted before every item was asked for") \
  X(OtherPlanAboard, "accepted, but the checksum is not our plan's") \
  /* refused by the autopilot: MAV_MISSION_RESULT 1 to 15 in order, then any other result */ \
  X(Error, "autopilot: error") \
  X(UnsupportedFrame, "autopilot: frame not supported") \
  X(Unsupported, "autopilot: command not supported in a plan") \
  X(NoSpace, "autopilot: no room for the items") \
  X(Invalid, "autopilot: bad parameter") \
  X(InvalidParam1, "autopilot: bad param1") \
  X(InvalidParam2, "autopilot: bad param2") \
  X(InvalidParam3, "autopilot: bad param3") \
  X(InvalidParam4, "autopilot: bad param4") \
  X(InvalidParam5, "autopilot: bad x (latitude)") \
  X(InvalidParam6, "autopilot: bad y (longitude)") \
  X(InvalidParam7, "autopilot: bad z (altitude)") \
  X(InvalidSequence, "autopilot: item out of sequence") \
  X(Denied, "autopilot: denied (another station?)") \
  X(CancelledByAutopilot, "the autopilot cancelled or timed out") \
  X(UnknownResult, "autopilot: unknown code") \
  /* commands: MAV_RESULT 1 to 4 and 7 to 10 in order, then any other result */ \
  X(CommandRejected, "autopilot: not now, try later") \
  X(CommandDenied, "autopilot: denied (a bad parameter)") \
  X(CommandUnsupported, "autopilot: command not supported") \
  X(CommandFailed, "autopilot: failed; its text says why") \
  X(CommandLongOnly, "autopilot: only as COMMAND_LONG") \
  X(CommandIntOnly, "autopilot: only as COMMAND_INT") \
  X(CommandFrame, "autopilot: not in this frame") \
  X(NotInControl, "autopilot: another station is in control") \
  X(CommandRefused, "autopilot: refused, by another code") \
  X(NoSuchMode, "this vehicle has no such mode") \
  X(NotArmed, "the autopilot is not armed") \
  X(Unproven, "the plan aboard may not be ours") \
  X(FliesOtherPlan, "it flies a plan that may not be ours") /* start() was too late */ \
  X(Infeasible, "accepted, then found impossible to fly") \
  X(NoSuchItem, "the plan has no such item") \
  X(NothingToFly, "refused: nothing to fly to") \
  X(NoLanding, "refused: no landing or return at its end") /* Flight */ \
  X(OtherItem, "the autopilot is not at the first item")  /* failedItem() is the item it is at */ \
  X(TakenOver, "somebody else has set another mode") \
  X(Overruled, "another mode was undone, and not set again") \
  /* Steering: nothing was sent, unless control was lost during the operation */ \
  X(PilotHasIt, "a pilot or another station is in control") \
  X(FailsafeHasIt, "a failsafe or its own plan is in control") \
  X(NotFlying, "the aircraft is not in the air") \
  X(NoHome, "the autopilot names no home") \
  X(BadSpeed, "refused: a speed must be above 0, up to 100 m/s") \
  X(NotRenewed, "held: the target was not renewed") /* MovingTarget */ \
  /* parameters */ \
  X(NoParameter, "no such parameter, or not heard") \
  X(OtherValue, "the autopilot stores another value")  /* Parameters::value() */
// clang-format on

// The state of an operation, or how it has ended. The namespace has this name for one reason: if a sketch has
// Serial.println(status), which Arduino's println() does not take, the first line of the compiler's error then says
// what to write: Serial.println(toString(status)). No sketch writes the namespace.
inline namespace print_it_with_toString {
enum class Status : uint8_t {
#define MAVMISSION_NAME(name, text) name,
  MAVMISSION_STATUSES(MAVMISSION_NAME)
#undef MAVMISSION_NAME
};
}  // namespace print_it_with_toString

// True if an operation that has ended with this status may succeed when it is started again. False if the plan itself
// is wrong, or if the aircraft is armed.
bool isWorthRetry(Status status);

// The plan that the autopilot holds when an operation has ended.
#define MAVMISSION_ABOARD(X)                                \
  X(NotKnown, "not known")                                  \
  X(AsBefore, "what was aboard before")                     \
  X(OurPlan, "our plan, whole")                             \
  X(Mixture, "a mixture: our first items, then older ones") \
  X(Nothing, "no plan")                                     \
  X(OtherPlan, "not ours: somebody has replaced or cleared it")

// Which plan is aboard.
inline namespace print_it_with_toString {
enum class Aboard : uint8_t {
#define MAVMISSION_NAME(name, text) name,
  MAVMISSION_ABOARD(MAVMISSION_NAME)
#undef MAVMISSION_NAME
};
}  // namespace print_it_with_toString

// The status in words, for Serial.print(). The text is in flash; null for a value that is no Status.
FlashText toString(Status status);
FlashText toString(Aboard aboard);

// True if an operation with this status has ended.
constexpr bool isEnd(Status status) { return status > Status::Transferring; }

// The status that stands for a MAV_MISSION_RESULT (MISSION_ACK.type).
constexpr Status fromMissionResult(uint8_t result) {
  return result == 0    ? Status::Accepted
         : result <= 15 ? static_cast<Status>(static_cast<uint8_t>(Status::Error) + result - 1)
                        : Status::UnknownResult;
}

static_assert(fromMissionResult(15) == Status::CancelledByAutopilot,
              "Status must list the results from Error on in the order of MAV_MISSION_RESULT");

}  // namespace mavmission
