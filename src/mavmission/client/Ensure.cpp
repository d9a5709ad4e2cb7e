// MissionClient's ensure(): looks which plan is aboard, and uploads only where it is another one.
//
//   WaitingForAutopilot -> Checking -> the look ------------------------> AlreadyAboard
//                                        | another plan is aboard
//                                        +--> armed: Armed, and nothing is changed
//                                        +--> our reading is closed (freeStep()), 0.4 s pass ----> the upload
//
// The look is MISSION_REQUEST_LIST. PX4's answer has the checksum of its plan, which is compared with ours; any other
// autopilot's items are read and compared.
#include <Arduino.h>

#include "../link/Messages.h"
#include "../link/Sending.h"
#include "Ensuring.h"
#include "MissionClient.h"
#include "Reading.h"
#include "Uploading.h"

namespace mavmission {
using namespace detail;

Status Client::ensurePlan(const ItemSource& plan, PlanType type, Readback proof) {
  const Status status = uploadProven(plan, type, proof);
  if (isEnd(status)) return status;
  beginEnsuring();
  return status;
}

void Client::beginEnsuring() {
  state_.operation = Ensuring::step;
  state_.status = Status::WaitingForAutopilot;
  state_.isLate = false;
}

bool Client::Ensuring::begin(Client& client, uint16_t) {
  client.beginChecking();
  client.reading_.summed = 0;
  client.opaqueId_.begin();
  return true;
}

void Client::Ensuring::time(Client& client, uint16_t nowMs) {
  if (client.state_.status == Status::Transferring) return look(client, nowMs);
  checkNext(client, nowMs);
}

void Client::Ensuring::step(Client& client, const FrameParser* frame, uint16_t nowMs) {
  operate<Ensuring>(client, frame, nowMs);
}

// Checks the plan as an upload does, and adds up its checksum, before the autopilot is asked: so the time of the look
// does not grow with the plan.
void Client::Ensuring::checkNext(Client& client, uint16_t nowMs) {
  if (client.checkNext() != Status::Transferring) return;
  // An item is checked in one update(), and added to the checksum in another: both together would take too long.
  uint16_t& wireItem = client.reading_.summed;
  if (client.plan_.has(kSaysChecksum) && wireItem < client.plan_.wireCount()) {
    const Status read = sum(client, wireItem);
    if (read == Status::Checking) return;
    if (read != Status::Accepted) {
      client.noteFailed(wireItem);
      return client.end(read);
    }
    ++wireItem;
    return;
  }
  client.reading_.take = takeItem;
  client.state_.isCompared = true;
  client.setOfPlan(true);
  client.setAboard(Aboard::NotKnown);  // what was known was about the plan before
  beginLook(client, nowMs);
  client.state_.proving = true;  // no progress is reported for the look
  client.session_.field = ItemField::None;
  client.state_.status = Status::Transferring;
}

void Client::Ensuring::beginLook(Client& client, uint16_t nowMs) {
  client.state_.lastResult = 255;
  client.reading_.transfer.begin(nowMs);
}

Status Client::Ensuring::sum(Client& client, uint16_t wireItem) {
  MissionItem& item = *static_cast<MissionItem*>(client.link_.draft());
  const Status read = client.plan_.read(wireItem, item);
  if (read == Status::Accepted) client.opaqueId_.add(&item.frame, &item.command, &item.autocontinue, &item);
  return read;
}

void Client::Ensuring::look(Client& client, uint16_t nowMs) {
  client.state_.readsHalf = true;  // as in ReadingPlan::time()
  DownloadTransfer& transfer = client.reading_.transfer;
  Status status = transfer.onTime(nowMs, client.link_.pace(), client.plan_.has(kAnswersAnyRequest));
  // A refusal of the request is believed only after the last attempt: the autopilot may hold an upload of ours open,
  // from before a reset, or one of another ground station, and both end within seconds.
  if (status == Status::NoAnswer && client.state_.lastResult != 255) {
    if ((client.state_.unsettled & kFromOpen) != 0) return beginLook(client, nowMs);
    status = fromMissionResult(client.state_.lastResult);
  }
  if (status == Status::Transferring && client.state_.isLate) status = Status::TookTooLong;
  if (status != Status::Transferring) return endLook(client, status);
  if (transfer.state() != DownloadTransfer::State::Closing) {
    return ReadingPlan::send(client, nowMs, ReadingPlan::asksAhead(client));
  }
  if (!client.link_.canSend()) return;
  client.sendAck(MAV_MISSION_ACCEPTED, client.state_.type);
  endLook(client, Status::AlreadyAboard);
}

void Client::Ensuring::frame(Client& client, const FrameParser& frame, uint16_t nowMs) {
  switch (frame.messageId()) {
    case MAVLINK_MSG_ID_MISSION_COUNT: return takeCount(client, frame, nowMs);
    case MAVLINK_MSG_ID_MISSION_ITEM_INT:
    case MAVLINK_MSG_ID_MISSION_ITEM:
      ReadingPlan::takeNext(client, frame, nowMs);
      if (client.state_.operation == step && client.session_.field != ItemField::None) replaceOther(client);
      return;
    case MAVLINK_MSG_ID_MISSION_ACK: {
      typedef mavlink_mission_ack_t Ack;
      if (frame.payloadByte(offsetof(Ack, mission_type)) != static_cast<uint8_t>(client.state_.type)) return;
      const uint8_t result = frame.payloadByte(offsetof(Ack, type));
      const Status status = client.reading_.transfer.onAck(result);
      if (status == Status::Transferring) return;
      client.state_.lastResult = result;
      if (client.reading_.transfer.state() != DownloadTransfer::State::Listing) {
        // An error may be the late answer to the last item of an earlier upload, if that item was sent again.
        const bool mayBeOlder = status == Status::Error && (client.state_.unsettled & kFromOpen) != 0;
        const bool isEnded = status == Status::Error && client.reading_.transfer.beginAnew(nowMs);  // as in a reading
        return mayBeOlder || isEnded ? void() : endLook(client, status);
      }
      // ArduPilot has just given up the upload for which it refused to be read.
      if (status == Status::CancelledByAutopilot) beginLook(client, nowMs);
      return;
    }
    default: return;
  }
}

void Client::Ensuring::takeCount(Client& client, const FrameParser& frame, uint16_t nowMs) {
  typedef mavlink_mission_count_t Count;
  DownloadTransfer& transfer = client.reading_.transfer;
  if (frame.payloadByte(offsetof(Count, mission_type)) != static_cast<uint8_t>(client.state_.type)) return;
  if (!transfer.expectsAnswer(DownloadTransfer::State::Listing)) return;
  const uint16_t count = frame.payloadWord(offsetof(Count, count));
  client.reading_.planId = frame.payloadLong(offsetof(Count, opaque_id));
  if (!client.isOurCount(count)) {
    client.session_.field = ItemField::Count;
    return replaceOther(client);
  }
  // Our checksum is that of the items as integers.
  if (!client.plan_.has(kSaysChecksum) || client.reading_.planId == 0 || client.state_.floatItems) {
    transfer.onCount(count, nowMs, client.link_.pace());
  } else if (client.reading_.planId == client.opaqueId_.value()) {
    client.tellCancelled();  // otherwise PX4 would wait for our requests for 5 s
    endLook(client, Status::AlreadyAboard);
  } else {
    replaceOther(client);
  }
}

// Compares an item of the look. A difference is left in session_.field for frame().
Status Client::Ensuring::takeItem(Client& client, uint16_t wireItem, MissionItem& item) {
  const Status compared = ReadingPlan::compare(client, wireItem, item);
  if (compared == Status::Transferring || compared == Status::Checking) return compared;
  client.noteFailed(wireItem);
  if (compared != Status::Differs) {
    client.session_.field = ItemField::None;
    endLook(client, compared);
  }
  return Status::Checking;  // nothing more is made of this item
}

// Another plan is aboard.
void Client::Ensuring::replaceOther(Client& client) {
  // An autopilot that is armed may be flying its plan. allowWhileArmed() does not matter here: a sketch calls ensure()
  // at each start, which may be a reset in the air.
  if (client.isArmed()) return endLook(client, Status::Armed);
  client.state_.readsHalf = false;
  client.state_.operation = freeStep;
}

// Closes our reading before the upload. PX4 would otherwise refuse MISSION_COUNT, being busy with our reading.
void Client::Ensuring::freeStep(Client& client, const FrameParser* frame, uint16_t) {
  State& state = client.state_;
  if (state.isLate) return endLook(client, Status::TookTooLong);
  if (frame != nullptr || !client.link_.canSend()) return;
  client.sendAck(MAV_MISSION_OPERATION_CANCELLED, state.type);
  client.expectAnswers(kFromBusy | kFromBefore);  // the closing may be lost
  state.operation = freedStep;
}

// A copy of our closing, which the line may bring, would end our upload.
void Client::Ensuring::freedStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  State& state = client.state_;
  if (frame != nullptr) return Uploading::noteEarly(client, *frame);
  if (client.awaitsCopies()) return;
  if (client.isArmed()) return client.end(Status::Armed);
  state.limitFromS = state.seconds;  // the upload has its whole time
  state.failedItem = kNoItem;
  client.session_.field = ItemField::None;
  client.state_.lastResult = 255;
  client.state_.proving = false;
  client.session_.options.continueAfter = continueAfterFirst;
  if (client.session_.options.readBack == ReadingPlan::prove) client.session_.options.readBack = prove;
  state.operation = Uploading::step;
  Uploading::begin(client, nowMs);
}

