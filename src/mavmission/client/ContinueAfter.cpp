// What follows the end of an upload when the sketch has chosen options: the back-off, the MISSION_ITEM fallback, the
// read-back. They are all decided here, so that an upload without any of these options needs only one test.
#include "MissionClient.h"
#include "Uploading.h"

namespace mavmission {
using namespace detail;

// True if the operation continues.
bool Client::Uploading::continueAfter(Client& client, Status status, uint16_t nowMs) {
  const Session& session = client.session_;
  if (session.options.goOn != nullptr && session.options.goOn(client, status, nowMs)) return true;
  const UploadTransfer& transfer = client.transfer_;
  // A server whose ways are not known has given the upload up. On a lossy link that may be the cause, and what it
  // held is gone: so the upload begins anew, within the time for the whole operation.
  if ((status == Status::TimedOut || status == Status::CancelledByAutopilot) && client.plan_.has(kMayBeOld) &&
      client.link_.pace().isLossy()) {
    client.unsettle();
    begin(client, nowMs);
    client.state_.isDoubtful = true;
    return true;
  }
  // An idle ArduPilot answers with an error when the line has repeated the last item. The acceptance may have been lost
  // before that.
  const bool isDoubtfulError = status == Status::Error && !client.plan_.has(kRepeatsAcceptance) &&
                               transfer.state() == UploadTransfer::State::Confirming;
  // Of the frames that a line has broken, one of 65,536 has a right checksum all the same: where the line was seen to
  // lose, a plan may have been accepted with a broken item, unless PX4 has named the checksum of the plan itself.
  bool isInDoubt = status == Status::Unconfirmed || isDoubtfulError;
  bool isProofDue = isInDoubt;
  if (status == Status::Accepted) {
    isInDoubt = client.link_.pace().isLossy() && !transfer.isProven();
    isProofDue = isInDoubt || session.proof == static_cast<uint8_t>(Readback::Always);
  }
  if (!isProofDue || session.options.readBack == nullptr) return false;
  if (isInDoubt) client.unsettle();
  client.state_.mayBeRefused = isDoubtfulError;
  session.options.readBack(client, nowMs);
  return true;
}

}  // namespace mavmission
