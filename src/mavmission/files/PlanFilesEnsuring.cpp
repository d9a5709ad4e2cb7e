// PlanFiles' ensure(): the plan aboard is read as a file and compared; where it is another one it is replaced.
//
//   WaitingForAutopilot -> Checking -> the look (PlanFilesReading.cpp) -----> AlreadyAboard
//        |                    |          |   |  another plan is aboard
//        |                    |          |   +--> the upload (PlanFilesWriting.cpp); Armed, if it is armed by now
//        |  no files, armed,  |          |  no answer, or a refusal
//        +- or a lossy link --+----------+--> MissionClient::ensure()
#include "../client/Operation.h"
#include "../client/PlanPort.h"
#include "PlanFiles.h"

namespace mavmission {
using namespace detail;

Status PlanFiles::ensure(const ItemSource& plan, PlanType type) {
  const Status status = upload(plan, type);
  if (isEnd(status)) return status;
  if (client_.runs(writeStep)) {
    beginOperation(ensureStep);
    plans().goOnBy(ensureStep, *this);
    isEnsuring_ = true;
  } else {
    plans().ensureByItems();  // a short fence
  }
  return status;
}

struct PlanFiles::EnsuringFile : OperationParts {
  static bool begin(Client& client, uint16_t) {
    PlanFiles& self = PlanPort::filesOf(client);
    Port& port = self.client_;
    // Opening a file closes one that another client has left open, and so may store a plan: not in the air.
    if (!self.isUsable() || port.link().pace().isLossy() || port.autopilot().isArmed()) {
      self.plans().ensureByItems();
      return false;
    }
    self.plans().beginChecking();
    self.isForeseen_ = true;
    return true;
  }

  static void time(Client& client, uint16_t nowMs) {
    PlanFiles& self = PlanPort::filesOf(client);
    if (!self.isChecked()) return;
    if (!self.isForFile()) return self.plans().ensureByItems();
    self.client_.beginTransferring(nowMs);
    self.plans().nowAboard(Aboard::NotKnown);  // what was known was about the plan before
    self.isWholeLook_ = true;
    self.beginComparing(takeEnsured);
    self.beginReading();
  }
};

void PlanFiles::ensureStep(Client& client, const FrameParser* frame, uint16_t nowMs) {
  operate<EnsuringFile>(client, frame, nowMs);
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
