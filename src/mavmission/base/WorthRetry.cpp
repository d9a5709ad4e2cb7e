#include "Status.h"

namespace mavmission {

bool isWorthRetry(Status status) {
  switch (status) {
    case Status::NoAutopilot:
    case Status::Unconfirmed:
    case Status::NoAnswer:
    case Status::TimedOut:
    case Status::TookTooLong:
    case Status::AcceptedEarly:
    case Status::OtherPlanAboard:
    case Status::Differs:
    case Status::Error:
    case Status::NoSpace:  // also from an ArduPilot that starts, whose storage is not there yet
    case Status::Denied:
    case Status::InvalidSequence:
    case Status::CancelledByAutopilot:
    case Status::CommandRejected:
    case Status::CommandFailed: return true;
    default: return false;
  }
}

}  // namespace mavmission
