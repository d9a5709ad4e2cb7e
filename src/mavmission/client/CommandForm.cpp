// A command of the sketch's own that the autopilot takes in its other form only: COMMAND_LONG or COMMAND_INT.
#include <string.h>

#include "../base/FloatBits.h"
#include "CommandOperations.h"
#include "MissionClient.h"

namespace mavmission {
using namespace detail;
namespace {

// The whole number that this float is; false if it is none.
bool isInteger(float value, int32_t& whole) {
  int32_t bits;
  memcpy(&bits, &value, sizeof(bits));
  whole = timesWhole(bits, 1);
  const float again = quotient(whole, 1);
  int32_t againBits;
  memcpy(&againBits, &again, sizeof(againBits));
  return againBits == bits;
}

// True if this number is the same as a float.
bool isFloat(int32_t whole) {
  int32_t through = whole;
  throughFloat(&through);
  return through == whole;
}

}  // namespace

// Sends the command again in the form that the autopilot has named, if each of its values has a place in that form. A
// place does not fit into COMMAND_LONG: its coordinates would be rounded by metres, and the reference of its altitude
// would be left to the autopilot. The refused command was not carried out, so this holds as well for one that must not
// be carried out twice.
Status Client::OwnCommand::sendInOtherForm(Client& client, Status refusal) {
  if (client.commanding_.fill != fill) return refusal;
  const FlightCommand& own = *client.commanding_.own;
  FillCommand other = nullptr;
  int32_t whole = 0;
  if (refusal == Status::CommandIntOnly && !own.hasPlace) {
    if (isInteger(own.param5, whole) && isInteger(own.param6, whole)) other = fillAsInt;
  } else if (refusal == Status::CommandLongOnly && own.hasPlace && own.frame == CoordinateFrame::Mission) {
    if (isFloat(own.x) && isFloat(own.y)) other = fillAsLong;
  }
  if (other == nullptr) return refusal;
  client.commanding_.fill = other;
  client.commanding_.transfer.next(client.commanding_.transfer.repeats());
  return Status::Transferring;
}

void Client::OwnCommand::fillAsInt(Client& client, FlightCommand& command) {
  fill(client, command);
  isInteger(command.param5, command.x);
  isInteger(command.param6, command.y);
  command.hasPlace = true;
}

void Client::OwnCommand::fillAsLong(Client& client, FlightCommand& command) {
  fill(client, command);
  command.param5 = quotient(command.x, 1);
  command.param6 = quotient(command.y, 1);
  command.hasPlace = false;
}

}  // namespace mavmission
