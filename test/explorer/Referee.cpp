#include "Referee.h"

#include <string.h>

#include <algorithm>

#include "Plans.h"

using mavmission::Aboard;
using mavmission::Status;

namespace {

bool isPx4(Firmwares firmware) { return firmware == Firmwares::Px4; }

// By which PX4 names the plan.
uint32_t sum(const Task& task) {
  uint32_t sum = 0;
  for (uint8_t i = 0; i < task.items; ++i) sum = checksummed(sum, itemOf(task.plan, i), task.type);
  return sum;
}

}  // namespace

void Referee::begin(const Task& what, Firmwares firmware) {
  const uint8_t owed = owesCancel, hasEnded = hasEndedOne;
  memset(static_cast<void*>(this), 0, sizeof(*this));
  task = what;
  owesCancel = owed;
  hasEndedBefore = hasEnded;
  isRunning = true;
  items = static_cast<uint8_t>(wireCount(what.items, firmware, what.type));
  isLooking = what.operation == Operation::Ensure;
  isReading = isLooking || what.operation == Operation::Download || what.operation == Operation::Verify;
}

// What was asked for and sent before no longer counts.
void Referee::goOn() {
  const Task what = task;
  const uint8_t onTheWire = items;
  memset(static_cast<void*>(this), 0, sizeof(*this));
  task = what;
  items = onTheWire;
  isRunning = true;
}

void Referee::goOnByItems(bool isProof) {
  if (task.operation == Operation::FileVerify) {
    task.operation = Operation::Verify;
    isReading = true;
  } else {
    task.operation = Operation::UploadInDoubt;
    isLastSent = mayGoOn = isProof;
  }
}

void Referee::pass(uint16_t ms) {
  if (!isRunning) return;
  sinceSentMs = static_cast<uint16_t>(std::min<int>(sinceSentMs + ms, kAnswerMs));
  sinceFirstMs = static_cast<uint16_t>(std::min<int>(sinceFirstMs + ms, kLastAnswerMs));
  if (asked != 0 || counts != 0) sinceNewMs = static_cast<uint16_t>(std::min<int>(sinceNewMs + ms, kConfirmingMs));
}

const char* Referee::sent(const Message& message, Firmwares firmware) {
  const bool isCancel = message.kind == Kind::Ack && message.number == kCancelled;
  if (isCancel && owesCancel == 1 + message.type) {
    owesCancel = 0;
    return nullptr;
  }
  if (!isRunning) return "a frame is sent after the end";
  if (message.type != task.type) return "a frame is sent with the type of another plan";
  const char* const broken = sentWhile(message, firmware);
  hasSent = true;
  return broken;
}

const char* Referee::sentWhile(const Message& message, Firmwares firmware) {
  const bool isCancel = message.kind == Kind::Ack && message.number == kCancelled;
  if (task.operation == Operation::Clear) {
    if (message.kind == Kind::List) return sentInReading(message, firmware);
    if (message.kind != Kind::ClearAll) return "a frame is sent that is not CLEAR_ALL";
    if (clears == kTries && !isHurried) return "CLEAR_ALL is sent too often";
    if (clears != 0 && sinceSentMs < againMs(kAnswerMs) && !isCounted) return "CLEAR_ALL is sent again too early";
    if (clears < kTries) ++clears;
    isCounted = lists = 0;
    sinceSentMs = 0;
    return nullptr;
  }
  if (isUploading() && message.kind == Kind::List) {
    if (task.operation == Operation::Upload) return "the plan is read back unasked";
    if (!isLastSent && items != 0) return "the plan is read back before the last item was sent";
    const bool isRefused = hasHeard(kError);
    const uint8_t goesOn = mayGoOn;
    goOn();
    wasRefused = isRefused;
    mayGoOn = goesOn;
    isReading = true;
  }
  if (mayGoOn && isReading && message.kind == Kind::Count) {
    const uint8_t hurried = isHurried;
    goOn();
    task.operation = Operation::UploadVerified;
    isHurried = hurried;
  }
  if (isLooking && isCancel) {
    if (!isCounted) return "an upload begins before it was looked what is aboard";
    goOn();
    return nullptr;
  }
  if (isCancel && !isPx4(firmware) && !mayFree) return "a running transfer is cancelled";
  // What has given the upload up on a lossy link gets it anew.
  if (isGeneric(firmware) && isUploading() && message.kind == Kind::Count && asked != 0 && isHurried && isGivenUp()) {
    counts = asked = current = heardLast = open = sentItem = isLastSent = copies = isUnasked = 0;
    heardAcks = 0;
  }
  const char* const broken = isReading ? sentInReading(message, firmware) : sentInUpload(message);
  sinceSentMs = 0;
  return broken;
}

