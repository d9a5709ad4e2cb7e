// MissionClient's upload: connects the plan and the transfer's state machine to the link.
#include <Arduino.h>

#include "../link/Messages.h"
#include "../link/Sending.h"
#include "MissionClient.h"
#include "Uploading.h"

namespace mavmission {
using namespace detail;

Status Client::startUpload(const ItemSource& plan, PlanType type) {
  if (state_.operation != nullptr) return Status::Busy;
  if (type == PlanType::All) return refuseType();
  setPlan(plan, type);
  session_.options.readBack = nullptr;
  return uploadKeptPlan();
}

Status Client::refuseType() {
  startOperation(Uploading::step);
  return refuse(Status::BadPlanType);
}

void Client::setPlan(const ItemSource& plan, PlanType type) {
  if (session_.planType != type || !plan_.isFrom(plan)) setOfPlan(false);
  plan_.setSource(plan);
  session_.planType = type;
  state_.tooLong = plan.count > kMaxItems;
  session_.announcePart = nullptr;
}

Status Client::uploadKeptPlan() {
  if (state_.operation != nullptr) return Status::Busy;
  startOperation(Uploading::step);
  state_.type = session_.planType;
  state_.itemsTotal = plan_.count();
  if (state_.type == PlanType::All) return refuse(Status::SourceRefused);  // there is no plan yet
  if (state_.tooLong) return refuse(Status::TooManyItems);
  return state_.status;
}

// As operate() would call them, but in the order in which a request is answered soonest.
void Client::Uploading::step(Client& client, const FrameParser* frame, uint16_t nowMs) {
  if (client.state_.status == Status::Transferring) {
    return frame != nullptr ? Uploading::frame(client, *frame, nowMs) : time(client, nowMs);
  }
  if (frame != nullptr) return noteEarly(client, *frame);
  if (client.state_.status == Status::WaitingForAutopilot) {
    client.waitForAutopilot();
    if (client.state_.status != Status::Checking) return;
    client.beginChecking();
  }
  checkNext(client, nowMs);
}

// The first item is requested before our COUNT has left: the line has brought one of before once more. What is accepted
// then may be made of that transfer's number of items and of ours. (After a request for a later item one for the first
// shows that our COUNT was heard. A transfer that was left open is known of.)
void Client::Uploading::noteEarly(Client& client, const FrameParser& frame) {
  typedef mavlink_mission_request_int_t Request;
  const uint16_t id = frame.messageId();
  const bool isRequest = id == MAVLINK_MSG_ID_MISSION_REQUEST || id == MAVLINK_MSG_ID_MISSION_REQUEST_INT;
  const bool isKnown = (client.state_.unsettled & kFromOpen) != 0;
  if (isRequest && !isKnown && frame.payloadWord(offsetof(Request, seq)) == 0) client.state_.isDoubtful = true;
}

void Client::Uploading::time(Client& client, uint16_t nowMs) {
  const Status status = client.transfer_.onTime(nowMs, client.link_.pace());
  // While the stream does not take a frame, no answer to it is overdue.
  if (status != Status::Transferring && client.link_.canSend()) return goOn(client, status, nowMs);
  if (client.state_.isLate) return goOn(client, Status::TookTooLong, nowMs);
  send(client, nowMs);
}

void Client::beginPlan() { plan_.begin(firmware(), link_.finder().heartbeat().vehicleType, state_.type, session_.raw); }

// Accepted, or NotKept, with the field of the item that the autopilot would not keep in session_.field.
Status Client::keeping(const MissionItem& item) {
  session_.field = notKept(item, plan_.keeper());
  return session_.field == ItemField::None ? Status::Accepted : Status::NotKept;
}

void PlanPort::beginChecking() {
  Client& client = static_cast<Client&>(*this);
  client.beginPlan();
  client.state_.next = 0;
}

// To be called only when the link can send: the item is read into the outgoing frame's buffer, to save stack.
Status Client::checkItem(uint16_t wireItem) {
  MissionItem& item = *static_cast<MissionItem*>(link_.draft());
  Status status = plan_.read(wireItem, item);
  if (status == Status::Accepted) status = keeping(item);
  return status == Status::Accepted ? plan_.follow(item) : status;
}

// The one check of a plan, by whatever way it goes: the same autopilot, then what hinders all of the plan, then an
// item.
Status PlanPort::checkNext() {
  Client& client = static_cast<Client&>(*this);
  Client::State& state = client.state_;
  const WirePlan& plan = client.plan_;
  const AutopilotFinder& finder = client.link_.finder();
  if (!finder.isFound() || finder.firmware() != plan.firmware()) {
    state.status = Status::WaitingForAutopilot;  // the autopilot was lost, or is another one now
    return Status::Checking;
  }
  Status checked = Status::Accepted;
  if (plan.isTooLong()) {
    checked = Status::TooManyItems;
  } else if (state.isLate) {
    checked = Status::TookTooLong;  // the source has no item, or the stream takes no more bytes
  } else if (client.session_.announcePart != nullptr && plan.has(kTakesWholePlansOnly)) {
    checked = Status::WholePlansOnly;
  } else if (!isTypeCarried()) {
    checked = Status::NeedsMavlink2;
  } else {
    if (!client.link_.canSend() || !client.claimHeavyWork()) return Status::Checking;
    if (state.next == plan.wireCount()) return Status::Transferring;
    checked = client.checkItem(state.next);
    if (checked == Status::Checking) return checked;
    if (checked == Status::Accepted) {
      ++state.next;
      return checked;
    }
    noteFailed(state.next);
  }
  client.end(checked);
  return Status::Checking;
}

void Client::Uploading::checkNext(Client& client, uint16_t nowMs) {
  for (uint8_t read = 0; read < MAVMISSION_ITEMS_PER_UPDATE; ++read) {
    const Status checked = client.checkNext();
    if (checked == Status::Transferring) return begin(client, nowMs);
    if (checked != Status::Accepted) return;
  }
}

// All that announces a plan passes here, also where it does so a second time: the autopilot may have been armed
// meanwhile.
void Client::Uploading::begin(Client& client, uint16_t nowMs) {
  if (client.isArmed() && !client.state_.armedAllowed) return client.end(Status::Armed);
  client.setOfPlan(true);
  client.setAboard(Aboard::NotKnown);  // from now on, until an answer says it
  client.transfer_.begin(client.plan_.wireCount(), client.plan_.firmware(), client.state_.unsettled);
  client.opaqueId_.begin();
  client.state_.next = 0;
  client.state_.status = Status::Transferring;
  send(client, nowMs);
}

void Client::Uploading::frame(Client& client, const FrameParser& frame, uint16_t nowMs) {
  switch (frame.messageId()) {
    case MAVLINK_MSG_ID_MISSION_REQUEST:
    case MAVLINK_MSG_ID_MISSION_REQUEST_INT: {
      typedef mavlink_mission_request_int_t Request;
      static_assert(sizeof(mavlink_mission_request_t) == sizeof(Request),
                    "MISSION_REQUEST and MISSION_REQUEST_INT must have the same layout");
      const uint8_t type = frame.payloadByte(offsetof(Request, mission_type));
      if (type != static_cast<uint8_t>(client.state_.type)) {
        // A COUNT of an upload of before has come once more, and PX4 does not hear ours while it waits for those items.
        if (!client.transfer_.hasBegun()) client.tellCancelled(static_cast<PlanType>(type));
        return;
      }
      if (frame.messageId() == MAVLINK_MSG_ID_MISSION_REQUEST_INT) client.transfer_.noteInt();
      const Status status =
          client.transfer_.onRequest(frame.payloadWord(offsetof(Request, seq)), nowMs, client.link_.pace());
      send(client, nowMs);
      goOn(client, status, nowMs);
      return;
    }
    case MAVLINK_MSG_ID_MISSION_ACK: {
      typedef mavlink_mission_ack_t Ack;
      if (frame.payloadByte(offsetof(Ack, mission_type)) != static_cast<uint8_t>(client.state_.type)) return;
      const uint8_t result = frame.payloadByte(offsetof(Ack, type));
      client.state_.lastResult = result;
      if (!client.transfer_.hasBegun() && !client.link_.isSent())
        return;  // COUNT still waits for room: this answers something else
      Status status = client.transfer_.onAck(result, nowMs, client.link_.pace());
      if (status == Status::Accepted) status = proven(client, frame.payloadLong(offsetof(Ack, opaque_id)));
      goOn(client, status, nowMs);
      return;
    }
    default: return;
  }
}

// The status that follows from an acceptance with this opaque_id, in which PX4 reports the checksum of the plan that it
// holds. It is not compared when it is 0, which means that none is reported, nor when items were sent as floats, since
// our checksum was computed before the conversion.
Status Client::Uploading::proven(Client& client, uint32_t opaqueId) {
  // ArduPilot asks by MISSION_REQUEST. Another one may only say that it is an ArduPilot, and hold as the first item
  // what was sent in home's place.
  if (client.plan_.numbers().isHomeAdded() && client.transfer_.isAskedByInt()) return Status::Unconfirmed;
  if (!client.state_.floatItems) {
    // What a server does whose ways are not known is not known: Betaflight deletes the plan that it has just accepted,
    // when a network brings our COUNT once more. Reading shows that. (After an empty plan there is nothing to be
    // deleted, and what was sent as floats cannot be compared.)
    if (client.plan_.has(kIsReadBack) && client.transfer_.hasBegun()) return Status::Unconfirmed;
    const bool isNamed = client.plan_.has(kSaysChecksum) && opaqueId != 0;
    if (!isNamed && client.state_.isDoubtful) return Status::Unconfirmed;
    if (isNamed) {
      if (opaqueId != client.opaqueId_.value())
        // What was ended before ours began again may have been accepted, and the line bring that once more.
        return client.transfer_.hasFreed() ? Status::Unconfirmed : Status::OtherPlanAboard;
      client.transfer_.noteProven();
    }
  }
  if (client.state_.type == PlanType::Mission) client.known_.planId = opaqueId;
  return Status::Accepted;
}

// Reports the progress, and ends the upload or continues it, according to the transfer's status.
void Client::Uploading::goOn(Client& client, Status status, uint16_t nowMs) {
  if (client.state_.status != Status::Transferring) return;  // the source has refused the item that was to be sent
  // The autopilot holds every item that it has requested except the last one.
  const uint16_t notHeld = client.plan_.numbers().before() + 1;
  if (client.transfer_.itemsAskedFor() > notHeld) client.report(client.transfer_.itemsAskedFor() - notHeld);
  if (status == Status::Transferring) return;

  if (client.session_.options.continueAfter != nullptr && client.session_.options.continueAfter(client, status, nowMs))
    return;
  client.setAboard(aboardAfter(client, status));
  switch (status) {
    case Status::Accepted:
      client.report(client.state_.itemsTotal);
      client.noteAccepted();
      break;
    case Status::NoAnswer:
    case Status::TimedOut:
    case Status::TookTooLong:
    case Status::SourceRefused:
      if (status == Status::TimedOut) client.noteFailed(client.transfer_.itemsAskedFor() - 1);
      client.tellCancelled();
      client.unsettle();
      break;
    case Status::Unconfirmed: client.unsettle(); break;
    default:
      client.settle();
      if (client.transfer_.hasBegun() && client.transfer_.isLastItemRefused())
        client.noteFailed(client.transfer_.lastItem());
      break;
  }
  client.end(status);
}

void Client::noteAccepted() {
  if (state_.type == PlanType::Mission) state_.infeasible = false;
  settle();
}

Aboard Client::Uploading::aboardAfter(const Client& client, Status status) {
  if (status == Status::Accepted) return Aboard::OurPlan;
  const bool begun = client.transfer_.hasBegun();
  const bool refused = status >= Status::Error;  // a refusal by the autopilot
  const bool mayBeWhole =
      client.transfer_.state() == UploadTransfer::State::Confirming || status == Status::AcceptedEarly;
  // An error after the last item does not prove a refusal: a radio may have repeated an item, which then reached an
  // idle autopilot.
  if (mayBeWhole && (!refused || status == Status::Error)) return Aboard::NotKnown;
  // Such an autopilot keeps the old plan until the new plan is complete; an empty plan is complete at once.
  if (client.plan_.has(kKeepsPlanUntilWhole) && (refused || client.plan_.count() != 0)) return Aboard::AsBefore;
  if (!begun) {
    const bool isAsBefore = refused && !client.transfer_.isSuspected() && !client.state_.isDoubtful;
    return isAsBefore ? Aboard::AsBefore : Aboard::NotKnown;
  }
  if (client.plan_.has(kDropsPlanFirst)) return Aboard::Nothing;
  // ArduPilot replaces a mission item by item, but a fence only as a whole.
  return client.plan_.has(kReplacesItemByItem) && client.state_.type == PlanType::Mission ? Aboard::Mixture
                                                                                          : Aboard::NotKnown;
}

void PlanPort::noteFailed(uint16_t wireItem) {
  Client& client = static_cast<Client&>(*this);
  client.state_.failedItem = client.ownItem(wireItem);
}

// Sends what is due. An item is packed before it is requested, while the line waits for the autopilot: the answer to
// the request then begins earlier by the time of packing, and no update() both packs an item and writes it.
void Client::Uploading::send(Client& client, uint16_t nowMs) {
  const bool isNothingDue = client.transfer_.toSend() == UploadTransfer::Send::Nothing;
  // (What is prepared now is the next item: whatever was sent since has taken its place.)
  if (isNothingDue && (client.link_.isPrepared() || !client.transfer_.expectsRequest())) return;
  if (!client.link_.canSend()) return;
  if (isNothingDue) return prepare(client, client.transfer_.nextItem(), nowMs);
  if (client.transfer_.toSend() < UploadTransfer::Send::Item) {
    sendAnnouncement(client);
  } else if (client.isPrepared(client.transfer_.itemToSend())) {
    client.link_.release();
    client.link_.flush(nowMs, kStartBytes);  // at once: the autopilot waits for this item
  } else {
    return prepare(client, client.transfer_.itemToSend(), nowMs);
  }
  client.transfer_.sent(nowMs);
  client.noteSent(client.transfer_.tries());
}

// Sends the message that comes before the items (COUNT, or the announcement of a part), or a cancellation.
void Client::Uploading::sendAnnouncement(Client& client) {
  if (client.transfer_.toSend() == UploadTransfer::Send::Cancel) {
    client.sendAck(MAV_MISSION_OPERATION_CANCELLED, client.state_.type);
  } else if (client.session_.announcePart != nullptr) {
    client.session_.announcePart(client);
  } else {
    client.sendShort(KeyIndex::MISSION_COUNT, client.plan_.wireCount(), client.state_.type);
  }
}

void Client::Uploading::prepare(Client& client, uint16_t wireItem, uint16_t nowMs) {
  static_assert(offsetof(mavlink_mission_item_int_t, seq) == kPlaceBytes,
                "param1 to z must lie in MISSION_ITEM_INT as they lie in MissionItem");
  static_assert(sizeof(mavlink_mission_item_t) == sizeof(mavlink_mission_item_int_t),
                "MISSION_ITEM and MISSION_ITEM_INT must have the same layout");
  if (!client.claimHeavyWork()) return;
  // The item is read into the buffer of the outgoing frame and turned into the message in place: param1 to z stay where
  // they are, the other fields are moved. This keeps the deepest stack small.
  union Piece {
    MissionItem item;
    mavlink_mission_item_int_t message;
  };
  static_assert(sizeof(MissionItem) <= Outbox::kMaxPayload && sizeof(mavlink_mission_item_int_t) <= Outbox::kMaxPayload,
                "raise Outbox::kMaxPayload: an item is made in the outbox");
  Piece& piece = *static_cast<Piece*>(client.link_.draft());
  const Status read = client.plan_.read(wireItem, piece.item);
  if (read == Status::Checking) return;
  if (read != Status::Accepted) {
    client.noteFailed(wireItem);
    return goOn(client, read, nowMs);
  }
  const MissionItem& item = piece.item;
  mavlink_mission_item_int_t& message = piece.message;
  const uint16_t command = item.command;
  const CoordinateFrame frame = item.frame;
  const uint8_t current = item.current;
  const uint8_t autocontinue = item.autocontinue;
  message.seq = wireItem;
  message.command = command;
  message.frame = static_cast<uint8_t>(frame);
  message.current = current;
  message.autocontinue = autocontinue;
  message.mission_type = static_cast<uint8_t>(client.state_.type);
  if (wireItem == client.state_.next && client.plan_.has(kSaysChecksum)) {
    // Computing the checksum is enough work for one update(): the item is packed in the next one.
    ++client.state_.next;
    return client.opaqueId_.add(&message.frame, &message.command, &message.autocontinue, &message);
  }
  if (client.state_.floatItems) {
    client.session_.options.toFloats(&message);
    client.link_.prepareAs<mavlink_mission_item_t>(&message);
  } else {
    client.link_.prepareAs<mavlink_mission_item_int_t>(&message);
  }
  client.session_.prepared = wireItem;
}

}  // namespace mavmission
