// MissionClient's start(): connects StartTransfer to the heartbeats, the plan and the link. And startMission().
#include <Arduino.h>

#include "../base/FloatBits.h"
#include "../link/Messages.h"
#include "CommandOperations.h"
#include "MissionClient.h"

namespace mavmission {
using namespace detail;

Status MissionClient::start(uint16_t item) {
  const Status status = beginCommand(Starting::fill, Starting::on);
  if (status == Status::Busy) return status;
  commanding_.start.setFirst(item);
  Starting::note(*this);
  return status;
}

Status Client::Starting::on(Client& client, CommandEvent event, Status status, const FrameParser* frame,
                            uint16_t nowMs) {
  StartTransfer& start = client.commanding_.start;
  CommandTransfer& sending = client.commanding_.transfer;
  if (client.isVehicleAsked()) return client.onVehicle(event, status, fill);
  if (start.state() == StartTransfer::State::New) {
    status = mayBegin(client);
    if (status != Status::Transferring || client.asksVehicle()) return status;
    begin(client);
  }
  const bool isOther = client.aboard() != Aboard::OurPlan && !start.isLeaving();
  if (event == CommandEvent::Time && !start.isJudging() && !isOther) return status;
  Aircraft aircraft = aircraftOf(client, nowMs);
  if (event == CommandEvent::Ready) aircraft.mode = client.firstMode();
  if (isOther) {
    status = start.onOther(aircraft, sending);
  } else {
    switch (event) {
      case CommandEvent::Ready:
      case CommandEvent::Time: status = lookAtItem(client, aircraft); break;
      case CommandEvent::Accepted: status = start.onAccepted(aircraft, sending); break;
      case CommandEvent::Refused: status = start.onRefused(status, aircraft, sending); break;
      case CommandEvent::Silent: status = start.onSilent(status, aircraft, sending); break;
      case CommandEvent::Heartbeat: status = start.onHeartbeat(aircraft, sending); break;
      case CommandEvent::Current: {
        if (sending.isOld()) break;  // it may have been disarmed since
        const mavlink_mission_current_t current = messageFrom<mavlink_mission_current_t>(*frame);
        const uint8_t state = current.mission_state;
        const bool isUnderWay = state == MISSION_STATE_UNKNOWN || state == MISSION_STATE_ACTIVE;
        status = client.namesOther(*frame) ? start.onOtherNamed(aircraft, sending)
                                           : start.onCurrent(current.seq, isUnderWay, aircraft, sending);
        break;
      }
    }
  }
  note(client);
  noted(client, status);
  if (status == Status::Unproven) {
    client.setAboard(PlanType::Mission, Aboard::OtherPlan);
    if (client.isArmed()) status = Status::FliesOtherPlan;
  }
  if (status == Status::OtherItem) client.state_.failedItem = client.ownItem(start.seen());
  return start.isLooking() && status == Status::Transferring ? Status::Checking : status;
}

// Somebody has set another mode, or has disarmed it.
Status Client::Starting::noted(Client& client, Status ended) {
  if (ended == Status::TakenOver || ended == Status::Overruled || ended == Status::NotArmed) {
    const bool isFailsafe = client.link_.finder().heartbeat().state >= MAV_STATE_CRITICAL;
    client.noteTaken(isFailsafe ? Status::FailsafeHasIt : Status::PilotHasIt);
  }
  return ended;
}

// Whether the plan may be flown: Transferring, or why not.
Status Client::Starting::mayBegin(Client& client) {
  if (client.known_.takenBy != Status::Idle) return client.known_.takenBy;
  if (client.hasBeenDisarmed()) return noted(client, Status::NotArmed);  // by somebody, who wants it so
  if (client.isArmed() && !client.state_.armedAllowed) return Status::Armed;
  if (client.aboard() != Aboard::OurPlan) return Status::Unproven;
  if (client.state_.infeasible) return Status::Infeasible;
  const uint16_t item = client.commanding_.start.first();
  if (!client.hasItem(item)) return Status::NoSuchItem;
  const bool hasMode = !has(client.firmware(), kModesByVehicle) || client.numberOf(FlightMode::Auto) != kNoMode;
  return hasMode ? Status::Transferring : Status::NoSuchMode;
}

void Client::Starting::begin(Client& client) {
  const uint16_t item = client.commanding_.start.first();
  client.state_.type = PlanType::Mission;
  client.beginPlan();
  // ArduPilot's item 0 is home. When home is set as the current item, ArduPilot resets its jump counters and begins
  // with item 1.
  const uint16_t first = item != 0 ? client.plan_.numbers().toWire(item) : item;
  // If the plan that was given last is a fence, or was refused, plan_ is not the mission aboard.
  client.commanding_.start.begin(first, client.isMissionInPlan(), client.plan_.firmware());
}

Aircraft Client::Starting::aircraftOf(const Client& client, uint16_t nowMs) {
  return Aircraft{client.plan_.firmware(),
                  client.vehicleType(),
                  client.isArmed(),
                  client.shownMode(),
                  client.numberOf(FlightMode::Auto),
                  client.state_.seconds,
                  nowMs};
}

// What outlives the operation.
void Client::Starting::note(Client& client) {
  client.session_.startStep = static_cast<uint8_t>(client.commanding_.start.step());
  client.session_.startArming = static_cast<uint8_t>(client.commanding_.start.arming());
}

// Gives start() the item of the plan that it looks at next.
Status Client::Starting::lookAtItem(Client& client, const Aircraft& aircraft) {
  StartTransfer& start = client.commanding_.start;
  Status read = start.wantsItem(client.plan_.wireCount(), client.plan_.firmware());
  if (read == Status::Done) return read;
  const MissionItem* item = nullptr;
  if (read == Status::Accepted) {
    if (!client.link_.canSend() || !client.claimHeavyWork()) return Status::Transferring;
    read = client.checkItem(start.next());
    if (read == Status::Checking) return Status::Transferring;
    item = static_cast<const MissionItem*>(client.link_.draft());
    if (read != Status::Accepted) read = Status::SourceRefused;
  }
  return start.onItem(read, item, aircraft, client.commanding_.transfer);
}

void Client::Starting::fill(Client& client, FlightCommand& command) {
  const StartTransfer& start = client.commanding_.start;
  switch (start.message()) {
    case StartTransfer::Message::Mode: return fillModeNumber(command, start.modeToSet());
    case StartTransfer::Message::FirstItem: command.x = start.first(); return;  // MISSION_SET_CURRENT
    case StartTransfer::Message::Arm: return fillArming(command, true);
    case StartTransfer::Message::Disarm: return fillArming(command, false);
    case StartTransfer::Message::AskCurrent:
      command.id = MAV_CMD_REQUEST_MESSAGE;
      command.param1 = floatOf(MAVLINK_MSG_ID_MISSION_CURRENT);
      return;
    case StartTransfer::Message::Start:
      command.id = MAV_CMD_MISSION_START;  // ArduPilot wants parameters of 0; PX4 begins with the item in param1
      if (client.plan_.has(kArmsByMissionStart)) command.param1 = floatOf(start.first());
      return;
  }
}

void Client::BeginningMission::fill(Client&, FlightCommand& command) { command.id = MAV_CMD_MISSION_START; }

Status MissionClient::startMission() { return beginCommand(BeginningMission::fill, BeginningMission::on); }

Status Client::BeginningMission::on(Client& client, CommandEvent event, Status status, const FrameParser* frame,
                                    uint16_t nowMs) {
  Commanding& commanding = client.commanding_;
  if (client.isVehicleAsked()) return client.onVehicle(event, status, fill);
  const bool isRestoring = commanding.mode.order.isRestoring();
  if (event == CommandEvent::Ready) {
    commanding.mode.number = client.numberOf(FlightMode::Auto);
    if (has(client.firmware(), kModesByVehicle) && commanding.mode.number == kNoMode) return Status::NoSuchMode;
    if (client.isArmed() && client.asksVehicle()) return status;
    commanding.mode.number = client.numberOf(FlightMode::Auto);
    // MAV_CMD_MISSION_START, which would arm, is not sent: an armed aircraft flies its mission by the mode alone.
    if (has(client.firmware(), kArmsByMissionStart)) commanding.fill = SettingMode::fill;
  }
  if (!isRestoring && !client.isArmed()) return Status::NotArmed;
  const Status ended = SettingMode::on(client, event, status, frame, nowMs);
  // Where AUTO is there already, a copter still waits for the command.
  const bool isAnswered = commanding.fill != fill || client.state_.lastResult == MAV_RESULT_ACCEPTED;
  return ended == Status::Done && !isAnswered ? Status::Transferring : ended;
}

}  // namespace mavmission
