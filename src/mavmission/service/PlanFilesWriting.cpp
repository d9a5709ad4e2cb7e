// PlanFiles' upload(): the plan is written as a file, straight from its source, and read back.
//
//   Checking -> writing --------------------------------> the read-back -> Accepted, Differs, Unconfirmed
//                 | there are no files, or none for this     (PlanFilesReading.cpp)
//                 +--> the mission protocol
//
// While the aircraft is armed, the number of items aboard is read first: ArduPilot does not clear a plan that it flies,
// and a shorter one would be followed by the rest of it.
#include <Arduino.h>
#include <string.h>

#include "../MissionClient.h"
#include "../PlanFiles.h"
#include "../autopilot/Rules.h"
#include "FileFrame.h"

namespace mavmission {
using namespace detail;

Status PlanFiles::upload(const ItemSource& plan, PlanType type) {
  Client& client = insideOf(client_);
  const bool isShortFence = type == PlanType::Fence && plan.count != 0 && plan.count <= Client::kShortFence;
  const Status status = client.uploadProven(plan, type, isShortFence ? Readback::Always : Readback::InDoubt);
  if (isEnd(status)) return status;
  isByFile_ = false;
  if (isShortFence) {
    client.rest_.prove = Client::proveFence;
  } else {
    beginOperation(writeStep);
  }
  return status;
}

void PlanFiles::writeStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  PlanFiles& self = *client.reading_.files;
  Client::State& state = client.state_;
  if (state.status == Status::Transferring) {
    if (frame == nullptr) return self.writeOn(nowMs);
    return self.isReply(*frame) ? self.takeWriteReply(*frame, nowMs) : void();
  }
  if (frame != nullptr) return;
  if (state.status == Status::WaitingForAutopilot) {
    client.waitForAutopilot();
    if (state.status != Status::Checking) return;
    client.beginChecking();
    self.isForeseen_ = true;
  }
  self.check(nowMs);
}

void PlanFiles::check(uint16_t nowMs) {
  Client& client = insideOf(client_);
  if (client.isArmed() && !client.state_.armedAllowed) return client.end(Status::Armed);
  if (!isChecked()) return;
  if (!isUsable() || !isForFile()) return uploadByItems(nowMs);
  client.beginSeconds(nowMs);
  client.state_.status = Status::Transferring;
  if (!client.isArmed()) return beginWriting();
  isLook_ = true;
  beginComparing(takeLook);
  beginReading();
}

// As Client::checkPlan(), and asks of each item whether it is known what ArduPilot makes of it. True when all is
// checked.
bool PlanFiles::isChecked() {
  Client& client = insideOf(client_);
  Client::State& state = client.state_;
  const WirePlan& plan = client.plan_;
  if (!client.hasAutopilot() || client.firmware() != plan.firmware()) {
    state.status = Status::WaitingForAutopilot;  // the autopilot was lost, or is another one now
    return false;
  }
  Status checked = Status::Accepted;
  if (plan.isTooLong()) {
    checked = Status::TooManyItems;
  } else if (!client.isTypeCarried()) {
    checked = Status::NeedsMavlink2;
  } else {
    if (!client.link_.canSend() || !client.claimHeavyWork()) return false;
    if (state.next == plan.wireCount()) return true;
    checked = client.checkItem(state.next);
    if (checked == Status::Checking) return false;
    if (checked == Status::Accepted) {
      if (!isForeseen(*static_cast<const MissionItem*>(client.link_.draft()))) isForeseen_ = false;
      ++state.next;
      return false;
    }
    state.failedItem = client.ownItem(state.next);
  }
  client.end(checked);
  return false;
}

// True if the plan that was checked may be written as a file.
bool PlanFiles::isForFile() const {
#if MAVMISSION_SIGNING
  if (insideOf(client_).link_.signing().isOn())
    return false;  // a frame that is made while it goes out cannot be signed
#endif
  return isForeseen_ && insideOf(client_).plan_.wireCount() <= kMostItems;
}

