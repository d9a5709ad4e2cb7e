// What a service sees of the client: its line, the autopilot, the running operation, and which mission is aboard. A
// service includes this header, and CommandPort.h or PlanPort.h where its operations need them, and nothing else of
// client/: the client's own members are private.
//
// A port has neither members nor virtual functions. The client derives from it, and the files of client/ define it: so
// it takes no RAM, and where the whole program is optimised together no flash either.
#pragma once

#include <stdint.h>

#include "../base/Config.h"
#include "../base/ItemField.h"
#include "../base/Status.h"
#include "../link/Link.h"
#include "../transfer/CommandLog.h"
#include "../transfer/Operations.h"

namespace mavmission {

class MissionClient;

namespace detail {

class Client;
class CommandPort;
class PlanPort;

class Port {
 public:
  // In the place of an item's number: none.
  static constexpr uint16_t kNoItem = 0xFFFF;
  // The least number of bytes that an update() may write [bytes].
  static constexpr uint8_t kStartBytes = 8;

  // An operation's part of update(): takes a frame of the autopilot, or null for the passing of time. (Operation.h)
  typedef void (*Step)(Client& client, const FrameParser* frame, uint16_t nowMs);

  static Port& of(MissionClient& client);
  static Port& of(Client& client);
  // What operations with commands, and those that transfer plans, see beside this.
  CommandPort& commands();
  PlanPort& plans();

  // --- The line, and who is there

  // Sends, listens, counts.
  Link& link();
  // The autopilot on the line, as its heartbeats tell.
  const AutopilotFinder& autopilot() const;
  // To be asked before a command is sent beside the operations: whose answers may still come.
  CommandLog& commandLog();

  // --- The operations of the client, of which one runs at a time

  // The status of the running operation; Status::Idle while none runs.
  Status running() const;
  // That of the running operation, or the one with which the last one has ended.
  Status outcome() const;
  // True if the running or last operation transfers items. Commands and clear() do not, nor does a download before its
  // MISSION_COUNT.
  bool hasItems() const;
  // True while this operation runs.
  bool runs(Step operation) const;
  // Takes the running operation from WaitingForAutopilot to Checking, or ends it, when the time for that has come.
  void waitForAutopilot();
  // Takes it to Transferring: from now on its time counts.
  void beginTransferring(uint16_t nowMs);
  // The time of the operation, or of its transfer [s]; and counts it from now on.
  uint16_t seconds() const;
  MAVMISSION_APART void beginSeconds(uint16_t nowMs);
  // True when it has reached its time limit.
  bool hasTakenTooLong() const;
  // Takes the time of this update() for heavy work. False when bytes have taken it: the work then waits for the next
  // one, which looks at half as many.
  MAVMISSION_APART bool claimHeavyWork();
  // The field that differingField() names.
  void blame(ItemField field);
  // Ends it with this status.
  MAVMISSION_APART MAVMISSION_ONE_EXIT void end(Status status);
  // Who has taken the aircraft from the sketch: PilotHasIt, FailsafeHasIt; Idle: nobody. It stays until the sketch asks
  // for the aircraft again: noteTaken(Status::Idle).
  Status takenBy() const;
  void noteTaken(Status who);
  // True if the sketch allows changes while the autopilot is armed.
  bool isAllowedWhileArmed() const;

  // --- The mission aboard

  bool isOurMission() const;
  // The number of the sketch's item, or kNoItem for home.
  uint16_t itemFromWire(uint16_t wireItem) const;
  // The autopilot's name (opaque_id) of the mission accepted or verified last; 0: none.
  uint32_t acceptedPlanId() const;
  // The autopilot has named the mission that it has. (0: it gives none.)
  void noteMissionName(uint32_t planId);
  // Somebody else has put a mission aboard. What aboard() says of a transfer that has not ended well stays.
  void noteOtherMission();
  // True if this MISSION_CURRENT is about another plan than ours.
  bool namesOther(const FrameParser& frame) const;
  // The autopilot has reported that it cannot fly the mission that it has accepted.
  void noteInfeasible();
};

}  // namespace detail
}  // namespace mavmission
