// MissionClient's upload: connects the plan and the transfer's state machine to the link.
#include <Arduino.h>

#include "../MissionClient.h"
#include "../link/Messages.h"
#include "../link/Sending.h"

namespace mavmission {
using namespace detail;

Status Client::startUpload(const ItemSource& plan, PlanType type) {
  if (state_.operation != nullptr) return Status::Busy;
  if (type == PlanType::All) return refuseType();
  // "Our plan" is this one from now on, and what was ours is what was aboard before.
  if (aboard(type) == Aboard::OurPlan) setAboard(type, Aboard::AsBefore);
  setPlan(plan, type);
  rest_.options.readBack = nullptr;
  return uploadKeptPlan();
}

Status Client::refuseType() {
  startOperation(uploadStep);
  return refuse(Status::BadPlanType);
}

void Client::setPlan(const ItemSource& plan, PlanType type) {
  plan_.setSource(plan);
  rest_.planType = type;
  state_.tooLong = plan.count > kMaxItems;
  state_.announcePart = nullptr;
}

Status Client::uploadKeptPlan() {
  if (state_.operation != nullptr) return Status::Busy;
  startOperation(uploadStep);
  state_.type = rest_.planType;
  rest_.itemsTotal = plan_.count();
  if (state_.type == PlanType::All) return refuse(Status::SourceRefused);  // there is no plan yet
  if (state_.tooLong) return refuse(Status::TooManyItems);
  return state_.status;
}

// As operate() would call them, but in the order in which a request is answered soonest.
void Client::uploadStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  if (client.state_.status == Status::Transferring) {
    return frame != nullptr ? client.takeUploadFrame(*frame, nowMs) : client.onUploadTime(nowMs);
  }
  if (frame != nullptr) return;
  if (client.state_.status == Status::WaitingForAutopilot) {
    client.waitForAutopilot();
    if (client.state_.status != Status::Checking) return;
    client.beginChecking();
  }
  client.checkPlan(nowMs);
}

void Client::onUploadTime(uint16_t nowMs) {
  const Status status = transfer_.onTime(nowMs, link_.pace());
  if (status != Status::Transferring) return continueUpload(status, nowMs);
  if (state_.isLate) return continueUpload(Status::TookTooLong, nowMs);
  sendUpload(nowMs);
}

void Client::beginPlan() { plan_.begin(firmware(), link_.finder().heartbeat().vehicleType, state_.type, rest_.raw); }

// Accepted, or NotKept, with the field of the item that the autopilot would not keep in rest_.field.
Status Client::keeping(const MissionItem& item) {
  rest_.field = notKept(item, plan_.keeper());
  return rest_.field == ItemField::None ? Status::Accepted : Status::NotKept;
}

void PlanPort::beginChecking() {
  Client& client = static_cast<Client&>(*this);
  client.beginPlan();
  client.state_.next = 0;
}

// To be called only when the link can send: the item is read into the outgoing frame's buffer, to save stack.
Status Client::checkItem(uint16_t wireItem) {
  MissionItem& item = *static_cast<MissionItem*>(link_.draft());
  const Status read = plan_.read(wireItem, item);
  return read == Status::Accepted ? keeping(item) : read;
}

