// PlanFiles' reading: verify(), download(), and the proof of an upload.
#include <Arduino.h>
#include <string.h>

#include "../MissionClient.h"
#include "../PlanFiles.h"
#include "../autopilot/Rules.h"
#include "FileFrame.h"

namespace mavmission {
using namespace detail;

namespace {

// ArduPilot does not write x, y and z of an item whose command has none of them: they are those of an item that it has
// read before. The mission protocol gives zeros for them.
void dropLeftOvers(MissionItem& item, Keeper keeper) {
  const uint16_t kinds = static_cast<uint16_t>(rulesOf(item, keeper).bits >> 16);
  if ((kinds & 15) == keeping::D) item.x = 0;
  if ((kinds >> 4 & 15) == keeping::D) item.y = 0;
  if ((kinds >> 8 & 15) == keeping::D) item.z = 0;
}

}  // namespace

Status PlanFiles::verify(const ItemSource& plan, PlanType type) {
  Client& client = insideOf(client_);
  if (client.isBusy()) return Status::Busy;
  if (type == PlanType::All) return client.refuseType();
  client.setPlanToVerify(plan, type);
  client.startOperation(readStep);
  beginOperation(readStep);
  client.reading_.take = Client::compareItem;
  client.state_.isCompared = true;
  client.rest_.itemsTotal = client.plan_.count();
  if (client.state_.tooLong) return client.refuse(Status::TooManyItems);
  return client.status();
}

Status PlanFiles::download(const ItemSink& sink, PlanType type) {
  Client& client = insideOf(client_);
  if (client.isBusy()) return Status::Busy;
  if (type == PlanType::All) return client.refuseType();
  client.state_.type = type;
  client.startOperation(readStep);
  beginOperation(readStep);
  client.reading_.take = Client::storeItem;
  client.state_.isCompared = false;
  client.reading_.sink = sink;
  return client.status();
}

void PlanFiles::readStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  PlanFiles& self = *client.reading_.files;
  Client::State& state = client.state_;
  if (frame != nullptr) {
    if (state.status == Status::Transferring && self.isReply(*frame)) self.takeReadReply(*frame, nowMs);
    return;
  }
  if (state.status == Status::WaitingForAutopilot) {
    client.waitForAutopilot();
    if (state.status != Status::Checking) return;
    if (!client.isTypeCarried()) return client.end(Status::NeedsMavlink2);
    client.beginPlan();
    client.beginSeconds(nowMs);
    state.status = Status::Transferring;
    // On a line that loses, each lost item costs a request and an answer, and both are longer than those of the mission
    // protocol. A sink that is not ready would let the rest of a burst go by.
    const bool mayWait = !client.state_.isCompared && client.reading_.sink.isReady != nullptr;
    if (mayWait || client.link_.pace().isLossy() || !self.isUsable()) return self.readByItems(0, nowMs);
    self.beginReading();
  }
  self.readOn(nowMs);
}

void PlanFiles::beginReading() {
  beginFile();
  reading_.begin(insideOf(client_).state_.isCompared);
}

void PlanFiles::readOn(uint16_t nowMs) {
  Client& client = insideOf(client_);
  // As in Client::readStep(): the update() that reads the last bytes of an item compares it too.
  client.state_.readsHalf = true;
  const Status status = reading_.onTime(nowMs, client.link_.pace());
  if (status == Status::NoAnswer || reading_.isTooSlow()) return readByItems(reading_.itemToAsk(), nowMs);
  if (status != Status::Transferring) return endReading(status, nowMs);
  if (client.state_.isLate && reading_.state() != FileReadTransfer::State::Closing) reading_.close(Status::TookTooLong);
  typedef FileReadTransfer::Send Send;
  const Send due = reading_.toSend();
  if (due == Send::Nothing || !client.link_.canSend()) return;
  // A repeat has the number of the request that it repeats; a burst is given again, each time with a number of its own.
  if (reading_.tries() == 0 || due == Send::Burst) ++sequence_;
  const uint32_t offset = kFileHeader + static_cast<uint32_t>(reading_.itemToAsk()) * kFileItem;
  switch (due) {
    case Send::Open: sendOpening(sequence_, MAV_FTP_OPCODE_OPENFILERO); break;
    case Send::Header: send(sequence_, MAV_FTP_OPCODE_READFILE, kFileHeader); break;
    case Send::Item: send(sequence_, MAV_FTP_OPCODE_READFILE, kFileItem, offset); break;
    case Send::Burst:
      send(sequence_, MAV_FTP_OPCODE_BURSTREADFILE, kFileItem, offset);
      // Each piece has the next number, and the end of the burst has one more. The next request must not have the last
      // one's: ArduPilot would take it for a repeat.
      sequence_ += reading_.count() + 2;
      break;
    default: send(sequence_, MAV_FTP_OPCODE_TERMINATESESSION); break;
  }
  reading_.sent(nowMs);
}