// False for a command without a row of rules: if ArduPilot does not take it, a file that holds it would leave the items
// before it aboard.
bool PlanFiles::isForeseen(const MissionItem& item) const {
  const Rules rules = rulesOf(item, insideOf(client_).plan_.keeper());
  const uint8_t height = static_cast<uint8_t>(rules.bits >> 24) & 15;
  return height != keeping::Height || !(rules.has(kAsItsFrameSays) || rules.has(kHasNoPlace));
}

void PlanFiles::beginWriting() {
  beginFile();
  insideOf(client_).setAboard(Aboard::AsBefore);
  insideOf(client_).state_.operation = writeStep;
  operation_ = writeStep;
  writing_.transfer.begin(insideOf(client_).plan_.wireCount());
  writing_.isBroken = false;
}

// A reading of the plan aboard, within an upload.
void PlanFiles::beginComparing(void (*onRead)(PlanFiles& self, Status status, uint16_t nowMs)) {
  Client& client = insideOf(client_);
  client.state_.operation = readStep;
  operation_ = readStep;
  onRead_ = onRead;
  client.state_.proving = true;  // no progress is reported for it
  client.state_.mayBeRefused = false;
  client.reading_.take = Client::compareItem;
  client.state_.isCompared = true;
  client.reading_.files = this;
}

void PlanFiles::takeLook(PlanFiles& self, Status status, uint16_t nowMs) {
  self.isLook_ = false;
  insideOf(self.client_).state_.proving = false;
  const bool isShorter =
      status != Status::Downloaded || self.reading_.count() > insideOf(self.client_).plan_.wireCount();
  if (isShorter) return self.uploadByItems(nowMs);
  self.isLengthKnown_ = true;
  self.beginWriting();
}

void PlanFiles::uploadByItems(uint16_t nowMs) {
  isByFile_ = false;
  if (isEnsuring_ && insideOf(client_).isArmed()) return insideOf(client_).end(Status::Armed);
  insideOf(client_).state_.operation = Client::uploadStep;
  insideOf(client_).beginUpload(nowMs);
}

void PlanFiles::writeOn(uint16_t nowMs) {
  Client& client = insideOf(client_);
  FileWriteTransfer& transfer = writing_.transfer;
  if (transfer.isLeaving() && client.link_.isSent()) transfer.onLeft(nowMs);
  Status status = transfer.onTime(nowMs, client.link_.pace());
  if (status == Status::NoAnswer) return uploadByItems(nowMs);
  if (client.state_.isLate) status = Status::TookTooLong;
  if (writing_.isBroken) status = Status::SourceRefused;
  if (status != Status::Transferring) {
    if (status == Status::TimedOut) client.state_.failedItem = client.ownItem(transfer.itemsWritten());
    return client.end(status);
  }
  if (!transfer.isDue() || transfer.isLeaving() || !client.link_.canSend()) return;
  switch (transfer.state()) {
    case FileWriteTransfer::State::Creating:
      return sendOpening(transfer.begun(sequence_).sequence, MAV_FTP_OPCODE_CREATEFILE);
    case FileWriteTransfer::State::Items: return sendItems(nowMs);
    case FileWriteTransfer::State::Heading: {
      // It was armed meanwhile, and may fly the old plan by now. What has been written is not stored without a header.
      if (client.isArmed() && !isLengthKnown_)
        return client.state_.armedAllowed && !isEnsuring_ ? uploadByItems(nowMs) : client.end(Status::Armed);
      client.setAboard(Aboard::NotKnown);  // from now on whoever closes the file may store it
      isStorable_ = true;
      const FileHeader header = {FileHeader::kMagic, static_cast<uint8_t>(client.state_.type), 0, 0,
                                 client.plan_.wireCount()};
      memcpy(static_cast<FileFrame*>(client.link_.draft())->data, &header, kFileHeader);
      return send(transfer.begun(sequence_).sequence, MAV_FTP_OPCODE_WRITEFILE, kFileHeader);
    }
    case FileWriteTransfer::State::Closing:
      return send(transfer.begun(sequence_).sequence, MAV_FTP_OPCODE_TERMINATESESSION);
  }
}

