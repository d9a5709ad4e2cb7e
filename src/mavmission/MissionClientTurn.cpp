// MissionClient waiting for its turn while another ground station transfers; apart because not every sketch wants it.
#include <Arduino.h>

#include "MissionClient.h"

namespace mavmission {

void MissionClient::retryWhenDenied(uint16_t seconds) {
  state_.turnLimitS = seconds;
  state_.denied = seconds != 0 ? waitForTurn : nullptr;
}

// Takes up a refusal of COUNT; false if the time allowed is over.
bool MissionClient::waitForTurn(MissionClient& client, Status refusal) {
  State& state = client.state_;
  if (refusal != Status::Denied && !(refusal == Status::Error && client.firmware() == Firmware::Px4)) return false;
  if (state.turnPauseS == 0) client.beginSeconds(static_cast<uint16_t>(millis()));
  state.turnPauseS = state.turnPauseS == 0 ? 1 : state.turnPauseS >= 8 ? 8 : 2 * state.turnPauseS;
  if (state.seconds + state.turnPauseS > state.turnLimitS) return false;
  state.turnAtS = state.seconds + state.turnPauseS;
  state.status = Status::WaitingForTurn;
  state.operation = turnStep;
  return true;
}

void MissionClient::turnStep(MissionClient& client, const FrameParser* frame, uint16_t) {
  State& state = client.state_;
  if (frame != nullptr || state.seconds < state.turnAtS) return;
  state.operation = uploadStep;
  state.status = Status::WaitingForAutopilot;  // it may have been armed, or lost, meanwhile: from the start
}

}  // namespace mavmission