void PlanFiles::takeReadReply(const FrameParser& frame, uint16_t nowMs) {
  const uint8_t requested = frame.payloadByte(offsetof(FileFrame, requested));
  typedef FileReadTransfer::State State;
  if (frame.payloadByte(offsetof(FileFrame, opcode)) != MAV_FTP_OPCODE_ACK) {
    if (requested == MAV_FTP_OPCODE_BURSTREADFILE && frame.payloadByte(offsetof(FileFrame, data)) == MAV_FTP_ERR_EOF) {
      return reading_.onBurstEnd();
    }
    // A late refusal of an opening, whose repeat was taken, changes nothing.
    const bool isLate = requested == MAV_FTP_OPCODE_OPENFILERO && reading_.state() != State::Opening;
    if (isLate || reading_.state() == State::Closing) return;
    // The file was closed by somebody, who may have changed the plan: a comparison begins anew.
    return readByItems(insideOf(client_).state_.isCompared ? 0 : reading_.itemToAsk(), nowMs);
  }
  const uint32_t offset = frame.payloadLong(offsetof(FileFrame, offset));
  switch (requested) {
    case MAV_FTP_OPCODE_OPENFILERO: return reading_.onOpened(nowMs, insideOf(client_).link_.pace());
    case MAV_FTP_OPCODE_TERMINATESESSION: {
      const Status ended = reading_.onClosed();
      return ended == Status::Transferring ? void() : endReading(ended, nowMs);
    }
    case MAV_FTP_OPCODE_READFILE:
    case MAV_FTP_OPCODE_BURSTREADFILE: break;
    default: return;
  }
  if (offset == 0) return takeCount(frame, nowMs);
  if (frame.payloadByte(offsetof(FileFrame, size)) != kFileItem) return;
  const uint32_t item = (offset - kFileHeader) / kFileItem;
  if (item > 0xFFFF || item * kFileItem + kFileHeader != offset) return;
  takeItem(frame, static_cast<uint16_t>(item), nowMs);
}

void PlanFiles::takeCount(const FrameParser& frame, uint16_t nowMs) {
  const uint8_t header = FileFrame::kHead;
  const uint16_t type = frame.payloadWord(header + offsetof(FileHeader, type));
  const uint16_t count = frame.payloadWord(header + offsetof(FileHeader, count));
  if (frame.payloadWord(header + offsetof(FileHeader, magic)) != FileHeader::kMagic ||
      type != static_cast<uint8_t>(insideOf(client_).state_.type) ||
      !reading_.onCount(count, nowMs, insideOf(client_).link_.pace())) {
    return;
  }
  Client& client = insideOf(client_);
  if (isLook_) return reading_.close(Status::Downloaded);
  const bool isHomeFirst = client.homeBefore() != 0;
  if (!client.state_.isCompared) {
    const uint16_t items = isHomeFirst && count > 0 ? count - 1 : count;
    client.rest_.itemsTotal = items;
    if (items > client.reading_.sink.limit) reading_.close(Status::SinkFull);
    return;
  }
  // ArduPilot without a plan has a count of 0, or of 1 for its home.
  const bool isBothEmpty = isHomeFirst && client.plan_.count() == 0 && count <= 1;
  if (isBothEmpty || count == client.plan_.wireCount()) return;
  client.rest_.field = ItemField::Count;
  reading_.close(Status::Differs);
}

void PlanFiles::takeItem(const FrameParser& frame, uint16_t number, uint16_t nowMs) {
  if (!reading_.wants(number)) return reading_.onUnused(nowMs);
  Client& client = insideOf(client_);
  union {
    MissionItem item;
    mavlink_mission_item_int_t message;
    FileFrame request;
    uint8_t bytes[FileFrame::kItem];
  } piece;
  frame.copyPayload(&piece, sizeof(piece.bytes));
  memmove(piece.bytes, piece.bytes + FileFrame::kHead, kFileItem);
  const uint16_t command = piece.message.command;
  const uint8_t frameNumber = piece.message.frame;
  const uint8_t autocontinue = piece.message.autocontinue;
  piece.item.command = command;
  piece.item.frame = static_cast<Frame>(frameNumber);
  piece.item.current = 0;  // the file has it by another rule than the protocol
  piece.item.autocontinue = autocontinue;
  dropLeftOvers(piece.item, client.plan_.keeper());
  const Status taken = client.reading_.take(client, number, piece.item);
  if (taken == Status::Checking) return;
  if (taken != Status::Transferring) {
    client.state_.failedItem = client.ownItem(number);
    return reading_.close(taken);
  }
  reading_.onItem(number, nowMs, client.link_.pace());
  if (!client.state_.proving) {
    const uint16_t done = reading_.itemsTaken();
    client.report(done < client.homeBefore() ? 0 : done - client.homeBefore());
  }
}

// Goes over to the mission protocol, from this item on.
void PlanFiles::readByItems(uint16_t first, uint16_t nowMs) {
  Client& client = insideOf(client_);
  if (isLook_ || isWholeLook_) return onRead_(*this, Status::NoAnswer, nowMs);
  if (client.state_.proving) return proveByItems(nowMs);
  isByFile_ = false;
  client.reading_.fromFloats = Client::fromFloats;
  client.state_.operation = Client::readStep;
  client.reading_.transfer.begin(nowMs);
  client.reading_.transfer.skipTo(first);
}

void PlanFiles::endReading(Status status, uint16_t nowMs) {
  Client& client = insideOf(client_);
  client.state_.readsHalf = false;
  if (onRead_ != nullptr) return onRead_(*this, status, nowMs);
  if (status == Status::Downloaded && client.state_.isCompared) {
    status = Status::Verified;
    client.setAboard(Aboard::OurPlan);
    if (client.state_.type == PlanType::Mission) client.rest_.planId = 0;
  } else if (status == Status::Differs) {
    client.setAboard(Aboard::NotKnown);
  }
  client.end(status);
}

}  // namespace mavmission