static_assert(FileFrame::kHead + FileWriteTransfer::kMostItems * kFileItem <= MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL_LEN,
              "a write must fit into a frame, and its length into a byte");

// A write of one item or of several. The frame's length must be known before it begins: MAVLink 2 leaves out the zeros
// at the end of a payload, so the last item is looked at first.
void PlanFiles::sendItems(uint16_t nowMs) {
  Client& client = insideOf(client_);
  if (!client.claimHeavyWork()) return;
  writing_.going = writing_.transfer.begun(sequence_);
  writing_.pieces = 0;
  const Request& write = writing_.going;
  const uint8_t* const last = static_cast<const uint8_t*>(client.link_.draft());
  uint8_t length = FileFrame::kHead + write.count * kFileItem;
  if (makeItem(write.first + write.count - 1, client.link_.draft()) == Status::Accepted) {
    for (uint8_t i = kFileItem; i != 0 && last[i - 1] == 0; --i) --length;
  }
  client.link_.sendStreamed(kKeysOfFiles, length, nextPiece, this);
  client.link_.flush(nowMs, Client::kStartBytes);
}

uint8_t PlanFiles::nextPiece(void* context, uint8_t* piece) {
  PlanFiles& self = *static_cast<PlanFiles*>(context);
  Writing& writing = self.writing_;
  // The operation may have been cancelled; what has begun of the frame is then no write.
  if (!self.isRunning() || self.operation_ != writeStep || writing.isBroken) return Outbox::kBroken;
  if (writing.pieces == 0) {
    ++writing.pieces;
    return self.makeHead(piece);
  }
  if (!insideOf(self.client_).claimHeavyWork()) return Outbox::kNotNow;
  const uint16_t wireItem = writing.going.first + writing.pieces - 1;
  const Status made = self.makeItem(wireItem, piece);
  if (made == Status::Accepted) {
    ++writing.pieces;
    return kFileItem;
  }
  insideOf(self.client_).state_.failedItem = insideOf(self.client_).ownItem(wireItem);
  writing.isBroken = true;
  return Outbox::kBroken;
}

uint8_t PlanFiles::makeHead(uint8_t* piece) const {
  FileFrame& head = *reinterpret_cast<FileFrame*>(piece);
  const Request& write = writing_.going;
  const Heartbeat& autopilot = insideOf(client_).link_.finder().heartbeat();
  head.network = 0;
  head.system = autopilot.systemId;
  head.component = autopilot.componentId;
  head.sequence = write.sequence;
  head.session = session_;
  head.opcode = MAV_FTP_OPCODE_WRITEFILE;
  head.size = write.count * kFileItem;
  head.requested = 0;
  head.isBurstComplete = 0;
  head.padding = 0;
  head.offset = kFileHeader + static_cast<uint32_t>(write.first) * kFileItem;
  return FileFrame::kHead;
}

// Makes an item as it lies in a file: as MISSION_ITEM_INT.
Status PlanFiles::makeItem(uint16_t wireItem, void* bytes) const {
  union Piece {
    MissionItem item;
    mavlink_mission_item_int_t message;
  };
  Piece& piece = *static_cast<Piece*>(bytes);
  const Status read = insideOf(client_).plan_.read(wireItem, piece.item);
  if (read != Status::Accepted) return read;
  const uint16_t command = piece.item.command;
  const Frame frame = piece.item.frame;
  const uint8_t current = piece.item.current;
  const uint8_t autocontinue = piece.item.autocontinue;
  mavlink_mission_item_int_t& message = piece.message;
  message.seq = wireItem;
  message.command = command;
  message.target_system = insideOf(client_).link_.finder().heartbeat().systemId;
  message.target_component = insideOf(client_).link_.finder().heartbeat().componentId;
  message.frame = static_cast<uint8_t>(frame);
  message.current = current;
  message.autocontinue = autocontinue;
  message.mission_type = static_cast<uint8_t>(insideOf(client_).state_.type);
  return Status::Accepted;
}

