#include "../TelemetryPause.h"

#include <Arduino.h>

#include "../MissionClient.h"
#include "../base/Clock.h"
#include "../base/Flash.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;
namespace {

// The fewest that make up nine tenths of the recorded telemetry, the loudest first (test_quiet_transfers.py).
const PausableMessage kArduPilots[] PROGMEM = {
    {65, 0},   // RC_CHANNELS
    {24, 0},   // GPS_RAW_INT
    {147, 0},  // BATTERY_STATUS
    {1, 0},    // SYS_STATUS
    {27, 0},   // RAW_IMU
    {163, 0},  // AHRS
    {30, 0},   // ATTITUDE
    {33, 0},   // GLOBAL_POSITION_INT
    {178, 0},  // AHRS2
    {116, 0},  // SCALED_IMU2
    {62, 0},   // NAV_CONTROLLER_OUTPUT
    {129, 0},  // SCALED_IMU3
    {193, 0},  // EKF_STATUS_REPORT
    {136, 0},  // TERRAIN_REPORT
    {241, 0},  // VIBRATION
    {74, 0},   // VFR_HUD
    {29, 0},   // SCALED_PRESSURE
    {137, 0},  // SCALED_PRESSURE2
    {36, 0},   // SERVO_OUTPUT_RAW
    {32, 0},   // LOCAL_POSITION_NED
};
const PausableMessage kPx4s[] PROGMEM = {
    {30, 0},     // ATTITUDE
    {31, 0},     // ATTITUDE_QUATERNION
    {24, 0},     // GPS_RAW_INT
    {33, 0},     // GLOBAL_POSITION_INT
    {74, 0},     // VFR_HUD
    {85, 0},     // POSITION_TARGET_LOCAL_NED
    {83, 0},     // ATTITUDE_TARGET
    {12901, 0},  // OPEN_DRONE_ID_LOCATION
    {1, 0},      // SYS_STATUS
    {36, 0},     // SERVO_OUTPUT_RAW
    {141, 0},    // ALTITUDE
    {32, 0},     // LOCAL_POSITION_NED
    {12904, 0},  // OPEN_DRONE_ID_SYSTEM
    {8, 0},      // LINK_NODE_STATUS
    {242, 0},    // HOME_POSITION
};
constexpr uint8_t kArduPilotsCount = sizeof(kArduPilots) / sizeof(kArduPilots[0]);
constexpr uint8_t kPx4sCount = sizeof(kPx4s) / sizeof(kPx4s[0]);
static_assert(kArduPilotsCount <= TelemetryPause::kMostMessages && kPx4sCount <= TelemetryPause::kMostMessages,
              "a bit each");

// As commands have it (MAVLink guide, Command Protocol).
constexpr uint8_t kTries = UploadTransfer::kTries;
constexpr uint16_t kAnswerMs = UploadTransfer::kAnswerMs;

// Without these a transfer or a command could not be followed: HEARTBEAT, the messages of missions and of commands,
// STATUSTEXT.
bool isNeeded(uint16_t id) {
  switch (id) {
    case MAVLINK_MSG_ID_HEARTBEAT:
    case MAVLINK_MSG_ID_MISSION_REQUEST_INT:
    case MAVLINK_MSG_ID_MISSION_ITEM_INT:
    case MAVLINK_MSG_ID_COMMAND_INT:
    case MAVLINK_MSG_ID_COMMAND_LONG:
    case MAVLINK_MSG_ID_COMMAND_ACK:
    case MAVLINK_MSG_ID_STATUSTEXT: return true;
    default: return id >= MAVLINK_MSG_ID_MISSION_REQUEST_PARTIAL_LIST && id <= MAVLINK_MSG_ID_MISSION_ACK;
  }
}

uint32_t bitOf(uint8_t index) { return uint32_t{1} << index; }

}  // namespace

