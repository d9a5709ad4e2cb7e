// How MissionClient reads the autopilot's plan: to hand it to a sink, to compare it with a source, to prove an upload.
#include <Arduino.h>

#include "../link/Messages.h"
#include "../link/Sending.h"
#include "MissionClient.h"
#include "Reading.h"
#include "Uploading.h"

namespace mavmission {
using namespace detail;

Status MissionClient::verify(const ItemSource& plan, PlanType type) {
  if (state_.operation != nullptr) return Status::Busy;
  if (type == PlanType::All) return refuseType();
  setPlanToVerify(plan, type);
  startOperation(ReadingPlan::beginStep);
  reading_.take = ReadingPlan::compare;
  state_.isCompared = true;
  state_.itemsTotal = plan_.count();
  if (state_.tooLong) return refuse(Status::TooManyItems);
  return state_.status;
}

void Client::setPlanToVerify(const ItemSource& plan, PlanType type) {
  setPlan(plan, type);
  state_.type = type;
}

// Reads back the plan that is aboard; the comparison decides how the upload ends.
void Client::ReadingPlan::prove(Client& client, uint16_t nowMs) {
  client.state_.operation = readOn;
  client.state_.proving = true;
  client.link_.pace().noteShorterFrames();
  client.setAboard(Aboard::NotKnown);
  client.reading_.take = compare;
  client.state_.isCompared = true;
  client.reading_.transfer.begin(nowMs);
}

Status Client::uploadProven(const ItemSource& plan, PlanType type, Readback proof) {
  Client* client = this;
  asm("" : "+r"(client));
  const Status status = client->startUpload(plan, type);
  if (isEnd(status)) return status;
  client->session_.proof = static_cast<uint8_t>(proof);
  client->session_.options.readBack = ReadingPlan::prove;
  client->session_.options.continueAfter = Uploading::continueAfter;
  return status;
}

bool PlanPort::isTypeCarried() const {
  const Client& client = static_cast<const Client&>(*this);
  return client.state_.type == PlanType::Mission || !client.link_.speaksV1();
}

bool PlanPort::beginsReading(uint16_t nowMs) {
  Client& client = static_cast<Client&>(*this);
  if (!isTypeCarried()) {
    client.end(Status::NeedsMavlink2);
    return false;
  }
  // "Our plan" is this one from now on: whether it is aboard is what is to be found out.
  if (client.state_.isCompared && !client.isOfPlan()) {
    client.setOfPlan(true);
    if (client.aboard(client.state_.type) == Aboard::OurPlan) client.setAboard(Aboard::NotKnown);
  }
  client.beginPlan();
  client.beginTransferring(nowMs);
  return true;
}

// A step of its own, which an upload that is read back has no use for.
void Client::ReadingPlan::beginStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  if (frame != nullptr) return;
  client.waitForAutopilot();
  if (client.state_.status != Status::Checking || !client.beginsReading(nowMs)) return;
  client.state_.operation = step;
  client.reading_.transfer.begin(nowMs);
  step(client, nullptr, nowMs);
}

void Client::ReadingPlan::time(Client& client, uint16_t nowMs) { goOn(client, nowMs, true); }

bool Client::ReadingPlan::asksAhead(const Client& client) {
  return client.plan_.has(kAnswersAnyRequest) && client.link_.isQuick();
}

void Client::ReadingPlan::frame(Client& client, const FrameParser& frame, uint16_t nowMs) {
  const uint16_t id = frame.messageId();
  if (id == MAVLINK_MSG_ID_MISSION_ITEM || id == MAVLINK_MSG_ID_MISSION_ITEM_INT) {
    takeNext(client, frame, nowMs);
  } else if (id == MAVLINK_MSG_ID_MISSION_COUNT && !client.state_.isCompared) {
    if (!onCount(client, frame, nowMs)) return;
    if (!client.hasRoom(countIn(frame))) return end(client, Status::SinkFull);
  } else {
    readOn(client, &frame, nowMs);
  }
  // (It may have ended, and the sketch have begun another one at once.)
  if (client.state_.operation == step && client.state_.status == Status::Transferring)
    client.report(client.plan_.numbers().ownCount(client.reading_.transfer.itemsTaken()));
}

