// How MissionClient reads the autopilot's plan: to hand it to a sink, to compare it with a source, to prove an upload.
#include <Arduino.h>

#include "../MissionClient.h"
#include "../link/Messages.h"
#include "../link/Sending.h"

namespace mavmission {
using namespace detail;

Status MissionClient::verify(const ItemSource& plan, PlanType type) {
  if (state_.operation != nullptr) return Status::Busy;
  if (type == PlanType::All) return refuseType();
  setPlanToVerify(plan, type);
  startOperation(readStep);
  reading_.take = compareItem;
  state_.isCompared = true;
  reading_.fromFloats = fromFloats;
  rest_.itemsTotal = plan_.count();
  if (state_.tooLong) return refuse(Status::TooManyItems);
  return state_.status;
}

void Client::setPlanToVerify(const ItemSource& plan, PlanType type) {
  // "Our plan" is this one from now on: whether it is aboard is what is to be found out.
  if (aboard(type) == Aboard::OurPlan && !plan_.isFrom(plan)) setAboard(type, Aboard::NotKnown);
  setPlan(plan, type);
  state_.type = type;
}

// Reads back the plan that is aboard; the comparison decides how the upload ends.
void Client::proveUpload(Client& client, uint16_t nowMs) {
  client.state_.operation = readStep;
  client.state_.proving = true;
  client.link_.pace().noteShorterFrames();
  client.setAboard(Aboard::NotKnown);
  client.reading_.take = compareItem;
  client.state_.isCompared = true;
  client.reading_.fromFloats = nullptr;  // an autopilot that gives only floats cannot prove an upload
  client.reading_.transfer.begin(nowMs);
}

Status Client::uploadProven(const ItemSource& plan, PlanType type, Readback proof) {
  const Status status = startUpload(plan, type);
  if (isEnd(status)) return status;
  rest_.proof = static_cast<uint8_t>(proof);
  rest_.options.readBack = proveUpload;
  rest_.options.takeUp = takeUpEnd;
  return status;
}

bool PlanPort::isTypeCarried() const {
  const Client& client = static_cast<const Client&>(*this);
  return client.state_.type == PlanType::Mission || client.link_.version() != 1;
}

bool PlanPort::beginsReading(uint16_t nowMs) {
  Client& client = static_cast<Client&>(*this);
  if (!isTypeCarried()) {
    client.end(Status::NeedsMavlink2);
    return false;
  }
  client.beginPlan();
  client.beginTransferring(nowMs);
  return true;
}

struct Client::ReadingPlan : OperationParts {
  static bool begin(Client& client, uint16_t nowMs) {
    if (!client.beginsReading(nowMs)) return false;
    client.reading_.transfer.begin(nowMs);
    return true;
  }

  static void frame(Client& client, const FrameParser& frame, uint16_t nowMs) { client.takeReadFrame(frame, nowMs); }

  static void time(Client& client, uint16_t nowMs) {
    State& state = client.state_;
    // An item is compared in the same update() that reads the last bytes of its frame: reading fewer bytes leaves that
    // update() the time for the comparison.
    state.readsHalf = true;
    const Status status = client.reading_.transfer.onTime(nowMs, client.link_.pace());
    if (status != Status::Transferring) return client.endReading(status);
    if (state.isLate) return client.endReading(Status::TookTooLong);
    client.sendRead(nowMs);
  }
};

void Client::readStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  operate<ReadingPlan>(client, frame, nowMs);
}

void Client::sendRead(uint16_t nowMs) {
  DownloadTransfer& transfer = reading_.transfer;
  if (!link_.canSend()) return;
  switch (transfer.toSend()) {
    case DownloadTransfer::Send::Nothing: return;
    case DownloadTransfer::Send::List: sendShort(KeyIndex::MISSION_REQUEST_LIST, 0, state_.type); break;
    case DownloadTransfer::Send::Request: sendRequest(transfer.itemToAsk()); break;
    case DownloadTransfer::Send::Accepted: sendAck(MAV_MISSION_ACCEPTED, state_.type); break;
  }
  const bool isAll = transfer.sent(nowMs);
  noteSent(transfer.tries());
  if (isAll) endReading(Status::Downloaded);
}

