// What all operations of PlanFiles share: the requests, the replies, and the file that was left open.
#include "PlanFiles.h"

#include <Arduino.h>
#include <string.h>

#include "../base/Flash.h"
#include "../client/PlanPort.h"
#include "FileFrame.h"

namespace mavmission {
using namespace detail;
const MessageKey detail::kKeysOfFiles[] PROGMEM = {
    // As long as the longest request that is made in the outbox. A reply in MAVLink 1 is longer than the parser keeps.
    {MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL, MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL_CRC,
     MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL_MIN_LEN, Outbox::kMaxPayload,
     offsetof(mavlink_file_transfer_protocol_t, target_system)},
    MAVMISSION_LISTENER_KEY(HEARTBEAT),
};

namespace {

const char kNames[][21] PROGMEM = {"@MISSION/mission.dat", "@MISSION/fence.dat", "@MISSION/rally.dat"};

}  // namespace

PlanFiles::PlanFiles(MissionClient& client)
    : Listener(client, kKeysOfFiles, 2, take),
      operation_(nullptr),
      onRead_(nullptr),
      sequence_(0),
      firstSequence_(0),
      session_(0),
      closings_(FileRules::kUnsureClosings),
      isByFile_(false),
      isForeseen_(false),
      isLook_(false),
      isEnsuring_(false),
      isWholeLook_(false),
      isLengthKnown_(false),
      isStorable_(true),
      isDamaged_(false),
      isWithdrawing_(false) {}

PlanPort& PlanFiles::plans() const { return client_.plans(); }

// After this the client goes on by this operation.
void PlanFiles::beginOperation(Step operation) {
  operation_ = operation;
  onRead_ = nullptr;
  isByFile_ = false;
  isLook_ = false;
  isEnsuring_ = false;
  isWholeLook_ = false;
  isLengthKnown_ = false;
}

bool PlanFiles::isRunning() const { return operation_ != nullptr && client_.runs(operation_); }

// True if the plan may be transferred by file. A piece of a file is as long as an item, and must fit into the parser.
bool PlanFiles::isUsable() const {
  return FileFrame::kItem <= MAVMISSION_MAX_PAYLOAD && has(client_.autopilot().firmware(), kHasPlanFiles) &&
         !client_.link().speaksV1();
}

// There is one file for the whole autopilot, and whoever has its session number writes into it. So the number is made
// of our ids, which nobody else has; low numbers are those of ground stations. After a reset it is the same again: a
// file that was left open can be closed then. ArduPilot answers a request from memory if it has the number of the last
// one: so the numbers begin elsewhere each time.
void PlanFiles::takeNumbers() {
  if (session_ != 0) return;
  session_ = static_cast<uint8_t>(client_.link().systemId() * 31) ^ client_.link().componentId() ^ 0x5A;
  if (session_ < 16) session_ += 16;
  firstSequence_ = sequence_ = static_cast<uint16_t>(millis()) * 40503u;
}

void PlanFiles::beginFile() {
  takeNumbers();
  firstSequence_ = ++sequence_;  // unused: the answer to the last request of the operation before would have it
  isByFile_ = true;
  isWithdrawing_ = false;
}

// Sends a request. ArduPilot answers one that has the number of the last one from memory.
void PlanFiles::send(uint16_t sequence, uint8_t opcode, uint8_t size, uint32_t offset) {
  FileFrame& request = *static_cast<FileFrame*>(client_.link().draft());
  request.network = 0;
  request.sequence = sequence;
  request.session = session_;
  request.opcode = opcode;
  request.size = size;
  request.requested = 0;
  request.isBurstComplete = 0;
  request.padding = 0;
  request.offset = offset;
  // Only these carry data; otherwise the size is that of the answer.
  const bool hasData =
      opcode == MAV_FTP_OPCODE_OPENFILERO || opcode == MAV_FTP_OPCODE_CREATEFILE || opcode == MAV_FTP_OPCODE_WRITEFILE;
  const uint8_t used = hasData ? size : 0;
  memset(request.data + used, 0, sizeof(request.data) - used);
  client_.link().sendMessage(&request.network, kKeysOfFiles);
}

void PlanFiles::sendOpening(uint16_t sequence, uint8_t opcode) {
  FileFrame& request = *static_cast<FileFrame*>(client_.link().draft());
  static_assert(sizeof(kNames[0]) <= sizeof(request.data), "the longest name must fit into a request");
  memcpy_P(request.data, kNames[static_cast<uint8_t>(plans().planType())], sizeof(kNames[0]));
  send(sequence, opcode, static_cast<uint8_t>(strlen(reinterpret_cast<const char*>(request.data))));
  if (closings_ == 0) closings_ = FileRules::kUnsureClosings;
}

bool PlanFiles::isReply(const FrameParser& frame) const {
  return frame.messageId() == MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL &&
         frame.payloadByte(offsetof(FileFrame, session)) == session_ &&
         static_cast<int16_t>(frame.payloadWord(offsetof(FileFrame, sequence)) - firstSequence_) > 0;
}

// Notes whether the file is open. A file that was left open is closed beside whatever runs: once with each heartbeat of
// the autopilot, until it answers.
void PlanFiles::take(Listener& listener, const FrameParser& frame) {
  PlanFiles& self = static_cast<PlanFiles&>(listener);
  Port& client = self.client_;
  if (!self.isFromAutopilot(frame)) return;
  if (frame.messageId() == MAVLINK_MSG_ID_HEARTBEAT) {
    if (self.closings_ == 0 || self.isRunning() || !client.link().canSend()) return;
    // One that was left open before a reset: to look for it may store a plan that somebody else has left open.
    const bool isOfBefore = self.isStorable_ && self.closings_ != kUntilClosed;
    if (!isOfBefore || (self.isUsable() && !client.autopilot().isArmed())) self.closeLeftOpen();
    return;
  }
  if (!frame.isFor(client.link().systemId(), client.link().componentId()) || !self.isReply(frame)) return;
  const bool isAck = frame.payloadByte(offsetof(FileFrame, opcode)) == MAV_FTP_OPCODE_ACK;
  // Else it may be a copy that the line has made of an answer before.
  const bool isLast = static_cast<uint16_t>(self.sequence_ + 1) == frame.payloadWord(offsetof(FileFrame, sequence));
  switch (frame.payloadByte(offsetof(FileFrame, requested))) {
    case MAV_FTP_OPCODE_OPENFILERO:
    case MAV_FTP_OPCODE_CREATEFILE:
      if (!isAck) break;
      self.closings_ = kUntilClosed;
      // It is empty, or open for reading; after a copy that has come late, copies of the writes may have come too.
      self.isStorable_ = !isLast;
      break;
    case MAV_FTP_OPCODE_TERMINATESESSION:
      self.closings_ = 0;
      self.isStorable_ = false;
      break;
    case MAV_FTP_OPCODE_WRITEFILE:
      if (!self.isWithdrawing_ || !isLast) break;
      self.isStorable_ = false;  // a refusal too: it is open for reading by now
      self.closings_ = kUntilClosed;
      break;
    default: break;
  }
  if (isAck) return;
  const uint8_t error = frame.payloadByte(offsetof(FileFrame, data));
  // It is somebody else's file that is open, or none. To close it all the same would hand that file to the next client
  // that asks.
  if (error != MAV_FTP_ERR_INVALIDSESSION && error != MAV_FTP_ERR_FILENOTFOUND) return;
  self.closings_ = 0;
  self.isStorable_ = false;
}

// A plan that is complete in its file would be stored now, after the end of its upload, and perhaps over another plan
// that has been uploaded meanwhile. So its header is withdrawn first; after the answer the next heartbeat closes it.
void PlanFiles::closeLeftOpen() {
  takeNumbers();
  if (closings_ != kUntilClosed) --closings_;
  if (!isStorable_) return send(++sequence_, MAV_FTP_OPCODE_TERMINATESESSION);
  if (closings_ == 0) {  // nobody answers: what is closed next is what an operation may have opened since
    isStorable_ = false;
    if (operation_ != nullptr) closings_ = FileRules::kUnsureClosings;
  }
  memset(static_cast<FileFrame*>(client_.link().draft())->data, 0, kFileHeader);
  isWithdrawing_ = true;
  send(++sequence_, MAV_FTP_OPCODE_WRITEFILE, kFileHeader);
}

}  // namespace mavmission
