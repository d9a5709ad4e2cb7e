// MissionClient's upload of a plan of any type. A file of its own, since only a fence needs this.
#include "../MissionClient.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;
namespace {

// ArduPilot accepts a fence of fewer than three corners or circles in the place of a longer one, gives it back when it
// is read at once, and wipes it when it next looks at its fence: 3 to 25 times a second, by vehicle. A return point is
// neither a corner nor a circle, so such a fence has at most three items [items].
constexpr uint8_t kShortFence = 3;
// The time from the acceptance of such a fence to its read-back [s].
constexpr uint8_t kFenceSettleS = 1;

}  // namespace

// A short fence is always read back, and uploaded again if it is gone: then it replaces no longer fence, and stays.
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

// The same after the second upload, which is the last.
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
  client.rest_.prove = proveFence;  // for the next uploadAgain()
}

void Client::fenceStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  typedef mavlink_mission_count_t Count;
  const bool isNone = frame != nullptr && frame->messageId() == MAVLINK_MSG_ID_MISSION_COUNT &&
                      client.reading_.transfer.expectsAnswer(DownloadTransfer::State::Listing) &&
                      frame->payloadByte(offsetof(Count, mission_type)) == static_cast<uint8_t>(PlanType::Fence) &&
                      frame->payloadWord(offsetof(Count, count)) == 0;
  if (!isNone || !client.plan_.has(kWipesShortFences)) return readStep(client, frame, nowMs);
  client.rest_.proving = false;
  client.rest_.prove = proveFenceAgain;
  client.state_.operation = uploadStep;
  client.beginUpload(nowMs);
}

}  // namespace mavmission
