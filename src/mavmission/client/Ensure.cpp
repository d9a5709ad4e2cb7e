// MissionClient's ensure(): looks which plan is aboard, and uploads only where it is another one.
//
//   WaitingForAutopilot -> Checking -> the look ------------------------> AlreadyAboard
//                                        | another plan is aboard
//                                        +--> armed: Armed, and nothing is changed
//                                        +--> our reading is closed (ensureFreeStep) -> the upload
//
// The look is MISSION_REQUEST_LIST. PX4's answer has the checksum of its plan, which is compared with ours; any other
// autopilot's items are read and compared.
#include <Arduino.h>

#include "../MissionClient.h"
#include "../link/Messages.h"
#include "../link/Sending.h"

namespace mavmission {
using namespace detail;

Status Client::ensurePlan(const ItemSource& plan, PlanType type, Readback proof) {
  const Status status = uploadProven(plan, type, proof);
  if (isEnd(status)) return status;
  beginEnsuring();
  return status;
}

Status MissionClient::ensure(const ItemSource& plan, PlanType type, Readback proof) {
  const Status status = upload(plan, type, proof);
  if (isEnd(status)) return status;
  beginEnsuring();
  return status;
}

void Client::beginEnsuring() {
  state_.operation = ensureStep;
  state_.status = Status::WaitingForAutopilot;
  rest_.options.takeUp = ensureTakeUp;
  setAboard(Aboard::NotKnown);  // what was known was about the plan before
}

struct Client::Ensuring : OperationParts {
  static bool begin(Client& client, uint16_t) {
    client.beginChecking();
    client.reading_.summed = 0;
    client.opaqueId_.begin();
    return true;
  }

  static void frame(Client& client, const FrameParser& frame, uint16_t nowMs) { client.takeLookFrame(frame, nowMs); }

  static void time(Client& client, uint16_t nowMs) {
    if (client.state_.status == Status::Transferring) return client.look(nowMs);
    client.checkEnsured(nowMs);
  }
};

void Client::ensureStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  operate<Ensuring>(client, frame, nowMs);
}

// Checks the plan as an upload does, and adds up its checksum, before the autopilot is asked: so the time of the look
// does not grow with the plan.
void Client::checkEnsured(uint16_t nowMs) {
  if (checkNext(false) != Status::Transferring) return;
  // An item is checked in one update(), and added to the checksum in another: both together would take too long.
  uint16_t& wireItem = reading_.summed;
  if (plan_.has(kSaysChecksum) && wireItem < plan_.wireCount()) {
    const Status read = sumItem(wireItem);
    if (read == Status::Checking) return;
    if (read != Status::Accepted) {
      noteFailed(wireItem);
      return end(read);
    }
    ++wireItem;
    return;
  }
  reading_.take = ensureItem;
  state_.isCompared = true;
  reading_.fromFloats = fromFloats;
  beginLook(nowMs);
  state_.proving = true;  // no progress is reported for the look
  rest_.field = ItemField::None;
  if (rest_.backOffPauseS == 0) beginSeconds(nowMs);
  state_.status = Status::Transferring;
}

void Client::beginLook(uint16_t nowMs) {
  rest_.lastResult = 255;
  reading_.transfer.begin(nowMs);
}

Status Client::sumItem(uint16_t wireItem) {
  MissionItem& item = *static_cast<MissionItem*>(link_.draft());
  const Status read = plan_.read(wireItem, item);
  if (read == Status::Accepted) opaqueId_.add(&item.frame, &item.command, &item.autocontinue, &item);
  return read;
}