void Client::sendRequest(uint16_t wireItem) {
  // An autopilot that is neither ArduPilot nor PX4 may know only the older request. It is sent in turns with the newer
  // one: most know only that, and on a line that loses both of the first may be lost.
  const uint8_t tries = reading_.transfer.tries();
  const bool older = plan_.has(kMayBeOld) && tries >= DownloadRules::kNewRequestTries && (tries & 1) == 0;
  sendShort(older ? KeyIndex::MISSION_REQUEST : KeyIndex::MISSION_REQUEST_INT, wireItem, state_.type);
}

void Client::takeReadFrame(const FrameParser& frame, uint16_t nowMs) {
  switch (frame.messageId()) {
    case MAVLINK_MSG_ID_MISSION_COUNT: return takeReadCount(frame, nowMs);
    case MAVLINK_MSG_ID_MISSION_ITEM_INT:
    case MAVLINK_MSG_ID_MISSION_ITEM: return takeReadItem(frame, nowMs);
    case MAVLINK_MSG_ID_MISSION_ACK: {
      typedef mavlink_mission_ack_t Ack;
      if (frame.payloadByte(offsetof(Ack, mission_type)) != static_cast<uint8_t>(state_.type)) return;
      const uint8_t result = frame.payloadByte(offsetof(Ack, type));
      const Status status = reading_.transfer.onAck(result);
      if (status == Status::Transferring) return;
      // While an upload is being proven, the autopilot may still hold the upload open: ArduPilot then denies reading
      // until it gives the upload up, and PX4 answers with an error. The request is repeated, and the number of its
      // attempts limits the wait. An error to a request for an item may be PX4's end of this reading, which a request
      // that comes late is for it: what is asked behind that stays unanswered, so the reading begins anew. (It may also
      // be the late answer to our last item, if that was sent again.)
      const bool isListing = reading_.transfer.state() == DownloadTransfer::State::Listing;
      // Behind a transfer that was left open it may be the answer to that, or ArduPilot's giving it up.
      const bool mayBeOlder = (state_.unsettled & UploadTransfer::kAnswers) != 0 &&
                              (status == Status::Error || status == Status::CancelledByAutopilot);
      if (state_.proving && !isListing && status == Status::Error) return reading_.transfer.begin(nowMs);
      if (mayBeOlder || (state_.proving && isListing)) return;
      // The refusal of the older request, perhaps.
      const bool isOlderAsked = reading_.transfer.tries() > DownloadRules::kNewRequestTries;
      if (plan_.has(kMayBeOld) && isOlderAsked && status == Status::Unsupported) return;
      rest_.lastResult = result;
      return endReading(status);
    }
    default: return;
  }
}

void Client::takeReadCount(const FrameParser& frame, uint16_t nowMs) {
  typedef mavlink_mission_count_t Count;
  if (frame.payloadByte(offsetof(Count, mission_type)) != static_cast<uint8_t>(state_.type)) return;
  const uint16_t count = frame.payloadWord(offsetof(Count, count));
  if (!reading_.transfer.onCount(count, nowMs, link_.pace())) return;
  if (state_.isCompared) reading_.planId = frame.payloadLong(offsetof(Count, opaque_id));
  const Status status = takeCount(count);
  if (status != Status::Transferring) endReading(status);
}

Status PlanPort::takeCount(uint16_t count) {
  Client& client = static_cast<Client&>(*this);
  if (!client.state_.isCompared) {
    const uint16_t items = client.plan_.numbers().ownCount(count);
    client.rest_.itemsTotal = items;
    return items > client.reading_.sink.limit ? Status::SinkFull : Status::Transferring;
  }
  if (client.isOurCount(count)) return Status::Transferring;
  client.rest_.field = ItemField::Count;
  return Status::Differs;
}

bool Client::isOurCount(uint16_t count) const { return plan_.numbers().isCountOf(plan_.count(), count); }

