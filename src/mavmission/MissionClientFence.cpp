// MissionClient putting a plan of any type aboard; apart because of what only a fence needs.
#include "Messages.h"
#include "MissionClient.h"

namespace mavmission {

// ArduPilot now and then accepts a fence of one item in the place of a longer one, and holds none then. So a fence of one
// item is always read back, and goes out once more when there is none. That has always helped: then it replaces nothing.
Status MissionClient::upload(const ItemSource& plan, PlanType type, Proof proof) {
  const bool isDoubtful = type == PlanType::Fence && plan.count == 1;
  const Status status = uploadProven(plan, type, isDoubtful ? Proof::Always : proof);
  if (isDoubtful && !isEnd(status)) rest_.prove = proveFence;
  return status;
}

void MissionClient::proveFence(MissionClient& client, uint16_t nowMs) {
  proveUpload(client, nowMs);
  client.state_.operation = fenceStep;
}

// The same behind the second upload: what it says then is so.
void MissionClient::proveFenceAgain(MissionClient& client, uint16_t nowMs) {
  proveUpload(client, nowMs);
  client.rest_.prove = proveFence;  // of the next uploadAgain()
}

void MissionClient::fenceStep(MissionClient& client, const FrameParser* frame, uint16_t nowMs) {
  typedef mavlink_mission_count_t Count;
  const bool isNone = frame != nullptr && frame->messageId() == MAVLINK_MSG_ID_MISSION_COUNT &&
                      client.reading_.transfer.expectsAnswer(DownloadTransfer::State::Listing) &&
                      frame->payloadByte(offsetof(Count, mission_type)) == static_cast<uint8_t>(PlanType::Fence) &&
                      frame->payloadWord(offsetof(Count, count)) == 0;
  if (!isNone || client.plan_.firmware() != Firmware::ArduPilot) return readStep(client, frame, nowMs);
  client.rest_.proving = false;
  client.rest_.prove = proveFenceAgain;
  client.state_.operation = uploadStep;
  client.beginUpload(nowMs);
}

}  // namespace mavmission
