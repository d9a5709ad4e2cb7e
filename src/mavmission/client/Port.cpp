// The port that each service sees, and the port of operations with commands: what takes a line or two of the client.
#include "Port.h"

#include <string.h>

#include "../link/Messages.h"
#include "CommandOperations.h"
#include "MissionClient.h"

namespace mavmission {
namespace detail {

Port& Port::of(MissionClient& client) { return static_cast<Client&>(client); }
Port& Port::of(Client& client) { return client; }
CommandPort& Port::commands() { return static_cast<Client&>(*this); }

// --- The line, and who is there

Link& Port::link() { return static_cast<Client&>(*this).link_; }
const AutopilotFinder& Port::autopilot() const { return static_cast<const Client&>(*this).link_.finder(); }
CommandLog& Port::commandLog() { return static_cast<Client&>(*this).known_.log; }

// --- The operations

Status Port::running() const {
  const Client& client = static_cast<const Client&>(*this);
  return client.isBusy() ? client.status() : Status::Idle;
}

Status Port::outcome() const { return static_cast<const Client&>(*this).status(); }

bool Port::hasItems() const { return static_cast<const Client&>(*this).itemsTotal() != 0; }

bool Port::runs(Step operation) const { return static_cast<const Client&>(*this).state_.operation == operation; }

void Port::beginTransferring(uint16_t nowMs) {
  beginSeconds(nowMs);
  static_cast<Client&>(*this).state_.status = Status::Transferring;
}

uint16_t Port::seconds() const { return static_cast<const Client&>(*this).state_.seconds; }

bool Port::hasTakenTooLong() const { return static_cast<const Client&>(*this).state_.isLate; }

void Port::blame(ItemField field) { static_cast<Client&>(*this).session_.field = field; }

bool Port::isAllowedWhileArmed() const { return static_cast<const Client&>(*this).state_.armedAllowed; }

Status Port::takenBy() const { return static_cast<const Client&>(*this).known_.takenBy; }

void Port::noteTaken(Status who) { static_cast<Client&>(*this).known_.takenBy = who; }

// --- The mission aboard

bool Port::isOurMission() const { return static_cast<const Client&>(*this).aboard() == Aboard::OurPlan; }

uint32_t Port::acceptedPlanId() const { return static_cast<const Client&>(*this).known_.planId; }

void Port::noteMissionName(uint32_t planId) {
  Client& client = static_cast<Client&>(*this);
  const uint32_t accepted = client.known_.planId;
  if (planId == 0 || accepted == 0) return;
  if (planId != accepted) return noteOtherMission();
  if (client.aboard() != Aboard::OtherPlan) return;
  client.setAboard(PlanType::Mission, Aboard::OurPlan);  // it is back
}

void Port::noteOtherMission() {
  if (isOurMission()) static_cast<Client&>(*this).setAboard(PlanType::Mission, Aboard::OtherPlan);
}

void Port::noteInfeasible() {
  Client& client = static_cast<Client&>(*this);
  if (client.state_.status == Status::Infeasible || !isOurMission()) return;
  if (client.state_.operation != nullptr && client.state_.operation != Client::Command::step) return;
  client.state_.infeasible = true;
  end(Status::Infeasible);
}

// --- Operations with commands

CommandPort& CommandPort::of(Client& client) { return client; }

void* CommandPort::ownerOf(const Client& client) { return client.commanding_.owner; }

void* CommandPort::owner() const { return static_cast<const Client&>(*this).commanding_.owner; }

Status CommandPort::beginCommands(FillCommand fill, OnCommand on, void* owner) {
  Client& client = static_cast<Client&>(*this);
  const Status status = client.beginCommand(fill, on);
  if (status != Status::Busy) client.commanding_.owner = owner;
  return status;
}

Status CommandPort::beginOwn(Port::Step operation, void* owner) {
  Client& client = static_cast<Client&>(*this);
  const Status status = client.startOperation(operation);
  client.state_.isPlanless = true;
  memset(&client.commanding_, 0, sizeof(client.commanding_));
  client.commanding_.owner = owner;
  client.commanding_.transfer.setRepeats(true);
  return status;
}

void CommandPort::takeOver(FillCommand fill, OnCommand on, void* owner) {
  Client::Commanding& commanding = static_cast<Client&>(*this).commanding_;
  commanding.owner = owner;
  commanding.fill = fill;
  commanding.on = on;
}

bool CommandPort::runs(OnCommand on) const {
  const Client& client = static_cast<const Client&>(*this);
  return client.isBusy() && client.state_.isCommanding && client.commanding_.on == on;
}

bool CommandPort::runs(Port::Step operation, const void* owner) const {
  const Client& client = static_cast<const Client&>(*this);
  return client.state_.operation == operation && client.commanding_.owner == owner;
}

bool CommandPort::isCommanding() const { return static_cast<const Client&>(*this).state_.isCommanding; }

CommandTransfer& CommandPort::sending() { return static_cast<Client&>(*this).commanding_.transfer; }

bool CommandPort::isSetting(uint16_t mode) const {
  const Client& client = static_cast<const Client&>(*this);
  const Client::Commanding& running = client.commanding_;
  const bool isSetting = client.status() == Status::Transferring && client.state_.isCommanding &&
                         running.fill == Client::SettingMode::fill;
  return isSetting && !running.mode.order.isRestoring() && running.mode.number == mode;
}

}  // namespace detail
}  // namespace mavmission
