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

#include "../autopilot/Rules.h"
#include "../client/Operation.h"
#include "../client/PlanPort.h"
#include "FileFrame.h"
#include "PlanFiles.h"

namespace mavmission {
using namespace detail;

Status PlanFiles::upload(const ItemSource& plan, PlanType type) {
  const Status status = plans().startUploading(plan, type);
  if (isEnd(status)) return status;
  isByFile_ = false;
  if (PlanPort::isShortFence(plan, type)) return status;
  beginOperation(writeStep);
  plans().goOnBy(writeStep, *this);
  return status;
}

struct PlanFiles::WritingFile : OperationParts {
  static bool begin(Client& client, uint16_t) {
    PlanFiles& self = PlanPort::filesOf(client);
    self.plans().beginChecking();
    self.isForeseen_ = true;
    return true;
  }

  static void frame(Client& client, const FrameParser& frame, uint16_t nowMs) {
    PlanFiles& self = PlanPort::filesOf(client);
    if (self.isReply(frame)) self.takeWriteReply(frame, nowMs);
  }

  static void time(Client& client, uint16_t nowMs) {
    PlanFiles& self = PlanPort::filesOf(client);
    if (self.client_.running() == Status::Transferring) return self.writeOn(nowMs);
    self.check(nowMs);
  }
};

void PlanFiles::writeStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  operate<WritingFile>(client, frame, nowMs);
}

void PlanFiles::check(uint16_t nowMs) {
  if (!isChecked()) return;
  if (!isUsable() || !isForFile()) return uploadByItems(nowMs);
  client_.beginTransferring(nowMs);
  if (!client_.autopilot().isArmed()) return beginWriting();
  if (!client_.isAllowedWhileArmed()) return client_.end(Status::Armed);
  isLook_ = true;
  beginComparing(takeLook);
  beginReading();
}

// Checks the plan, and asks of each item whether it is known what ArduPilot makes of it. True when all is checked.
bool PlanFiles::isChecked() {
  const Status checked = plans().checkNextOfAny();
  if (checked == Status::Accepted && !isForeseen(*static_cast<const MissionItem*>(client_.link().draft()))) {
    isForeseen_ = false;
  }
  return checked == Status::Transferring;
}

// True if the plan that was checked may be written as a file.
bool PlanFiles::isForFile() const {
#if MAVMISSION_SIGNING
  if (client_.link().signing().isOn()) return false;  // a frame that is made while it goes out cannot be signed
#endif
  return isForeseen_ && plans().plan().wireCount() <= kMostItems;
}

// False for a command without a row of rules: if ArduPilot does not take it, a file that holds it would leave the items
// before it aboard.
bool PlanFiles::isForeseen(const MissionItem& item) const {
  const Rules rules = rulesOf(item, plans().plan().keeper());
  const uint8_t height = static_cast<uint8_t>(rules.bits >> 24) & 15;
  return height != keeping::Height || !(rules.has(kAsItsFrameSays) || rules.has(kHasNoPlace));
}

void PlanFiles::beginWriting() {
  beginFile();
  plans().nowAboard(Aboard::AsBefore);
  plans().goOnBy(writeStep, *this);
  operation_ = writeStep;
  writing_.transfer.begin(plans().plan().wireCount());
  writing_.isBroken = false;
}

// A reading of the plan aboard, within an upload.
void PlanFiles::beginComparing(void (*onRead)(PlanFiles& self, Status status, uint16_t nowMs)) {
  operation_ = readStep;
  onRead_ = onRead;
  plans().beginComparing(readStep, *this);
}

void PlanFiles::takeLook(PlanFiles& self, Status status, uint16_t nowMs) {
  self.isLook_ = false;
  self.plans().endComparing();
  const bool isShorter = status != Status::Downloaded || self.reading_.count() > self.plans().plan().wireCount();
  if (isShorter) return self.uploadByItems(nowMs);
  self.isLengthKnown_ = true;
  self.beginWriting();
}

void PlanFiles::uploadByItems(uint16_t nowMs) {
  isByFile_ = false;
  if (isEnsuring_ && client_.autopilot().isArmed()) return client_.end(Status::Armed);
  plans().uploadByItems(nowMs);
}

