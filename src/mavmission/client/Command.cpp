// MissionClient's commands: one at a time, each confirmed by COMMAND_ACK. MAVLink guide, Command Protocol.
#include <Arduino.h>

#include "../autopilot/Guarded.h"
#include "../autopilot/VehicleKind.h"
#include "../base/Clock.h"
#include "../base/FloatBits.h"
#include "../link/Messages.h"
#include "../link/Sending.h"
#include "CommandOperations.h"
#include "MissionClient.h"

namespace mavmission {
using namespace detail;
namespace {

// The status of a MAV_RESULT that lies `more` above `first`.
constexpr Status offset(Status first, uint8_t more) { return static_cast<Status>(static_cast<uint8_t>(first) + more); }

static_assert(offset(Status::CommandRejected, MAV_RESULT_FAILED - 1) == Status::CommandFailed &&
                  offset(Status::CommandLongOnly, MAV_RESULT_NOT_IN_CONTROL - MAV_RESULT_COMMAND_LONG_ONLY) ==
                      Status::NotInControl,
              "Status must list the results of commands in the order of MAV_RESULT");

Status fromCommandResult(uint8_t result) {
  if (result == MAV_RESULT_ACCEPTED) return Status::Done;
  if (result <= MAV_RESULT_FAILED) return offset(Status::CommandRejected, result - MAV_RESULT_TEMPORARILY_REJECTED);
  if (result < MAV_RESULT_COMMAND_LONG_ONLY || result > MAV_RESULT_NOT_IN_CONTROL) return Status::CommandRefused;
  return offset(Status::CommandLongOnly, result - MAV_RESULT_COMMAND_LONG_ONLY);
}

// True if its param1 is not 0.
bool isOn(const FlightCommand& command) {
  uint32_t bits;
  memcpy(&bits, &command.param1, sizeof(bits));
  return (bits << 1) != 0;
}

}  // namespace

Status Client::beginCommand(FillCommand fill, OnCommand on) {
  if (state_.operation != nullptr) return Status::Busy;
  // Late answers to an earlier command may still come. state_.seconds counts from the end of the last operation, if
  // that has sent commands, else from its beginning.
  const CommandLog::Before before = state_.seconds >= CommandLog::kLateAnswersS ? CommandLog::Before::Nothing
                                    : state_.isCommanding                       ? CommandLog::Before::Command
                                                                                : CommandLog::Before::Other;
  startOperation(Command::step);
  state_.isCommanding = true;
  state_.isPlanless = true;
  memset(&commanding_, 0, sizeof(commanding_));
  known_.log.begin(before, static_cast<uint16_t>(millis()));
  commanding_.fill = fill;
  commanding_.on = on;
  commanding_.transfer.setRepeats(true);
  commanding_.modeFlags = link_.finder().heartbeat().baseMode;
  return state_.status;
}

void Client::nextCommand(FillCommand fill) {
  commanding_.fill = fill;
  commanding_.transfer.next(true);
}

void CommandPort::lookAtClock(uint16_t nowMs) {
  Client& client = static_cast<Client&>(*this);
  const Link& link = client.link_;
  if (client.commanding_.transfer.look(link.isOld(), link.isBlind(), nowMs)) client.link_.withdraw();
}

void Client::Command::step(Client& client, const FrameParser* frame, uint16_t nowMs) {
  State& state = client.state_;
  client.lookAtClock(nowMs);
  if (frame != nullptr) {
    client.commanding_.modeFlags |= client.link_.finder().heartbeat().baseMode;
    if (state.status == Status::Transferring) takeFrame(client, *frame, nowMs);
    return;
  }
  if (state.status == Status::WaitingForAutopilot) {
    client.waitForAutopilot();
    state.next = client.shownMode();
    // An order that could not be begun for so long is not meant any more: somebody may stand beside the aircraft. (What
    // has no events of its own only asks for messages.)
    const bool isOrder = client.commanding_.on != nullptr;
    if (state.status == Status::WaitingForAutopilot && isOrder && client.session_.waitingLimitS == 0 &&
        state.seconds >= kOrderWaitS) {
      client.end(client.link_.finder().severalHeard() ? Status::SeveralAutopilots : Status::NoAutopilot);
    }
    // What its last heartbeat has shown is too old: another one is asked for.
    if (state.status == Status::WaitingForAutopilot && client.link_.finder().isCertain() && !client.link_.isCurrent()) {
      client.commanding_.transfer.ask();
      if (client.link_.canSend()) send(client, false, nowMs);
    }
  }
  if (state.status == Status::Checking) {
    OnCommand const on = client.commanding_.on;
    const Status ready =
        on != nullptr ? on(client, CommandEvent::Ready, Status::Transferring, nullptr, nowMs) : Status::Transferring;
    if (ready == Status::Checking) return;
    if (ready != Status::Transferring) return client.end(ready);
    state.status = Status::Transferring;
    client.beginSeconds(nowMs);
    return;  // start() may have looked at an item: that was work enough for one update()
  }
  if (state.status != Status::Transferring) return;
  Status status = client.commanding_.transfer.onTime(client.known_.log.asksOpen(), nowMs);
  if (status == Status::Transferring && state.isLate) status = Status::TookTooLong;
  // What was begun is not carried out when the autopilot is heard again, some time later.
  if (!client.hasAutopilot()) status = Status::NoAnswer;
  const bool goesOn = status == Status::Transferring;
  takeEvent(client, goesOn ? CommandEvent::Time : CommandEvent::Silent, status, nullptr, nowMs);
  if (state.status != Status::Transferring) return;
  const CommandTransfer& sending = client.commanding_.transfer;
  const bool isDue = sending.isDue() || sending.isAskDue(nowMs, askAgainMs(client));
  if (isDue && client.link_.canSend() && client.claimHeavyWork()) send(client, true, nowMs);
}

void Client::Command::takeEvent(Client& client, CommandEvent event, Status status, const FrameParser* frame,
                                uint16_t nowMs) {
  const CommandTransfer& sending = client.commanding_.transfer;
  const uint8_t tries = sending.tries();
  if (event == CommandEvent::Silent) client.known_.log.gaveUp();
  OnCommand const on = client.commanding_.on;
  if (on != nullptr) status = on(client, event, status, frame, nowMs);
  if (status != Status::Transferring || sending.tries() == 0) client.known_.log.ended(tries, nowMs);
  // After a pause the same is asked again: a late answer to it is as good.
  if (sending.state() == CommandTransfer::State::Pausing) client.known_.log.forget();
  if (status == Status::Transferring) return;
  client.beginSeconds(nowMs);  // the seconds tell the next command how long ago this one ended
  client.end(status);
}

// Twice as often while somebody's mode may be undone.
uint16_t Client::Command::askAgainMs(Client& client) {
  const uint16_t againMs = client.link_.pace().waitMs(CommandTransfer::kAskMs);
  return client.commanding_.transfer.isUrgent() ? againMs / 2 : againMs;
}

// `isBegun`: the operation has begun, and not only a heartbeat may be asked for.
void Client::Command::send(Client& client, bool isBegun, uint16_t nowMs) {
  // The command is turned into its message in place: param1 to param4, and z, stay where they are.
  union {
    FlightCommand command;
    mavlink_command_long_t asLong;
    mavlink_command_int_t asInt;
    mavlink_mission_set_current_t asItem;
  } piece;
  static_assert(offsetof(mavlink_command_long_t, command) == offsetof(FlightCommand, x) &&
                    offsetof(mavlink_command_int_t, x) == offsetof(FlightCommand, param5) &&
                    offsetof(mavlink_command_int_t, z) == offsetof(FlightCommand, param7),
                "param1 to param7 must lie in FlightCommand as they lie in COMMAND_LONG and COMMAND_INT");
  memset(&piece, 0, sizeof(piece));
  CommandTransfer& sending = client.commanding_.transfer;
  bool isAsking = !isBegun || !sending.isDue();
  if (!isAsking) {
    client.commanding_.fill(client, piece.command);
    // (What sets a mode again does not wait for late answers to the order that has undone it: a refusal of that has
    // come before the heartbeat that shows its mode, and an acceptance ends nothing.)
    if (!sending.isRestoring() && !client.known_.log.maySend(piece.command.id, nowMs)) return;
    // The gate: nothing that takes the aircraft, arms it or lets its motors start has another way out.
    if (isGuarded(piece.command.id)) sending.guard();
    if (client.known_.takenBy != Status::Idle && mayStartMotors(piece.command.id, isOn(piece.command))) {
      return client.end(client.known_.takenBy);
    }
    if (sending.lacksHeartbeat(nowMs)) {
      sending.ask();
      isAsking = true;
    }
  }
  if (isAsking) {
    if (!sending.isAskDue(nowMs, askAgainMs(client))) return;
    static_assert(MAVLINK_MSG_ID_HEARTBEAT == 0, "param1 is the message that is asked for");
    memset(&piece, 0, sizeof(piece));
    piece.command.id = MAV_CMD_REQUEST_MESSAGE;
  }
  const uint16_t id = piece.command.id;
  KeyIndex key = KeyIndex::COMMAND_LONG;
  if (id == CommandLog::kNoCommand) {
    const int32_t item = piece.command.x;
    piece.asItem.seq = static_cast<uint16_t>(item);
    key = KeyIndex::MISSION_SET_CURRENT;
  } else if (piece.command.hasPlace) {
    CoordinateFrame frame = piece.command.frame;
    // PX4 1.18 takes no other number.
    if (frame == CoordinateFrame::Global) frame = CoordinateFrame::GlobalInt;
    memmove(&piece.command.param5, &piece.command.x, 2 * sizeof(piece.command.x));
    piece.asInt.command = id;
    piece.asInt.frame = static_cast<uint8_t>(frame);
    piece.asInt.current = 0;
    piece.asInt.autocontinue = 0;
    key = KeyIndex::COMMAND_INT;
  } else {
    piece.asLong.command = id;
    piece.asLong.confirmation = isAsking ? 0 : sending.tries();
  }
  client.link_.sendMessage(reinterpret_cast<uint8_t*>(&piece), &kKeys[static_cast<uint8_t>(key)]);
  if (isAsking) {
    client.known_.log.askedAside(nowMs);
    return sending.asked(nowMs);
  }
  sending.sent(nowMs, client.link_.pace().waitMs(CommandTransfer::kAnswerMs));
  client.known_.log.sent(id, sending.waitMs(), nowMs);
}

void Client::Command::takeFrame(Client& client, const FrameParser& frame, uint16_t nowMs) {
  CommandEvent event;
  Status status = Status::Transferring;
  switch (frame.messageId()) {
    case MAVLINK_MSG_ID_COMMAND_ACK: {
      const mavlink_command_ack_t ack = messageFrom<mavlink_command_ack_t>(frame);
      if (!client.known_.log.isAnswer(ack.command, frame.sequence(), nowMs)) return;
      client.state_.lastResult = ack.result;
      if (ack.result == MAV_RESULT_IN_PROGRESS) {
        client.known_.log.onProgress(nowMs);
        return client.commanding_.transfer.onProgress(nowMs);
      }
      status = fromCommandResult(ack.result);
      if (status == Status::Done) client.commanding_.transfer.onAccepted(ack.command == CommandLog::kRequestMessage);
      event = status == Status::Done ? CommandEvent::Accepted : CommandEvent::Refused;
      break;
    }
    case MAVLINK_MSG_ID_HEARTBEAT:
      client.commanding_.transfer.onHeartbeat(nowMs);
      if (!client.commanding_.transfer.isOld()) client.known_.log.onHeartbeat();
      event = CommandEvent::Heartbeat;
      break;
    case MAVLINK_MSG_ID_MISSION_CURRENT:
      if (client.commanding_.transfer.isUrgent()) return;  // it does not tell whose the aircraft is
      event = CommandEvent::Current;
      break;
    default: return;
  }
  takeEvent(client, event, status, &frame, nowMs);
}

Status MissionClient::send(const FlightCommand& command, CommandRepeat repeat) {
  const Status status = beginCommand(OwnCommand::fill, OwnCommand::on);
  if (status == Status::Busy) return status;
  commanding_.own = &command;
  commanding_.transfer.setRepeats(repeat == CommandRepeat::Always || !isOnceOnly(command.id));
  return status;
}

Status Client::OwnCommand::on(Client& client, CommandEvent event, Status status, const FrameParser*, uint16_t) {
  if (event == CommandEvent::Refused) return sendInOtherForm(client, status);
  if (event != CommandEvent::Ready && event != CommandEvent::Heartbeat) return status;
  const uint16_t id = client.commanding_.own->id;
  // MAV_CMD_MISSION_START would arm this autopilot.
  const bool arms = id == MAV_CMD_MISSION_START && has(client.firmware(), kArmsByMissionStart);
  if (arms && !client.isArmed()) return Status::NotArmed;
  if (!isGuarded(id)) return status;
  // Somebody has set another mode since it was begun, or has disarmed: it does not leave, or not again. (The mode may
  // also be the one that it has set.)
  const bool isDisarmed = client.hasBeenDisarmed();
  CommandTransfer& sending = client.commanding_.transfer;
  if (!isDisarmed && client.shownMode() == client.firstMode()) return status;
  if (sending.tries() == 0) return isDisarmed ? Status::NotArmed : Status::TakenOver;
  sending.setRepeats(false);
  return status;
}

bool CommandPort::hasBeenDisarmed() const {
  const Client& client = static_cast<const Client&>(*this);
  const uint8_t gone = client.commanding_.modeFlags & static_cast<uint8_t>(~client.link_.finder().heartbeat().baseMode);
  return (gone & MAV_MODE_FLAG_SAFETY_ARMED) != 0;
}

void Client::OwnCommand::fill(Client& client, FlightCommand& command) {
  command = *client.commanding_.own;
  if (command.id == MAV_CMD_COMPONENT_ARM_DISARM) command.param2 = 0;  // never forced
}

Status MissionClient::arm() { return beginCommand(Arming::fill, Arming::on); }

Status MissionClient::disarm() { return beginCommand(Arming::fillDisarming, Arming::on); }

// The aircraft is armed, or disarmed, when a heartbeat shows it: ArduPilot sends none at arming, so one is asked for.
// The answer may be a late one, to an earlier command.
Status Client::Arming::on(Client& client, CommandEvent event, Status status, const FrameParser*, uint16_t) {
  CommandTransfer& sending = client.commanding_.transfer;
  const bool arms = client.commanding_.fill == fill;
  switch (event) {
    case CommandEvent::Accepted: sending.ask(); return Status::Transferring;
    case CommandEvent::Ready:
    case CommandEvent::Heartbeat: {
      if (arms && client.hasBeenDisarmed()) return Status::NotArmed;  // by somebody, who wants it so
      const bool isDone = sending.tries() != 0 && client.isArmed() == arms;
      if (isDone && !sending.isOld()) return Status::Done;
      if (client.state_.lastResult == MAV_RESULT_ACCEPTED) sending.askLater();
      return status;
    }
    case CommandEvent::Silent: return Command::whenSilent(client, status);
    default: return status;
  }
}

// An order that was accepted, and that no heartbeat shows.
Status Client::Command::whenSilent(const Client& client, Status silence) {
  return client.state_.lastResult == MAV_RESULT_ACCEPTED ? Status::Unconfirmed : silence;
}

void CommandPort::fillArming(FlightCommand& command, bool arms) {
  command.id = MAV_CMD_COMPONENT_ARM_DISARM;
  if (arms) command.param1 = 1;  // param2 stays 0: never forced
}

// On a line that loses nothing an arming without an answer may have been carried out, and undone by somebody since: it
// leaves once.
void Client::Arming::fill(Client& client, FlightCommand& command) {
  client.commanding_.transfer.setRepeats(client.link_.pace().isLossy());
  fillArming(command, true);
}

void Client::Arming::fillDisarming(Client&, FlightCommand& command) { fillArming(command, false); }

uint16_t CommandPort::numberOf(FlightMode mode) const {
  const Client& client = static_cast<const Client&>(*this);
  return modeNumber(mode, client.firmware(), client.vehicleType());
}

bool MissionClient::isInMode(FlightMode mode) const {
  return mavmission::isInMode(mode, firmware(), vehicleType(), customMode());
}

FlashText MissionClient::modeName() const { return mavmission::modeName(firmware(), vehicleType(), customMode()); }

uint16_t CommandPort::shownMode() const { return modeNumberOf(static_cast<const Client&>(*this).customMode()); }

bool CommandPort::isReturn(uint16_t mode) const {
  return mode == numberOf(FlightMode::ReturnToLaunch) || mode == numberOf(kOtherReturn);
}

uint16_t CommandPort::counted(uint16_t mode) const {
  const bool isReturning = isPlane(static_cast<const Client&>(*this).vehicleType()) && isReturn(mode);
  return isReturning ? numberOf(FlightMode::ReturnToLaunch) : mode;
}

uint16_t CommandPort::firstMode() const { return static_cast<const Client&>(*this).state_.next; }

Status MissionClient::setMode(FlightMode mode) {
  const Status status = beginCommand(SettingMode::fill, SettingMode::onNamed);
  if (status != Status::Busy) commanding_.mode.named = mode;
  return status;
}

Status MissionClient::setCustomMode(uint32_t customMode) {
  const Status status = beginCommand(SettingMode::fill, SettingMode::onCustom);
  if (status == Status::Busy) return status;
  // PX4 has nothing in the lower half, and what is there would be cut.
  const bool isCut = customMode > 0xFFFF && static_cast<uint16_t>(customMode) != 0;
  commanding_.mode.number = isCut ? kNoMode : modeNumberOf(customMode);
  commanding_.mode.isLarge = customMode > 255;
  return status;
}

// By its name a plane's QRTL is its return, by its number it is another mode.
uint16_t Client::SettingMode::seen(const Client& client, uint16_t mode) {
  return client.commanding_.on == onNamed ? client.counted(mode) : mode;
}

// ArduPilot's mode numbers have one byte. A larger number would be cut, and set another mode.
Status Client::SettingMode::onCustom(Client& client, CommandEvent event, Status status, const FrameParser* frame,
                                     uint16_t nowMs) {
  const Modes& mode = client.commanding_.mode;
  const bool isNone = event == CommandEvent::Ready &&
                      (mode.number == kNoMode || (has(client.firmware(), kModeIsOneByte) && mode.isLarge));
  return isNone ? Status::NoSuchMode : on(client, event, status, frame, nowMs);
}

Status Client::SettingMode::onNamed(Client& client, CommandEvent event, Status status, const FrameParser* frame,
                                    uint16_t nowMs) {
  Modes& mode = client.commanding_.mode;
  if (client.isVehicleAsked()) return client.onVehicle(event, status, fill);
  if (event == CommandEvent::Ready) {
    if (client.numberOf(mode.named) != kNoMode && client.asksVehicle()) return status;
    mode.number = client.numberOf(mode.named);
  }
  return mode.number == kNoMode ? Status::NoSuchMode : on(client, event, status, frame, nowMs);
}

// A mode is set when a heartbeat shows it: PX4 answers twice, and may first accept a mode that it then refuses. Until a
// heartbeat shows the mode, the command is repeated, since the refusal may have been lost.
Status Client::SettingMode::on(Client& client, CommandEvent event, Status status, const FrameParser*, uint16_t nowMs) {
  Modes& mode = client.commanding_.mode;
  CommandTransfer& sending = client.commanding_.transfer;
  const bool isRestoring = mode.order.isRestoring();
  switch (event) {
    case CommandEvent::Ready: mode.order.begin(seen(client, client.firstMode()), mode.number); return status;
    case CommandEvent::Accepted: sending.ask(); return Status::Transferring;
    case CommandEvent::Heartbeat:
      switch (mode.order.onHeartbeat(seen(client, client.shownMode()), sending.tries() != 0,
                                     sending.mayBeUnderWay(nowMs))) {
        // It has taken the order, and left that mode by itself, as with a plan that has ended: again would be the same.
        case ModeOrder::Sight::Before:
          if (!isRestoring && sending.isDue() && sending.tries() != 0 &&
              client.state_.lastResult == MAV_RESULT_ACCEPTED) {
            return Status::Unconfirmed;
          }
          break;
        case ModeOrder::Sight::Wanted:
          if (!sending.isOld()) return isRestoring ? Status::TakenOver : Status::Done;
          sending.ask();
          break;
        case ModeOrder::Sight::Foreign: return Status::TakenOver;
        case ModeOrder::Sight::Doubtful: sending.doubt(); break;
        case ModeOrder::Sight::Undone:
          mode.number = mode.order.wanted();
          client.commanding_.fill = fill;
          sending.restore();
          break;
      }
      return status;
    case CommandEvent::Silent: return isRestoring ? Status::Overruled : Command::whenSilent(client, status);
    case CommandEvent::Refused: return isRestoring ? Status::Overruled : status;
    default: return status;
  }
}

void Client::SettingMode::fill(Client& client, FlightCommand& command) {
  fillModeNumber(command, client.commanding_.mode.number);
}

void CommandPort::fillModeNumber(FlightCommand& command, uint16_t number) {
  command.id = MAV_CMD_DO_SET_MODE;
  command.param1 = MAV_MODE_FLAG_CUSTOM_MODE_ENABLED;
  command.param2 = floatOf(static_cast<uint8_t>(number));
  command.param3 = floatOf(number >> 8);
}

// False if the plan aboard is known not to have this item.
bool Client::hasItem(uint16_t item) {
  const bool isKnown = aboard() == Aboard::OurPlan && isMissionInPlan();
  if (item != kNoItem && (!isKnown || item < plan_.count())) return true;
  state_.failedItem = item;
  return false;
}

Status MissionClient::setCurrentItem(uint16_t item) {
  const Status status = beginCommand(SettingCurrent::fill, SettingCurrent::on);
  if (status != Status::Busy) commanding_.item = item;
  return status;
}

Status Client::SettingCurrent::on(Client& client, CommandEvent event, Status status, const FrameParser* frame,
                                  uint16_t) {
  Commanding& commanding = client.commanding_;
  const ItemNumbers numbers = client.numbersAboard();
  switch (event) {
    case CommandEvent::Ready:
      if (!client.hasItem(commanding.item)) return Status::NoSuchItem;
      commanding.item = numbers.toWire(commanding.item);
      break;
    case CommandEvent::Refused:
      if (status != Status::CommandUnsupported) break;
      client.nextCommand(fillMessage);
      return Status::Transferring;
    case CommandEvent::Current: {
      // The older message has no answer of its own: MISSION_CURRENT with our item is the answer. MISSION_CURRENT with
      // another item is no answer, unless the total shows that the plan has no such item, which PX4 reports only in a
      // STATUSTEXT. (A PX4 without a plan reports a total of 65535.)
      if (commanding.fill != fillMessage || commanding.transfer.tries() == 0) break;
      const mavlink_mission_current_t current = messageFrom<mavlink_mission_current_t>(*frame);
      if (current.seq == commanding.item) return Status::Done;
      const uint16_t total = current.total;
      if (total == 0) break;  // the autopilot does not report a total
      if (total != 0xFFFF && commanding.item < total + numbers.home()) break;
      client.state_.failedItem = client.itemFromWire(commanding.item);
      return Status::NoSuchItem;
    }
    default: break;
  }
  return status;
}

void Client::SettingCurrent::fill(Client& client, FlightCommand& command) {
  command.id = MAV_CMD_DO_SET_MISSION_CURRENT;
  command.param1 = floatOf(client.commanding_.item);
}

void Client::SettingCurrent::fillMessage(Client& client, FlightCommand& command) {
  command.x = client.commanding_.item;
}

Status MissionClient::setMessageInterval(uint16_t messageId, int32_t intervalUs) {
  const Status status = beginCommand(SettingInterval::fill, nullptr);
  if (status == Status::Busy) return status;
  commanding_.interval.us = intervalUs;
  commanding_.interval.message = messageId;
  return status;
}

void Client::SettingInterval::fill(Client& client, FlightCommand& command) {
  command.id = MAV_CMD_SET_MESSAGE_INTERVAL;
  command.param1 = floatOf(client.commanding_.interval.message);
  command.param2 = static_cast<float>(client.commanding_.interval.us);
}

uint16_t Port::itemFromWire(uint16_t wireItem) const {
  return wireItem - static_cast<const Client&>(*this).numbersAboard().before();
}

}  // namespace mavmission