const char* Referee::sentInUpload(const Message& message) {
  switch (message.kind) {
    case Kind::Count:
      if (asked != 0) return "COUNT is sent in mid-transfer";
      if (message.number != items) return "COUNT is sent with a wrong number";
      if (counts == kTries && !isHurried) return "COUNT is sent too often";
      if (counts != 0 && sinceSentMs < againMs(kAnswerMs) && hasFreed != kJustNow)
        return "COUNT is sent again too early";
      if (hasFreed) hasFreed = kBefore;
      if (counts == 0) sinceNewMs = 0;
      if (counts < kTries) ++counts;
      return nullptr;

    case Kind::Item: {
      if (message.number >= items) return "an item beyond the plan is sent";
      const int own = message.number - (items - task.items);  // as the sketch counts; -1 is home
      const uint8_t meant = own < 0 ? kHome : itemOf(task.plan, static_cast<uint8_t>(own));
      if (message.item != meant) return "an item is sent that is not the plan's";
      const uint8_t bit = static_cast<uint8_t>(1u << message.number);
      const bool isLast = message.number + 1 == items;
      if (isPresumed && message.number == current) {
        open = static_cast<uint8_t>(open | bit);
        asked = std::max(asked, ++current);
        sinceNewMs = 0;
        copies = isPresumed = isUnasked = 0;
      }
      const bool isConfirming = isLastSent;
      if ((open & bit) == 0) {
        if (message.number + 1 != current) return "an item is sent that was not asked for";
        if (!isConfirming && !isHurried) return "an item is sent that was not asked for";
        if (sinceSentMs < againMs(kAnswerMs)) return "the last item is repeated too early";
        if (isConfirming && sinceNewMs >= kConfirmingMs) return "the last item is repeated too late";
        if (isOver) return "an item is sent to a PX4 that has given the upload up";
        isUnasked = true;
      }
      open = static_cast<uint8_t>(open & ~bit);
      sentItem = static_cast<uint8_t>(message.number + 1);
      if (copies == 0) sinceFirstMs = 0;
      if (copies < 2) ++copies;
      if (isLast) isLastSent = true;
      return nullptr;
    }

    case Kind::Ack:
      if (message.number != kCancelled) return "an ACK is sent that is no client's";
      if (!mayFree || (hasFreed && asked != 0)) return "a running transfer is cancelled";
      if (hasFreed && sinceSentMs < kAnswerMs) return "an older transfer is cancelled again too early";
      if (!hasFreed) counts = 0;  // as many tries again: PX4 gives it up by itself 5 s after it has heard something
      hasFreed = kJustNow;
      asked = current = heardLast = open = sentItem = isLastSent = copies = isUnasked = 0;
      return nullptr;

    default: return "a frame is sent that has no place in an upload";
  }
}

const char* Referee::sentInReading(const Message& message, Firmwares firmware) {
  switch (message.kind) {
    case Kind::List:
      // An error may be PX4's end of the reading; while an upload is proven, any refusal may be due to a copy.
      if (isCounted && task.operation != Operation::Download &&
          (heardAcks & (isUpload() && !isLooking ? 0xFFFE : 1u << kError)) != 0) {
        isCounted = lists = received = requests = underWay = 0;
        heardAcks = static_cast<uint16_t>(heardAcks & 1u);
      }
      if (task.operation == Operation::Clear && !hasHeard(kAccepted)) return "it is asked before CLEAR_ALL is accepted";
      if (isCounted) return "REQUEST_LIST is sent in mid-transfer";
      if (isLooking && lists == kTries && heardAcks != 0) lists = heardAcks = 0;  // it was refused, and asks anew
      if (lists == kTries && !isHurried) return "REQUEST_LIST is sent too often";
      if (lists != 0 && sinceSentMs < againMs(kAnswerMs)) return "REQUEST_LIST is sent again too early";
      if (lists < kTries) ++lists;
      return nullptr;

    case Kind::Request:
    case Kind::OlderRequest:
      if (!isCounted || message.number < received || message.number >= announced) return "a wrong item is asked for";
      if (message.number != received) {
        // Several may be under way, each once, where each is answered and nothing is lost.
        const bool mayAsk = isArduPilot(firmware) && !isHurried && underWay != 0 && underWay < kMostUnderWay;
        if (!mayAsk || message.number != received + underWay) return "a wrong item is asked for";
        ++underWay;
        return nullptr;
      }
      if (requests == kItemTries && !isHurried) return "an item is asked for too often";
      if (requests != 0 && sinceSentMs < againMs(kItemMs)) return "an item is asked for again too early";
      if (requests < kItemTries) ++requests;
      underWay = 1;
      return nullptr;

    case Kind::Ack:
      if (message.number != kAccepted) return "an ACK is sent that is no client's";
      if (!isCounted || received != announced) return "a download is closed before its last item";
      if (isClosed) return "a download is closed twice";
      isClosed = true;
      return nullptr;

    default: return "a frame is sent that has no place in a download";
  }
}

