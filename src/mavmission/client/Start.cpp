// MissionClient's start(): connects StartTransfer to the heartbeats, the plan and the link. And startMission().
#include <Arduino.h>

#include "../MissionClient.h"
#include "../base/FloatBits.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;

Status MissionClient::start(uint16_t item) {
  const Status status = beginCommand(fillStart, onStart);
  if (status == Status::Busy) return status;
  commanding_.start.setFirst(item);
  noteStart();
  return status;
}

Status Client::onStart(Client& client, CommandEvent event, Status status, const FrameParser* frame, uint16_t nowMs) {
  StartTransfer& start = client.commanding_.start;
  CommandTransfer& sending = client.commanding_.transfer;
  if (client.isVehicleAsked()) return client.onVehicle(event, status, fillStart);
  if (start.state() == StartTransfer::State::New) {
    status = client.mayStart();
    if (status != Status::Transferring || client.asksVehicle()) return status;
    client.beginStart();
  }
  const bool isOther = client.aboard() != Aboard::OurPlan && !start.isLeaving();
  if (event == CommandEvent::Time && !start.isJudging() && !isOther) return status;
  Aircraft aircraft = client.aircraft(nowMs);
  if (event == CommandEvent::Ready) aircraft.mode = client.firstMode();
  if (isOther) {
    status = start.onOther(aircraft, sending);
  } else {
    switch (event) {
      case CommandEvent::Ready:
      case CommandEvent::Time: status = client.lookAtItem(aircraft); break;
      case CommandEvent::Accepted: status = start.onAccepted(aircraft, sending); break;
      case CommandEvent::Refused: status = start.onRefused(status, aircraft, sending); break;
      case CommandEvent::Silent: status = start.onSilent(status, aircraft, sending); break;
      case CommandEvent::Heartbeat: status = start.onHeartbeat(aircraft, sending); break;
      case CommandEvent::Current: {
        const mavlink_mission_current_t current = messageFrom<mavlink_mission_current_t>(*frame);
        const uint8_t state = current.mission_state;
        const bool isUnderWay = state == MISSION_STATE_UNKNOWN || state == MISSION_STATE_ACTIVE;
        status = client.namesOther(*frame) ? start.onOtherNamed(aircraft, sending)
                                           : start.onCurrent(current.seq, isUnderWay, aircraft, sending);
        break;
      }
    }
  }
  client.noteStart();
  if (status == Status::Unproven) client.setAboard(PlanType::Mission, Aboard::OtherPlan);
  if (status == Status::OtherItem) client.state_.failedItem = client.ownItem(start.seen());
  return start.isLooking() && status == Status::Transferring ? Status::Checking : status;
}

// Whether the plan may be flown: Transferring, or why not.
Status Client::mayStart() {
  if (isArmed() && !state_.armedAllowed) return Status::Armed;
  if (aboard() != Aboard::OurPlan) return Status::Unproven;
  if (state_.infeasible) return Status::Infeasible;
  const uint16_t item = commanding_.start.first();
  if (!hasItem(item)) return Status::NoSuchItem;
  const bool hasMode = !has(firmware(), kModesByVehicle) || numberOf(FlightMode::Auto) != kNoMode;
  return hasMode ? Status::Transferring : Status::NoSuchMode;
}

void Client::beginStart() {
  const uint16_t item = commanding_.start.first();
  state_.type = PlanType::Mission;
  beginPlan();
  // ArduPilot's item 0 is home. When home is set as the current item, ArduPilot resets its jump counters and begins
  // with item 1.
  const uint16_t first = item != 0 ? plan_.numbers().toWire(item) : item;
  // If the plan that was uploaded last is a fence, plan_ is no mission any more.
  commanding_.start.begin(first, rest_.planType == PlanType::Mission, plan_.firmware());
}

Aircraft Client::aircraft(uint16_t nowMs) const {
  return Aircraft{plan_.firmware(),           vehicleType(),  isArmed(), shownMode(),
                  numberOf(FlightMode::Auto), state_.seconds, nowMs};
}

// What outlives the operation.
void Client::noteStart() {
  rest_.startStep = static_cast<uint8_t>(commanding_.start.step());
  rest_.startArming = static_cast<uint8_t>(commanding_.start.arming());
}

// Gives start() the item of the plan that it looks at next.
Status Client::lookAtItem(const Aircraft& aircraft) {
  StartTransfer& start = commanding_.start;
  Status read = start.wantsItem(plan_.wireCount(), plan_.firmware());
  if (read == Status::Done) return read;
  const MissionItem* item = nullptr;
  if (read == Status::Accepted) {
    if (!link_.canSend() || !claimHeavyWork()) return Status::Transferring;
    read = checkItem(start.next());
    if (read == Status::Checking) return Status::Transferring;
    item = static_cast<const MissionItem*>(link_.draft());
    if (read != Status::Accepted) read = Status::SourceRefused;
  }
  return start.onItem(read, item, aircraft, commanding_.transfer);
}

void Client::fillStart(Client& client, FlightCommand& command) {
  const StartTransfer& start = client.commanding_.start;
  switch (start.message()) {
    case StartTransfer::Message::Mode: return fillModeNumber(command, start.modeToSet());
    case StartTransfer::Message::FirstItem: command.x = start.first(); return;  // MISSION_SET_CURRENT
    case StartTransfer::Message::Arm: return fillArm(client, command);
    case StartTransfer::Message::Disarm: return fillDisarm(client, command);
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

void Client::fillBegin(Client&, FlightCommand& command) { command.id = MAV_CMD_MISSION_START; }

Status MissionClient::startMission() { return beginCommand(fillBegin, onStartMission); }

Status Client::onStartMission(Client& client, CommandEvent event, Status status, const FrameParser* frame,
                              uint16_t nowMs) {
  Commanding& commanding = client.commanding_;
  if (client.isVehicleAsked()) return client.onVehicle(event, status, fillBegin);
  const bool isRestoring = commanding.mode.order.isRestoring();
  if (event == CommandEvent::Ready) {
    commanding.mode.number = client.numberOf(FlightMode::Auto);
    if (has(client.firmware(), kModesByVehicle) && commanding.mode.number == kNoMode) return Status::NoSuchMode;
    if (client.isArmed() && client.asksVehicle()) return status;
    commanding.mode.number = client.numberOf(FlightMode::Auto);
    // MAV_CMD_MISSION_START, which would arm, is not sent: an armed aircraft flies its mission by the mode alone.
    if (has(client.firmware(), kArmsByMissionStart)) commanding.fill = fillMode;
  }
  if (!isRestoring && !client.isArmed()) return Status::NotArmed;
  const Status ended = onMode(client, event, status, frame, nowMs);
  // Where AUTO is there already, a copter still waits for the command.
  const bool isAnswered = commanding.fill != fillBegin || client.rest_.lastResult == MAV_RESULT_ACCEPTED;
  return ended == Status::Done && !isAnswered ? Status::Transferring : ended;
}

}  // namespace mavmission
