#include "TelemetryPause.h"

#include <Arduino.h>

#include "../base/Clock.h"
#include "../base/Flash.h"
#include "../client/Port.h"
#include "../link/Messages.h"

namespace mavmission {
using namespace detail;
namespace {

// The fewest messages that make up nine tenths of the recorded telemetry, those with the most bytes first
// (test_quiet_transfers.py).
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
              "a list must have at most 32 messages: TelemetryPause keeps one bit for each");

// Messages without which a transfer or a command cannot be followed: HEARTBEAT, STATUSTEXT, those of missions and
// commands.
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
      isWaiting_(false),
      isAnswered_(false) {}

const TelemetryPause::List& TelemetryPause::list() const {
  return has(client_.autopilot().firmware(), kStreamsAsArduPilot) ? forArduPilot_ : forOthers_;
}

// Commands and clear() have no items, nor has a download before its MISSION_COUNT.
bool TelemetryPause::isTransferring() const { return client_.running() == Status::Transferring && client_.hasItems(); }

// Goes on to the next message that needs a command, from index_ on; false if there is none.
bool TelemetryPause::findNext() {
  const List& messages = list();
  if (isHushing_) {
    while (index_ < messages.count && isNeeded(fromFlash(&messages.messages[index_].id))) ++index_;
    return index_ < messages.count;
  }
  if (messages.count < kMostMessages) muted_ &= bitOf(messages.count) - 1;
  while (muted_ != 0) {
    if (index_ >= messages.count) index_ = 0;  // again from the start, until each was answered
    if (isNeeded(fromFlash(&messages.messages[index_].id))) muted_ &= ~bitOf(index_);
    if ((muted_ & bitOf(index_)) != 0) return true;
    ++index_;
  }
  return false;
}

void TelemetryPause::update() {
  const uint16_t nowMs = static_cast<uint16_t>(millis());
  if (isWaiting_) {
    if (since(asked_.atMs, nowMs) < IntervalRules::kAnswerMs) return;
    isWaiting_ = false;
    giveUpWaiting(nowMs);
    if (isAnswered_ || tries_ == IntervalRules::kTries) {
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
  if (findNext() && client_.link().canSend()) askNext(nowMs);
}

void TelemetryPause::askNext(uint16_t nowMs) {
  const PausableMessage message = fromFlash(&list().messages[index_]);
  ask(message.id, isHushing_ ? -1 : static_cast<float>(uint32_t{1000} * message.intervalMs), tries_, nowMs);
  muted_ |= bitOf(index_);
  ++tries_;
  isWaiting_ = true;
  isAnswered_ = false;
}

void TelemetryPause::take(Listener& listener, const FrameParser& frame) {
  TelemetryPause& self = static_cast<TelemetryPause&>(listener);
  const uint16_t nowMs = static_cast<uint16_t>(millis());
  if (self.isAnswered_ || !self.mayAsk(nowMs) || !self.isAnswer(frame)) return;
  self.takeResult(frame.payloadByte(offsetof(mavlink_command_ack_t, result)), nowMs);
}

void TelemetryPause::takeResult(uint8_t result, uint16_t nowMs) {
  if (result == MAV_RESULT_TEMPORARILY_REJECTED) return;  // sent again after the timeout
  if (result == MAV_RESULT_IN_PROGRESS) {
    await(nowMs);
    return;
  }
  // If the autopilot refuses to restore the interval, it does not have such a message.
  if (!isHushing_) muted_ &= ~bitOf(index_);
  if (tries_ == 1) {
    settle();
    isWaiting_ = false;
    tries_ = 0;
    ++index_;
    return;
  }
  // The answer to another attempt may still come, and could not be told from the answer to the next message's command.
  isAnswered_ = true;
  await(nowMs);
}

}  // namespace mavmission