// The one check of a plan, by whatever way it goes: the same autopilot, then what hinders all of the plan, then an
// item.
Status PlanPort::checkNext(bool isToChange) {
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
  } else if (state.announcePart != nullptr && plan.has(kTakesWholePlansOnly)) {
    checked = Status::WholePlansOnly;
  } else if (!isTypeCarried()) {
    checked = Status::NeedsMavlink2;
  } else if (isToChange && finder.isArmed() && !state.armedAllowed) {
    checked = Status::Armed;
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

void Client::checkPlan(uint16_t nowMs) {
  for (uint8_t read = 0; read < MAVMISSION_ITEMS_PER_UPDATE; ++read) {
    const Status checked = checkNext(true);
    if (checked == Status::Transferring) return beginUpload(nowMs);
    if (checked != Status::Accepted) return;
  }
}

void Client::beginTransfer() { transfer_.begin(plan_.wireCount(), plan_.firmware(), state_.unsettled); }

void Client::beginUpload(uint16_t nowMs) {
  beginTransfer();
  if (state_.announcePart != nullptr) state_.announcePart(*this, true);
  opaqueId_.begin();
  state_.next = 0;
  state_.isLate = false;
  if (rest_.backOffPauseS == 0) beginSeconds(nowMs);
  state_.status = Status::Transferring;
  sendUpload(nowMs);
}

void Client::takeUploadFrame(const FrameParser& frame, uint16_t nowMs) {
  switch (frame.messageId()) {
    case MAVLINK_MSG_ID_MISSION_REQUEST:
    case MAVLINK_MSG_ID_MISSION_REQUEST_INT: {
      typedef mavlink_mission_request_int_t Request;
      static_assert(sizeof(mavlink_mission_request_t) == sizeof(Request),
                    "MISSION_REQUEST and MISSION_REQUEST_INT must have the same layout");
      if (frame.payloadByte(offsetof(Request, mission_type)) != static_cast<uint8_t>(state_.type)) return;
      if (frame.messageId() == MAVLINK_MSG_ID_MISSION_REQUEST_INT) transfer_.noteInt();
      const Status status = transfer_.onRequest(frame.payloadWord(offsetof(Request, seq)), nowMs, link_.pace());
      // The item is sent at once, before the rest of this update().
      sendUpload(nowMs);
      link_.flush(nowMs, kStartBytes);
      continueUpload(status, nowMs);
      return;
    }
    case MAVLINK_MSG_ID_MISSION_ACK: {
      typedef mavlink_mission_ack_t Ack;
      if (frame.payloadByte(offsetof(Ack, mission_type)) != static_cast<uint8_t>(state_.type)) return;
      const uint8_t result = frame.payloadByte(offsetof(Ack, type));
      rest_.lastResult = result;
      if (!transfer_.hasBegun() && !link_.isSent()) return;  // COUNT still waits for room: this answers something else
      Status status = transfer_.onAck(result, nowMs, link_.pace());
      if (status == Status::Accepted) status = proven(frame.payloadLong(offsetof(Ack, opaque_id)));
      continueUpload(status, nowMs);
      return;
    }
    default: return;
  }
}

// The status that follows from an acceptance with this opaque_id, in which PX4 reports the checksum of the plan that it
// holds. It is not compared when it is 0, which means that none is reported, nor when items were sent as floats, since
// our checksum was computed before the conversion.
Status Client::proven(uint32_t opaqueId) {
  // ArduPilot asks by MISSION_REQUEST. Another one may only say that it is an ArduPilot, and hold as the first item
  // what was sent in home's place.
  if (plan_.numbers().isHomeAdded() && transfer_.isAskedByInt()) return Status::Unconfirmed;
  if (!state_.floatItems) {
    // What a server does whose ways are not known is not known: Betaflight deletes the plan that it has just accepted,
    // when a network brings our COUNT once more. Reading shows that. (Behind an empty plan there is nothing to be
    // deleted, and what was sent as floats cannot be compared.)
    if (plan_.has(kIsReadBack) && transfer_.hasBegun()) return Status::Unconfirmed;
    if (plan_.has(kSaysChecksum) && opaqueId != 0 && opaqueId != opaqueId_.value()) return Status::OtherPlanAboard;
  }
  if (state_.type == PlanType::Mission) rest_.planId = opaqueId;
  return Status::Accepted;
}

// Reports the progress, and ends the upload or continues it, according to the transfer's status.
void Client::continueUpload(Status status, uint16_t nowMs) {
  if (state_.status != Status::Transferring) return;  // the source has refused the item that was to be sent
  // The autopilot holds every item that it has requested except the last one.
  const uint16_t notHeld = plan_.numbers().before() + 1;
  if (transfer_.itemsAskedFor() > notHeld) report(transfer_.itemsAskedFor() - notHeld);
  if (status == Status::Transferring) return;

  if (rest_.options.takeUp != nullptr && rest_.options.takeUp(*this, status, nowMs)) return;
  setAboard(aboardAfterUpload(status));
  switch (status) {
    case Status::Accepted:
      report(rest_.itemsTotal);
      noteAccepted();
      break;
    case Status::NoAnswer:
    case Status::TimedOut:
    case Status::TookTooLong:
    case Status::SourceRefused:
      if (status == Status::TimedOut) noteFailed(transfer_.itemsAskedFor() - 1);
      tellCancelled();
      unsettle(nowMs);
      break;
    case Status::Unconfirmed: unsettle(nowMs); break;
    default:
      state_.unsettled = 0;
      if (transfer_.hasBegun()) noteFailed(transfer_.lastItem());
      break;
  }
  end(status);
}

void Client::noteAccepted() {
  if (state_.type == PlanType::Mission) state_.infeasible = false;
  state_.unsettled = 0;
}

Aboard Client::aboardAfterUpload(Status status) const {
  if (status == Status::Accepted) return Aboard::OurPlan;
  const bool begun = transfer_.hasBegun();
  const bool refused = status >= Status::Error;  // a refusal by the autopilot
  const bool mayBeWhole = transfer_.state() == UploadTransfer::State::Confirming || status == Status::AcceptedEarly;
  // An error after the last item does not prove a refusal: a radio may have repeated an item, which then reached an
  // idle autopilot.
  if (mayBeWhole && (!refused || status == Status::Error)) return Aboard::NotKnown;
  // Such an autopilot keeps the old plan until the new plan is complete; an empty plan is complete at once.
  if (plan_.has(kKeepsPlanUntilWhole) && (refused || plan_.count() != 0)) return Aboard::AsBefore;
  if (!begun) return refused && !transfer_.isSuspected() ? Aboard::AsBefore : Aboard::NotKnown;
  if (plan_.has(kDropsPlanFirst)) return Aboard::Nothing;
  // ArduPilot replaces a mission item by item, but a fence only as a whole.
  return plan_.has(kReplacesItemByItem) && state_.type == PlanType::Mission ? Aboard::Mixture : Aboard::NotKnown;
}

void PlanPort::noteFailed(uint16_t wireItem) {
  Client& client = static_cast<Client&>(*this);
  client.state_.failedItem = client.ownItem(wireItem);
}

// Sends what is due. An item is packed before it is requested, while the line waits for the autopilot: the answer to
// the request then begins earlier by the time of packing, and no update() both packs an item and writes it.
void Client::sendUpload(uint16_t nowMs) {
  if (transfer_.toSend() == UploadTransfer::Send::Nothing) {
    // (What is prepared now is the next item: whatever was sent since has taken its place.)
    if (link_.isPrepared() || !transfer_.expectsRequest() || !link_.canSend()) return;
    return prepareItem(transfer_.nextItem(), nowMs);
  }
  if (!link_.canSend()) return;
  if (transfer_.toSend() != UploadTransfer::Send::Item) {
    sendAnnouncement();
  } else if (isPrepared(transfer_.itemToSend())) {
    link_.release();
  } else {
    return prepareItem(transfer_.itemToSend(), nowMs);
  }
  transfer_.sent(nowMs);
  noteSent(transfer_.tries());
}

// Sends the message that comes before the items (COUNT, or the announcement of a part), or a cancellation.
void Client::sendAnnouncement() {
  if (transfer_.toSend() == UploadTransfer::Send::Cancel) {
    sendAck(MAV_MISSION_OPERATION_CANCELLED, state_.type);
  } else if (state_.announcePart != nullptr) {
    state_.announcePart(*this, false);
  } else {
    sendShort(KeyIndex::MISSION_COUNT, plan_.wireCount(), state_.type);
  }
}

void Client::prepareItem(uint16_t wireItem, uint16_t nowMs) {
  static_assert(offsetof(mavlink_mission_item_int_t, seq) == kPlaceBytes,
                "param1 to z must lie in MISSION_ITEM_INT as they lie in MissionItem");
  static_assert(sizeof(mavlink_mission_item_t) == sizeof(mavlink_mission_item_int_t),
                "MISSION_ITEM and MISSION_ITEM_INT must have the same layout");
  if (!claimHeavyWork()) return;
  // The item is read into the buffer of the outgoing frame and turned into the message in place: param1 to z stay where
  // they are, the other fields are moved. This keeps the deepest stack small.
  union Piece {
    MissionItem item;
    mavlink_mission_item_int_t message;
  };
  static_assert(sizeof(MissionItem) <= Outbox::kMaxPayload && sizeof(mavlink_mission_item_int_t) <= Outbox::kMaxPayload,
                "raise Outbox::kMaxPayload: an item is made in the outbox");
  Piece& piece = *static_cast<Piece*>(link_.draft());
  const Status read = plan_.read(wireItem, piece.item);
  if (read == Status::Checking) return;
  if (read != Status::Accepted) {
    noteFailed(wireItem);
    return continueUpload(read, nowMs);
  }
  const MissionItem& item = piece.item;
  mavlink_mission_item_int_t& message = piece.message;
  const uint16_t command = item.command;
  const Frame frame = item.frame;
  const uint8_t current = item.current;
  const uint8_t autocontinue = item.autocontinue;
  message.seq = wireItem;
  message.command = command;
  message.frame = static_cast<uint8_t>(frame);
  message.current = current;
  message.autocontinue = autocontinue;
  message.mission_type = static_cast<uint8_t>(state_.type);
  if (wireItem == state_.next && plan_.has(kSaysChecksum)) {
    // Computing the checksum is enough work for one update(): the item is packed in the next one.
    ++state_.next;
    return opaqueId_.add(&message.frame, &message.command, &message.autocontinue, &message);
  }
  if (state_.floatItems) {
    rest_.options.toFloats(&message);
    link_.prepareAs<mavlink_mission_item_t>(&message);
  } else {
    link_.prepareAs<mavlink_mission_item_int_t>(&message);
  }
  state_.prepared = wireItem;
}

}  // namespace mavmission