void Client::look(uint16_t nowMs) {
  state_.readsHalf = true;  // as in readStep()
  DownloadTransfer& transfer = reading_.transfer;
  Status status = transfer.onTime(nowMs, link_.pace());
  // A refusal of the request is believed only after the last attempt: the autopilot may hold an upload of ours open,
  // from before a reset, or one of another ground station, and both end within seconds.
  if (status == Status::NoAnswer && rest_.lastResult != 255) {
    if ((state_.unsettled & UploadTransfer::kAnswers) != 0) return beginLook(nowMs);
    status = fromMissionResult(rest_.lastResult);
  }
  if (status == Status::Transferring && state_.isLate) status = Status::TookTooLong;
  if (status != Status::Transferring) return endLook(status);
  if (transfer.toSend() != DownloadTransfer::Send::Accepted) return sendRead(nowMs);
  if (!link_.canSend()) return;
  sendAck(MAV_MISSION_ACCEPTED, state_.type);
  endLook(Status::AlreadyAboard);
}

void Client::takeLookFrame(const FrameParser& frame, uint16_t nowMs) {
  switch (frame.messageId()) {
    case MAVLINK_MSG_ID_MISSION_COUNT: return takeLookCount(frame, nowMs);
    case MAVLINK_MSG_ID_MISSION_ITEM_INT:
    case MAVLINK_MSG_ID_MISSION_ITEM:
      takeReadItem(frame, nowMs);
      if (state_.operation == ensureStep && rest_.field != ItemField::None) replaceOther();
      return;
    case MAVLINK_MSG_ID_MISSION_ACK: {
      typedef mavlink_mission_ack_t Ack;
      if (frame.payloadByte(offsetof(Ack, mission_type)) != static_cast<uint8_t>(state_.type)) return;
      const uint8_t result = frame.payloadByte(offsetof(Ack, type));
      const Status status = reading_.transfer.onAck(result);
      if (status == Status::Transferring || reading_.transfer.tries() == 0) return;
      rest_.lastResult = result;
      if (reading_.transfer.state() != DownloadTransfer::State::Listing) {
        // An error may be the late answer to the last item of an earlier upload, if that item was sent again.
        const bool mayBeOlder = status == Status::Error && (state_.unsettled & UploadTransfer::kAnswers) != 0;
        return mayBeOlder ? void() : endLook(status);
      }
      // ArduPilot has just given up the upload for which it refused to be read.
      if (status == Status::CancelledByAutopilot) beginLook(nowMs);
      return;
    }
    default: return;
  }
}

void Client::takeLookCount(const FrameParser& frame, uint16_t nowMs) {
  typedef mavlink_mission_count_t Count;
  DownloadTransfer& transfer = reading_.transfer;
  if (frame.payloadByte(offsetof(Count, mission_type)) != static_cast<uint8_t>(state_.type)) return;
  if (!transfer.expectsAnswer(DownloadTransfer::State::Listing)) return;
  const uint16_t count = frame.payloadWord(offsetof(Count, count));
  reading_.planId = frame.payloadLong(offsetof(Count, opaque_id));
  if (!isOurCount(count)) {
    rest_.field = ItemField::Count;
    return replaceOther();
  }
  // Our checksum is that of the items as integers.
  if (!plan_.has(kSaysChecksum) || reading_.planId == 0 || state_.floatItems) {
    transfer.onCount(count, nowMs, link_.pace());
  } else if (reading_.planId == opaqueId_.value()) {
    tellCancelled();  // otherwise PX4 would wait for our requests for 5 s
    endLook(Status::AlreadyAboard);
  } else {
    replaceOther();
  }
}

// Compares an item of the look. A difference is left in rest_.field for takeLookFrame().
Status Client::ensureItem(Client& client, uint16_t wireItem, MissionItem& item) {
  const Status compared = compareItem(client, wireItem, item);
  if (compared == Status::Transferring || compared == Status::Checking) return compared;
  client.noteFailed(wireItem);
  if (compared != Status::Differs) {
    client.rest_.field = ItemField::None;
    client.endLook(compared);
  }
  return Status::Checking;  // nothing more is made of this item
}

// Another plan is aboard.
void Client::replaceOther() {
  // An autopilot that is armed may be flying its plan. allowWhileArmed() does not matter here: a sketch calls ensure()
  // at each start, which may be a reset in the air.
  if (isArmed()) return endLook(Status::Armed);
  state_.readsHalf = false;
  state_.operation = ensureFreeStep;
}

