// Which vehicle an ArduPilot is, before a mode is ordered by its number.
//
// A plane says in its heartbeat whatever type its Q_MAV_TYPE has: also a copter's, whose mode numbers are others. So
// what does not say that it is a plane is asked, once, by a command that only planes know: DO_VTOL_TRANSITION to the
// state "undefined", which changes nothing. A plane answers FAILED, whether it can hover or not, and any other vehicle
// UNSUPPORTED (ArduPilot 4.6.3). Its name would come as a text, which may be lost; AUTOPILOT_VERSION does not have it.
#include "../autopilot/VehicleKind.h"
#include "../link/Messages.h"
#include "CommandOperations.h"
#include "MissionClient.h"

namespace mavmission {
namespace detail {

bool CommandPort::asksVehicle() {
  Client& client = static_cast<Client&>(*this);
  const bool isKnown = !has(client.firmware(), kModesByVehicle) || isPlane(client.vehicleType()) ||
                       client.link_.finder().isVehicleKnown();
  if (isKnown) return false;
  client.commanding_.fill = Client::AskingVehicle::fill;
  return true;
}

bool Client::isVehicleAsked() const { return commanding_.fill == AskingVehicle::fill; }

bool CommandPort::isAskingVehicle() const { return static_cast<const Client&>(*this).isVehicleAsked(); }

void Client::AskingVehicle::fill(Client&, FlightCommand& command) {
  command.id = MAV_CMD_DO_VTOL_TRANSITION;
  command.param1 = MAV_VTOL_STATE_UNDEFINED;
}

Status CommandPort::onVehicle(CommandEvent event, Status status, FillCommand then) {
  if (event == CommandEvent::Silent) return status;
  if (event != CommandEvent::Refused) return Status::Transferring;
  if (status != Status::CommandUnsupported && status != Status::CommandFailed) return status;
  Client& client = static_cast<Client&>(*this);
  client.link_.finder().setVehicle(status == Status::CommandFailed);
  client.state_.lastResult = 255;
  client.commanding_.fill = then;
  client.commanding_.transfer.next(true);
  client.commanding_.transfer.forgetHeartbeat();  // the operation has not looked at it
  client.state_.status = Status::Checking;        // CommandEvent::Ready comes again
  return Status::Transferring;
}

}  // namespace detail
}  // namespace mavmission
