// MissionClient's clear().
#include <Arduino.h>

#include "../MissionClient.h"
#include "../base/Clock.h"
#include "../link/Messages.h"
#include "../link/Sending.h"
#include "Clearing.h"

namespace mavmission {
using namespace detail;

Status MissionClient::clear(PlanType type) {
  if (state_.operation != nullptr) return Status::Busy;
  state_.type = type;
  startOperation(Clearing::step);
  return state_.status;
}

bool Client::Clearing::begin(Client& client, uint16_t) {
  Status hindrance = Status::NeedsMavlink2;
  if (client.isTypeCarried()) {
    if (!client.isArmed() || client.state_.armedAllowed) {
      client.clearing_.begin(client.state_.type);
      client.state_.status = Status::Transferring;
      return true;
    }
    hindrance = Status::Armed;
  }
  client.end(hindrance);
  return false;
}

void Client::Clearing::frame(Client& client, const FrameParser& frame, uint16_t) {
  ClearTransfer& clearing = client.clearing_;
  if (frame.messageId() != MAVLINK_MSG_ID_MISSION_ACK) return;
  const mavlink_mission_ack_t ack = messageFrom<mavlink_mission_ack_t>(frame);
  if (ack.mission_type != static_cast<uint8_t>(clearing.type()) || !clearing.hasBeenSent()) return;
  client.state_.lastResult = ack.type;
  Status status = fromMissionResult(ack.type);
  if (status == Status::Accepted) {
    client.setAboard(clearing.type(), Aboard::Nothing);
    status = clearing.onAccepted();
  }
  // ArduPilot gives up an upload that was left open, 8 s later: that is no answer to this.
  const bool isOlder =
      status == Status::CancelledByAutopilot && (client.state_.unsettled & UploadTransfer::kAnswers) != 0;
  if (status != Status::Transferring && !isOlder) end(client, status);
}

void Client::Clearing::time(Client& client, uint16_t nowMs) {
  const State& state = client.state_;
  ClearTransfer& clearing = client.clearing_;
  const Status status = clearing.onTime(nowMs, client.link_.pace());
  if (status != Status::Transferring) return end(client, status);
  // An answer to a transfer that was left open may still be on its way, and would look like the answer to this.
  const bool mayBeAnswered = (state.unsettled & UploadTransfer::kAnswers) != 0 && !clearing.hasBeenSent();
  if (mayBeAnswered && since(state.unsettledMs, nowMs) < ClearTransfer::kAnswerMs) return;
  if (clearing.state() != ClearTransfer::State::Due || !client.link_.canSend()) return;
  clearing.sent(nowMs);
  client.noteSent(clearing.tries());
  client.sendShort(KeyIndex::MISSION_CLEAR_ALL, 0, clearing.type());
}

void Client::Clearing::step(Client& client, const FrameParser* frame, uint16_t nowMs) {
  operate<Clearing>(client, frame, nowMs);
}

void Client::Clearing::end(Client& client, Status status) {
  // A refusal leaves the plan; silence may hide an answer that was lost.
  if (status == Status::NoAnswer) client.setAboard(client.clearing_.type(), Aboard::NotKnown);
  client.end(status);
}

}  // namespace mavmission
