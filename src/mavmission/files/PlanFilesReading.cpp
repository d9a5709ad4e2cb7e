// PlanFiles' reading: verify(), download(), and the proof of an upload.
#include <Arduino.h>
#include <string.h>

#include "../autopilot/Rules.h"
#include "../client/Operation.h"
#include "../client/PlanPort.h"
#include "FileFrame.h"
#include "PlanFiles.h"

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
  if (client_.running() != Status::Idle) return Status::Busy;
  beginOperation(readStep);
  return plans().startVerifying(plan, type, readStep, *this);
}

Status PlanFiles::download(const ItemSink& sink, PlanType type) {
  if (client_.running() != Status::Idle) return Status::Busy;
  beginOperation(readStep);
  return plans().startDownloading(sink, type, readStep, *this);
}

struct PlanFiles::ReadingFile : OperationParts {
  static bool begin(Client& client, uint16_t nowMs) {
    PlanFiles& self = PlanPort::filesOf(client);
    if (!self.plans().beginsReading(nowMs)) return false;
    // On a lossy link, each lost item costs a request and an answer, and both are longer than those of the mission
    // protocol. A sink that is not ready would let the rest of a burst go by.
    if (self.plans().mayWaitForSink() || self.client_.link().pace().isLossy() || !self.isUsable()) {
      self.readByItems(0, nowMs);
      return false;
    }
    self.beginReading();
    return true;
  }

  static void frame(Client& client, const FrameParser& frame, uint16_t nowMs) {
    PlanFiles& self = PlanPort::filesOf(client);
    if (self.isReply(frame)) self.takeReadReply(frame, nowMs);
  }

  static void time(Client& client, uint16_t nowMs) { PlanPort::filesOf(client).readOn(nowMs); }
};

void PlanFiles::readStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  operate<ReadingFile>(client, frame, nowMs);
}

void PlanFiles::beginReading() {
  beginFile();
  reading_.begin(plans().isCompared());
}

void PlanFiles::readOn(uint16_t nowMs) {
  // The update() that reads the last bytes of an item compares it too.
  plans().keepTimeFree(true);
  const Status status = reading_.onTime(nowMs, client_.link().pace());
  if (status == Status::NoAnswer || reading_.isTooSlow()) return readByItems(reading_.itemToAsk(), nowMs);
  if (status != Status::Transferring) return endReading(status, nowMs);
  if (client_.hasTakenTooLong() && reading_.state() != FileReadTransfer::State::Closing)
    reading_.close(Status::TookTooLong);
  typedef FileReadTransfer::Send Send;
  const Send due = reading_.toSend();
  if (due == Send::Nothing || !client_.link().canSend()) return;
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
    return readByItems(plans().isCompared() ? 0 : reading_.itemToAsk(), nowMs);
  }
  const uint32_t offset = frame.payloadLong(offsetof(FileFrame, offset));
  switch (requested) {
    case MAV_FTP_OPCODE_OPENFILERO: return reading_.onOpened(nowMs, client_.link().pace());
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
      type != static_cast<uint8_t>(plans().planType()) || !reading_.onCount(count, nowMs, client_.link().pace())) {
    return;
  }
  if (isLook_) return reading_.close(Status::Downloaded);
  const Status taken = plans().takeCount(count);
  if (taken != Status::Transferring) reading_.close(taken);
}

void PlanFiles::takeItem(const FrameParser& frame, uint16_t number, uint16_t nowMs) {
  if (!reading_.wants(number)) return reading_.onUnused(nowMs);
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
  piece.item.frame = static_cast<CoordinateFrame>(frameNumber);
  piece.item.current = 0;  // the file has it by another rule than the protocol
  piece.item.autocontinue = autocontinue;
  dropLeftOvers(piece.item, plans().plan().keeper());
  const Status taken = plans().takeItem(number, piece.item);
  if (taken == Status::Checking) return;
  if (taken != Status::Transferring) return reading_.close(taken);
  reading_.onItem(number, nowMs, client_.link().pace());
  plans().progress(reading_.itemsTaken());
}

// Goes over to the mission protocol, from this item on.
void PlanFiles::readByItems(uint16_t first, uint16_t nowMs) {
  if (isLook_ || isWholeLook_) return onRead_(*this, Status::NoAnswer, nowMs);
  if (onRead_ != nullptr) return proveByItems(nowMs);
  isByFile_ = false;
  plans().readByItems(first, nowMs);
}

void PlanFiles::endReading(Status status, uint16_t nowMs) {
  plans().keepTimeFree(false);
  if (onRead_ != nullptr) return onRead_(*this, status, nowMs);
  if (status == Status::Downloaded && plans().isCompared()) return plans().endAsOurs(Status::Verified);
  if (status == Status::Differs) plans().nowAboard(Aboard::NotKnown);
  client_.end(status);
}

}  // namespace mavmission