// What a read-back needs of a reading, without its beginning, its progress, several requests at once, and what a sink
// or floats need: an upload alone costs no more than that.
void Client::ReadingPlan::readOn(Client& client, const FrameParser* frame, uint16_t nowMs) {
  if (frame != nullptr) return take(client, *frame, nowMs);
  goOn(client, nowMs, false);
}

void Client::ReadingPlan::goOn(Client& client, uint16_t nowMs, bool mayBeAhead) {
  State& state = client.state_;
  // An item is compared in the same update() that reads the last bytes of its frame: reading fewer bytes leaves that
  // update() the time for the comparison.
  state.readsHalf = true;
  const Status status =
      client.reading_.transfer.onTime(nowMs, client.link_.pace(), client.plan_.has(kAnswersAnyRequest), mayBeAhead);
  if (status != Status::Transferring) return end(client, status);
  if (state.isLate) return end(client, Status::TookTooLong);
  send(client, nowMs, mayBeAhead && asksAhead(client));
}

void Client::ReadingPlan::step(Client& client, const FrameParser* frame, uint16_t nowMs) {
  if (frame == nullptr) return ReadingPlan::time(client, nowMs);
  ReadingPlan::frame(client, *frame, nowMs);
}

void Client::ReadingPlan::send(Client& client, uint16_t nowMs, bool asksAhead) {
  DownloadTransfer& transfer = client.reading_.transfer;
  if (!client.link_.canSend() || transfer.mustWait(nowMs)) return;
  switch (transfer.toSend(asksAhead)) {
    case DownloadTransfer::Send::Nothing: return;
    case DownloadTransfer::Send::List: client.sendShort(KeyIndex::MISSION_REQUEST_LIST, 0, client.state_.type); break;
    case DownloadTransfer::Send::Request: sendRequest(client, transfer.itemToAsk()); break;
    case DownloadTransfer::Send::Accepted: client.sendAck(MAV_MISSION_ACCEPTED, client.state_.type); break;
  }
  const bool isAll = transfer.sent(nowMs, asksAhead);
  client.noteSent(transfer.tries());
  if (isAll) end(client, Status::Downloaded);
}

void Client::ReadingPlan::sendRequest(Client& client, uint16_t wireItem) {
  // An autopilot that is neither ArduPilot nor PX4 may know only the older request. It is sent in turns with the newer
  // one: most know only that, and on a lossy link both of the first may be lost.
  // (Neither of those that a macro names: Betaflight does not know it, and iNav answers it with its places as floats,
  // metres beside those that were sent.)
  const uint8_t tries = client.reading_.transfer.tries();
  const bool isNamed = isByOwn(client.plan_.keeper());
  const bool older =
      client.plan_.has(kMayBeOld) && !isNamed && tries >= DownloadRules::kNewRequestTries && (tries & 1) == 0;
  client.sendShort(older ? KeyIndex::MISSION_REQUEST : KeyIndex::MISSION_REQUEST_INT, wireItem, client.state_.type);
}

void Client::ReadingPlan::take(Client& client, const FrameParser& frame, uint16_t nowMs) {
  switch (frame.messageId()) {
    case MAVLINK_MSG_ID_MISSION_COUNT: return compareCount(client, frame, nowMs);
    // (An autopilot that gives only floats cannot prove an upload.)
    case MAVLINK_MSG_ID_MISSION_ITEM_INT: return takeItem(client, frame, nowMs, nullptr);
    case MAVLINK_MSG_ID_MISSION_ACK: {
      typedef mavlink_mission_ack_t Ack;
      if (frame.payloadByte(offsetof(Ack, mission_type)) != static_cast<uint8_t>(client.state_.type)) return;
      const uint8_t result = frame.payloadByte(offsetof(Ack, type));
      const Status status = client.reading_.transfer.onAck(result);
      if (status == Status::Transferring) return;
      const bool isListing = client.reading_.transfer.state() == DownloadTransfer::State::Listing;
      // The refusal of the older request, perhaps.
      const bool isOlderAsked = client.reading_.transfer.tries() > DownloadRules::kNewRequestTries;
      if (client.plan_.has(kMayBeOld) && isOlderAsked && status == Status::Unsupported) return;
      // PX4 ends a reading with an error at a request that comes late, or once more, and does not answer the next ones.
      // ArduPilot denies the next item when the line has brought the COUNT of our upload once more. (An error may also
      // be the late answer to our last item, if that was sent again.) A comparison then begins anew.
      const bool mayBeOfCopy = client.state_.proving || (client.state_.isCompared && status == Status::Error);
      if (mayBeOfCopy && !isListing && client.reading_.transfer.beginAnew(nowMs)) return;
      // While an upload is being proven, the autopilot may still hold the upload open: ArduPilot then denies reading
      // until it gives the upload up, and PX4 answers with an error. The request is repeated, and the number of its
      // attempts limits the wait. After a transfer that was left open it may be the answer to that, or ArduPilot's
      // giving it up.
      const bool mayBeOlder = (client.state_.unsettled & kFromOpen) != 0 &&
                              (status == Status::Error || status == Status::CancelledByAutopilot);
      if (mayBeOlder || (client.state_.proving && isListing)) return;
      client.state_.lastResult = result;
      return end(client, status);
    }
    default: return;
  }
}