void Client::Ensuring::prove(Client& client, uint16_t nowMs) {
  ReadingPlan::prove(client, nowMs);
  client.state_.operation = proofStep;
}

// The read-back, as it is after any upload, but for its COUNT: that may be the look's, which the line has repeated. So
// another number of items is believed when REQUEST_LIST has been sent again.
void Client::Ensuring::proofStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  typedef mavlink_mission_count_t Count;
  const DownloadTransfer& transfer = client.reading_.transfer;
  if (frame != nullptr && frame->messageId() == MAVLINK_MSG_ID_MISSION_COUNT) {
    if (frame->payloadByte(offsetof(Count, mission_type)) != static_cast<uint8_t>(client.state_.type)) return;
    const bool isOurs = client.isOurCount(frame->payloadWord(offsetof(Count, count)));
    if (transfer.tries() < (isOurs ? 1 : DownloadRules::kOtherTries)) return;
    client.state_.operation = ReadingPlan::readOn;
  }
  ReadingPlan::readOn(client, frame, nowMs);
}

void Client::Ensuring::endLook(Client& client, Status status) {
  client.state_.readsHalf = false;
  if (status == Status::AlreadyAboard) {
    client.setAboard(Aboard::OurPlan);
    if (client.state_.type == PlanType::Mission) {
      // What PX4 has said about a plan holds until it takes another one.
      if (client.reading_.planId != client.known_.planId) client.state_.infeasible = false;
      client.known_.planId = client.reading_.planId;
    }
    client.report(client.state_.itemsTotal);
  } else {
    client.tellCancelled();
  }
  client.expectAnswers(kFromBusy);  // our last message may be lost
  if (client.session_.options.backOff != nullptr && client.session_.options.backOff(client, status)) {
    client.state_.operation = backOffStep;
    return;
  }
  client.end(status);
}