void Referee::heard(const Message& message, Firmwares firmware) {
  if (!isRunning) return;
  if (message.type != task.type) {
    // The autopilot waits for the items of an upload of before, and is told that there are none.
    if (message.kind == Kind::Request && isUploading()) owesCancel = static_cast<uint8_t>(1 + message.type);
    return;
  }
  if (message.kind == Kind::Ack && !hasSent) return;  // it answers something before
  switch (message.kind) {
    case Kind::Request:
      if (isUpload() && counts == 0 && !isReading) hasOther = true;
      if (!isUpload() || isReading || counts == 0) return;
      if (message.number >= items) hasOther = true;
      if (message.number >= items && isLastSent && !isGeneric(firmware)) mayFree = true;
      if (message.number >= items || message.number > asked) return;
      if (message.number + 1 < heardLast && sinceNewMs < kLateRequestMs) return;
      heardLast = static_cast<uint8_t>(message.number + 1);
      if (message.number + 1 != current) {
        current = static_cast<uint8_t>(message.number + 1);
        asked = std::max(asked, current);
        sinceNewMs = 0;
        copies = isPresumed = isUnasked = 0;
      } else if (message.number + 1 == sentItem && sinceSentMs < kSameRequestMs) {
        return;  // answered already
      }
      open = static_cast<uint8_t>(open | 1u << message.number);
      return;

    case Kind::Ack:
      heardAcks = static_cast<uint16_t>(heardAcks | 1u << message.number);
      // What was sent twice since it was asked for, so long ago that this is no answer to anything before: it is there.
      if (isUploading() && isArduPilot(firmware) && message.number == kInvalidSequence && copies == 2 &&
          sinceFirstMs == kLastAnswerMs && current != 0 && current < items) {
        isPresumed = true;
      }
      if (isUpload() && isPx4(firmware) && message.number == kError && asked == 0) mayFree = true;
      // It has gone on with a shorter plan of before.
      if (isUpload() && isPx4(firmware) && message.number == kAccepted && !isLastSent && items != 0) mayFree = true;
      if (isUploading() && isPx4(firmware) && message.number == kError && isUnasked && !isLastSent &&
          sinceNewMs >= kLateErrorMs) {
        isOver = true;
      }
      if (isLooking && !isCounted && message.number == kCancelled) lists = 0;  // an older upload is over
      return;

    case Kind::Count:
      if (task.operation == Operation::Clear && lists != 0) {
        isCounted = true;
        owesCancel = static_cast<uint8_t>(1 + task.type);  // PX4 would wait for us
      }
      if (!isReading || isCounted || lists == 0) return;
      // The look's COUNT, perhaps, which the line has repeated: another number is believed when it comes again. (Home
      // alone is no plan.)
      if (isUpload() && !isLooking && lists < 2 && message.number != items &&
          !(items == 0 && message.number == 1 && hasHome(firmware, task.type))) {
        return;
      }
      isCounted = true;
      announced = static_cast<uint8_t>(message.number);
      // PX4's checksum of the plan proves it, and no item is needed.
      if (isUpload() && task.operation != Operation::UploadVerified && !isLooking && isPx4(firmware) &&
          message.opaqueId != 0 && message.opaqueId == sum(task))
        received = announced;
      return;

    case Kind::Item:
      if (!isCounted || requests == 0 || message.number != received || received == announced) return;
      ++received;
      --underWay;
      requests = underWay != 0;
      return;

    default: return;
  }
}

