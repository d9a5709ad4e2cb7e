// MissionClient's back-off while another ground station transfers. A file of its own, since not every sketch wants it.
#include <Arduino.h>

#include "MissionClient.h"
#include "Uploading.h"

namespace mavmission {
using namespace detail;

struct Client::BackingOff {
  static bool begin(Client& client, Status refusal);
  static void step(Client& client, const FrameParser* frame, uint16_t nowMs);
};

void MissionClient::retryWhenBusy(uint16_t seconds) {
  session_.backOffLimitS = seconds;
  session_.options.backOff = seconds != 0 ? BackingOff::begin : nullptr;
  if (session_.options.goOn == nullptr) session_.options.goOn = Uploading::backsOff;
  session_.options.continueAfter = Uploading::continueAfter;
}

// Begins the back-off after a refusal of COUNT; false if the time allowed is over.
bool Client::BackingOff::begin(Client& client, Status refusal) {
  State& state = client.state_;
  if (refusal != Status::Denied && !(refusal == Status::Error && has(client.firmware(), kSaysErrorWhenBusy)))
    return false;
  if (client.session_.backOffPauseS == 0) client.beginSeconds(static_cast<uint16_t>(millis()));
  client.session_.backOffPauseS = client.session_.backOffPauseS == 0 ? BackOffRules::kFirstS
                                  : client.session_.backOffPauseS >= BackOffRules::kMostS
                                      ? BackOffRules::kMostS
                                      : 2 * client.session_.backOffPauseS;
  if (state.seconds + client.session_.backOffPauseS > client.session_.backOffLimitS) return false;
  client.state_.limitFromS = state.seconds + client.session_.backOffPauseS;
  state.status = Status::BackingOff;
  state.operation = step;
  return true;
}

void Client::BackingOff::step(Client& client, const FrameParser* frame, uint16_t) {
  State& state = client.state_;
  if (frame != nullptr || state.seconds < state.limitFromS) return;
  state.operation = Uploading::step;
  state.isLate = false;
  state.unsettled &= kFromOpen | kFromBusy;    // what is answered late was asked for the same plan
  state.status = Status::WaitingForAutopilot;  // it may be armed, or lost, by now: from the start
}

}  // namespace mavmission
