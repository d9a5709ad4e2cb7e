#include "StandardModes.h"

#include <Arduino.h>
#include <string.h>

#include "../base/Flash.h"
#include "../client/CommandPort.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;
namespace {

const MessageKey kModes[] PROGMEM = {
    MAVMISSION_LISTENER_KEY(AVAILABLE_MODES),
    MAVMISSION_LISTENER_KEY(CURRENT_MODE),
};

static_assert(static_cast<uint8_t>(StandardMode::TakeOff) == MAV_STANDARD_MODE_TAKEOFF,
              "StandardMode must list the modes in the order of MAV_STANDARD_MODE");
static_assert(MAVLINK_MSG_ID_AVAILABLE_MODES_LEN == 46, "StandardModes says how many bytes must be kept");
static_assert(sizeof(mavlink_available_modes_t::mode_name) == StandardModes::kMostCharacters,
              "StandardModes says how long a name may be");

}  // namespace

StandardModes::StandardModes(MissionClient& client, Kept)
    : Listener(client, kModes, sizeof(kModes) / sizeof(kModes[0]), take),
      customMode_(0),
      before_(0),
      mode_(StandardMode::NonStandard),
      current_(StandardMode::NonStandard),
      wanted_(StandardMode::NonStandard),
      count_(0),
      number_(0),
      isSelectable_(false),
      isAsking_(false),
      isHeard_(false),
      isAnswered_(false),
      isSet_(false) {
  memset(name_, 0, sizeof(name_));
}

// --- What the sketch calls

Status StandardModes::set(StandardMode mode) { return begin(mode, 0); }
Status StandardModes::read(uint8_t number) { return begin(StandardMode::NonStandard, number == 0 ? 255 : number); }

Status StandardModes::begin(StandardMode wanted, uint8_t number) {
  const Status status = client_.commands().beginCommands(fill, on, this);
  if (status == Status::Busy) return status;
  wanted_ = wanted;
  number_ = number;
  isAsking_ = isHeard_ = isAnswered_ = isSet_ = false;
  return status;
}

// --- What is heard

void StandardModes::take(Listener& listener, const FrameParser& frame) {
  StandardModes& self = static_cast<StandardModes&>(listener);
  if (!self.isFromAutopilot(frame)) return;
  if (frame.messageId() == MAVLINK_MSG_ID_AVAILABLE_MODES) return self.takeEntry(frame);
  self.current_ = static_cast<StandardMode>(frame.payloadByte(offsetof(mavlink_current_mode_t, standard_mode)));
  self.isHeard_ = true;
}

void StandardModes::takeEntry(const FrameParser& frame) {
  mavlink_available_modes_t entry;
  frame.copyPayload(&entry, sizeof(entry));
  if (entry.mode_index != number_) return;  // another client has asked for it
  count_ = entry.number_modes;
  mode_ = static_cast<StandardMode>(entry.standard_mode);
  customMode_ = entry.custom_mode;
  isSelectable_ = (entry.properties & MAV_MODE_PROPERTY_NOT_USER_SELECTABLE) == 0;
  memcpy(name_, entry.mode_name, kMostCharacters);
  isHeard_ = true;
}

// --- The operations

void StandardModes::fill(Client& client, FlightCommand& command) {
  const StandardModes& self = *static_cast<const StandardModes*>(CommandPort::ownerOf(client));
  if (self.isSetting() && !self.isAsking_) {
    command.id = MAV_CMD_DO_SET_STANDARD_MODE;
    command.param1 = static_cast<uint8_t>(self.wanted_);
    return;
  }
  command.id = MAV_CMD_REQUEST_MESSAGE;
  command.param1 = self.isSetting() ? MAVLINK_MSG_ID_CURRENT_MODE : MAVLINK_MSG_ID_AVAILABLE_MODES;
  command.param2 = self.number_;
}

Status StandardModes::on(Client& client, CommandEvent event, Status status, const FrameParser*, uint16_t nowMs) {
  return static_cast<StandardModes*>(CommandPort::ownerOf(client))->onEvent(event, status, nowMs);
}

Status StandardModes::onEvent(CommandEvent event, Status status, uint16_t nowMs) {
  switch (event) {
    case CommandEvent::Ready:
      if (isSetting() && wanted_ == StandardMode::NonStandard) return Status::NoSuchMode;
      before_ = client_.commands().shownMode();
      return client_.link().speaksV1() ? Status::NeedsMavlink2 : status;
    case CommandEvent::Accepted:
      if (!isSetting() || isAsking_) {
        isAnswered_ = true;
        return Status::Transferring;
      }
      beginAsking(nowMs);
      return Status::Transferring;
    case CommandEvent::Refused: return isAsking_ ? Status::Unconfirmed : status;
    case CommandEvent::Silent: return isAsking_ || isAnswered_ ? Status::Unconfirmed : status;
    case CommandEvent::Time: break;
    case CommandEvent::Heartbeat:
      if (isSet_) return client_.commands().sending().isOld() ? status : Status::Done;
      // Another mode by now: somebody else's, or this order's. It does not leave again in any case.
      if (!isSetting() || isAsking_ || client_.commands().shownMode() == before_) return status;
      if (client_.commands().sending().tries() == 0) return Status::TakenOver;
      beginAsking(nowMs);
      return status;
    case CommandEvent::Current: return status;
  }
  // Without the answer, it would be taken for that to the next question.
  if (!isAnswered_ || !isHeard_ || isSet_) return status;
  if (!isSetting()) return Status::Done;
  if (current_ == wanted_) {
    // PX4's heartbeat comes once a second: the next order would take the new mode for somebody else's.
    isSet_ = true;
    client_.commands().sending().listen(kConfirmS * 1000, nowMs);
    client_.commands().sending().ask();
    return status;
  }
  if (client_.seconds() >= kConfirmS) return Status::Unconfirmed;
  askAgain();
  client_.commands().sending().pause(kAskAgainMs, nowMs);
  return status;
}

// From now on the autopilot is asked for its mode.
void StandardModes::beginAsking(uint16_t nowMs) {
  isAsking_ = true;
  client_.beginSeconds(nowMs);
  askAgain();
}

void StandardModes::askAgain() {
  isHeard_ = isAnswered_ = false;
  client_.commands().sending().next(true);
}

}  // namespace mavmission