// What aboard() says is about the last operation that can tell: only where it is about this one it is looked at.
const char* Referee::untrueAboard(Status status, Aboard said, const Autopilot& autopilot,
                                  const Autopilot* before) const {
  const bool isMeant = autopilot.holds(task.plan, task.items);
  switch (said) {
    case Aboard::OurPlan:
      if (task.operation == Operation::Clear && clears != 0) return "aboard() says our plan, and CLEAR_ALL has left";
      if ((!isUpload() && status != Status::Verified) || !hasSent) return nullptr;
      return isMeant ? nullptr : "aboard() says our plan, and it is not";
    case Aboard::Nothing:
      if (task.operation != Operation::Clear) return nullptr;
      return autopilot.heldCount == 0 ? nullptr : "aboard() says no plan, and there is one";
    case Aboard::AsBefore:
      if (!isUpload() || before == nullptr) return nullptr;
      return autopilot.holdsAs(*before) ? nullptr : "aboard() says as before, and it is not";
    case Aboard::Mixture:
      return isArduPilot(autopilot.firmware) ? nullptr : "aboard() says a mixture, and this autopilot holds none";
    case Aboard::OtherPlan: return "aboard() says somebody else's plan, and there is nobody else";
    case Aboard::NotKnown: return nullptr;
  }
  return nullptr;
}

