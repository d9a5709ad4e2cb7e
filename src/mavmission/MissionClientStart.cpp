// MissionClient's start(): what each autopilot needs in order to fly the plan that is aboard, step by step.
#include <Arduino.h>

#include "Messages.h"
#include "MissionClient.h"

namespace mavmission {

Status MissionClient::start() {
  const Status status = beginCommand(fillBegin, 0);
  if (status == Status::Busy) return status;
  rest_.startStep = StartStep::None;
  commanding_.prepare = prepareStart;
  commanding_.accepted = nextStartStep;
  return status;
}

Status MissionClient::prepareStart(MissionClient& client) {
  if (client.isArmed() && !client.rest_.armedAllowed) return Status::Armed;
  if (client.aboard() != Aboard::OurPlan) return Status::Unproven;
  if (client.rest_.infeasible) return Status::Infeasible;
  return nextStartStep(client);
}

// Goes on with the next step that this vehicle needs. When there is none, a heartbeat is to say that it is armed: one that
// has restarted between two steps accepts those that are left, and stays on the ground.
Status MissionClient::nextStartStep(MissionClient& client) {
  while (client.rest_.startStep != StartStep::Begin) {
    client.rest_.startStep = static_cast<StartStep>(static_cast<uint8_t>(client.rest_.startStep) + 1);
    const Status status = client.chooseStartStep();
    if (status != Status::Done) return status;
  }
  Commanding& commanding = client.commanding_;
  if (commanding.fill == nullptr) return Status::Done;
  commanding.fill = nullptr;
  commanding.id = 0;
  commanding.isDue = false;  // the last step may have been due again when its answer came
  commanding.repeats = false;
  commanding.waitMs = AutopilotFinder::kLostMs;
  return Status::Transferring;
}

// Sets up the current step: Transferring, or Done if this vehicle does without it.
Status MissionClient::chooseStartStep() {
  const bool isArduPilot = firmware() == Firmware::ArduPilot;
  switch (rest_.startStep) {
    case StartStep::None:
      return Status::Done;
    case StartStep::ReadyMode: {
      // Copter refuses to be armed in AUTO: GUIDED. Rover: MANUAL. Plane arms in the mode that it is in.
      if (!isArduPilot || isArmed()) return Status::Done;
      switch (link_.finder().heartbeat().vehicleType) {
        case MAV_TYPE_GROUND_ROVER:
        case MAV_TYPE_SURFACE_BOAT:
          setModeNumbers(FlightMode::Manual);
          break;
        case MAV_TYPE_FIXED_WING:
          return Status::Done;
        default:
          setModeNumbers(FlightMode::Guided);
          break;
      }
      nextCommand(fillMode);
      return Status::Transferring;
    }
    case StartStep::Arm:
      if (firmware() == Firmware::Px4 || isArmed()) return Status::Done;  // PX4's MISSION_START arms
      commanding_.argument = 1;
      nextCommand(fillArm);
      return Status::Transferring;
    case StartStep::AutoMode:
      if (!isArduPilot) return Status::Done;
      setModeNumbers(FlightMode::Auto);
      nextCommand(fillMode);
      return Status::Transferring;
    case StartStep::Begin:
      nextCommand(fillBegin);
      return Status::Transferring;
  }
  return Status::Done;
}

void MissionClient::fillBegin(MissionClient&, FlightCommand& command) {
  command.id = MAV_CMD_MISSION_START;  // ArduPilot wants its parameters to be 0
}

Status MissionClient::startMission() {
  const Status status = beginCommand(fillBegin, 0);
  if (status != Status::Busy) commanding_.prepare = prepareBegin;
  return status;
}

Status MissionClient::prepareBegin(MissionClient& client) {
  if (!client.isArmed()) return Status::NotArmed;
  if (client.firmware() == Firmware::Px4) {
    // PX4's MISSION_START arms: an armed aircraft flies its mission by the mode alone.
    if (!client.setModeNumbers(FlightMode::Auto)) return Status::NoSuchMode;
    client.commanding_.fill = fillMode;
  }
  return Status::Transferring;
}

}  // namespace mavmission