void PlanFiles::writeOn(uint16_t nowMs) {
  Port& client = client_;
  FileWriteTransfer& transfer = writing_.transfer;
  if (transfer.isLeaving() && client.link().isSent()) transfer.onLeft(nowMs);
  Status status = transfer.onTime(nowMs, client.link().pace());
  if (status == Status::NoAnswer) return uploadByItems(nowMs);
  if (client.hasTakenTooLong()) status = Status::TookTooLong;
  if (writing_.isBroken) status = Status::SourceRefused;
  if (status != Status::Transferring) {
    if (status == Status::TimedOut) plans().noteFailed(transfer.itemsWritten());
    return client.end(status);
  }
  if (!transfer.isDue() || transfer.isLeaving() || !client.link().canSend()) return;
  switch (transfer.state()) {
    case FileWriteTransfer::State::Creating:
      return sendOpening(transfer.begun(sequence_).sequence, MAV_FTP_OPCODE_CREATEFILE);
    case FileWriteTransfer::State::Items: return sendItems(nowMs);
    case FileWriteTransfer::State::Heading: {
      // It was armed meanwhile, and may fly the old plan by now. What has been written is not stored without a header.
      if (client.autopilot().isArmed() && !isLengthKnown_)
        return client.isAllowedWhileArmed() && !isEnsuring_ ? uploadByItems(nowMs) : client.end(Status::Armed);
      plans().nowAboard(Aboard::NotKnown);  // from now on whoever closes the file may store it
      isStorable_ = true;
      const FileHeader header = {FileHeader::kMagic, static_cast<uint8_t>(plans().planType()), 0, 0,
                                 plans().plan().wireCount()};
      memcpy(static_cast<FileFrame*>(client.link().draft())->data, &header, kFileHeader);
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
  Port& client = client_;
  if (!client.claimHeavyWork()) return;
  writing_.going = writing_.transfer.begun(sequence_);
  writing_.pieces = 0;
  const Request& write = writing_.going;
  const uint8_t* const last = static_cast<const uint8_t*>(client.link().draft());
  uint8_t length = FileFrame::kHead + write.count * kFileItem;
  if (makeItem(write.first + write.count - 1, client.link().draft()) == Status::Accepted) {
    for (uint8_t i = kFileItem; i != 0 && last[i - 1] == 0; --i) --length;
  }
  client.link().sendStreamed(kKeysOfFiles, length, nextPiece, this);
  client.link().flush(nowMs, Port::kStartBytes);
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
  if (!self.client_.claimHeavyWork()) return Outbox::kNotNow;
  const uint16_t wireItem = writing.going.first + writing.pieces - 1;
  const Status made = self.makeItem(wireItem, piece);
  if (made == Status::Accepted) {
    ++writing.pieces;
    return kFileItem;
  }
  self.plans().noteFailed(wireItem);
  writing.isBroken = true;
  return Outbox::kBroken;
}

uint8_t PlanFiles::makeHead(uint8_t* piece) const {
  FileFrame& head = *reinterpret_cast<FileFrame*>(piece);
  const Request& write = writing_.going;
  const Heartbeat& autopilot = client_.autopilot().heartbeat();
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
  const Status read = plans().plan().read(wireItem, piece.item);
  if (read != Status::Accepted) return read;
  const uint16_t command = piece.item.command;
  const CoordinateFrame frame = piece.item.frame;
  const uint8_t current = piece.item.current;
  const uint8_t autocontinue = piece.item.autocontinue;
  mavlink_mission_item_int_t& message = piece.message;
  message.seq = wireItem;
  message.command = command;
  message.target_system = client_.autopilot().heartbeat().systemId;
  message.target_component = client_.autopilot().heartbeat().componentId;
  message.frame = static_cast<uint8_t>(frame);
  message.current = current;
  message.autocontinue = autocontinue;
  message.mission_type = static_cast<uint8_t>(plans().planType());
  return Status::Accepted;
}

void PlanFiles::takeWriteReply(const FrameParser& frame, uint16_t nowMs) {
  FileWriteTransfer& transfer = writing_.transfer;
  const uint16_t sequence = frame.payloadWord(offsetof(FileFrame, sequence)) - 1;
  if (!transfer.isOpen(sequence)) return;
  // Somebody else has the file, or the autopilot has restarted, or there is no such file.
  if (frame.payloadByte(offsetof(FileFrame, opcode)) != MAV_FTP_OPCODE_ACK) return uploadByItems(nowMs);
  const bool isClosed = transfer.onAnswer(sequence, nowMs, client_.link().pace());
  // The last item is reported when the plan is proven.
  const uint16_t written = transfer.itemsWritten();
  if (written != 0) plans().progress(written - 1);
  if (!isClosed) return;
  plans().noteWhole();
  beginComparing(takeProof);
  if (client_.link().pace().isLossy()) return proveByItems(nowMs);
  beginReading();
}

// Reads back item by item. A comparison always begins with the first one.
void PlanFiles::proveByItems(uint16_t nowMs) {
  isDamaged_ = false;
  plans().proveByItems(proveByItemsStep, proveItem, *this, nowMs);
}

void PlanFiles::proveByItemsStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  PlanFiles& self = PlanPort::proverOf(client);
  const bool isOther = frame != nullptr && self.plans().isOtherCount(*frame);
  if (!isOther || !self.client_.link().pace().isLossy()) {
    self.plans().readOnByItems(frame, nowMs);
    if (!self.isDamaged_) return;
  }
  self.uploadDamaged(nowMs);
}

Status PlanFiles::proveItem(Client& client, uint16_t wireItem, MissionItem& item) {
  PlanFiles& self = PlanPort::proverOf(client);
  const Status status = self.plans().compare(wireItem, item);
  if (status != Status::Differs || !self.client_.link().pace().isLossy()) return status;
  self.isDamaged_ = true;
  return Status::Checking;  // nothing more of this item
}

// Of the frames that a line breaks one in 65,536 has the right checksum by chance. A write that is broken so puts an
// item into the file that is none: ArduPilot then holds the plan up to there, or all of it with that item. The mission
// protocol is several times quicker on such a line; and it says which item is refused, if that was the cause.
void PlanFiles::uploadDamaged(uint16_t nowMs) {
  isDamaged_ = false;
  plans().proveInAnyCase();
  uploadByItems(nowMs);
}

void PlanFiles::takeProof(PlanFiles& self, Status status, uint16_t nowMs) {
  Port& client = self.client_;
  if (status == Status::Differs && client.link().pace().isLossy()) return self.uploadDamaged(nowMs);
  if (status == Status::Downloaded) return self.plans().endAsOurs(Status::Accepted);
  client.end(status == Status::Differs ? Status::Differs : Status::Unconfirmed);
}

}  // namespace mavmission
