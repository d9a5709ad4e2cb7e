// MissionClient's clear().
#include <Arduino.h>

#include "../MissionClient.h"
#include "../base/Clock.h"
#include "../link/Messages.h"
#include "../link/Sending.h"

namespace mavmission {
using namespace detail;

namespace {
constexpr uint8_t kLossyTries = 40;  // CLEAR_ALLs on a line that loses
}

Status MissionClient::clear(PlanType type) {
  if (state_.operation != nullptr) return Status::Busy;
  state_.type = type;
  startOperation(clearStep);
  return state_.status;
}

void Client::clearStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  State& state = client.state_;
  Clearing& clearing = client.clearing_;
  if (frame != nullptr) {
    if (state.status != Status::Transferring || frame->messageId() != MAVLINK_MSG_ID_MISSION_ACK) return;
    const mavlink_mission_ack_t ack = messageFrom<mavlink_mission_ack_t>(*frame);
    if (ack.mission_type != static_cast<uint8_t>(clearing.type) || clearing.tries == 0) return;
    client.rest_.lastResult = ack.type;
    const Status status = fromMissionResult(ack.type);
    if (status != Status::Accepted) return client.endClearing(status);
    client.setAboard(clearing.type, Aboard::Nothing);
    if (clearing.type == clearing.last) return client.endClearing(Status::Cleared);
    // All three, one by one: ArduPilot does not know the type for all.
    clearing.type = static_cast<PlanType>(static_cast<uint8_t>(clearing.type) + 1);
    clearing.tries = 0;
    clearing.isDue = true;
    return;
  }
  if (state.status == Status::WaitingForAutopilot) {
    client.waitForAutopilot();
    if (state.status != Status::Checking) return;
    if (!client.isTypeCarried()) return client.end(Status::NeedsMavlink2);
    if (client.isArmed() && !client.rest_.armedAllowed) return client.end(Status::Armed);
    const bool isAll = state.type == PlanType::All;
    clearing.type = isAll ? PlanType::Mission : state.type;
    clearing.last = isAll ? PlanType::Rally : state.type;
    clearing.tries = 0;
    clearing.isDue = true;
    state.status = Status::Transferring;
  }
  const Pace& pace = client.link_.pace();
  if (!clearing.isDue &&
      since(clearing.sentMs, nowMs) >= (pace.isLossy() ? pace.againMs() : UploadTransfer::kAnswerMs)) {
    if (clearing.tries >= (pace.isLossy() ? kLossyTries : UploadTransfer::kTries))
      return client.endClearing(Status::NoAnswer);
    clearing.isDue = true;
  }
  // An answer to a transfer that was left open may still be on its way, and would look like the answer to this.
  const bool mayBeAnswered = (state.unsettled & UploadTransfer::kAnswers) != 0;
  if (clearing.tries == 0 && mayBeAnswered && since(state.unsettledMs, nowMs) < UploadTransfer::kAnswerMs) return;
  if (!clearing.isDue || !client.link_.canSend()) return;
  clearing.isDue = false;
  ++clearing.tries;
  clearing.sentMs = nowMs;
  mavlink_mission_clear_all_t message = mavlink_mission_clear_all_t();
  message.mission_type = static_cast<uint8_t>(clearing.type);
  client.link_.send(message);
}

void Client::endClearing(Status status) {
  // A refusal leaves the plan; silence may hide an answer that was lost.
  if (status == Status::NoAnswer) setAboard(clearing_.type, Aboard::NotKnown);
  end(status);
}

}  // namespace mavmission
