// MissionClient's back-off while another ground station transfers. A file of its own, since not every sketch wants it.
#include <Arduino.h>

#include "../MissionClient.h"

namespace mavmission {
using namespace detail;

void MissionClient::retryWhenBusy(uint16_t seconds) {
  rest_.turnLimitS = seconds;
  rest_.denied = seconds != 0 ? waitForTurn : nullptr;
  rest_.takeUp = takeUpEnd;
}

// Begins the back-off after a refusal of COUNT; false if the time allowed is over.
bool Client::waitForTurn(Client& client, Status refusal) {
  State& state = client.state_;
  if (refusal != Status::Denied && !(refusal == Status::Error && has(client.firmware(), kSaysErrorWhenBusy)))
    return false;
  if (client.rest_.turnPauseS == 0) client.beginSeconds(static_cast<uint16_t>(millis()));
  client.rest_.turnPauseS = client.rest_.turnPauseS == 0   ? 1
                            : client.rest_.turnPauseS >= 8 ? 8
                                                           : 2 * client.rest_.turnPauseS;
  if (state.seconds + client.rest_.turnPauseS > client.rest_.turnLimitS) return false;
  client.state_.turnAtS = state.seconds + client.rest_.turnPauseS;
  state.status = Status::BackingOff;
  state.operation = turnStep;
  return true;
}

void Client::turnStep(Client& client, const FrameParser* frame, uint16_t) {
  State& state = client.state_;
  if (frame != nullptr || state.seconds < client.state_.turnAtS) return;
  state.operation = uploadStep;
  state.status = Status::WaitingForAutopilot;  // it may be armed, or lost, by now: from the start
}

}  // namespace mavmission
