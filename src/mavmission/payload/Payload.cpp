// Payload: what becomes of a command, in one of four records.
//
//         COMMAND_LONG to us         update() calls the function         repeats may come no more
//   None -------------------> Come ------------------------------> Answered ----------------------> None
//                               |                                     ^
//                               |  it returns InProgress              |  finish()
//                               +-----------------> InProgress -------+
//                                                   tells its progress once a second
//
// A repeat (COMMAND_LONG.confirmation is not 0) of a command that has a record gets the answer of the record.
#include "Payload.h"

#include <Arduino.h>
#include <string.h>

#include "../base/Checksum.h"
#include "../base/Clock.h"
#include "../base/Flash.h"
#include "../client/Port.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;
namespace {

const MessageKey kCommands[] PROGMEM = {
    MAVMISSION_MESSAGE_KEY(COMMAND_LONG, offsetof(mavlink_command_long_t, target_system))};
// The answer goes to whoever has sent the command: its targets are not the autopilot's.
const MessageKey kAnswer PROGMEM = MAVMISSION_LISTENER_KEY(COMMAND_ACK);

}  // namespace

Payload::Payload(MissionClient& client, PayloadFunction function, void* context)
    : Listener(client, kCommands, 1, take), function_(function), context_(context) {
  memset(&command_, 0, sizeof(command_));
  memset(records_, 0, sizeof(records_));
}

void Payload::take(Listener& listener, const FrameParser& frame) {
  Payload& self = static_cast<Payload&>(listener);
  const Link& link = self.client_.link();
  // What finds no place is not answered, and so repeated by its sender.
  if (!frame.isFor(link.systemId(), link.componentId()) || self.find(State::Come) != nullptr) return;
  const mavlink_command_long_t message = messageFrom<mavlink_command_long_t>(frame);
  PayloadCommand& command = self.command_;
  static_assert(offsetof(mavlink_command_long_t, param1) == 0 &&
                    offsetof(mavlink_command_long_t, param7) == sizeof(command.param) - sizeof(command.param[0]),
                "the seven parameters must lie one after the other");
  memcpy(command.param, &message, sizeof(command.param));
  command.id = message.command;
  command.systemId = frame.systemId();
  command.componentId = frame.componentId();
  command.isForAll = message.target_component == 0;
  self.put(message.confirmation != 0, static_cast<uint16_t>(millis()));
}

// Makes a record of the command, which update() looks at. A sender without an answer repeats its command and counts
// `confirmation` up: it must not be carried out twice.
void Payload::put(bool isRepeat, uint16_t nowMs) {
  const uint16_t sum =
      checksum(kChecksumStart, reinterpret_cast<const uint8_t*>(command_.param), sizeof(command_.param));
  Record* place = nullptr;
  for (Record& record : records_) {
    const bool isSame = record.state != State::None && record.id == command_.id && record.sum == sum &&
                        record.systemId == command_.systemId && record.componentId == command_.componentId;
    if (isSame && isRepeat) {
      record.isDue = true;
      return;
    }
    // An empty one is better than one whose command may be repeated, and of these the older one.
    if (record.state == State::None) {
      if (place == nullptr || place->state != State::None) place = &record;
    } else if (record.state == State::Answered && !record.isDue &&
               (place == nullptr ||
                (place->state != State::None && since(record.changedMs, nowMs) > since(place->changedMs, nowMs)))) {
      place = &record;
    }
  }
  if (place == nullptr) return;
  place->id = command_.id;
  place->sum = sum;
  place->systemId = command_.systemId;
  place->componentId = command_.componentId;
  place->isForAll = command_.isForAll;
  place->state = State::Come;
  place->isDue = false;
}

Payload::Record* Payload::find(State state) {
  for (Record& record : records_) {
    if (record.state == state) return &record;
  }
  return nullptr;
}

bool Payload::isBusy() const { return const_cast<Payload*>(this)->find(State::InProgress) != nullptr; }

void Payload::update() {
  const uint16_t nowMs = static_cast<uint16_t>(millis());
  for (Record& record : records_) work(record, nowMs);
}

void Payload::work(Record& record, uint16_t nowMs) {
  const uint16_t elapsedMs = since(record.changedMs, nowMs);
  switch (record.state) {
    case State::None: return;
    case State::Come: {
      const bool wasBusy = isBusy();
      record.answer = function_ != nullptr ? function_(context_, command_) : PayloadAnswer::Unsupported;
      if (record.answer == PayloadAnswer::InProgress && wasBusy) record.answer = PayloadAnswer::Rejected;
      record.state = record.answer == PayloadAnswer::InProgress ? State::InProgress : State::Answered;
      if (record.state == State::InProgress) percent_ = 0;
      record.changedMs = nowMs;
      record.isDue = true;
      break;
    }
    case State::InProgress:
      if (elapsedMs < PayloadRules::kProgressMs) break;
      record.changedMs = nowMs;
      record.isDue = true;
      break;
    case State::Answered:
      // Later a repeat would be another command, whose first copy was lost.
      if (elapsedMs >= PayloadRules::kRepeatsMs && !record.isDue) record.state = State::None;
      break;
  }
  if (!record.isDue) return;
  const bool isSilent = record.isForAll && record.answer == PayloadAnswer::Unsupported;
  if (!isSilent && !client_.link().canSend()) return;
  record.isDue = false;
  if (!isSilent) answer(record);
}

void Payload::finish(PayloadAnswer answer) {
  Record* const record = find(State::InProgress);
  if (record == nullptr || answer == PayloadAnswer::InProgress) return;
  record->answer = answer;
  record->state = State::Answered;
  record->changedMs = static_cast<uint16_t>(millis());
  record->isDue = true;
}

void Payload::answer(const Record& record) {
  mavlink_command_ack_t message = mavlink_command_ack_t();
  message.command = record.id;
  message.result = static_cast<uint8_t>(record.answer);
  if (record.answer == PayloadAnswer::InProgress) message.progress = percent_;
  message.target_system = record.systemId;
  message.target_component = record.componentId;
  client_.link().send(&message, kAnswer);
}

}  // namespace mavmission
