// MissionClient's clear().
#include <Arduino.h>

#include "../base/Clock.h"
#include "../link/Messages.h"
#include "../link/Sending.h"
#include "Clearing.h"
#include "MissionClient.h"

namespace mavmission {
using namespace detail;

Status MissionClient::clear(PlanType type) {
  if (state_.operation != nullptr) return Status::Busy;
  state_.type = type;
  startOperation(Clearing::step);
  return state_.status;
}

bool Client::Clearing::begin(Client& client, uint16_t nowMs) {
  if (!client.isTypeCarried()) {
    client.end(Status::NeedsMavlink2);
    return false;
  }
  const State& state = client.state_;
  // Then the acceptance of something before may come, and look like the one of this.
  const bool isDoubtful = (state.unsettled & (kFromOpen | kFromBefore)) != 0;
  client.clearing_.begin(state.type, isDoubtful);
  client.beginTransferring(nowMs);
  return true;
}

void Client::Clearing::frame(Client& client, const FrameParser& frame, uint16_t) {
  ClearTransfer& clearing = client.clearing_;
  if (!clearing.hasBeenSent()) return;
  switch (frame.messageId()) {
    case MAVLINK_MSG_ID_MISSION_COUNT: return takeCount(client, messageFrom<mavlink_mission_count_t>(frame));
    case MAVLINK_MSG_ID_MISSION_ACK: return takeAck(client, messageFrom<mavlink_mission_ack_t>(frame));
    default: return;
  }
}

void Client::Clearing::takeCount(Client& client, const mavlink_mission_count_t& count) {
  ClearTransfer& clearing = client.clearing_;
  if (!clearing.isAsking() || count.mission_type != static_cast<uint8_t>(clearing.type())) return;
  client.tellCancelled(clearing.type());  // otherwise PX4 would wait for our requests for 5 s
  ItemNumbers numbers;
  numbers.begin(client.firmware(), clearing.type(), false);
  if (clearing.onCount(numbers.isCountOf(0, count.count))) takeCleared(client);
}

void Client::Clearing::takeAck(Client& client, const mavlink_mission_ack_t& ack) {
  ClearTransfer& clearing = client.clearing_;
  if (clearing.isAsking() || ack.mission_type != static_cast<uint8_t>(clearing.type())) return;
  client.state_.lastResult = ack.type;
  const Status status = fromMissionResult(ack.type);
  if (status == Status::Accepted) return clearing.onAccepted() ? takeCleared(client) : void();
  const bool mayBeOlder = (client.state_.unsettled & kFromOpen) != 0;
  // ArduPilot gives up an upload that was left open, 8 s later: that is no answer to this.
  if (status == Status::CancelledByAutopilot && mayBeOlder) return;
  // A refusal of the only MISSION_CLEAR_ALL leaves the plan. Of several the first may have been carried out.
  if (clearing.tries() == 1 && !mayBeOlder) client.setAboard(clearing.type(), clearing.aboardBefore());
  client.end(status);
}

// There is no plan of this type.
void Client::Clearing::takeCleared(Client& client) {
  client.setAboard(client.clearing_.type(), Aboard::Nothing);
  if (!client.clearing_.next()) client.end(Status::Cleared);
}

void Client::Clearing::time(Client& client, uint16_t nowMs) {
  const State& state = client.state_;
  ClearTransfer& clearing = client.clearing_;
  const Status status = state.isLate ? Status::TookTooLong : clearing.onTime(nowMs, client.link_.pace());
  if (status != Status::Transferring) return client.end(status);
  // An answer to a transfer that was left open may still be on its way, and would look like the answer to this.
  const bool mayBeAnswered = (state.unsettled & kFromOpen) != 0 && !clearing.hasBeenSent();
  if (mayBeAnswered && since(state.unsettledMs, nowMs) < ClearTransfer::kAnswerMs) return;
  if (clearing.state() != ClearTransfer::State::Due || !client.link_.canSend()) return;
  KeyIndex message = KeyIndex::MISSION_REQUEST_LIST;
  if (!clearing.isAsking()) {
    // (It may have been armed since the last one.)
    if (client.isArmed() && !state.armedAllowed) return client.end(Status::Armed);
    message = KeyIndex::MISSION_CLEAR_ALL;
    // From now on it is not known what is aboard, until an answer says it.
    if (!clearing.hasBeenSent()) clearing.setAboardBefore(client.aboard(clearing.type()));
    client.setAboard(clearing.type(), Aboard::NotKnown);
  }
  if (clearing.isAsking()) client.expectAnswers(kFromBusy);  // PX4 may be left waiting for our requests
  clearing.sent(nowMs);
  client.noteSent(clearing.tries());
  client.sendShort(message, 0, clearing.type());
}

void Client::Clearing::step(Client& client, const FrameParser* frame, uint16_t nowMs) {
  operate<Clearing>(client, frame, nowMs);
}

}  // namespace mavmission