void PlanFiles::takeWriteReply(const FrameParser& frame, uint16_t nowMs) {
  Client& client = insideOf(client_);
  FileWriteTransfer& transfer = writing_.transfer;
  const uint16_t sequence = frame.payloadWord(offsetof(FileFrame, sequence)) - 1;
  if (!transfer.isOpen(sequence)) return;
  // Somebody else has the file, or the autopilot has restarted, or there is no such file.
  if (frame.payloadByte(offsetof(FileFrame, opcode)) != MAV_FTP_OPCODE_ACK) return uploadByItems(nowMs);
  const bool isClosed = transfer.onAnswer(sequence, nowMs, client.link_.pace());
  // The last item is reported when the plan is proven.
  const uint16_t written = transfer.itemsWritten(), home = client.homeBefore();
  if (written > home + 1) client.report(written - home - 1);
  if (!isClosed) return;
  client.rest_.lastResult = MAV_MISSION_ACCEPTED;  // no mixture: the file was closed
  beginComparing(takeProof);
  if (client.link_.pace().isLossy()) return proveByItems(nowMs);
  beginReading();
}

// Reads back item by item. A comparison always begins with the first one.
void PlanFiles::proveByItems(uint16_t nowMs) {
  Client& client = insideOf(client_);
  client.reading_.fromFloats = nullptr;  // an autopilot that gives only floats cannot prove an upload
  client.reading_.prover = this;
  isDamaged_ = false;
  client.reading_.take = proveItem;
  client.state_.operation = proveByItemsStep;
  client.reading_.transfer.begin(nowMs);
}

void PlanFiles::proveByItemsStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  typedef mavlink_mission_count_t Count;
  const bool isCount = frame != nullptr && frame->messageId() == MAVLINK_MSG_ID_MISSION_COUNT &&
                       client.reading_.transfer.expectsAnswer(DownloadTransfer::State::Listing) &&
                       frame->payloadByte(offsetof(Count, mission_type)) == static_cast<uint8_t>(client.state_.type);
  // An empty plan may have a count of 1: home.
  const bool isOther =
      isCount && client.plan_.count() != 0 && frame->payloadWord(offsetof(Count, count)) != client.plan_.wireCount();
  PlanFiles& self = *client.reading_.prover;
  if (!isOther || !client.link_.pace().isLossy()) {
    Client::readStep(client, frame, nowMs);
    if (!self.isDamaged_) return;
  }
  self.uploadDamaged(nowMs);
}

Status PlanFiles::proveItem(Client& client, uint16_t wireItem, MissionItem& item) {
  const Status status = Client::compareItem(client, wireItem, item);
  if (status != Status::Differs || !client.link_.pace().isLossy()) return status;
  client.reading_.prover->isDamaged_ = true;
  return Status::Checking;  // nothing more of this item
}

// Of the frames that a line breaks one in 65,536 has the right checksum by chance. A write that is broken so puts an
// item into the file that is none: ArduPilot then holds the plan up to there, or all of it with that item. The mission
// protocol is several times quicker on such a line; and it says which item is refused, if that was the cause.
void PlanFiles::uploadDamaged(uint16_t nowMs) {
  Client& client = insideOf(client_);
  isDamaged_ = false;
  client.state_.proving = false;
  client.rest_.proof = static_cast<uint8_t>(Readback::Always);
  client.rest_.field = ItemField::None;
  client.state_.failedItem = Client::kNoItem;
  client.state_.readsHalf = false;
  uploadByItems(nowMs);
}

void PlanFiles::takeProof(PlanFiles& self, Status status, uint16_t nowMs) {
  Client& client = insideOf(self.client_);
  if (status == Status::Differs && client.link_.pace().isLossy()) return self.uploadDamaged(nowMs);
  if (status == Status::Downloaded) {
    client.setAboard(Aboard::OurPlan);
    client.noteAccepted();
    if (client.state_.type == PlanType::Mission) client.rest_.planId = 0;
    client.report(client.rest_.itemsTotal);
    return client.end(Status::Accepted);
  }
  client.end(status == Status::Differs ? Status::Differs : Status::Unconfirmed);
}

}  // namespace mavmission