void Client::takeReadItem(const FrameParser& frame, uint16_t nowMs) {
  union {
    MissionItem item;
    mavlink_mission_item_int_t message;
  } piece;
  static_assert(offsetof(mavlink_mission_item_int_t, seq) == kPlaceBytes,
                "param1 to z must lie in MISSION_ITEM_INT as they lie in MissionItem");
  frame.copyPayload(&piece.message, sizeof(piece.message));
  const mavlink_mission_item_int_t& message = piece.message;
  DownloadTransfer& transfer = reading_.transfer;
  const uint16_t seq = message.seq;
  if (message.mission_type != static_cast<uint8_t>(state_.type)) return;
  if (!transfer.expectsItem(seq, nowMs, link_.pace())) return;
  if (frame.messageId() == MAVLINK_MSG_ID_MISSION_ITEM) {
    if (reading_.fromFloats == nullptr) return;
    reading_.fromFloats(&piece.message);
  }
  const uint16_t command = message.command;
  const uint8_t frameNumber = message.frame;
  const uint8_t current = message.current;
  const uint8_t autocontinue = message.autocontinue;
  piece.item.command = command;
  piece.item.frame = static_cast<Frame>(frameNumber);
  piece.item.current = current;
  piece.item.autocontinue = autocontinue;
  const Status taken = reading_.take(*this, seq, piece.item);
  if (taken == Status::Checking) return;  // the item is requested again, by askAgain() or after the timeout
  if (taken != Status::Transferring) {
    noteFailed(seq);
    return endReading(taken);
  }
  transfer.onItem(nowMs, link_.pace());
  // The progress of an upload stands still during its read-back: the upload is complete only when it is proven.
  if (!state_.proving) report(ownItem(seq) + 1);
}

Status Client::compareItem(Client& client, uint16_t wireItem, MissionItem& item) {
  WirePlan& plan = client.plan_;
  ItemField field = ItemField::Command;
  if (plan.numbers().isHome(wireItem)) {
    // Home is the autopilot's own, however the sketch counts, and nothing else: not what we have sent in its place.
    if (item.command == kNavWaypoint && item.frame == Frame::Global) return Status::Transferring;
  } else {
    MissionItem meant;
    const Status read = plan.read(wireItem, meant);
    if (read == Status::Checking) client.reading_.transfer.askAgain();  // the search for a place continues then
    if (read != Status::Accepted) return read;
    field = difference(meant, item, plan.keeper());
    // Betaflight gives a height above sea level, by a home that is not known here. That an upload is whole is known
    // from the count, which is 0 from our MISSION_COUNT to the last item; a plan of before is not to be told by that.
    if (field == ItemField::Reference && plan.has(kGivesHeightsAboveSea) && client.state_.proving &&
        client.state_.operation == readStep) {
      item.frame = meant.frame;
      item.z = meant.z;
      field = difference(meant, item, plan.keeper());
    }
    if (field == ItemField::None) return Status::Transferring;
    // A value that this autopilot cannot keep is reported as NotKept, not as a difference.
    if (client.keeping(meant) != Status::Accepted) return Status::NotKept;
  }
  client.rest_.field = field;
  return Status::Differs;
}

void Client::endReading(Status status) {
  state_.readsHalf = false;
  if (status == Status::Downloaded) {
    if (state_.isCompared) {
      status = Status::Verified;
      setAboard(Aboard::OurPlan);
      if (state_.type == PlanType::Mission) rest_.planId = reading_.planId;
    }
  } else {
    tellCancelled();  // otherwise PX4 would wait for us for 5 s
    // When the autopilot refuses to be read, another ground station may be uploading a plan.
    if (status == Status::Differs || status >= Status::Error) setAboard(Aboard::NotKnown);
  }
  if (state_.proving) {
    switch (status) {
      case Status::Verified:
        status = Status::Accepted;
        noteAccepted();
        report(rest_.itemsTotal);
        break;
      case Status::Differs:
        // A plan that was accepted is complete, though it is another plan; otherwise ArduPilot has a mixture.
        if (plan_.has(kReplacesItemByItem) && state_.type == PlanType::Mission &&
            rest_.lastResult != MAV_MISSION_ACCEPTED) {
          setAboard(Aboard::Mixture);
        }
        if (state_.mayBeRefused) {  // the doubtful error was a refusal of the last item
          status = Status::Error;
          state_.failedItem = plan_.count() - 1;
        }
        break;
      default: status = Status::Unconfirmed; break;
    }
  }
  state_.unsettled |= UploadTransfer::kBusy;  // our last message may be lost
  state_.unsettledMs = state_.secondMs;       // about now: less than a second ago
  end(status);
}

}  // namespace mavmission