// Closes our reading, then begins the upload. PX4 would otherwise refuse MISSION_COUNT, being busy with our reading.
void Client::ensureFreeStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  if (frame != nullptr || !client.link_.canSend()) return;
  State& state = client.state_;
  client.sendAck(MAV_MISSION_OPERATION_CANCELLED, state.type);
  state.unsettled |= UploadTransfer::kBusy;  // the closing may be lost
  state.unsettledMs = nowMs;
  state.failedItem = kNoItem;
  client.rest_.field = ItemField::None;
  client.rest_.lastResult = 255;
  client.state_.proving = false;
  if (client.rest_.options.readBack == proveUpload) client.rest_.options.readBack = proveEnsured;
  state.operation = uploadStep;
  client.beginUpload(nowMs);
}

void Client::proveEnsured(Client& client, uint16_t nowMs) {
  proveUpload(client, nowMs);
  client.state_.operation = ensureProofStep;
}

// The read-back, as it is behind any upload, but for its COUNT: that may be the look's, which the line has repeated. So
// another number of items is believed when REQUEST_LIST has been sent again.
void Client::ensureProofStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  typedef mavlink_mission_count_t Count;
  const DownloadTransfer& transfer = client.reading_.transfer;
  if (frame != nullptr && frame->messageId() == MAVLINK_MSG_ID_MISSION_COUNT) {
    if (frame->payloadByte(offsetof(Count, mission_type)) != static_cast<uint8_t>(client.state_.type)) return;
    const bool isOurs = client.isOurCount(frame->payloadWord(offsetof(Count, count)));
    if (transfer.tries() < (isOurs ? 1 : DownloadRules::kOtherTries)) return;
    client.state_.operation = readStep;
  }
  readStep(client, frame, nowMs);
}

void Client::endLook(Status status) {
  state_.readsHalf = false;
  if (status == Status::AlreadyAboard) {
    setAboard(Aboard::OurPlan);
    if (state_.type == PlanType::Mission) {
      // What PX4 has said about a plan holds until it takes another one.
      if (reading_.planId != rest_.planId) state_.infeasible = false;
      rest_.planId = reading_.planId;
    }
    report(rest_.itemsTotal);
  } else {
    tellCancelled();
  }
  state_.unsettled |= UploadTransfer::kBusy;  // our last message may be lost
  state_.unsettledMs = state_.secondMs;       // about now: less than a second ago
  if (rest_.options.backOff != nullptr && rest_.options.backOff(*this, status)) {
    state_.operation = ensureBackOffStep;
    return;
  }
  end(status);
}

// ArduPilot denies reading while it receives our plan. So the first denial of MISSION_COUNT may be the answer to a
// MISSION_REQUEST_LIST of the look that the line has repeated: COUNT is sent again before a denial is believed.
bool Client::ensureTakeUp(Client& client, Status status, uint16_t nowMs) {
  client.rest_.options.takeUp = ensureTakeUpAgain;
  if (status == Status::Denied && !client.transfer_.hasBegun()) return true;
  return ensureTakeUpAgain(client, status, nowMs);
}

// After a back-off it is looked again: the transfer that was waited for may have brought our plan, or another one.
bool Client::ensureTakeUpAgain(Client& client, Status status, uint16_t nowMs) {
  const bool hasBegun = client.transfer_.hasBegun();
  client.rest_.options.takeUp = takeUpEnd;
  if (takeUpEnd(client, status, nowMs)) {
    if (client.state_.status == Status::BackingOff) client.state_.operation = ensureBackOffStep;
    return true;
  }
  if (hasBegun || (status != Status::Denied && status != Status::Error)) return false;
  // The look may still be what is refused, and COUNT have been taken: aboard() stays NotKnown.
  client.end(status);
  return true;
}

void Client::ensureBackOffStep(Client& client, const FrameParser* frame, uint16_t) {
  if (frame == nullptr && client.state_.seconds >= client.state_.backOffEndS) client.beginEnsuring();
}

}  // namespace mavmission
