#include "Parameters.h"

#include <Arduino.h>
#include <string.h>

#include "../base/Flash.h"
#include "../base/FloatBits.h"
#include "../client/CommandPort.h"
#include "../client/Operation.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;
namespace {

const MessageKey kValue[] PROGMEM = {MAVMISSION_LISTENER_KEY(PARAM_VALUE)};
const MessageKey kRequest PROGMEM =
    MAVMISSION_MESSAGE_KEY(PARAM_REQUEST_READ, offsetof(mavlink_param_request_read_t, target_system));
const MessageKey kSet PROGMEM = MAVMISSION_MESSAGE_KEY(PARAM_SET, offsetof(mavlink_param_set_t, target_system));
static_assert(sizeof(mavlink_param_request_read_t) == MAVLINK_MSG_ID_PARAM_REQUEST_READ_LEN &&
                  sizeof(mavlink_param_set_t) == MAVLINK_MSG_ID_PARAM_SET_LEN &&
                  sizeof(mavlink_param_value_t) == MAVLINK_MSG_ID_PARAM_VALUE_LEN,
              "the struct of a message must have the layout of its payload on the wire");
static_assert(sizeof(mavlink_param_set_t::param_id) == Parameters::kMostCharacters,
              "Parameters says how long a name may be");

// Whether a type of whole numbers has this number. What has more than 32 bits has each.
bool isWithin(uint8_t type, int32_t number) {
  switch (type) {
    case MAV_PARAM_TYPE_UINT8: return number >= 0 && number <= 0xFF;
    case MAV_PARAM_TYPE_INT8: return number >= INT8_MIN && number <= INT8_MAX;
    case MAV_PARAM_TYPE_UINT16: return number >= 0 && number <= 0xFFFF;
    case MAV_PARAM_TYPE_INT16: return number >= INT16_MIN && number <= INT16_MAX;
    case MAV_PARAM_TYPE_UINT32:
    case MAV_PARAM_TYPE_UINT64: return number >= 0;
    default: return true;
  }
}

// Whether the type has whole numbers only.
bool isWholeType(uint8_t type) { return type < MAV_PARAM_TYPE_REAL32; }

int32_t bitsOf(float value) {
  int32_t bits;
  memcpy(&bits, &value, sizeof(bits));
  return bits;
}

}  // namespace

Parameters::Parameters(MissionClient& client) : Listener(client, kValue, 1, take) { memset(name_, 0, sizeof(name_)); }

// --- Beginning

Status Parameters::begin(FlashText name, const char* nameInRam, Wanted wanted, int32_t value) {
  if (client_.running() != Status::Idle) return Status::Busy;
  memset(name_, 0, sizeof(name_));
  for (uint8_t i = 0;; ++i) {
    const char c =
        nameInRam != nullptr ? nameInRam[i] : static_cast<char>(fromFlash(reinterpret_cast<const uint8_t*>(name) + i));
    isTooLong_ = i == sizeof(name_) && c != 0;
    if (c == 0 || isTooLong_) break;
    name_[i] = c;
  }
  type_ = 0;
  what_ = wanted;
  wanted_ = value;
  isSetting_ = false;
  return client_.commands().beginOwn(step, this);
}

Status Parameters::read(FlashText name) { return begin(name, nullptr, Wanted::Nothing, 0); }

Status Parameters::set(FlashText name, float value) { return begin(name, nullptr, Wanted::Float, bitsOf(value)); }

Status Parameters::setWhole(FlashText name, int32_t value) { return begin(name, nullptr, Wanted::Whole, value); }

#ifdef ARDUINO
Status Parameters::read(const char* name) { return begin(nullptr, name, Wanted::Nothing, 0); }

Status Parameters::set(const char* name, float value) { return begin(nullptr, name, Wanted::Float, bitsOf(value)); }

Status Parameters::setWhole(const char* name, int32_t value) { return begin(nullptr, name, Wanted::Whole, value); }
#endif

// --- The operation

// (The answer comes to take().)
struct Parameters::Exchange : OperationParts {
  static void time(Client& client, uint16_t nowMs) {
    static_cast<Parameters*>(CommandPort::ownerOf(client))->onTime(nowMs);
  }
};

void Parameters::step(Client& client, const FrameParser* frame, uint16_t nowMs) {
  operate<Exchange>(client, frame, nowMs);
}

