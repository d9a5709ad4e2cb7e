// PlanFiles' ensure(): the plan aboard is read as a file and compared; where it is another one it is replaced.
//
//   WaitingForAutopilot -> Checking -> the look (PlanFilesReading.cpp) -----> AlreadyAboard
//        |                    |          |   |  another plan is aboard
//        |                    |          |   +--> the upload (PlanFilesWriting.cpp); Armed, if it is armed by now
//        |  no files, armed,  |          |  no answer, or a refusal
//        +- or a lossy line --+----------+--> MissionClient::ensure()
#include "../MissionClient.h"
#include "../PlanFiles.h"
#include "FileFrame.h"

namespace mavmission {
using namespace detail;

Status PlanFiles::ensure(const ItemSource& plan, PlanType type) {
  const Status status = upload(plan, type);
  if (isEnd(status)) return status;
  Client& client = insideOf(client_);
  client.setAboard(Aboard::NotKnown);  // what was known was about the plan before
  if (client.state_.operation == writeStep) {
    beginOperation(ensureStep);
    isEnsuring_ = true;
  } else {
    client.beginEnsuring();  // a short fence
  }
  return status;
}

void PlanFiles::ensureStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  if (frame != nullptr) return;
  PlanFiles& self = *client.reading_.files;
  Client::State& state = client.state_;
  if (state.status == Status::WaitingForAutopilot) {
    client.waitForAutopilot();
    if (state.status != Status::Checking) return;
    // Opening a file closes one that another client has left open, and so may store a plan: not in the air.
    if (!self.isUsable() || client.link_.pace().isLossy() || client.isArmed()) return client.beginEnsuring();
    client.beginChecking();
    self.isForeseen_ = true;
  }
  if (!self.isChecked()) return;
  if (!self.isForFile()) return client.beginEnsuring();
  client.beginSeconds(nowMs);
  state.status = Status::Transferring;
  self.isWholeLook_ = true;
  self.beginComparing(takeEnsured);
  self.beginReading();
}

void PlanFiles::takeEnsured(PlanFiles& self, Status status, uint16_t) {
  Client& client = insideOf(self.client_);
  self.isWholeLook_ = false;
  client.state_.proving = false;
  switch (status) {
    case Status::Downloaded:
      client.setAboard(Aboard::OurPlan);
      if (client.state_.type == PlanType::Mission) client.rest_.planId = 0;
      client.report(client.rest_.itemsTotal);
      return client.end(Status::AlreadyAboard);
    case Status::Differs:
      if (client.isArmed()) return client.end(Status::Armed);
      client.rest_.field = ItemField::None;
      client.state_.failedItem = Client::kNoItem;
      return self.beginWriting();
    case Status::NoAnswer:  // there is no file, or the line loses too much of it
      self.isByFile_ = false;
      return client.beginEnsuring();
    default: return client.end(status);
  }
}

}  // namespace mavmission
