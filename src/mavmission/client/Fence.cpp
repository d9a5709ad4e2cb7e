// MissionClient's upload of a plan of any type. A file of its own, since only fences and rally points need the steps
// below.
#include "../link/Messages.h"
#include "Ensuring.h"
#include "MissionClient.h"
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

// The check before an upload, which then goes on as that of a mission does.
struct Client::CheckingAreas : OperationParts {
  static bool begin(Client& client, uint16_t) {
    client.beginChecking();
    return true;
  }
  static void time(Client& client, uint16_t nowMs) {
    for (uint8_t read = 0; read < MAVMISSION_ITEMS_PER_UPDATE; ++read) {
      const Status checked = client.checkNextOfAny();
      if (checked == Status::Transferring) {
        client.state_.operation = Uploading::step;
        return Uploading::begin(client, nowMs);
      }
      if (checked != Status::Accepted) return;
    }
  }
  static void step(Client& client, const FrameParser* frame, uint16_t nowMs) {
    operate<CheckingAreas>(client, frame, nowMs);
  }
};

// The same before the look of ensure().
struct Client::EnsuringAreas : OperationParts {
  static bool begin(Client& client, uint16_t nowMs) { return Ensuring::begin(client, nowMs); }
  static void time(Client& client, uint16_t) {
    if (client.checkNextOfAny() == Status::Transferring) client.state_.operation = Ensuring::step;
  }
  static void step(Client& client, const FrameParser* frame, uint16_t nowMs) {
    operate<EnsuringAreas>(client, frame, nowMs);
  }
};

Status PlanPort::checkNextOfAny() {
  static_assert(sizeof(Areas) <= offsetof(Client::Reading, take), "it lies where a reading begins later");
  Client& client = static_cast<Client&>(*this);
  Client::State& state = client.state_;
  const Status checked = checkNext();
  if (state.type == PlanType::Mission || client.plan_.count() == 0) return checked;
  Areas& areas = client.areas_;
  Areas::Verdict verdict = {Status::BadFence, ItemField::Param1};
  uint16_t item = state.next;  // after the last item; else the one that was checked
  if (checked == Status::Accepted) {
    --item;
    if (item == 0) areas.begin(client.plan_.keeper());
    verdict = areas.take(*static_cast<const MissionItem*>(client.link_.draft()));
    if (verdict.status == Status::Accepted) return checked;
  } else if (checked != Status::Transferring || areas.unfinished() == 0) {
    return checked;
  }
  if (verdict.status == Status::BadFence) item -= areas.unfinished();
  noteFailed(item);
  client.session_.field = verdict.field;
  client.end(verdict.status);
  return Status::Checking;
}

// Only a mission has nothing that its items must make together.
Status PlanPort::checkAreas(Status status) {
  Client& client = static_cast<Client&>(*this);
  if (!isEnd(status) && client.state_.type != PlanType::Mission) client.state_.operation = Client::CheckingAreas::step;
  return status;
}

Status MissionClient::uploadWithoutReadback(const ItemSource& plan, PlanType type) {
  return checkAreas(startUpload(plan, type));
}

Status MissionClient::uploadAgain() {
  if (state_.operation == nullptr) {
    session_.announcePart = nullptr;  // the whole plan, also where a part of it was uploaded
    if (session_.options.continueAfter != nullptr)
      session_.options.continueAfter = Uploading::continueAfter;  // ensure() has one of its own
  }
  return checkAreas(uploadKeptPlan());
}

void PlanPort::ensureByItems() {
  Client& client = static_cast<Client&>(*this);
  client.beginEnsuring();
  if (client.state_.type != PlanType::Mission) client.state_.operation = Client::EnsuringAreas::step;
}

Status MissionClient::ensure(const ItemSource& plan, PlanType type, Readback proof) {
  const Status status = upload(plan, type, proof);
  if (!isEnd(status)) ensureByItems();
  return status;
}

// A short fence is always read back, and uploaded again if it was wiped: the second upload does not replace a longer
// fence, and so the short fence stays.
Status PlanPort::startUploading(const ItemSource& plan, PlanType type, Readback proof) {
  Client& client = static_cast<Client&>(*this);
  const bool isDoubtful = isShortFence(plan, type);
  const Status status = client.uploadProven(plan, type, isDoubtful ? Readback::Always : proof);
  if (isDoubtful && !isEnd(status)) client.session_.options.readBack = Client::ShortFence::prove;
  return checkAreas(status);
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
  client.session_.options.readBack = prove;  // for the next uploadAgain()
}

void Client::ShortFence::step(Client& client, const FrameParser* frame, uint16_t nowMs) {
  typedef mavlink_mission_count_t Count;
  const bool isNone = frame != nullptr && frame->messageId() == MAVLINK_MSG_ID_MISSION_COUNT &&
                      client.reading_.transfer.expectsAnswer(DownloadTransfer::State::Listing) &&
                      frame->payloadByte(offsetof(Count, mission_type)) == static_cast<uint8_t>(PlanType::Fence) &&
                      frame->payloadWord(offsetof(Count, count)) == 0;
  if (!isNone || !client.plan_.has(kWipesShortFences)) return ReadingPlan::readOn(client, frame, nowMs);
  client.state_.proving = false;
  client.session_.options.readBack = proveAgain;
  client.state_.operation = Uploading::step;
  Uploading::begin(client, nowMs);
  client.state_.isDoubtful = true;
}

}  // namespace mavmission
