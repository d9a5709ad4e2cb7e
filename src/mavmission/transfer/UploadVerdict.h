// What an answer to an upload means. An answer proves what it says only if nothing but this upload could have caused
// it: so everything else that could is named here, as evidence, and one pure function of the state, the answer and the
// evidence gives the verdict. UploadTransfer has the evidence, and does what the verdict says.
#pragma once

#include <stdint.h>

#include "../autopilot/Personality.h"
#include "../base/Status.h"

namespace mavmission {
namespace detail {

enum class UploadState : uint8_t { Counting, Sending, Confirming };

enum UploadEvidence : uint16_t {
  // --- Earlier than this upload
  kFromOpen = 1,    // a transfer of ours was left open, or this board was reset: its answers may still come
  kFromBusy = 2,    // PX4 may not have heard that an earlier transfer of ours is over
  kFromBefore = 4,  // an operation has just ended: its last answer may come once more
  // --- Of this upload
  kItemAgain = 8,  // an item was sent more than once
  kUnasked = 16,   // the current item was sent again although it was not requested again
  kFreed = 32,     // an open earlier transfer was ended first
  // --- Of others
  kBeyond = 64,  // an item was requested that this plan does not have: the autopilot receives another plan
  // --- How things are when the answer comes
  kDoubted = 128,     // another answer has come before that was not believed
  kOnLossy = 256,     // the link is lossy: earlier messages were repeated, and each repeat may be answered
  kLongAfter = 512,   // the last new request is so long ago that this answers nothing before it
  kIsTaken = 1024,    // if this answers the current item, the autopilot has that item
  kTriesUsed = 2048,  // COUNT was sent as often as it is sent to a PX4 that is busy
  kIsPart = 4096,     // a part of a plan, which was announced by MISSION_WRITE_PARTIAL_LIST
};

enum class Verdict : uint8_t {
  Ends,       // with the status that the answer stands for
  GoesOn,     // it answers something else
  Doubted,    // it goes on; if nothing else comes, the upload ends with the status that the answer stands for
  GivenUp,    // the autopilot has no upload of ours: TimedOut
  Unproven,   // all items were sent, and the answer does not tell whether they are aboard: Unconfirmed
  NextItem,   // the autopilot has the current item
  FreeFirst,  // the autopilot is busy with another one: what is open is cancelled, and the upload begins again
};

// Of an answer that something else may have caused.
constexpr Verdict doubtedIf(bool isDoubtful) { return isDoubtful ? Verdict::Doubted : Verdict::Ends; }

// The functions below ask the evidence `e` by e.has(UploadEvidence): each question costs code only where it is asked.

// All items were sent. (In Counting: the plan is empty, and any ACCEPTED looks like the answer.) PX4 answers a repeated
// last item with ACCEPTED even when it has just failed to store the plan. It also takes our last item for a repetition
// from an earlier, longer transfer that broke off at this item, and accepts it with the checksum of the items that it
// had received until then.
template <class Evidence>
constexpr Verdict verdictOnAccepted(UploadState state, Firmware firmware, const Evidence& e) {
  return e.has(kBeyond) || (state == UploadState::Counting && (e.has(kFromOpen) || e.has(kFromBefore))) ||
                 (e.has(kUnasked) && (e.has(kDoubted) || (has(firmware, kGoesOnWithOlder) && e.has(kFromOpen))))
             ? Verdict::Unproven
             : Verdict::Ends;
}

// PX4 may have gone on with an earlier, shorter transfer: its end is accepted. That is over, and ours begins again.
template <class Evidence>
constexpr Verdict verdictOnEarly(Firmware firmware, const Evidence& e) {
  return !e.has(kFromOpen) && !e.has(kFromBefore)            ? Verdict::Ends
         : has(firmware, kGoesOnWithOlder) && !e.has(kFreed) ? Verdict::FreeFirst
                                                             : Verdict::Doubted;
}

// ArduPilot answers so to every item but the one that it waits for, and continues. A server whose ways are not known
// may be idle after the last item, with our plan or without it; before, it has given the upload up at an item that
// came twice (Betaflight).
template <class Evidence>
constexpr Verdict verdictOnInvalidSequence(UploadState state, Firmware firmware, const Evidence& e) {
  return state == UploadState::Counting ? doubtedIf(e.has(kFromOpen))
         : has(firmware, kMayBeOld)     ? (state == UploadState::Confirming ? Verdict::Unproven : Verdict::GivenUp)
         : state == UploadState::Sending && has(firmware, kRefusesTakenItems) && e.has(kIsTaken) ? Verdict::NextItem
                                                                                                 : Verdict::GoesOn;
}

// PX4 is busy. If that may be with what was ours, it is ended, and COUNT sent again: the cancelling may be lost as
// well, and PX4 gives up by itself, 5 s after it has heard something, before all tries are used up. On a lossy
// link that is so after a reset, too, and each repeat of COUNT from before the cancelling has its error.
template <class Evidence>
constexpr Verdict verdictOnBusy(const Evidence& e) {
  return !e.has(kFreed)                                                                      ? Verdict::FreeFirst
         : !e.has(kTriesUsed) && (e.has(kFromBusy) || (e.has(kFromOpen) && e.has(kOnLossy))) ? Verdict::GoesOn
                                                                                             : Verdict::Ends;
}

// PX4 answers a COUNT that comes again with an error, "busy", and continues: a repeat of ours, or a copy that the line
// has made. An idle autopilot answers so to every item: to one of ours that it had not requested, and then it has given
// up, was restarted, or has the plan; and to a copy of an item that was sent twice. Any other error refuses the item.
template <class Evidence>
constexpr Verdict verdictOnItemError(UploadState state, Firmware firmware, const Evidence& e) {
  return has(firmware, kSaysErrorWhenBusy) ? Verdict::Doubted
         : e.has(kUnasked)                 ? (state == UploadState::Sending ? Verdict::GivenUp : Verdict::Unproven)
                                           : doubtedIf(state == UploadState::Confirming && e.has(kItemAgain));
}

// On a lossy link, many repeats in an earlier transfer may be answered with an error each. (The last item is read
// back in any case.)
template <class Evidence>
constexpr Verdict verdictOnError(UploadState state, Firmware firmware, const Evidence& e) {
  return state == UploadState::Counting && !has(firmware, kErrorRefusesCount)    ? verdictOnBusy(e)
         : state == UploadState::Sending && e.has(kUnasked) && e.has(kLongAfter) ? Verdict::GivenUp
         : !e.has(kFromOpen) || !e.has(kOnLossy) || (state == UploadState::Confirming && e.has(kUnasked))
             ? (state == UploadState::Counting ? Verdict::Ends : verdictOnItemError(state, firmware, e))
         : state == UploadState::Counting ? Verdict::Doubted
                                          : Verdict::GoesOn;
}

// `answer`: of MISSION_ACK; AcceptedEarly for an acceptance before all items were sent.
template <class Evidence>
constexpr Verdict verdictOf(UploadState state, Status answer, Firmware firmware, const Evidence& e) {
  return answer == Status::Accepted          ? verdictOnAccepted(state, firmware, e)
         : answer == Status::AcceptedEarly   ? verdictOnEarly(firmware, e)
         : answer == Status::InvalidSequence ? verdictOnInvalidSequence(state, firmware, e)
         // While a part is received, its announcement that comes again is denied.
         : answer == Status::Denied ? doubtedIf(e.has(kIsPart))
         : answer == Status::Error  ? verdictOnError(state, firmware, e)
         // The autopilot may mean an earlier transfer of ours, since it has not begun this one yet.
         : answer == Status::CancelledByAutopilot ? doubtedIf(state == UploadState::Counting && e.has(kFromOpen))
                                                  : Verdict::Ends;
}

}  // namespace detail
}  // namespace mavmission