TelemetryPause::TelemetryPause(MissionClient& client)
    : TelemetryPause(client, List{kArduPilots, kArduPilotsCount}, List{kPx4s, kPx4sCount}) {}

TelemetryPause::TelemetryPause(MissionClient& client, const List& forArduPilot, const List& forOthers)
    : MessageIntervals(client, &kKeys[static_cast<uint8_t>(KeyIndex::COMMAND_ACK)], 1, take),
      forArduPilot_(forArduPilot),
      forOthers_(forOthers),
      isHushing_(false),
      isAnswered_(false) {}

const TelemetryPause::List& TelemetryPause::list() const {
  return client_.firmware() == Firmware::ArduPilot ? forArduPilot_ : forOthers_;
}

// Commands have no items, nor has clear(); of a plan that is read it is not known yet how many.
bool TelemetryPause::isTransferring() const {
  return client_.isBusy() && client_.status() == Status::Transferring && client_.itemsTotal() != 0;
}

// Goes on to the next message that is to be asked for, from index_ on; false if there is none.
bool TelemetryPause::findNext() {
  const List& messages = list();
  if (isHushing_) {
    while (index_ < messages.count && isNeeded(fromFlash(&messages.messages[index_].id))) ++index_;
    return index_ < messages.count;
  }
  if (messages.count < kMostMessages) muted_ &= bitOf(messages.count) - 1;
  while (muted_ != 0) {
    if (index_ >= messages.count) index_ = 0;  // round and round, until each was answered
    if (isNeeded(fromFlash(&messages.messages[index_].id))) muted_ &= ~bitOf(index_);
    if ((muted_ & bitOf(index_)) != 0) return true;
    ++index_;
  }
  return false;
}

void TelemetryPause::update() {
  const uint16_t nowMs = static_cast<uint16_t>(millis());
  if (isWaiting_) {
    if (since(askedMs_, nowMs) < kAnswerMs) return;
    isWaiting_ = false;
    if (isAnswered_ || tries_ == kTries) {
      tries_ = 0;
      ++index_;
    }
  }
  if (!mayAsk(nowMs)) return;
  if (isHushing_ != isTransferring()) {
    isHushing_ = !isHushing_;
    index_ = 0;
    tries_ = 0;
  }
  if (findNext() && client_.link_.canSend()) askNext(nowMs);
}

void TelemetryPause::askNext(uint16_t nowMs) {
  const PausableMessage message = fromFlash(&list().messages[index_]);
  ask(message.id, isHushing_ ? -1 : static_cast<float>(uint32_t{1000} * message.intervalMs), tries_, nowMs);
  muted_ |= bitOf(index_);
  ++tries_;
  isAnswered_ = false;
}

void TelemetryPause::take(Listener& listener, const FrameParser& frame) {
  TelemetryPause& self = static_cast<TelemetryPause&>(listener);
  const uint16_t nowMs = static_cast<uint16_t>(millis());
  // The same frame again would be taken for the answer to the next message.
  if (self.isAnswered_ || !self.isAnswer(frame) || !self.mayAsk(nowMs) || frame.sequence() == self.sequence_) return;
  self.sequence_ = frame.sequence();
  self.takeResult(frame.payloadByte(offsetof(mavlink_command_ack_t, result)), nowMs);
}

void TelemetryPause::takeResult(uint8_t result, uint16_t nowMs) {
  if (result == MAV_RESULT_TEMPORARILY_REJECTED) return;  // asked for again when the wait is over
  if (result == MAV_RESULT_IN_PROGRESS) {
    askedMs_ = nowMs;
    return;
  }
  // What is refused to be given back has no such interval.
  if (!isHushing_) muted_ &= ~bitOf(index_);
  if (tries_ == 1) {
    settle();
    tries_ = 0;
    ++index_;
    return;
  }
  // An answer to another try may be on its way still, and could not be told from the answer to the next message.
  isAnswered_ = true;
  askedMs_ = nowMs;
}

}  // namespace mavmission
