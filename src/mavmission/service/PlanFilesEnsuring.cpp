// PlanFiles' ensure(): the plan aboard is read as a file and compared; where it is another one it is replaced.
//
//   WaitingForAutopilot -> Checking -> the look (PlanFilesReading.cpp) -----> AlreadyAboard
//        |                    |          |   |  another plan is aboard
//        |                    |          |   +--> the upload (PlanFilesWriting.cpp); Armed, if it is armed by now
//        |  no files, armed,  |          |  no answer, or a refusal
//        +- or a lossy line --+----------+--> MissionClient::ensure()
#include "../PlanFiles.h"
#include "../client/PlanPort.h"

namespace mavmission {
using namespace detail;

Status PlanFiles::ensure(const ItemSource& plan, PlanType type) {
  const Status status = upload(plan, type);
  if (isEnd(status)) return status;
  plans().nowAboard(Aboard::NotKnown);  // what was known was about the plan before
  if (client_.runs(writeStep)) {
    beginOperation(ensureStep);
    plans().goOnBy(ensureStep, *this);
    isEnsuring_ = true;
  } else {
    plans().ensureByItems();  // a short fence
  }
  return status;
}

void PlanFiles::ensureStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  if (frame != nullptr) return;
  PlanFiles& self = PlanPort::filesOf(client);
  Port& port = self.client_;
  PlanPort& plans = self.plans();
  if (port.running() == Status::WaitingForAutopilot) {
    port.waitForAutopilot();
    if (port.running() != Status::Checking) return;
    // Opening a file closes one that another client has left open, and so may store a plan: not in the air.
    if (!self.isUsable() || port.link().pace().isLossy() || port.autopilot().isArmed()) return plans.ensureByItems();
    plans.beginChecking();
    self.isForeseen_ = true;
  }
  if (!self.isChecked(false)) return;
  if (!self.isForFile()) return plans.ensureByItems();
  port.beginTransferring(nowMs);
  self.isWholeLook_ = true;
  self.beginComparing(takeEnsured);
  self.beginReading();
}

void PlanFiles::takeEnsured(PlanFiles& self, Status status, uint16_t) {
  PlanPort& plans = self.plans();
  self.isWholeLook_ = false;
  plans.endComparing();
  switch (status) {
    case Status::Downloaded: return plans.endAsOurs(Status::AlreadyAboard);
    case Status::Differs:
      if (self.client_.autopilot().isArmed()) return self.client_.end(Status::Armed);
      plans.forgetFailed();
      return self.beginWriting();
    case Status::NoAnswer:  // there is no file, or the line loses too much of it
      self.isByFile_ = false;
      return plans.ensureByItems();
    default: return self.client_.end(status);
  }
}

}  // namespace mavmission
