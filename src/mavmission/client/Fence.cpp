// MissionClient's upload of a plan of any type. A file of its own, since only fences need the steps below.
#include "../MissionClient.h"
#include "../link/Messages.h"
#include "Reading.h"
#include "Uploading.h"

namespace mavmission {
using namespace detail;

struct Client::ShortFence {
  static void prove(Client& client, uint16_t nowMs);
  static void proveAgain(Client& client, uint16_t nowMs);
  static void settleStep(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void settleAgainStep(Client& client, const FrameParser* frame, uint16_t nowMs);
  static void step(Client& client, const FrameParser* frame, uint16_t nowMs);
};

// A short fence is always read back, and uploaded again if it was wiped: the second upload does not replace a longer
// fence, and so the short fence stays.
Status PlanPort::startUploading(const ItemSource& plan, PlanType type, Readback proof) {
  Client& client = static_cast<Client&>(*this);
  const bool isDoubtful = isShortFence(plan, type);
  const Status status = client.uploadProven(plan, type, isDoubtful ? Readback::Always : proof);
  if (isDoubtful && !isEnd(status)) client.rest_.options.readBack = Client::ShortFence::prove;
  return status;
}

bool PlanPort::isShortFence(const ItemSource& plan, PlanType type) {
  return type == PlanType::Fence && plan.count != 0 && plan.count <= Client::kShortFence;
}

Status MissionClient::upload(const ItemSource& plan, PlanType type, Readback proof) {
  return startUploading(plan, type, proof);
}

void Client::ShortFence::prove(Client& client, uint16_t nowMs) {
  client.setAboard(Aboard::NotKnown);
  client.state_.operation = settleStep;
  client.beginSeconds(nowMs);
}

// The same read-back after the second upload; there is no third upload.
void Client::ShortFence::proveAgain(Client& client, uint16_t nowMs) {
  prove(client, nowMs);
  client.state_.operation = settleAgainStep;
}

void Client::ShortFence::settleStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  if (frame != nullptr || client.state_.seconds < FenceRules::kSettleS) return;
  ReadingPlan::prove(client, nowMs);
  client.state_.operation = step;
}

void Client::ShortFence::settleAgainStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  if (frame != nullptr || client.state_.seconds < FenceRules::kSettleS) return;
  ReadingPlan::prove(client, nowMs);
  client.rest_.options.readBack = prove;  // for the next uploadAgain()
}

void Client::ShortFence::step(Client& client, const FrameParser* frame, uint16_t nowMs) {
  typedef mavlink_mission_count_t Count;
  const bool isNone = frame != nullptr && frame->messageId() == MAVLINK_MSG_ID_MISSION_COUNT &&
                      client.reading_.transfer.expectsAnswer(DownloadTransfer::State::Listing) &&
                      frame->payloadByte(offsetof(Count, mission_type)) == static_cast<uint8_t>(PlanType::Fence) &&
                      frame->payloadWord(offsetof(Count, count)) == 0;
  if (!isNone || !client.plan_.has(kWipesShortFences)) return ReadingPlan::step(client, frame, nowMs);
  client.state_.proving = false;
  client.rest_.options.readBack = proveAgain;
  client.state_.operation = Uploading::step;
  Uploading::begin(client, nowMs);
  client.transfer_.noteBegunBefore();
}

}  // namespace mavmission
