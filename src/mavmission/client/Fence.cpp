// MissionClient putting a plan of any type aboard; apart because of what only a fence needs.
#include "../MissionClient.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;
namespace {

// ArduPilot accepts a fence of fewer than three corners and circles in the place of a longer one, gives it back when it
// is read at once, and has wiped it when its fence has next been looked at: 3 to 25 times a second, by vehicle. A
// return point is neither, so the fence has at most three items [items].
constexpr uint8_t kShortFence = 3;
// From the acceptance of such a fence to its read-back [s].
constexpr uint8_t kFenceSettleS = 1;

}  // namespace

// A short fence is always read back, and sent again when there is none: then it replaces nothing, and stays.
Status MissionClient::upload(const ItemSource& plan, PlanType type, Readback proof) {
  const bool isDoubtful = type == PlanType::Fence && plan.count != 0 && plan.count <= kShortFence;
  const Status status = uploadProven(plan, type, isDoubtful ? Readback::Always : proof);
  if (isDoubtful && !isEnd(status)) rest_.prove = proveFence;
  return status;
}

void Client::proveFence(Client& client, uint16_t nowMs) {
  client.setAboard(Aboard::NotKnown);
  client.state_.operation = fenceSettleStep;
  client.beginSeconds(nowMs);
}

// The same behind the second upload, which is the last.
void Client::proveFenceAgain(Client& client, uint16_t nowMs) {
  proveFence(client, nowMs);
  client.state_.operation = fenceSettleAgainStep;
}

void Client::fenceSettleStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  if (frame != nullptr || client.state_.seconds < kFenceSettleS) return;
  proveUpload(client, nowMs);
  client.state_.operation = fenceStep;
}

void Client::fenceSettleAgainStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  if (frame != nullptr || client.state_.seconds < kFenceSettleS) return;
  proveUpload(client, nowMs);
  client.rest_.prove = proveFence;  // of the next uploadAgain()
}

void Client::fenceStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
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