uint16_t Client::ReadingPlan::countIn(const FrameParser& frame) {
  return frame.payloadWord(offsetof(mavlink_mission_count_t, count));
}

// True if it is the answer to our request.
bool Client::ReadingPlan::onCount(Client& client, const FrameParser& frame, uint16_t nowMs) {
  typedef mavlink_mission_count_t Count;
  return frame.payloadByte(offsetof(Count, mission_type)) == static_cast<uint8_t>(client.state_.type) &&
         client.reading_.transfer.onCount(countIn(frame), nowMs, client.link_.pace());
}

void Client::ReadingPlan::compareCount(Client& client, const FrameParser& frame, uint16_t nowMs) {
  if (!onCount(client, frame, nowMs)) return;
  const uint32_t planId = frame.payloadLong(offsetof(mavlink_mission_count_t, opaque_id));
  client.reading_.planId = planId;
  // PX4's checksum of its plan proves an upload as well as the items do, where it is in doubt. (Elsewhere ours is 0.)
  const bool isInDoubt = client.state_.proving && client.session_.proof != static_cast<uint8_t>(Readback::Always);
  if (isInDoubt && planId != 0 && planId == client.opaqueId_.value()) return client.reading_.transfer.close();
  const Status status = client.compareCount(countIn(frame));
  if (status != Status::Transferring) end(client, status);
}

Status PlanPort::takeCount(uint16_t count) {
  Client& client = static_cast<Client&>(*this);
  if (client.state_.isCompared) return client.compareCount(count);
  return client.hasRoom(count) ? Status::Transferring : Status::SinkFull;
}

// True if the sink takes a plan of so many items on the wire.
bool Client::hasRoom(uint16_t count) {
  const uint16_t items = plan_.numbers().ownCount(count);
  state_.itemsTotal = items;
  return items <= reading_.sink.limit;
}

Status Client::compareCount(uint16_t count) {
  if (isOurCount(count)) return Status::Transferring;
  session_.field = ItemField::Count;
  return Status::Differs;
}

bool Client::isOurCount(uint16_t count) const { return plan_.numbers().isCountOf(plan_.count(), count); }

// An item, after which others may have been asked for.
void Client::ReadingPlan::takeNext(Client& client, const FrameParser& frame, uint16_t nowMs) {
  DownloadTransfer& transfer = client.reading_.transfer;
  const uint16_t item = transfer.itemsTaken();
  const uint8_t others = transfer.othersAsked();
  takeItem(client, frame, nowMs, frame.messageId() == MAVLINK_MSG_ID_MISSION_ITEM ? fromFloats : nullptr);
  if (transfer.itemsTaken() == item + 1u) transfer.stayAhead(others, nowMs);
}