void Parameters::onTime(uint16_t nowMs) {
  Port& client = client_;
  CommandTransfer& transfer = client.commands().sending();
  if (client.running() == Status::Checking) {
    if (isTooLong_) return client.end(Status::NoParameter);
    if (what_ == Wanted::Float) {
      const FloatKind kind = kindOf(&wanted_);
      if (kind == FloatKind::NotANumber) return client.end(Status::NotANumber);  // PX4 would store it
      if (kind == FloatKind::Infinite) return client.end(Status::NotFinite);
    }
    client.beginTransferring(nowMs);
  }
  if (client.running() != Status::Transferring) return;
  // Also when it is armed between the reading and the setting.
  if (what_ != Wanted::Nothing && client.autopilot().isArmed() && !client.isAllowedWhileArmed())
    return client.end(Status::Armed);
  Status status = transfer.onTime(0, nowMs);
  if (status == Status::Transferring && client.hasTakenTooLong()) status = Status::TookTooLong;
  if (status == Status::NoAnswer) status = isSetting_ ? Status::Unconfirmed : Status::NoParameter;
  if (status != Status::Transferring) return client.end(status);
  if (transfer.isDue() && client.link().canSend() && client.claimHeavyWork()) send(nowMs);
}

void Parameters::send(uint16_t nowMs) {
  Link& link = client_.link();
  if (isSetting_) {
    mavlink_param_set_t message = mavlink_param_set_t();
    memcpy(&message.param_value, &wanted_, sizeof(wanted_));
    memcpy(message.param_id, name_, sizeof(name_));
    message.param_type = type_;
    link.send(&message, kSet);
  } else {
    mavlink_param_request_read_t message = mavlink_param_request_read_t();
    memcpy(message.param_id, name_, sizeof(name_));
    message.param_index = -1;  // by its name
    link.send(&message, kRequest);
  }
  client_.commands().sending().sent(nowMs, link.pace().waitMs(CommandTransfer::kAnswerMs));
}

// --- The answer

void Parameters::take(Listener& listener, const FrameParser& frame) {
  Parameters& self = static_cast<Parameters&>(listener);
  Port& client = self.client_;
  if (!client.commands().runs(step, &self)) return;
  if (client.running() != Status::Transferring || client.commands().sending().tries() == 0) return;
  if (!self.isFromAutopilot(frame)) return;
  mavlink_param_value_t message;
  frame.copyPayload(&message, sizeof(message));
  // Any parameter may come at any time: autopilots tell those that change.
  if (strncmp(message.param_id, self.name_, sizeof(self.name_)) != 0) return;
  memcpy(&self.bits_, &message.param_value, sizeof(self.bits_));
  self.type_ = message.param_type;
  self.takeValue();
}

void Parameters::takeValue() {
  const Status status = compare();
  if (status != Status::Transferring) client_.end(status);
}

// What the value that has come means for the operation.
Status Parameters::compare() {
  CommandTransfer& transfer = client_.commands().sending();
  if (what_ == Wanted::Nothing) return Status::Done;
  if (isSetting_) {
    if (bits_ == wanted_) return Status::Done;
    // It may be a late answer to the reading, or PX4's second one to a setting before this. If the value still is
    // another one after a repeat, it is kept.
    return client_.seconds() >= ParameterRules::kOtherS && transfer.tries() > 1 ? Status::OtherValue
                                                                                : Status::Transferring;
  }
  if (!makeBits()) return Status::NotKept;
  if (bits_ == wanted_) return Status::Done;
  isSetting_ = true;
  client_.beginSeconds(static_cast<uint16_t>(millis()));
  transfer.next(true);
  return Status::Transferring;
}

// Makes of the wanted number the bits that this autopilot takes for a parameter of this type. False if it would keep
// another number.
bool Parameters::makeBits() {
  int32_t number = wanted_;
  if (what_ == Wanted::Float) {
    if (wanted_ == INT32_MIN) wanted_ = 0;  // -0 would come back as 0
    if (!isWholeType(type_)) return true;
    number = timesWhole(wanted_, 1);
  }
  if (!isWithin(type_, number)) return false;
  const int32_t asFloat = bitsOf(quotient(number, 1));
  if (what_ == Wanted::Float) {
    if (asFloat != wanted_) return false;
  } else if (!isAsBits() && timesWhole(asFloat, 1) != number) {
    return false;
  }
  wanted_ = isAsBits() ? number : asFloat;
  return true;
}

bool Parameters::isAsBits() const { return isWholeType(type_) && has(client_.autopilot().firmware(), kIntegersAsBits); }

bool Parameters::isWhole() const { return isWholeType(type_); }

float Parameters::value() const {
  if (isAsBits()) return quotient(bits_, 1);
  float value;
  memcpy(&value, &bits_, sizeof(value));
  return value;
}

int32_t Parameters::whole() const { return isAsBits() ? bits_ : timesWhole(bits_, 1); }

}  // namespace mavmission