// ArduPilot denies reading while it receives our plan. So the first denial of MISSION_COUNT may be the answer to a
// MISSION_REQUEST_LIST of the look that the line has repeated: COUNT is sent again before a denial is believed.
bool Client::Ensuring::continueAfterFirst(Client& client, Status status, uint16_t nowMs) {
  client.session_.options.continueAfter = continueAfter;
  if (status == Status::Denied && !client.transfer_.hasBegun()) return true;
  return continueAfter(client, status, nowMs);
}

// After a back-off it is looked again: the transfer that was waited for may have brought our plan, or another one.
bool Client::Ensuring::continueAfter(Client& client, Status status, uint16_t nowMs) {
  const bool hasBegun = client.transfer_.hasBegun();
  client.session_.options.continueAfter = Uploading::continueAfter;
  if (Uploading::continueAfter(client, status, nowMs)) {
    if (client.state_.status == Status::BackingOff) client.state_.operation = backOffStep;
    return true;
  }
  if (hasBegun || (status != Status::Denied && status != Status::Error)) return false;
  // The look may still be what is refused, and COUNT have been taken: aboard() stays NotKnown.
  client.end(status);
  return true;
}

void Client::Ensuring::backOffStep(Client& client, const FrameParser* frame, uint16_t) {
  if (frame == nullptr && client.state_.seconds >= client.state_.limitFromS) client.beginEnsuring();
}

}  // namespace mavmission