void Client::ReadingPlan::takeItem(Client& client, const FrameParser& frame, uint16_t nowMs,
                                   void (*fromFloats)(void* itemMessage)) {
  union {
    MissionItem item;
    mavlink_mission_item_int_t message;
  } piece;
  static_assert(offsetof(mavlink_mission_item_int_t, seq) == kPlaceBytes,
                "param1 to z must lie in MISSION_ITEM_INT as they lie in MissionItem");
  frame.copyPayload(&piece.message, sizeof(piece.message));
  const mavlink_mission_item_int_t& message = piece.message;
  DownloadTransfer& transfer = client.reading_.transfer;
  const uint16_t seq = message.seq;
  if (message.mission_type != static_cast<uint8_t>(client.state_.type)) return;
  if (!transfer.expectsItem(seq, nowMs, client.link_.pace())) return;
  if (fromFloats != nullptr) fromFloats(&piece.message);
  const uint16_t command = message.command;
  const uint8_t frameNumber = message.frame;
  const uint8_t current = message.current;
  const uint8_t autocontinue = message.autocontinue;
  piece.item.command = command;
  piece.item.frame = static_cast<CoordinateFrame>(frameNumber);
  piece.item.current = current;
  piece.item.autocontinue = autocontinue;
  const Status taken = client.reading_.take(client, seq, piece.item);
  if (taken == Status::Checking) return;  // the item is requested again, by askAgain() or after the timeout
  if (taken != Status::Transferring) {
    client.noteFailed(seq);
    return end(client, taken);
  }
  transfer.onItem(nowMs, client.link_.pace());
}

Status Client::ReadingPlan::compare(Client& client, uint16_t wireItem, MissionItem& item) {
  WirePlan& plan = client.plan_;
  ItemField field = ItemField::Command;
  if (plan.numbers().isHome(wireItem)) {
    // Home is the autopilot's own, however the sketch counts, and nothing else: not what we have sent in its place.
    if (item.command == kNavWaypoint && item.frame == CoordinateFrame::Global) return Status::Transferring;
  } else {
    MissionItem meant;
    const Status read = plan.read(wireItem, meant);
    if (read == Status::Checking) client.reading_.transfer.askAgain();  // the search for a place continues then
    if (read != Status::Accepted) return read;
    field = difference(meant, item, plan.keeper());
    // Betaflight gives a height above sea level, by a home that is not known here. That an upload is whole is known
    // from the count, which is 0 from our MISSION_COUNT to the last item; a plan of before is not to be told by that.
    if (field == ItemField::Reference && plan.has(kGivesHeightsAboveSea) && client.state_.proving &&
        client.state_.operation == readOn) {
      item.frame = meant.frame;
      item.z = meant.z;
      field = difference(meant, item, plan.keeper());
    }
    if (field == ItemField::None) return Status::Transferring;
    // A value that this autopilot cannot keep is reported as NotKept, not as a difference.
    if (client.keeping(meant) != Status::Accepted) return Status::NotKept;
  }
  client.session_.field = field;
  return Status::Differs;
}

void Client::ReadingPlan::end(Client& client, Status status) {
  client.state_.readsHalf = false;
  if (status == Status::Downloaded) {
    if (client.state_.isCompared) {
      status = Status::Verified;
      client.setAboard(Aboard::OurPlan);
      if (client.state_.type == PlanType::Mission) client.known_.planId = client.reading_.planId;
    }
  } else {
    client.tellCancelled();  // otherwise PX4 would wait for us for 5 s
    // When the autopilot refuses to be read, another ground station may be uploading a plan.
    if (status == Status::Differs || status >= Status::Error) client.setAboard(Aboard::NotKnown);
  }
  if (client.state_.proving) {
    switch (status) {
      case Status::Verified:
        status = Status::Accepted;
        client.noteAccepted();
        client.report(client.state_.itemsTotal);
        break;
      case Status::Differs:
        // A plan that was accepted is complete, though it is another plan; otherwise ArduPilot has a mixture.
        if (client.plan_.has(kReplacesItemByItem) && client.state_.type == PlanType::Mission &&
            client.state_.lastResult != MAV_MISSION_ACCEPTED) {
          client.setAboard(Aboard::Mixture);
        }
        if (client.state_.mayBeRefused) {  // the doubtful error was a refusal of the last item
          status = Status::Error;
          client.state_.failedItem = client.plan_.count() - 1;
        }
        break;
      default: status = Status::Unconfirmed; break;
    }
  }
  client.state_.unsettled |= kFromBusy;  // our last message may be lost
  client.end(status);
}

}  // namespace mavmission