const char* Referee::end(Status status, Aboard said, const Autopilot& autopilot, const Autopilot* before,
                         bool lineRepeats) {
  const bool isMeant = autopilot.holds(task.plan, task.items);
  const bool wasTransferring = (isUpload() || isReading) && hasSent;
  isRunning = false;
  hasEndedOne = true;
  ended = status;
  const bool isFound = status == Status::AlreadyAboard && isClosed;
  const bool isRead = isReading && hasSent && !isFound && status != Status::Accepted && status != Status::Verified &&
                      status != Status::Downloaded;
  if (task.operation != Operation::Clear) {
    owesCancel = isRead || (wasTransferring &&
                            (status == Status::Cancelled || status == Status::NoAnswer || status == Status::TimedOut))
                     ? static_cast<uint8_t>(1 + task.type)
                     : uint8_t{0};
  }

  const char* const untrue = untrueAboard(status, said, autopilot, before);
  if (untrue != nullptr) return untrue;

  const bool isListedOut = lists == kTries && !isCounted && sinceSentMs >= againMs(kAnswerMs);
  const bool isReadOut = isListedOut || (isCounted && requests == kItemTries && sinceSentMs >= againMs(kItemMs));
  switch (status) {
    case Status::Accepted:
      if (!isUpload()) return "an end that this operation does not have";
      if (!hasHeard(kAccepted) && !isClosed) return "Accepted, and nothing was acknowledged";
      if ((task.operation == Operation::UploadVerified || (isGeneric(autopilot.firmware) && items != 0)) && !isClosed)
        return "Accepted, and not read back";
      if (isLooking) return "Accepted, and nothing was uploaded";
      if (isHurried == kHurriedBefore && task.operation != Operation::Upload && !isClosed && !isPx4(autopilot.firmware))
        return "Accepted on a lossy link, and not read back";
      if (task.operation == Operation::Ensure && before != nullptr && before->holds(task.plan, task.items)) {
        return "a plan that was aboard is uploaded again";
      }
      return isMeant ? nullptr : "Accepted, and the plan aboard is not the plan meant";

    case Status::AlreadyAboard:
      if (!isLooking || !isCounted) return "AlreadyAboard, and it was not looked";
      if (!isClosed && !isPx4(autopilot.firmware)) return "AlreadyAboard, and not read to the end";
      return isMeant ? nullptr : "AlreadyAboard, and the plan aboard is not the plan meant";

    case Status::Verified:
      if (task.operation != Operation::Verify) return "an end that this operation does not have";
      if (!isClosed) return "Verified, and not read to the end";
      return isMeant ? nullptr : "Verified, and the plan aboard is not the plan meant";

    case Status::Differs:
      if (!isReading || task.operation == Operation::Download) return "an end that this operation does not have";
      return isMeant ? "Differs, and the plan aboard is the plan meant" : nullptr;

    case Status::Downloaded:
      if (task.operation != Operation::Download) return "an end that this operation does not have";
      return isClosed ? nullptr : "Downloaded, and not read to the end";  // what was read: see World

    case Status::Cleared:
      if (task.operation != Operation::Clear) return "an end that this operation does not have";
      if (!hasHeard(kAccepted)) return "Cleared, and nothing was acknowledged";
      return autopilot.heldCount == 0 ? nullptr : "Cleared, and a plan is aboard";

    case Status::Unconfirmed: {
      if (task.operation == Operation::Clear) {
        return clears == kTries || lists == kTries ? nullptr : "Unconfirmed before the tries were exhausted";
      }
      if (!isUpload() || (!isLastSent && !isReading && items != 0)) return "Unconfirmed before the last item was sent";
      if (isReading) return isReadOut || heardAcks != 0 ? nullptr : "Unconfirmed before the tries were exhausted";
      const bool isExhausted = sinceNewMs >= kConfirmingMs;
      const bool isIdle = hasHeard(kError) || (isGeneric(autopilot.firmware) && hasHeard(kInvalidSequence));
      // Of an empty plan any acceptance looks like the answer; PX4 accepts an item again for an older upload; what
      // requests items beyond the plan has another one.
      const bool isNoProof = (isGeneric(autopilot.firmware) || items == 0 || mayFree || hasOther ||
                              (isPx4(autopilot.firmware) && isUnasked)) &&
                             hasHeard(kAccepted);
      return isExhausted || isIdle || isNoProof ? nullptr : "Unconfirmed before the tries were exhausted";
    }

    case Status::NoAnswer:
      if (task.operation == Operation::Clear) {
        return clears == kTries && sinceSentMs >= againMs(kAnswerMs) ? nullptr
                                                                     : "NoAnswer before the tries were exhausted";
      }
      if (isReading) return isListedOut ? nullptr : "NoAnswer before the tries were exhausted";
      if (counts >= kTries && asked == 0 && sinceNewMs >= kCountingMs) return nullptr;
      return "NoAnswer before the tries were exhausted";

    case Status::TimedOut:
      if (isReading) return isReadOut ? nullptr : "TimedOut before the tries were exhausted";
      // An error to a repeat says that there is no transfer any more.
      if (asked != 0 && copies == 2 && hasHeard(kError)) return nullptr;
      if (asked != 0 && isGeneric(autopilot.firmware) && isGivenUp()) return nullptr;
      return asked != 0 && sinceNewMs >= kSilenceMs ? nullptr : "TimedOut before the wait was over";

    case Status::Cancelled: return nullptr;

    case Status::OtherPlanAboard:
      if (!isPx4(autopilot.firmware) || !hasHeard(kAccepted)) return "OtherPlanAboard, and nothing was accepted";
      return isMeant ? "OtherPlanAboard, and the plan aboard is the plan meant" : nullptr;

    case Status::AcceptedEarly: return hasHeard(kAccepted) ? nullptr : "AcceptedEarly, and nothing was accepted";

    default: break;
  }
  for (uint8_t result = 1; result < 16; ++result) {
    if (status != mavmission::fromMissionResult(result)) continue;
    // No model refuses a CLEAR_ALL: this was the answer to something earlier.
    if (task.operation == Operation::Clear) return "a clear ends by an answer that is another's";
    // Nor does ArduPilot answer a reading with an error while its plan stays the same.
    if (task.operation == Operation::Verify && result == kError && !isPx4(autopilot.firmware) && !lineRepeats)
      return "a reading ends by an answer that is another's";
    const bool isProven = isReading && result == kError && wasRefused;  // what was read back was not the plan
    const bool wasHeard = hasHeard(result) || isLooking;                // a look asks anew behind a refusal
    if (!wasHeard && !isProven) return "a refusal that the autopilot did not send";
    // With what this client has read. PX4 gives that up by itself before all tries are used up.
    const bool isBusy = isUploading() && result == kError && isPx4(autopilot.firmware) && asked == 0 &&
                        hasEndedBefore && autopilot.state == Autopilot::State::Sending;
    if (isBusy && counts != kTries) return "busy with what was ours, and the tries were not exhausted";
    // What a line brings twice draws an error that is no refusal, and that nobody can tell from one without reading
    // back.
    if (isUploading() && result == kError && lineRepeats) return nullptr;
    if (isUpload() && !isLooking && isMeant) return "a refusal, and the plan is aboard";
    const bool isOurs =
        autopilot.count == items && autopilot.expected != 0 && autopilot.staged[0] == itemOf(task.plan, 0);
    if (isUpload() && autopilot.state == Autopilot::State::Receiving && isPx4(autopilot.firmware) && isOurs) {
      return "a refusal, and the transfer goes on";
    }
    return nullptr;
  }
  return "an end that has no place in these operations";
}
