#include "MissionFollower.h"

#include <string.h>

#include "Messages.h"
#include "MissionClient.h"

namespace mavmission {
namespace {

const MessageKey kFollowed[] PROGMEM = {
    {MAVLINK_MSG_ID_MISSION_CURRENT, MAVLINK_MSG_ID_MISSION_CURRENT_CRC, MAVLINK_MSG_ID_MISSION_CURRENT_MIN_LEN,
     MAVLINK_MSG_ID_MISSION_CURRENT_LEN, MessageKey::kNoTarget},
    {MAVLINK_MSG_ID_MISSION_ITEM_REACHED, MAVLINK_MSG_ID_MISSION_ITEM_REACHED_CRC,
     MAVLINK_MSG_ID_MISSION_ITEM_REACHED_MIN_LEN, MAVLINK_MSG_ID_MISSION_ITEM_REACHED_LEN, MessageKey::kNoTarget},
    {MAVLINK_MSG_ID_STATUSTEXT, MAVLINK_MSG_ID_STATUSTEXT_CRC, MAVLINK_MSG_ID_STATUSTEXT_MIN_LEN,
     MAVLINK_MSG_ID_STATUSTEXT_LEN, MessageKey::kNoTarget},
};

const char kRejected[] PROGMEM = "Mission rejected";

}  // namespace

MissionFollower::MissionFollower(MissionClient& client) : Listener(client, kFollowed, 3, take) {}

void MissionFollower::onCurrent(ItemNumberFunction function, void* context) {
  currentFunction_ = function;
  currentContext_ = context;
}

void MissionFollower::onReached(ItemNumberFunction function, void* context) {
  reachedFunction_ = function;
  reachedContext_ = context;
}

void MissionFollower::onText(TextFunction function, void* context) {
  textFunction_ = function;
  textContext_ = context;
}

void MissionFollower::take(Listener& listener, const FrameParser& frame) {
  MissionFollower& self = static_cast<MissionFollower&>(listener);
  if (!self.isFromAutopilot(frame)) return;
  switch (frame.messageId()) {
    case MAVLINK_MSG_ID_MISSION_CURRENT:
      return self.takeCurrent(frame);
    case MAVLINK_MSG_ID_MISSION_ITEM_REACHED:
      return self.takeReached(frame);
    default:
      return self.takeText(frame);
  }
}

void MissionFollower::takeCurrent(const FrameParser& frame) {
  mavlink_mission_current_t message;
  frame.copyPayload(&message, sizeof(message));
  const uint16_t item = client_.itemFromWire(message.seq);
  total_ = message.total == 0xFFFF ? 0 : message.total;
  state_ = static_cast<MissionState>(message.mission_state);
  planId_ = message.mission_id;
  // PX4 looks at a plan after it has accepted it, and until then says the same of it: it counts when it is said again.
  const bool isDoubted = state_ == MissionState::NoMission && planId_ != 0 && isOurPlan();
  if (isDoubted && planId_ == doubtedId_) client_.noteInfeasible();
  doubtedId_ = isDoubted ? planId_ : 0;
  if (item == current_) return;
  current_ = item;
  if (item == reached_) isNewLeg_ = true;
  if (item != MissionClient::kNoItem && currentFunction_ != nullptr) currentFunction_(currentContext_, item);
}

void MissionFollower::takeReached(const FrameParser& frame) {
  mavlink_mission_item_reached_t message;
  frame.copyPayload(&message, sizeof(message));
  const uint16_t item = client_.itemFromWire(message.seq);
  // PX4 says it again each second while it stays there.
  if (item == MissionClient::kNoItem || (item == reached_ && !isNewLeg_)) return;
  reached_ = item;
  isNewLeg_ = false;
  if (reachedFunction_ != nullptr) reachedFunction_(reachedContext_, item);
}

void MissionFollower::takeText(const FrameParser& frame) {
  mavlink_statustext_t message;
  frame.copyPayload(&message, sizeof(message));
  char text[sizeof(message.text) + 1];
  memcpy(text, message.text, sizeof(message.text));
  text[sizeof(message.text)] = 0;
  // PX4 accepts a plan first and looks at it then.
  if (client_.firmware() == Firmware::Px4 && strncmp_P(text, kRejected, sizeof(kRejected) - 1) == 0) {
    client_.noteInfeasible();
  }
  if (textFunction_ != nullptr) textFunction_(textContext_, message.severity, text);
}

bool MissionFollower::isOurPlan() const {
  const uint32_t accepted = client_.acceptedPlanId();
  return planId_ == 0 || accepted == 0 || planId_ == accepted;
}

}  // namespace mavmission
